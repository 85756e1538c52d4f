"""Point clouds from files: the format by the file's ending, limits of size, and errors."""

from __future__ import annotations

import struct
import zipfile
import zlib
from dataclasses import replace
from pathlib import Path

from helicoide.files import text_file
from helicoide.perception import formats
from helicoide.perception.broken import BrokenFile
from helicoide.perception.cloud import FARTHEST, PointCloud, cloud_from_rows
from helicoide.perception.formats import MOST_BYTES, MOST_POINTS
from helicoide.perception.units import Unit, detect_unit
from helicoide.text import LANGUAGES, HelicoideError, Text, join_texts

# Exceptions of the parsers for a damaged file.
_OF_PARSERS = (ValueError, ArithmeticError, LookupError, RuntimeError, OSError, EOFError, MemoryError)
_OF_ARCHIVES = (zlib.error, zipfile.BadZipFile, struct.error)


def load_cloud(path: Path, unit: Unit | None = None) -> PointCloud:
    """The cloud in a file. Raises HelicoideError with what is wrong with the file and what is valid."""
    try:
        data = text_file.read_bytes(path, MOST_BYTES)
    except HelicoideError as error:
        raise _refusal(path.name, error.text) from error
    return read_cloud(path.name, data, unit)


def read_cloud(name: str, data: bytes, unit: Unit | None = None) -> PointCloud:
    """The cloud in the bytes of a file; the ending of its name determines the format.

    unit: unit of its numbers; None: the unit stated in the file, else one guessed from the numbers. Points without
    finite coordinates are dropped and counted. Raises HelicoideError with what is wrong and what is valid.
    """
    ending = Path(name).suffix.lower()
    if ending not in formats.formats_by_ending():
        raise _refusal(name, _ENDING.format(ending=ending or "–"))
    if len(data) > MOST_BYTES:
        raise _refusal(name, _TOO_LONG)
    try:
        raw = formats.formats_by_ending()[ending].coordinates(data)
    except BrokenFile as broken:
        raise _refusal(name, broken.text) from broken
    except (*_OF_PARSERS, *_OF_ARCHIVES) as error:
        raise _refusal(name, _DAMAGED.format(ending=ending)) from error
    try:
        taken, why = detect_unit(raw.rows, unit, raw.unit)
    except BrokenFile as broken:  # the format is the right one
        raise HelicoideError(_UNREAD.format(name=name, reason=broken.text)) from broken
    cloud = cloud_from_rows(raw.rows, taken)
    if not len(cloud.points):
        raise _refusal(name, _NO_POINTS if not cloud.dropped else _ALL_HOLES.format(n=cloud.dropped))
    return replace(cloud, notes=(_extent(cloud, why), *raw.notes, *_left_out(cloud)))


def _extent(cloud: PointCloud, why: Text) -> Text:
    """A sentence with the unit and the range of the coordinates."""
    lower, upper = cloud.points.min(axis=0), cloud.points.max(axis=0)
    ends = {f"{axis}{k}": end[i] for k, end in enumerate((lower, upper)) for i, axis in enumerate("xyz")}
    return Text(
        en="{why}: x {x0:.2f} to {x1:.2f}, y {y0:.2f} to {y1:.2f}, z {z0:.2f} to {z1:.2f} m.",
        pt_BR="{why}: x de {x0:.2f} a {x1:.2f}, y de {y0:.2f} a {y1:.2f}, z de {z0:.2f} a {z1:.2f} m.",
    ).format(why=why, **ends)


def _left_out(cloud: PointCloud) -> tuple[Text, ...]:
    if not cloud.dropped:
        return ()
    return (
        Text(
            en="Left out, without coordinates within {far:.0f} m: {n}.",
            pt_BR="Descartados, sem coordenadas a até {far:.0f} m: {n}.",
        ).format(n=cloud.dropped, far=FARTHEST),
    )


_UNREAD = Text(en="{name} cannot be read: {reason}.", pt_BR="Não dá para ler {name}: {reason}.")
_VALID = Text(
    en=" Valid are {valid}, with at most {points:.0f} million points and {bytes:.0f} MB.",
    pt_BR=" Valem {valid}, com no máximo {points:.0f} milhões de pontos e {bytes:.0f} MB.",
)
_TOO_LONG = Text(en="it is too long", pt_BR="é longo demais")
_ENDING = Text(en="no format has names that end in {ending}", pt_BR="nenhum formato tem nomes que terminam em {ending}")
_DAMAGED = Text(en="it is damaged, or no {ending}", pt_BR="está danificado ou não é {ending}")
_NO_POINTS = Text(en="there are no points in it", pt_BR="não há pontos nele")
_ALL_HOLES = Text(
    en="none of its {n} points has finite coordinates", pt_BR="nenhum dos seus {n} pontos tem coordenadas finitas"
)


def _refusal(name: str, reason: Text) -> HelicoideError:
    titles = {
        language: ", ".join(module.TITLE[language] for module in formats.cloud_formats()) for language in LANGUAGES
    }
    valid = _VALID.format(valid=Text(**titles), points=MOST_POINTS / 1e6, bytes=MOST_BYTES / 1e6)
    return HelicoideError(join_texts([_UNREAD.format(name=name, reason=reason), valid], by=""))
