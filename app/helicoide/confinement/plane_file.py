"""The file of planes, in TOML: name, normal and a point of each, in metres."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence

import msgspec
import numpy as np

from helicoide.arrays import frozen
from helicoide.confinement.plane_input import FARTHEST
from helicoide.confinement.planes import Planes
from helicoide.files import toml
from helicoide.files.text_file import decode_utf8 as text_of
from helicoide.text import HelicoideError, Text

# Largest number of planes, and of bytes of a file.
MOST, MOST_BYTES = 32, 100_000
# A normal whose length differs from 1 by no more is not scaled, so that saved planes are read back exactly.
UNIT = 1e-12
_HEAD = """\
# Planes n·r = d that confine an arm. normal: towards the inside, of any length; centre_m: a point of the plane, where
# its pane is shown, in metres, in the frame of the arm's base.
"""
_VALID = Text(
    en="{name} is not a plane file: {reason}. A plane file is TOML with 1 to {most} tables [[planes]], each with a "
    'unique name, a nonzero normal and a point within {far:g} m: name = "+z", normal = [0, 0, -1], centre_m = [0.5, '
    "0, 0.6].",
    pt_BR="{name} não é um arquivo de planos: {reason}. Um arquivo de planos é TOML com 1 a {most} tabelas "
    '[[planes]], cada uma com nome único, normal diferente de zero e um ponto a até {far:g} m: name = "+z", normal = '
    "[0, 0, -1], centre_m = [0.5, 0, 0.6].",
)


class PlaneEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """One plane of the file."""

    name: str
    normal: tuple[float, float, float]
    centre_m: tuple[float, float, float]


class PlanesFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file."""

    planes: tuple[PlaneEntry, ...]


def encode_planes(names: Sequence[str], planes: Planes) -> str:
    """The text of the file; `decode_planes` returns the same names and exactly the same numbers."""
    entries = [
        f"\n[[planes]]\nname = {_quoted(name)}\nnormal = {normal.tolist()}\ncentre_m = {centre.tolist()}\n"
        for name, normal, centre in zip(names, planes.normals, planes.centres, strict=True)
    ]
    return "".join([_HEAD, *entries])


def decode_planes(content: bytes, name: str) -> tuple[tuple[str, ...], Planes]:
    """Names and planes in the content of a file; raises HelicoideError with the name, the reason and what is valid."""
    try:
        file = toml.table_to_struct(toml.parse_toml(text_of(content, MOST_BYTES)), PlanesFile)
        _check(file)
    except HelicoideError as error:
        raise HelicoideError(_VALID.format(name=name, reason=error.text, most=MOST, far=FARTHEST)) from error
    names = tuple(entry.name for entry in file.planes)
    normals = np.array([_unit(entry.normal) for entry in file.planes])
    return names, Planes(frozen(normals), frozen([entry.centre_m for entry in file.planes]))


def _check(file: PlanesFile) -> None:
    """Checks beyond the types: number of planes, unique names, finite values, non-zero normals."""
    names = [entry.name for entry in file.planes]
    if not 1 <= len(names) <= MOST:
        raise HelicoideError(Text(en="it has {n} planes", pt_BR="tem {n} planos").format(n=len(names)))
    if doubled := [name for name in names if names.count(name) > 1]:
        raise HelicoideError(Text(en="two are named {name!r}", pt_BR="dois se chamam {name!r}").format(name=doubled[0]))
    for entry in file.planes:
        numbers = (*entry.normal, *entry.centre_m)
        if not all(math.isfinite(value) for value in numbers) or max(map(abs, entry.centre_m)) > FARTHEST:
            reason = Text(en="plane {name!r} has no position", pt_BR="o plano {name!r} não tem posição")
            raise HelicoideError(reason.format(name=entry.name))
        if not any(entry.normal):
            reason = Text(en="the normal of {name!r} is zero", pt_BR="a normal de {name!r} é zero")
            raise HelicoideError(reason.format(name=entry.name))


def _unit(normal: tuple[float, float, float]) -> tuple[float, ...]:
    length = math.hypot(*normal)
    if abs(length - 1.0) <= UNIT:
        return normal
    scale = max(map(abs, normal))  # first, since the length of extreme values overflows or underflows
    scaled = [value / scale for value in normal]
    return tuple(value / math.hypot(*scaled) for value in scaled)


def _quoted(name: str) -> str:
    """A TOML string: as in JSON, with DEL escaped as well."""
    return json.dumps(name, ensure_ascii=False).replace("\x7f", "\\u007f")
