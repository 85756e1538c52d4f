"""What the coefficients of an element are, in words: those that differ by their axis alone are explained together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import motor, rigid
from helicoide.readout.coefficients import Coefficient
from helicoide.readout.elements import Nature
from helicoide.readout.meanings import AXES, NO_SLIDE, has_opposite_sign, meaning
from helicoide.readout.roles import Part, Role, role_of
from helicoide.text import Text, rounded_numbers, rounded_text

TOGETHER: dict[Part, Text] = {
    "direction": Text(
        en="Components {axes} of the unit vector v along the line.",
        pt_BR="Componentes {axes} do vetor unitário v ao longo da reta.",
    ),
    "moment": Text(
        en="Components {axes} of the moment u = r × v of the line: lever arm r from the origin to the line, times v. "
        "The length of u is the distance of the line from the origin, {distance} mm.",
        pt_BR="Componentes {axes} do momento u = r × v da reta: braço de alavanca r, da origem à reta, vezes v. O "
        "comprimento de u é a distância da reta à origem, {distance} mm.",
    ),
    "normal": Text(
        en="Components {axes} of the unit vector n perpendicular to the plane, towards the allowed side.",
        pt_BR="Componentes {axes} do vetor unitário n perpendicular ao plano, para o lado permitido.",
    ),
    "coordinate": Text(
        en="Coordinates {axes} of the point: ({coordinates}) mm.",
        pt_BR="Coordenadas {axes} do ponto: ({coordinates}) mm.",
    ),
    "sine": Text(
        en="Components {axes} of the direction of the screw axis, ({direction}), times the sine of half the angle, "
        "sin {half}° = {sine}.",
        pt_BR="Componentes {axes} da direção do eixo helicoidal, ({direction}), vezes o seno da metade do ângulo, "
        "sen {half}° = {sine}.",
    ),
    "dual": Text(
        en="They say where the axis is: components {axes} of the moment r × v of the axis, ({moment}) mm, times "
        "sin {half}°, plus half the translation, {slide} mm, times those of the direction v, ({direction}), times "
        "cos {half}°. The lever arm r leads from the origin to the axis.",
        pt_BR="Dizem onde está o eixo: componentes {axes} do momento r × v do eixo, ({moment}) mm, vezes sen {half}°, "
        "mais metade da translação, {slide} mm, vezes as da direção v, ({direction}), vezes cos {half}°. O braço de "
        "alavanca r vai da origem até o eixo.",
    ),
}
ROTATED_TOGETHER = Text(
    en="They say where the axis is: components {axes} of the moment r × v of the axis, ({moment}) mm, times "
    "sin {half}°. The lever arm r leads from the origin to the axis, the unit vector v along it.",
    pt_BR="Dizem onde está o eixo: componentes {axes} do momento r × v do eixo, ({moment}) mm, vezes sen {half}°. O "
    "braço de alavanca r vai da origem até o eixo; o vetor unitário v aponta ao longo dele.",
)
TRANSLATED_TOGETHER = Text(
    en="Half the components {axes} of the translation, ({way}) mm: the motion does not turn.",
    pt_BR="Metade das componentes {axes} da translação, ({way}) mm: o movimento não gira.",
)


class SharedMeaning(NamedTuple):
    """Coefficients and what they are. opposite: those whose displayed sign the text does not have."""

    coefficients: tuple[Coefficient, ...]
    text: Text
    opposite: tuple[Coefficient, ...] = ()


def shared_meanings(nature: Nature, values: Array, shown: Iterable[Coefficient]) -> list[SharedMeaning]:
    """The meanings of these coefficients of an element, (16,) of `CL031`, m, in their order."""
    groups: dict[object, list[tuple[Coefficient, Role | None]]] = {}
    for one in shown:
        role = role_of(nature, one.blade)
        alike = one.blade if role is None or role.axis is None else role.part
        groups.setdefault(alike, []).append((one, role))
    return [_shared(nature, values, group) for group in groups.values()]


def _shared(nature: Nature, values: Array, group: Sequence[tuple[Coefficient, Role | None]]) -> SharedMeaning:
    first, role = group[0]
    if len(group) == 1 or role is None:
        return SharedMeaning((first,), meaning(nature, values, first.blade, first.sign))
    axes = [of.axis for _, of in group if of is not None and of.axis is not None]
    said = _of_motor(values, role.part, axes) if nature == "motor" else _of_element(values, role.part, axes)
    opposite = tuple(one for one, of in group if of is not None and has_opposite_sign(of, one.sign))
    return SharedMeaning(tuple(one for one, _ in group), said, opposite)


def _named(axes: list[int]) -> str:
    return ", ".join(AXES[i] for i in axes)


def _of_element(values: Array, part: Part, axes: list[int]) -> Text:
    """The words of components of a line, a plane or a point."""
    numbers: dict[str, Text] = {}
    if part == "moment":
        numbers["distance"] = rounded_text(1000 * float(np.linalg.norm(rigid.direction_and_moment(values)[1])), 1)
    if part == "coordinate":
        numbers["coordinates"] = rounded_numbers(1000 * rigid.coordinates(values)[axes], 1)
    return TOGETHER[part].format(axes=_named(axes), **numbers)


def _of_motor(values: Array, part: Part, axes: list[int]) -> Text:
    """The words of components of a motor."""
    screw = motor.screw_from_motor(values)
    if screw.angle == 0 and part == "dual":
        way = 1000 * float(screw.displacement) * screw.direction
        return TRANSLATED_TOGETHER.format(axes=_named(axes), way=rounded_numbers(way[axes], 1))
    half = float(screw.angle) / 2
    rotates = part == "dual" and abs(float(screw.displacement)) < NO_SLIDE
    return (ROTATED_TOGETHER if rotates else TOGETHER[part]).format(
        axes=_named(axes),
        half=rounded_text(float(np.degrees(half)), 2),
        sine=rounded_text(float(np.sin(half)), 3),
        direction=rounded_numbers(screw.direction[axes], 3),
        moment=rounded_numbers(1000 * np.cross(screw.point, screw.direction)[axes], 1),
        slide=rounded_text(500 * float(screw.displacement), 1),
    )
