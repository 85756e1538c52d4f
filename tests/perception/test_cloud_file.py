"""Clouds of every format, whole, broken, empty, huge, and full of holes."""

from __future__ import annotations

import base64
import io
import zipfile
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.perception.cloud_bytes import WRITERS, by_trimesh, npy, npz, packed, pcd, ply, xyz

from helicoide.arrays import Array
from helicoide.kernels import python_function
from helicoide.perception import cloud_file, formats
from helicoide.perception.cloud import FARTHEST, PointCloud
from helicoide.perception.lzf import unpack_kernel
from helicoide.text import HelicoideError

SOME = np.random.default_rng(0).normal(size=(200, 3))
HOLES = SOME.copy()
HOLES[3:40, 1], HOLES[50], HOLES[60, 2], HOLES[70, 0] = np.nan, np.inf, -np.inf, 1e300
every = pytest.mark.parametrize("name", WRITERS)


def read(name: str, points: Array) -> PointCloud:
    ending, writer = WRITERS[name]
    return cloud_file.read_cloud(f"cloud{ending}", writer(points))


def refused(name: str, data: bytes) -> str:
    """What is said of a file, in English; both languages say what would be valid."""
    with pytest.raises(HelicoideError) as refusal:
        cloud_file.read_cloud(name, data)
    text = refusal.value.text
    assert text.en.startswith(f"{name} cannot be read: ")
    assert "Valid are LAS (not packed), NPY (an array k × 3), NPZ" in text.en
    assert "at most 5 million points and 200 MB" in text.en
    assert "XYZ text" in text.en
    assert text.pt_BR.startswith(f"Não dá para ler {name}: ")
    assert "texto XYZ" in text.pt_BR
    return text.en.removeprefix(f"{name} cannot be read: ").partition(". Valid")[0]


@every
def test_points_come_back_bit_by_bit(name: str) -> None:
    cloud = read(name, SOME)
    np.testing.assert_array_equal(cloud.points, SOME)
    assert cloud.dropped == 0
    assert not cloud.points.flags.writeable


@every
def test_one_point_is_a_cloud(name: str) -> None:
    np.testing.assert_array_equal(read(name, SOME[:1]).points, SOME[:1])


@every
def test_points_without_coordinates_are_dropped_and_counted(name: str) -> None:
    cloud = read(name, HOLES)
    kept = np.isfinite(HOLES).all(axis=1) & (np.abs(HOLES) <= FARTHEST).all(axis=1)
    np.testing.assert_array_equal(cloud.points, HOLES[kept])
    assert cloud.dropped == 40
    assert cloud.description.en.startswith("160 points within")
    assert "; 40 without coordinates were left out." in cloud.description.en


@every
def test_a_file_of_holes_alone_is_refused(name: str) -> None:
    ending, writer = WRITERS[name]
    assert refused(f"c{ending}", writer(np.full((7, 3), np.nan))) == "none of its 7 points has finite coordinates"


@every
def test_an_empty_file_is_refused(name: str) -> None:
    ending, writer = WRITERS[name]
    refused(f"c{ending}", b"")
    assert refused(f"c{ending}", writer(np.zeros((0, 3)))) == "there are no points in it"


@every
def test_a_file_that_breaks_off_is_refused(name: str) -> None:
    """At any byte; in text a number may lose its last digits, so there the last lines are lost."""
    ending, writer = WRITERS[name]
    data = writer(SOME)
    if name == "xyz":
        said = "Rows ignored: 1 of 201; line 201 has 2 columns; valid are at least 3."
        assert said in [note.en for note in cloud_file.read_cloud("c.xyz", data + b"\n1 2").notes]
        return
    behind = data.rindex(b"\n3 0") if name == "ply text" else len(data) - 5 if "ply" in name else len(data)
    for end in [*range(0, behind, 97), behind - 3]:
        if "text" in name and end > data.rindex(b"\n", 0, behind - 1):
            continue
        refused(f"c{ending}", data[:end])


HUGE = 5_000_001


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("c.ply", ply(SOME, "ascii").replace(b"vertex 200", b"vertex %d" % HUGE)),
        ("c.ply", ply(SOME, "binary_big_endian").replace(b"vertex 200", b"vertex 99999999999999999999")),
        ("c.pcd", pcd(SOME, "ascii").replace(b"POINTS 200", b"POINTS %d" % HUGE)),
        ("c.pcd", pcd(SOME, "binary").replace(b"POINTS 200", b"POINTS 99999999999999999999")),
        ("c.pcd", pcd(SOME, "binary").replace(b"POINTS 200\n", b"").replace(b"HEIGHT 1", b"HEIGHT 99999")),
        ("c.npy", npy(np.lib.stride_tricks.as_strided(np.zeros(3, "f4"), (HUGE, 3), (0, 4)))),
        ("c.xyz", b"0 0 0\n" * HUGE),
    ],
)
def test_too_many_points_are_refused(name: str, data: bytes) -> None:
    assert refused(name, data).startswith("it has ")


