"""Clouds as other programs write them, and what is read of each: the same ceiling, or why not."""

from __future__ import annotations

import io
from collections.abc import Callable

import numpy as np
import pytest
from tests.perception.cloud_bytes import las, npy

from helicoide.arrays import Array
from helicoide.perception import cloud_file
from helicoide.perception.enclosure_reading import PLANE_READINGS, plane_in_cloud
from helicoide.perception.planes import FoundPlane, find_plane
from helicoide.perception.units import METRES, UNITS, Unit
from helicoide.text import HelicoideError

RNG = np.random.default_rng(5)
CEILING = 0.700
POINTS = np.column_stack(
    [RNG.uniform(0.2, 0.9, 400), RNG.uniform(-0.3, 0.3, 400), RNG.normal(CEILING, 5e-4, 400)]
).round(6)
X, Y, Z = POINTS.T
N = len(POINTS)
COUNT, TIMES, BRIGHT = range(N), 0.033 * np.arange(N), RNG.integers(0, 255, N)
INSIDE = np.array([0.5, 0.0, 0.2])


def rows(*columns: object, between: str = ",", end: str = "\n") -> str:
    """Lines of columns side by side."""
    lists = [column.tolist() if isinstance(column, np.ndarray) else list(column) for column in columns]  # type: ignore[call-overload]
    return end.join(between.join(map(str, row)) for row in zip(*lists, strict=True)) + end


def points(scale: float = 1.0, between: str = ",") -> str:
    return rows(*(scale * POINTS.T).round(6), between=between)


