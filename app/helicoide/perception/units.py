"""The unit of a cloud's numbers: chosen by a person, stated in the file, or guessed from the numbers."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

Unit = Literal["m", "cm", "mm", "inch", "ft"]
UNITS: tuple[Unit, ...] = get_args(Unit)
METRES: dict[Unit, float] = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "inch": 0.0254, "ft": 0.3048}
TITLES: dict[Unit, Text] = {
    "m": Text(en="metres", pt_BR="metros"),
    "cm": Text(en="centimetres", pt_BR="centímetros"),
    "mm": Text(en="millimetres", pt_BR="milímetros"),
    "inch": Text(en="inches", pt_BR="polegadas"),
    "ft": Text(en="feet", pt_BR="pés"),
}
# Clouds wider than the first, in metres, or narrower than the second, in mm, are implausible; between them the unit is
# ambiguous.
WIDEST_M, NARROWEST_MM = 10.0, 400.0
# Largest distance of a cloud from the base of the arm, m.
FARTHEST_CLOUD = 20.0
ENOUGH = 200_000
SAYS = Text(en="In {unit}, as stated in the file", pt_BR="Em {unit}, como diz o arquivo")
CHOSEN = Text(en="In {unit}, as chosen", pt_BR="Em {unit}, como foi escolhido")
LOOKS = Text(
    en="In {unit}, guessed (if wrong, choose the unit)",
    pt_BR="Em {unit}, por estimativa (se estiver errado, escolha a unidade)",
)


def detect_unit(rows: Array, chosen: Unit | None, stated: Unit | None) -> tuple[Unit, Text]:
    """The unit of rows (k, 3), and the reason; raises BrokenFile if it is ambiguous, or the points are too far away."""
    unit, why = (chosen, CHOSEN) if chosen else (stated, SAYS) if stated else (None, LOOKS)
    some = _finite(rows)
    if unit is None:
        unit = _looks(some)
    _check_near(some, unit)
    return unit, why.format(unit=TITLES[unit])


def _finite(rows: Array) -> Array:
    """A sample of the rows with plausible finite numbers."""
    some = rows[:: max(1, len(rows) // ENOUGH)]
    return some[(np.abs(some) < 1e15).all(axis=1)]


def _looks(rows: Array) -> Unit:
    """The unit guessed from the spread of most points."""
    if not len(rows):
        return "m"
    sizes = np.percentile(rows, 95, axis=0) - np.percentile(rows, 5, axis=0)
    if sizes.max() < WIDEST_M or _nearest(rows) * METRES["mm"] > FARTHEST_CLOUD:
        return "m"
    if sizes.max() >= NARROWEST_MM:
        return "mm"
    fields = dict(zip("xyz", sizes, strict=True))
    raise BrokenFile(
        Text(
            en="its numbers span {x:.0f} × {y:.0f} × {z:.0f}, and it does not say whether these are centimetres, "
            "inches, feet, millimetres or metres; choose the unit, then send the file again",
            pt_BR="os números abrangem {x:.0f} × {y:.0f} × {z:.0f}, e ele não diz se são centímetros, polegadas, pés, "
            "milímetros ou metros; escolha a unidade e envie o arquivo de novo",
        ).format(**fields)
    )


def _nearest(rows: Array) -> float:
    """Distance of the nearest points from the base, as the largest coordinate, without the nearest 5 %."""
    return float(np.percentile(np.abs(rows).max(axis=1), 5))


def _check_near(rows: Array, unit: Unit) -> None:
    if not len(rows) or _nearest(rows) * METRES[unit] <= FARTHEST_CLOUD:
        return
    middle = dict(zip("xyz", np.median(rows, axis=0), strict=True))
    raise BrokenFile(
        Text(
            en="its points are far from the arm's base, around ({x:.1f}, {y:.1f}, {z:.1f}) in {unit}; give "
            "coordinates in the base frame, within {room:.0f} m: subtract the origin of the map first, or choose "
            "another unit",
            pt_BR="os pontos ficam longe da base do braço, em torno de ({x:.1f}; {y:.1f}; {z:.1f}) em {unit}; dê "
            "coordenadas no referencial da base, a até {room:.0f} m dela: subtraia antes a origem do mapa ou escolha "
            "outra unidade",
        ).format(unit=TITLES[unit], room=FARTHEST_CLOUD, **middle)
    )
