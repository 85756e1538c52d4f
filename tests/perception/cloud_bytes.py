"""Clouds written as files of every format, by the tests' own hands."""

from __future__ import annotations

import io
import struct
from collections.abc import Callable

import numpy as np
import trimesh

from helicoide.arrays import Array

Writer = Callable[[Array], bytes]


def packed(data: bytes) -> bytes:
    """LZF without repeats: literal runs of up to 32 bytes."""
    runs = [data[i : i + 32] for i in range(0, len(data), 32)]
    return b"".join(bytes([len(run) - 1]) + run for run in runs)


def ply(points: Array, encoding: str) -> bytes:
    """With a colour behind, and an element before and one of lists after the points."""
    head = f"ply\nformat {encoding} 1.0\ncomment by hand\nelement camera 2\nproperty int16 id\nproperty double f\n"
    head += f"element vertex {len(points)}\nproperty uchar red\nproperty float64 x\nproperty float64 y\n"
    head += "property float64 z\nproperty int quality\nelement face 1\nproperty list uchar int vertex_indices\n"
    head += "end_header\n"
    if encoding == "ascii":
        rows = [f"7 {x!r} {y!r} {z!r} -9" for x, y, z in points.tolist()]
        return (head + "\n".join(["1 2.5", "2 2.5", *rows, "3 0 1 2"]) + "\n").encode()
    order = "<" if "little" in encoding else ">"
    cameras = np.zeros(2, dtype=[("id", f"{order}i2"), ("f", f"{order}f8")])
    kind = [("red", "u1"), *((axis, f"{order}f8") for axis in "xyz"), ("quality", f"{order}i4")]
    return head.encode() + cameras.tobytes() + _rows(points, kind).tobytes() + b"\3\0\0\0\0"


def _rows(points: Array, kind: list[tuple[str, str]]) -> np.ndarray[tuple[int], np.dtype[np.void]]:
    rows = np.zeros(len(points), dtype=kind)
    for axis, column in zip("xyz", points.T, strict=True):
        rows[axis] = column
    return rows


def pcd(points: Array, kind: str) -> bytes:
    """An organised picture with padding and a histogram between the coordinates."""
    head = "# .PCD v0.7\nVERSION 0.7\nFIELDS x _ y hist z\nSIZE 8 1 8 2 8\nTYPE F U F I F\nCOUNT 1 4 1 3 1\n"
    head += f"WIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\nDATA {kind}\n"
    if kind == "ascii":
        rows = [f"{x!r} 0 0 0 0 {y!r} 5 6 7 {z!r}" for x, y, z in points.tolist()]
        return (head + "\n".join(rows) + "\n").encode()
    layout = [("x", "<f8"), ("_", "<u1", 4), ("y", "<f8"), ("hist", "<i2", 3), ("z", "<f8")]
    rows = np.zeros(len(points), dtype=layout)
    for axis, column in zip("xyz", points.T, strict=True):
        rows[axis] = column
    if kind == "binary":
        return head.encode() + rows.tobytes()
    fields = b"".join(np.ascontiguousarray(rows[name[0]]).tobytes() for name in layout)
    small = packed(fields)
    return head.encode() + np.array([len(small), len(fields)], dtype="<u4").tobytes() + small


def las(points: Array, version: int = 2, origin: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> bytes:
    """LAS 1.2 with points of 20 bytes, or 1.4 with 30, in steps of 0.1 mm, below one record of variable length."""
    head, row = (375, 30) if version == 4 else (227, 20)
    data = bytearray(head + 60)
    data[:4], data[24:26] = b"LASF", bytes([1, version])
    struct.pack_into("<HIIBHI", data, 94, head, head + 60, 1, 6 if version == 4 else 0, row, len(points) % 2**32)
    struct.pack_into("<6d", data, 131, 1e-4, 1e-4, 1e-4, *origin)
    if version == 4:
        struct.pack_into("<I", data, 107, 0)
        struct.pack_into("<Q", data, 247, len(points))
    rows = np.zeros(len(points), dtype=[("place", "<i4", 3), ("rest", "u1", row - 12)])
    rows["place"] = np.round((points - origin) / 1e-4)
    return bytes(data) + rows.tobytes()


def npy(points: Array) -> bytes:
    file = io.BytesIO()
    np.save(file, points)
    return file.getvalue()


def npz(points: Array) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, points=points, colours=np.zeros(3))
    return file.getvalue()


def xyz(points: Array, between: str = " ", mark: str = ".") -> bytes:
    rows = [between.join(repr(value).replace(".", mark) for value in row) for row in points.tolist()]
    return "\n".join(rows).encode()


WRITERS: dict[str, tuple[str, Writer]] = {
    "ply text": (".ply", lambda points: ply(points, "ascii")),
    "ply little": (".PLY", lambda points: ply(points, "binary_little_endian")),
    "ply big": (".ply", lambda points: ply(points, "binary_big_endian")),
    "pcd text": (".pcd", lambda points: pcd(points, "ascii")),
    "pcd binary": (".pcd", lambda points: pcd(points, "binary")),
    "pcd packed": (".pcd", lambda points: pcd(points, "binary_compressed")),
    "xyz": (".xyz", xyz),
    "npy": (".npy", npy),
    "npz": (".npz", npz),
}


def by_trimesh(points: Array, encoding: str) -> bytes:
    """As trimesh writes PLY, in single precision."""
    return bytes(trimesh.PointCloud(points).export(file_type="ply", encoding=encoding))