PLAIN = points(between=" ")
QUOTED = "\n".join(",".join(f'"{value}"' for value in row) for row in POINTS.tolist())
TEXTS: dict[str, tuple[str, str | bytes]] = {
    "an index with names": (".csv", ",x,y,z\n" + rows(COUNT, X, Y, Z)),
    "an index without names": (".csv", rows(COUNT, X, Y, Z)),
    "an index from one, and colours": (".txt", rows(range(1, N + 1), X, Y, Z, BRIGHT, BRIGHT, between=" ")),
    "names that are numbers": (".csv", ",0,1,2\n" + rows(COUNT, X, Y, Z)),
    "row names": (".txt", '"x" "y" "z"\n' + rows([f'"{k + 1}"' for k in COUNT], X, Y, Z, between=" ")),
    "time first": (".csv", "timestamp,x,y,z\n" + rows(TIMES, X, Y, Z)),
    "dates first": (".csv", rows([f"2024-01-01T10:00:{k % 60:02}" for k in COUNT], X, Y, Z)),
    "brightness first": (".csv", "intensity,X,Y,Z\n" + rows(BRIGHT, X, Y, Z)),
    "z first": (".csv", "z,y,x\n" + rows(Z, Y, X)),
    "z first in a comment": (".xyz", "# z y x\n" + rows(Z, Y, X, between=" ")),
    "//X": (".asc", "//X Y Z R G B\n" + rows(X, Y, Z, BRIGHT, BRIGHT, BRIGHT, between=" ")),
    "//Z,Y,X": (".txt", "//Z,Y,X\n" + rows(Z, Y, X)),
    "Points:0": (".csv", '"Scalar 1","Points:0","Points:1","Points:2"\n' + rows(BRIGHT, X, Y, Z)),
    "normals first": (".csv", "nx,ny,nz,x,y,z\n" + rows(0 * X, 0 * X, 0 * X + 1, X, Y, Z)),
    "normal_x first": (".csv", "normal_x,normal_y,normal_z,pos_x,pos_y,pos_z\n" + rows(Z, Z, Z, X, Y, Z)),
    "camel case": (".csv", "Id;PosX;PosY;PosZ\n" + rows(BRIGHT, X, Y, Z, between=";")),
    "digits in names": (".csv", "x,y,z,scalar1,scalar2\n" + rows(X, Y, Z, BRIGHT, BRIGHT)),
    "a title and names": (".csv", "Scan of the room, 3 May 2024\nz,y,x\n" + rows(Z, Y, X)),
    "a line of units": (".csv", "x;y;z\n[m];[m];[m]\n" + points(between=";")),
    "quoted": (".csv", '"x","y","z"\n' + QUOTED),
    "quoted decimal commas": (".csv", QUOTED.replace(".", ",")),
    "decimal commas": (".csv", "x;y;z\n" + points(between=";").replace(".", ",")),
    "decimal commas and tabs": (".tsv", points(between="\t").replace(".", ",")),
    "whole numbers first": (".txt", "1 0 0\n" + PLAIN.replace(".", ",")),
    "a count": (".pts", f"{N}\n" + rows(X, Y, Z, -BRIGHT, BRIGHT, BRIGHT, BRIGHT, between=" ")),
    "line ends of the Mac": (".xyz", PLAIN.replace("\n", "\r")),
    "line ends of Windows": (".xyz", PLAIN.replace("\n", "\r\n")),
    "Latin-1": (".txt", f"# câmera à esquerda\n{PLAIN}".encode("latin-1")),
    "UTF-16": (".txt", PLAIN.encode("utf-16")),
    "UTF-16 without a mark": (".txt", PLAIN.encode("utf-16-be")),
    "UTF-32": (".txt", PLAIN.encode("utf-32")),
    "obj": (".txt", rows(["v"] * N, X, Y, Z, between=" ")),
    "sorted by x": (".txt", rows(*POINTS[np.argsort(X)].T, between=" ")),
    "a picture with colours": (".txt", rows(*POINTS[np.lexsort((X, np.arange(N) // 50))].T, BRIGHT, between=" ")),
}


def ceiling(name: str, data: bytes, unit: Unit | None = None) -> FoundPlane:
    """The plane that is found in a file; it is the ceiling."""
    cloud = cloud_file.read_cloud(name, data, unit)
    found = find_plane(cloud.points, PLANE_READINGS[0].normal, INSIDE)
    assert isinstance(found, FoundPlane), (found, cloud.notes)
    assert -found.plane.offset == pytest.approx(CEILING, abs=0.002)
    assert found.share > 0.99
    return found


@pytest.mark.parametrize("case", TEXTS)
def test_the_ceiling_is_found_in_text_of_every_kind(case: str) -> None:
    ending, text = TEXTS[case]
    ceiling(f"c{ending}", text.encode() if isinstance(text, str) else text)


def head(lines: str) -> bytes:
    return f"ply\nformat {lines}end_header\n".encode()


XYZ = "property float x\nproperty float y\nproperty float z\n"
LIST = "property list uint ushort seen\n"


def uneven(order: str, first: bool) -> bytes:
    """Points as bytes with lists of zero to two numbers before or behind them."""
    kind = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    data = head(f"{kind} 1.0\nelement vertex {N}\n{LIST + XYZ if first else XYZ + LIST}")
    for k, row in enumerate(POINTS):
        seen = np.array([k % 3], f"{order}u4").tobytes() + np.arange(k % 3).astype(f"{order}u2").tobytes()
        place = row.astype(f"{order}f4").tobytes()
        data += seen + place if first else place + seen
    return data


def faces_first(encoding: str) -> bytes:
    lines = f"{encoding} 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex {N}\n{XYZ}"
    if encoding == "ascii":
        return head(lines) + f"3 0 1 2\n4 0 1 2 3\n{PLAIN}".encode()
    faces = b"\3" + np.arange(3, dtype="<i4").tobytes() + b"\4" + np.arange(4, dtype="<i4").tobytes()
    return head(lines) + faces + POINTS.astype("<f4").tobytes()


def npz(**arrays: Array) -> bytes:
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


PCD = f"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS {N}\nDATA ascii\n"
FIELDS = np.zeros(N, dtype=[("intensity", "u1"), ("z", "f4"), ("y", "f8"), ("x", "f4")])
FIELDS["x"], FIELDS["y"], FIELDS["z"] = X, Y, Z
FILES: dict[str, tuple[str, Callable[[], bytes]]] = {
    "lists behind the points": (".ply", lambda: uneven("<", False)),
    "lists before the points": (".ply", lambda: uneven("<", True)),
    "lists, big-endian": (".ply", lambda: uneven(">", True)),
    "lists before the points in text": (
        ".ply",
        lambda: (
            head(f"ascii 1.0\nelement vertex {N}\n{LIST}{XYZ}")
            + "".join(f"{k % 3} {'9 ' * (k % 3)}{x} {y} {z}\n" for k, (x, y, z) in enumerate(POINTS.tolist())).encode()
        ),
    ),
    "faces first in text": (".ply", lambda: faces_first("ascii")),
    "faces first": (".ply", lambda: faces_first("binary_little_endian")),
    "capitals": (".ply", lambda: head(f"ascii 1.0\nelement vertex {N}\n{XYZ.replace(' x', ' X')}") + PLAIN.encode()),
    "PLY of the Mac": (
        ".ply",
        lambda: (head(f"ascii 1.0\nelement vertex {N}\n{XYZ}") + PLAIN.encode()).replace(b"\n", b"\r"),
    ),
    "PCD with decimal commas": (".pcd", lambda: (PCD + PLAIN.replace(".", ",")).encode()),
    "PCD of Windows, with holes": (
        ".pcd",
        lambda: (
            PCD.replace(str(N), str(N + 1)).replace("\n", "\r\n") + "-1.#IND 1.#QNAN nan(ind)\r\n" + PLAIN
        ).encode(),
    ),
    "LAS 1.2": (".las", lambda: las(POINTS)),
    "LAS 1.4, with an origin": (".LAS", lambda: las(POINTS, 4, (1.0, -2.0, 0.5))),
    "homogeneous": (".npy", lambda: npy(np.column_stack([POINTS, np.ones(N)]))),
    "lying": (".npy", lambda: npy(POINTS.T)),
    "with an index": (".npy", lambda: npy(np.column_stack([COUNT, POINTS]))),
    "a picture with colours": (".npy", lambda: npy(np.column_stack([POINTS, BRIGHT]).reshape(20, 20, 4))),
    "fields": (".npy", lambda: npy(FIELDS)),  # type: ignore[arg-type]
    "xyz and rgb": (".npz", lambda: npz(rgb=np.zeros((N, 3)), xyz=POINTS)),
    "Points": (".npz", lambda: npz(labels=np.zeros(N), Points=POINTS)),
}


@pytest.mark.parametrize("case", FILES)
def test_the_ceiling_is_found_in_files_of_every_kind(case: str) -> None:
    ending, data = FILES[case]
    ceiling(f"c{ending}", data())


REFUSED: dict[str, tuple[str, str, str]] = {
    "times without a name": (rows(TIMES, X, Y, Z), "column 1 grows from row to row", "a coluna 1 cresce"),
    "seconds since 1970": (
        rows(np.floor(TIMES) + 1.7e9, X, Y, Z), "column 1 grows from row to row", "a coluna 1 cresce",
    ),
    "brightness without a name": (rows(BRIGHT, X, Y, Z), "column 1 has whole numbers only", "a coluna 1 só tem"),
    "an index and two more": (rows(COUNT, X, Y), "column 1 counts up", "a coluna 1 cresce de um em um"),
    "other names": ("a,b,c\n" + points(), "its columns are named a, b, c; valid", "as colunas se chamam a, b, c"),
    "no z": ("x,y,i\n" + points(), "named x, y, i, and none of them z", "e nenhuma z"),
    "two x": ("x,y,z,x\n" + rows(X, Y, Z, X), "and 2 of them x", "e 2 delas x"),
    "commas between and within": (
        points().replace(".", ",").replace(",-0,", ",-0,0"), "commas both separate", "há vírgulas entre",
    ),
    "fewer than are counted": (f"{N + 9}\n{PLAIN}", f"it ends after {N} of {N + 9}", f"termina após {N} de {N + 9}"),
    "too many bad rows": (
        PLAIN + "1 2 abc\n" * 40, f"line {N + 1}, column 3 holds “abc”; valid is a number", "coluna 3, contém “abc”",
    ),
    "two columns": (rows(X, Y), "no row of three numbers", "não tem linha com três números"),
    "a map": (
        rows(X + 512345.5, Y + 7012345.5, Z), "far from the arm's base, around (512346", "longe da base do braço",
    ),
    "a wide map": (
        rows(90 * X + 512345.5, 90 * Y + 7012345.5, Z), "far from the arm's base", "longe da base do braço",
    ),
    "another origin": (rows(X + 30, Y, Z), "far from the arm's base, around (30", "longe da base do braço"),
    "centimetres, perhaps": (points(100), "whether these are centimetres, inches,", "se são centímetros, polegadas,"),
    "inches, perhaps": (points(1 / 0.0254), "whether these are centimetres, inches,", "se são centímetros"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_told_is_refused_in_both_languages(case: str) -> None:
    text, en, pt_BR = REFUSED[case]
    with pytest.raises(HelicoideError) as refusal:
        cloud_file.read_cloud("c.txt", text.encode())
    assert en in refusal.value.text.en
    assert pt_BR in refusal.value.text.pt_BR


def test_laser_scans_that_cannot_be_read_are_refused_in_both_languages() -> None:
    packed = bytearray(las(POINTS))
    packed[104] |= 0x80
    map_origin = 512345.0, 12345.0, 0.0
    cases = {
        "its points are packed, as in LAZ; valid": bytes(packed),
        "far from the arm's base, around (512345": las(POINTS + np.array(map_origin), 2, map_origin),
        f"it ends after {N - 1} of {N} points": las(POINTS)[:-1],
        "its header breaks off": las(POINTS)[:200],
    }
    for said, data in cases.items():
        with pytest.raises(HelicoideError) as refusal:
            cloud_file.read_cloud("c.laz", data)
        assert said in refusal.value.text.en
        assert refusal.value.text.pt_BR != refusal.value.text.en


@pytest.mark.parametrize("unit", UNITS)
def test_the_unit_that_is_chosen_counts(unit: Unit) -> None:
    ceiling("c.xyz", points(1 / METRES[unit], " ").encode(), unit)


@pytest.mark.parametrize("unit", ["m", "cm", "mm", "in", "ft"])
@pytest.mark.parametrize(
    "names", ["x [{u}],y [{u}],z [{u}]", "X({u}),Y({u}),Z({u})", "x_{u},y_{u},z_{u}", "x,y,z\n{u},{u},{u}"]
)
def test_the_unit_in_the_names_counts(unit: str, names: str) -> None:
    text = f"{names.format(u=unit)}\n{points(1 / METRES['inch' if unit == 'in' else unit])}".encode()
    ceiling("c.csv", text)
    assert "as stated in the file" in cloud_file.read_cloud("c.csv", text).notes[0].en


def test_millimetres_are_known_by_how_they_look_also_beyond_a_thousand() -> None:
    far = points(1000).encode(), rows(1000 * X + 1500, 1000 * Y, 1000 * Z).encode()
    for text in far:
        ceiling("c.csv", text)
        assert (
            cloud_file.read_cloud("c.csv", text)
            .notes[0]
            .pt_BR.startswith("Em milímetros, por estimativa (se estiver errado, escolha")
        )


def test_the_unit_and_the_extent_are_said_with_the_plane() -> None:
    cloud = cloud_file.read_cloud("c.xyz", f"{PLAIN}0.1 zero 0.2\nnan nan nan\n".encode())
    seen, pane = plane_in_cloud(cloud, PLANE_READINGS[0], INSIDE)
    assert pane is not None
    assert (
        "In metres, guessed (if wrong, choose the unit): x 0.20 to 0.90, y -0.30 to 0.30, z 0.70 to 0.70 m."
        in seen.words.en
    )
    assert "Rows ignored: 1 of 402; line 401, column 2 holds “zero”; valid is a number" in seen.words.en
    assert seen.words.en.endswith("Left out, without coordinates within 1000 m: 1.")
    assert "Em metros, por estimativa (se estiver errado, escolha a unidade): x de 0,20 a 0,90" in seen.words.pt_BR
    none, pane = plane_in_cloud(cloud, PLANE_READINGS[1], INSIDE)
    assert pane is None
    assert "In metres, guessed" in none.words.en


def test_columns_that_were_guessed_are_said() -> None:
    def said(text: str) -> str:
        return " ".join(note.en for note in cloud_file.read_cloud("c.csv", text.encode()).notes)

    assert "x, y and z are columns 2, 3 and 4" in said(rows(COUNT, X, Y, Z))
    assert "Columns 2, 3 and 4 were read" in said(rows(["a"] * N, X, Y, Z))
    assert "olumn" not in said(rows(X, Y, Z, BRIGHT))


@pytest.mark.parametrize("huge", ["1e999", "-inf", "1e308", "-1e308"])
def test_numbers_beyond_all_measure_are_holes(huge: str) -> None:
    for text in (f"{huge} {huge} 1e308 1\n{rows(X, Y, Z, BRIGHT, between=' ')}", f"1e308 {huge} {huge}\n{PLAIN}"):
        cloud = cloud_file.read_cloud("c.txt", text.encode())
        np.testing.assert_array_equal(cloud.points, POINTS)
        assert cloud.dropped == 1


def test_an_empty_cell_moves_no_other() -> None:
    cloud = cloud_file.read_cloud("c.csv", f"0.1,,0.7,128\n{rows(X, Y, Z, BRIGHT)}".encode())
    np.testing.assert_array_equal(cloud.points, POINTS)
    assert cloud.dropped == 1
