"""Point clouds from files: which format a file has, what it may be at most, and what is wrong with it."""

from __future__ import annotations

import struct
import zipfile
import zlib
from pathlib import Path

from helicoide.perception import formats
from helicoide.perception.cloud import Cloud, Unit, cloud_of
from helicoide.perception.formats import MOST_BYTES, MOST_POINTS, Broken
from helicoide.text import HelicoideError, Text

# What the parsers below the formats raise when a file is not what it says.
_OF_PARSERS = (ValueError, ArithmeticError, LookupError, RuntimeError, OSError, EOFError, MemoryError)
_OF_ARCHIVES = (zlib.error, zipfile.BadZipFile, struct.error)


def load(path: Path, unit: Unit = "m") -> Cloud:
    """The cloud in a file. Raises HelicoideError: what is wrong with the file, and what is valid."""
    try:
        if path.stat().st_size > MOST_BYTES:
            raise _refusal(path.name, _TOO_LONG)
        data = path.read_bytes()
    except OSError as error:
        raise _refusal(path.name, str(error.strerror)) from error
    return read(path.name, data, unit)


def read(name: str, data: bytes, unit: Unit = "m") -> Cloud:
    """The cloud in the bytes of a file; the ending of its name says the format, `unit` what its numbers count.

    Points without finite coordinates are dropped and counted. Raises HelicoideError: what is wrong with the file, and
    what is valid.
    """
    ending = Path(name).suffix.lower()
    if ending not in formats.endings():
        raise _refusal(name, Text(en="its name does not end so", pt_BR="o nome não termina assim"))
    if len(data) > MOST_BYTES:
        raise _refusal(name, _TOO_LONG)
    try:
        cloud = cloud_of(formats.endings()[ending].coordinates(data), unit)
    except Broken as broken:
        raise _refusal(name, broken.text) from broken
    except (*_OF_PARSERS, *_OF_ARCHIVES) as error:
        raise _refusal(name, str(error) or type(error).__name__) from error
    if not len(cloud.points):
        raise _refusal(
            name,
            Text(
                en="none of its {n} points has finite coordinates",
                pt_BR="nenhum dos seus {n} pontos tem coordenadas finitas",
            ).format(n=cloud.dropped)
            if cloud.dropped
            else Text(en="there are no points in it", pt_BR="não há pontos nele"),
        )
    return cloud


_TOO_LONG = Text(en="it is too long", pt_BR="é longo demais")


def _refusal(name: str, reason: Text | str) -> HelicoideError:
    titles = [module.TITLE for module in formats.found()]
    valid = Text(en=", ".join(title.en for title in titles), pt_BR=", ".join(title.pt_BR for title in titles))
    return HelicoideError(
        Text(
            en="{name} cannot be read: {reason}. Valid are {valid}, with at most {points:.0f} million points and "
            "{bytes:.0f} MB.",
            pt_BR="Não dá para ler {name}: {reason}. Valem {valid}, com no máximo {points:.0f} milhões de pontos e "
            "{bytes:.0f} MB.",
        ).format(name=name, reason=reason, valid=valid, points=MOST_POINTS / 1e6, bytes=MOST_BYTES / 1e6)
    )
