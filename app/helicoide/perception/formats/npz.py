"""NPZ, several arrays of numpy: the one named points, or the only one."""

from __future__ import annotations

import io
import zipfile

from helicoide.kinematics.chain import Array
from helicoide.perception.formats import MOST_BYTES, Broken, npy
from helicoide.text import Text

TITLE = Text(en="NPZ (with an array points)", pt_BR="NPZ (com uma matriz points)")
ENDINGS = (".npz",)

_POINTS = "points.npy"


def coordinates(data: bytes) -> Array:
    """Rows x, y, z (k, 3)."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        names = archive.namelist()
        if _POINTS not in names and len(names) != 1:
            raise Broken(
                Text(
                    en="it holds {names}; valid is an array points, or one alone",
                    pt_BR="contém {names}; vale uma matriz points, ou uma só",
                ).format(names=", ".join(name.removesuffix(".npy") for name in names[:10]) or "—")
            )
        name = _POINTS if _POINTS in names else names[0]
        if (size := archive.getinfo(name).file_size) > MOST_BYTES:
            raise Broken(Text(en="it unpacks to {n} bytes", pt_BR="descomprime em {n} bytes").format(n=size))
        return npy.coordinates(archive.read(name))