def test_a_promise_of_more_than_there_is_is_refused_before_memory_is_taken() -> None:
    data = npy(SOME).replace(b"'shape': (200, 3), }    ", b"'shape': (4999999, 3), }")
    assert refused("c.npy", data) == "it ends before the last of 4999999 points"
    assert refused("c.ply", ply(SOME, "binary_little_endian").replace(b"vertex 200", b"vertex 4999999")).startswith(
        "it ends after "
    )


def test_files_that_are_too_long_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "long.ply"
    with path.open("wb") as file:
        file.truncate(formats.MOST_BYTES + 1)
    with pytest.raises(HelicoideError, match=r"long\.ply cannot be read: it is too long"):
        cloud_file.load_cloud(path)
    assert refused("long.xyz", bytes(formats.MOST_BYTES + 1)) == "it is too long"


@pytest.mark.parametrize("kind", ["npz", "pcd"])
def test_small_files_that_unpack_to_huge_ones_are_refused(kind: str) -> None:
    if kind == "npz":
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("points.npy", bytes(formats.MOST_BYTES + 1))
        data = file.getvalue()
        assert len(data) < 1_000_000
    else:
        data = pcd(SOME, "binary_compressed").replace(b"COUNT 1 4 1 3 1", b"COUNT 1 4 1 30000000 1")
        at = data.index(b"compressed\n") + len(b"compressed\n") + 4
        data = data[:at] + b"\xff\xff\xff\xff" + data[at + 4 :]
    assert refused(f"c.{kind}", data).startswith("it unpacks to ")


def test_a_file_is_read_from_its_path(tmp_path: Path) -> None:
    path = tmp_path / "cloud.pcd"
    path.write_bytes(pcd(SOME, "binary"))
    np.testing.assert_array_equal(cloud_file.load_cloud(path, "mm").points, SOME * 1e-3)
    with pytest.raises(HelicoideError, match=r"none\.pcd cannot be read: there is no such file"):
        cloud_file.load_cloud(tmp_path / "none.pcd")
    with pytest.raises(HelicoideError, match="Valid are"):
        cloud_file.load_cloud(tmp_path)


@every
def test_millimetres_become_metres(name: str) -> None:
    ending, writer = WRITERS[name]
    cloud = cloud_file.read_cloud(f"c{ending}", writer(1000 * SOME), "mm")
    np.testing.assert_allclose(cloud.points, SOME, rtol=1e-15)
    assert "2,92" in cloud_file.read_cloud("c.npy", npy(SOME[:2] * 0 + [[0, 0, 0], [2.92, 1, 1]])).description.pt_BR


@pytest.mark.parametrize("encoding", ["ascii", "binary"])
def test_what_trimesh_writes_is_read(encoding: str) -> None:
    cloud = cloud_file.read_cloud("c.ply", by_trimesh(SOME, encoding))
    np.testing.assert_allclose(cloud.points, SOME, atol=5e-7)


# 300 points of a grid 20 × 15 as a file of PCL holds them, packed by liblzf: repeats short and long.
BY_LIBLZF = base64.b64decode(
    "DwAAAADNzMw9zcxMPpqZmT4gCwA+IBIIP5qZGT8zMzM/IBcHP2ZmZj8AAIAgCwCMIBcAmSAPAKYgGwCzIBMAwCATAMwgEwDZIBMA5iATAPMgE+D/"
    "T+H/P+L/L+P/H+Q5X+BDACCPJPvgQwMATCVD4EEDIz/gRAMg6+BEAyGLRfPgQANFN+BDA0bD4EMDIdvgRANHW+BDA0en4EMDR/PgQwMiz+BEA0iL"
    "4EMDSNfgQwMjbwA84P8D4f8H4f8H4f8H4YEHAcw8"
)


