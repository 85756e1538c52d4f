"""The coefficients of an element as they are displayed, in either algebra and with either names of blades."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import pga
from helicoide.geometry.clifford import CL031, PGA, Algebra
from helicoide.geometry.notation import displayed_blades
from helicoide.readout.elements import Nature
from helicoide.seat import Notation, ShownAlgebra

ALGEBRAS: dict[ShownAlgebra, Algebra] = {"Cl(0,3,1)": CL031, "Cl(3,0,1)": PGA}


class Coefficient(NamedTuple):
    """How one coefficient is displayed: as sign · (the value of `CL031` at this place).

    blade: the stored name in `CL031`, by which it is known; name: the displayed one.
    """

    blade: str
    name: str
    place: int
    sign: float
    grade: int


@cache
def coefficients(nature: Nature, notation: Notation) -> tuple[Coefficient, ...]:
    """The sixteen coefficients in the order in which they are displayed."""
    ones = in_algebra(nature, np.ones(CL031.count), notation.algebra)
    return tuple(
        Coefficient(CL031.names[blade.place], blade.name, blade.place, blade.sign * float(ones[blade.place]), grade)
        for blade in displayed_blades(ALGEBRAS[notation.algebra], notation.naming)
        for grade in [int(CL031.grades[blade.place])]
    )


def in_algebra(nature: Nature, values: Array, algebra: ShownAlgebra) -> Array:
    """The multivector (16,) of `CL031` in the chosen algebra: the same object, by `geometry.pga`."""
    if algebra == "Cl(0,3,1)":
        return values
    return pga.motor_to_modern(values) if nature == "motor" else pga.to_modern(values)


def exact_text(nature: Nature, values: Array, notation: Notation) -> str:
    """All coefficients that are not zero, one line each, with the 17 digits that determine a number exactly."""
    lines = [
        f"{one.name}\t{one.sign * values[one.place]:.17g}"
        for one in coefficients(nature, notation)
        if values[one.place] != 0
    ]
    return "\n".join([notation.algebra, *lines])
