"""The values of the console: numbers, quaternions, and multivectors of Cl(0,3,1) or Cl(3,0,1)."""

from __future__ import annotations

from math import hypot, isfinite

from helicoide.geometry import pga
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Array
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError, Text

Value = float | Multivector

NOT_FINITE = Text(
    en="the result is not a finite number: it is too large, or not defined",
    pt_BR="o resultado não é um número finito: é grande demais ou não está definido",
)


def quaternion_value(wxyz: Array) -> Multivector:
    """A quaternion w + x i + y j + z k. wxyz: (4,)."""
    return Multivector(wxyz, QUATERNIONS)


def multivector_value(coefficients: Array) -> Multivector:
    """A multivector of Cl(0,3,1). coefficients: (16,)."""
    return Multivector(coefficients, CL031)


def finite_value(value: Value) -> Value:
    """The value, if each of its numbers is finite; raises HelicoideError otherwise."""
    numbers = value.values.tolist() if isinstance(value, Multivector) else [value]
    if not all(map(isfinite, numbers)):
        raise HelicoideError(NOT_FINITE)
    return value


def size_of(value: Value) -> float:
    """The absolute value of a number, the length of a quaternion, the norm of a multivector."""
    if not isinstance(value, Multivector):
        return abs(value)
    return hypot(*value.values.tolist()) if value.algebra is QUATERNIONS else value.norm()


def reverse_of(value: Value) -> Value:
    """The reverse of a multivector; the conjugate of a quaternion, whose units are bivectors; a number as it is."""
    if not isinstance(value, Multivector):
        return value
    return value.conjugate() if value.algebra is QUATERNIONS else ~value


def coefficients_in_sources(value: Multivector) -> Array:
    """The coefficients (16,) of a multivector in Cl(0,3,1), whichever of the two algebras it is of.

    Even ones with a scalar or a pseudoscalar are converted as motors, all others as points, lines and planes.
    """
    if value.algebra is not PGA:
        return value.values
    is_even = not value.values[CL031.grades % 2 == 1].any()
    if is_even and (value.values[0] or value.values[-1]):
        return pga.motor_from_modern(value.values)
    return pga.from_modern(value.values)
