"""NPZ, several arrays of numpy: the array whose name means points is read, or the only one."""

from __future__ import annotations

import io
import zipfile

from helicoide.perception.broken import BrokenFile
from helicoide.perception.formats import MOST_BYTES, RawPoints, npy
from helicoide.perception.text.names import shortened_list
from helicoide.text import Text

TITLE = Text(en="NPZ (with an array points)", pt_BR="NPZ (com uma matriz points)")
ENDINGS = (".npz",)

# Usual names of the array of points.
NAMES = ("points", "xyz", "point_cloud", "pointcloud", "cloud", "pcd", "vertices", "coords", "coordinates", "positions")


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3)."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        held = {name.removesuffix(".npy"): name for name in reversed(archive.namelist())}
        lower = {name.lower(): name for name in held}
        chosen = next((lower[name] for name in NAMES if name in lower), None)
        if chosen is None and len(held) != 1:
            raise BrokenFile(
                Text(
                    en="it holds {names}; valid is an array points or xyz, or one alone",
                    pt_BR="contém {names}; vale uma matriz points ou xyz, ou uma só",
                ).format(names=shortened_list(sorted(held)) or "–")
            )
        name = held[chosen] if chosen is not None else next(iter(held.values()))
        if (size := archive.getinfo(name).file_size) > MOST_BYTES:
            raise BrokenFile(Text(en="it unpacks to {n} bytes", pt_BR="descomprime em {n} bytes").format(n=size))
        return npy.coordinates(archive.read(name))
