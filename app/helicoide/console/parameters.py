"""What the functions of the console take: each parameter checks a value and converts it to an array or a number.

A parameter raises HelicoideError for a value that it does not take.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from helicoide.console.kinds import KINDS_OF_VALUES, KindName, kind_of
from helicoide.console.values import Value, multivector_value, size_of
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Array
from helicoide.geometry.motor import is_motor
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError, Text

OTHER = Text(en="expects {wanted}, but got {kind}", pt_BR="espera {wanted}, mas recebeu {kind}")
OTHER_ALGEBRA = Text(
    en="this takes multivectors of Cl(0,3,1): convert with sources(X)",
    pt_BR="isto recebe multivetores de Cl(0,3,1): converta com sources(X)",
)


Parameter = Callable[[Value], Any]


def _number(value: Value) -> float | None:
    """The number that a value is: a number, or a multivector with nothing but a scalar."""
    if not isinstance(value, Multivector):
        return float(value)
    scalar, *others = value.values.tolist()
    return None if any(others) else float(scalar)


def _given(value: Value, wanted: Text) -> HelicoideError:
    return HelicoideError(OTHER.format(kind=kind_of(value).title, wanted=wanted))


def _elements(kinds: tuple[KindName, ...], wanted: Text, unit: bool = True) -> Callable[[Value], Array]:
    """Takes multivectors of Cl(0,3,1) of some kinds. unit: finite ones are scaled to unit size, points to weight 1."""

    def take(value: Value) -> Array:
        if not isinstance(value, Multivector):
            raise _given(value, wanted)
        if value.algebra is PGA:
            raise HelicoideError(OTHER_ALGEBRA)
        kind = kind_of(value).name
        if value.algebra is not CL031 or kind not in kinds:
            raise _given(value, wanted)
        return _of_unit_size(value.values, kind) if unit else value.values

    return take


def _of_unit_size(X: Array, kind: KindName) -> Array:
    if kind == "point":
        return np.asarray(X / X[11])
    if kind not in ("line", "plane"):
        return X
    scaled = X / np.abs(X).max()  # the squares of its coefficients could overflow
    return np.asarray(scaled / CL031.norm(scaled))


def _take_number(value: Value) -> float:
    number = _number(value)
    if number is None:
        raise _given(value, KINDS_OF_VALUES["number"])
    return number


def _take_grade(value: Value) -> int:
    number = _number(value)
    if number is None or number != int(number) or not 0 <= number <= 4:
        raise HelicoideError(Text(en="a grade is 0, 1, 2, 3 or 4", pt_BR="um grau é 0, 1, 2, 3 ou 4"))
    return int(number)


def _take_unit_quaternion(value: Value) -> Array:
    if not isinstance(value, Multivector) or value.algebra is not QUATERNIONS:
        raise _given(value, KINDS_OF_VALUES["quaternion"])
    if not abs(size_of(value) - 1) < 1e-9:
        what = Text(
            en="this takes a unit quaternion: divide it by its norm, as in q/norm(q)",
            pt_BR="aqui vai um quatérnio unitário: divida-o pela norma, como em q/norm(q)",
        )
        raise HelicoideError(what)
    return value.values


def _take_motor(value: Value) -> Array:
    if isinstance(value, Multivector) and value.algebra is CL031 and is_motor(value.values):
        return value.values
    if isinstance(value, Multivector) and value.algebra is PGA:
        raise HelicoideError(OTHER_ALGEBRA)
    raise _given(value, UNIT_MOTOR)


def _take_multivector(value: Value) -> Multivector:
    """A multivector of either algebra; a number is a multiple of 1."""
    if not isinstance(value, Multivector):
        return multivector_value(value * CL031.blade("1"))
    if value.algebra is QUATERNIONS:
        raise _given(value, KINDS_OF_VALUES["multivector"])
    return value


def _take_anything(value: Value) -> Value:
    return value


UNIT_MOTOR = Text(en="a motor of size 1", pt_BR="um motor unitário")
POINT_LINE_PLANE = Text(en="a point, a line or a plane", pt_BR="um ponto, uma reta ou um plano")
LINE_OR_PLANE = Text(en="a line or a plane", pt_BR="uma reta ou um plano")
FAR: tuple[KindName, ...] = ("direction", "far_line", "far_plane")

NUMBER: Parameter = _take_number
GRADE: Parameter = _take_grade
UNIT_QUATERNION: Parameter = _take_unit_quaternion
MOTOR: Parameter = _take_motor
POINT: Parameter = _elements(("point",), KINDS_OF_VALUES["point"])
LINE: Parameter = _elements(("line",), KINDS_OF_VALUES["line"])
BIVECTOR: Parameter = _elements(("line", "screw", "far_line", "zero"), KINDS_OF_VALUES["screw"], unit=False)
ELEMENT: Parameter = _elements(("point", "line", "plane"), POINT_LINE_PLANE)
FLAT: Parameter = _elements(("line", "plane"), LINE_OR_PLANE)
INCIDENT: Parameter = _elements(("point", "line", "plane", *FAR), POINT_LINE_PLANE)
MULTIVECTOR: Parameter = _take_multivector
ANYTHING: Parameter = _take_anything