def test_what_liblzf_packed_is_unpacked() -> None:
    head = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 20\nHEIGHT 15\nDATA binary_compressed\n"
    lengths = np.array([len(BY_LIBLZF), 3600], dtype="<u4").tobytes()
    cloud = cloud_file.read_cloud("c.pcd", head.encode() + lengths + BY_LIBLZF)
    i = np.arange(300)
    expected = np.stack([i % 20, i // 20, np.full(300, 0.25)], axis=1).astype("f4") / np.float32(10)
    np.testing.assert_array_equal(cloud.points, expected)


@given(packed=st.binary(max_size=60), size=st.integers(0, 100))
def test_no_packed_bytes_are_written_beyond_their_place(packed: bytes, size: int) -> None:
    """The kernel does as the plain function does, whose indices are checked."""
    source = np.frombuffer(bytearray(packed), dtype=np.uint8)
    here, there = np.zeros(size, np.uint8), np.zeros(size, np.uint8)
    assert unpack_kernel(source, here) == python_function(unpack_kernel)(source, there)
    np.testing.assert_array_equal(here, there)


@pytest.mark.parametrize("name", WRITERS)
@settings(max_examples=150)
@given(data=st.data())
def test_damaged_files_are_read_or_refused(name: str, data: st.DataObject) -> None:
    """Bytes changed, lost and added anywhere; mostly in the header, which is what is understood."""
    ending, writer = WRITERS[name]
    damaged = bytearray(writer(SOME[:4]))
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(damaged)))
        lost, added = data.draw(st.integers(0, 3)), data.draw(st.binary(max_size=3))
        damaged[at : at + lost] = added
    with suppress(HelicoideError):
        cloud = cloud_file.read_cloud(f"c{ending}", bytes(damaged))
        assert np.isfinite(cloud.points).all()
        assert len(cloud.points) > 0


TEXTS = {
    "blanks": "1.5 -2 3e-1\n 4 5 6\n",
    "tabs and more columns": "1.5\t-2\t.3\t255\t0\n4\t5\t6\t1\t1",
    "commas": "1.5,-2,0.3\n4,5,6",
    "commas and blanks": "1.5, -2, 0.3\r\n4, 5, 6\r\n",
    "semicolons": "1.5;-2;0.3\n4;5;6",
    "decimal commas": "1,5;-2;0,3\n4;5;6",
    "decimal commas, blanks": "1,5 -2,0 0,3\n4,0 5,0 6,0",
    "names first": "X;Y;Z\n1,5;-2;0,3\n4;5;6",
    "names first, commas": "x,y,z\n1.5,-2,0.3\n4,5,6",
    "comments": "# from a camera\n// 2 points\n\n1.5 -2 0.3 # first\n\n4 5 6",
    "byte order mark": "\ufeff1.5 -2 0.3\n4 5 6",
}


@pytest.mark.parametrize("case", TEXTS)
def test_text_in_the_ways_that_people_write_it(case: str) -> None:
    cloud = cloud_file.read_cloud("c.csv", TEXTS[case].encode())
    np.testing.assert_array_equal(cloud.points, [[1.5, -2, 0.3], [4, 5, 6]])


def test_a_first_line_of_holes_is_not_one_of_names() -> None:
    cloud = cloud_file.read_cloud("c.txt", b"nan NaN -inf\n1 2 3\n")
    assert (len(cloud.points), cloud.dropped) == (1, 1)


@pytest.mark.parametrize("between", [" ", ";"])
def test_decimal_commas_keep_every_digit(between: str) -> None:
    np.testing.assert_array_equal(cloud_file.read_cloud("c.txt", xyz(SOME, between, ",")).points, SOME)


def bare(lines: str) -> bytes:
    return f"ply\nformat ascii 1.0\n{lines}end_header\n1 2 3\n".encode()


XYZ = "property float x\nproperty float y\nproperty float z\n"
SAID = {
    "another ending": ("c.stl", b"", "no format has names that end in .stl"),
    "no ply": ("c.ply", b"PLY\nend_header\n", "none of PLY"),
    "no end": ("c.ply", b"ply\nformat ascii 1.0\n", "none of PLY"),
    "no format": ("c.ply", b"ply\nelement vertex 1\nend_header\n", "none of PLY"),
    "another version": ("c.ply", b"ply\nformat ascii 2.0\nend_header\n", "does not know: 'format ascii 2.0'"),
    "no vertex": ("c.ply", bare("element face 3\n"), "no element vertex"),
    "no z": ("c.ply", bare("element vertex 1\nproperty float x\nproperty float y\n"), "no column z, only x, y"),
    "lists of broken lengths": ("c.ply", bare(f"element vertex 1\nproperty list float int i\n{XYZ}"), "does not know"),
    "a list that ends too early": (
        "c.ply",
        bare(f"element vertex 1\nproperty list uchar int i\n{XYZ}"),
        "line 9 has 2 columns",
    ),
    "a type": ("c.ply", bare("element vertex 1\nproperty quad x\n"), "does not know: 'property quad x'"),
    "words": ("c.ply", bare(f"element vertex 1\n{XYZ}").replace(b"1 2 3", b"1 two 3"), "two"),
    "two columns": ("c.ply", bare(f"element vertex 1\n{XYZ}").replace(b"1 2 3", b"1 2"), "column"),
    "no pcd": ("c.pcd", b"ply", "none of PCD"),
    "a kind": ("c.pcd", pcd(SOME, "zip"), "its DATA is 'zip'"),
    "a size": ("c.pcd", pcd(SOME, "ascii").replace(b"SIZE 8", b"SIZE 3"), "field x .* SIZE 3"),
    "a column less": ("c.pcd", pcd(SOME, "ascii").replace(b"COUNT 1", b"COUNT"), "not equally many"),
    "no count": ("c.pcd", pcd(SOME, "ascii").replace(b"POINTS 200", b"").replace(b"WIDTH", b"W"), "how many points"),
    "no y": ("c.pcd", pcd(SOME, "binary").replace(b"x _ y", b"x _ v"), "no column y, only x, _, v"),
    "no y, packed": ("c.pcd", pcd(SOME, "binary_compressed").replace(b"x _ y", b"x _ v"), "no column y"),
    "no npy": ("c.npy", b"\x93NUMPX", "none of NPY"),
    "two columns of npy": ("c.npy", npy(SOME[:, :2]), "shape (200, 2)"),
    "one row": ("c.npy", npy(SOME[0]), "shape (3,)"),
    "words of npy": ("c.npy", npy(np.array([["a", "b", "c"]])), "real numbers"),
    "complex": ("c.npy", npy(SOME * 1j), "real numbers"),
    "objects": ("c.npy", npy(np.array([[1, None, 2]], dtype=object)), "real numbers"),
    "no zip": ("c.npz", npy(SOME), "it is damaged, or no .npz"),
    "many arrays": ("c.npz", npz(SOME).replace(b"points", b"pxints"), "it holds colours, pxints"),
    "binary": ("c.txt", npy(SOME), "no text"),
    "latin": ("c.txt", "1 2 é".encode("latin-1"), "begins “1 2 é”"),
    "a word": ("c.txt", b"1 2 3\n1 2 three\n", "three"),
    "short lines": ("c.txt", b"1 2\n3 4\n", "no row of three numbers"),
    "names alone": ("c.txt", b"x y z\n", "no points"),
    "comments alone": ("c.txt", b"# 1 2 3\n", "no points"),
}


@pytest.mark.parametrize("case", SAID)
def test_what_is_wrong_with_a_file_is_said(case: str) -> None:
    name, data, said = SAID[case]
    answer = refused(name, data)
    if ".*" in said:
        begin, _, end = said.partition(".*")
        assert begin.strip() in answer
        said = end.strip()
    assert said in answer


def test_pictures_of_depth_cameras_and_other_numbers_are_read() -> None:
    picture = SOME.reshape(20, 10, 3)
    np.testing.assert_array_equal(cloud_file.read_cloud("c.npy", npy(picture)).points, SOME)
    np.testing.assert_array_equal(cloud_file.read_cloud("c.npy", npy(np.asfortranarray(picture))).points, SOME)
    np.testing.assert_array_equal(
        cloud_file.read_cloud("c.npy", npy(np.array([[1, 2, 3]], ">i2")), "mm").points * 1000, [[1, 2, 3]]
    )
    alone = io.BytesIO()
    np.savez(alone, SOME.astype("f4"))
    np.testing.assert_array_equal(cloud_file.read_cloud("c.npz", alone.getvalue()).points, SOME.astype("f4"))


@pytest.mark.parametrize("kind", ["ascii", "binary", "binary_compressed"])
def test_of_a_field_of_several_numbers_the_first_is_taken(kind: str) -> None:
    head = f"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 2 1 1\nPOINTS 2\nDATA {kind}\n".encode()
    rows = np.array([[1, 9, 2, 3], [4, 9, 5, 6]], dtype="<f4")
    fields = packed(np.array([1, 9, 4, 9, 2, 5, 3, 6], dtype="<f4").tobytes())
    lengths = np.array([len(fields), 32], dtype="<u4").tobytes()
    text = b"1 9 2 3\n4 9 5 6\n"
    data = {"ascii": text, "binary": rows.tobytes(), "binary_compressed": lengths + fields}[kind]
    np.testing.assert_array_equal(cloud_file.read_cloud("c.pcd", head + data).points, [[1, 2, 3], [4, 5, 6]])


def test_every_format_has_a_title_and_endings_of_its_own() -> None:
    assert len(formats.formats_by_ending()) == sum(len(module.ENDINGS) for module in formats.cloud_formats())
    texts = {".xyz", ".txt", ".csv", ".pts", ".asc", ".tsv"}
    assert {".ply", ".pcd", ".npy", ".npz", ".las", ".laz", *texts} == set(formats.formats_by_ending())
