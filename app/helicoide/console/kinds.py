"""What a value is: a number, a quaternion, a point, a line, a plane, a motor, …, recognised by its coefficients."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from helicoide.console.values import Value, coefficients_in_sources
from helicoide.geometry.clifford import QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.text import Text

KindName = Literal[
    "number", "quaternion", "zero", "point", "direction", "line", "far_line", "plane", "far_plane", "screw", "motor",
    "even", "pseudoscalar", "multivector",
]  # fmt: skip

ROUNDING = 1e-9  # coefficients below this part of the largest one count as zero
NOISE = 1e-12  # and so do these, whatever the others are


@dataclass(frozen=True)
class Kind:
    """A kind of values, and its name in words."""

    name: KindName
    title: Text


KINDS_OF_VALUES: dict[KindName, Text] = {
    "number": Text(en="number", pt_BR="número"),
    "quaternion": Text(en="quaternion", pt_BR="quatérnio"),
    "zero": Text(en="zero", pt_BR="zero"),
    "point": Text(en="point", pt_BR="ponto"),
    "direction": Text(en="direction (point at infinity)", pt_BR="direção (ponto no infinito)"),
    "line": Text(en="line", pt_BR="reta"),
    "far_line": Text(en="line at infinity", pt_BR="reta no infinito"),
    "plane": Text(en="plane", pt_BR="plano"),
    "far_plane": Text(en="plane at infinity", pt_BR="plano no infinito"),
    "screw": Text(en="screw (bivector)", pt_BR="helicoide (bivetor)"),
    "motor": Text(en="motor", pt_BR="motor"),
    "even": Text(en="dual quaternion, not of size 1", pt_BR="quatérnio dual, não unitário"),
    "pseudoscalar": Text(en="pseudoscalar", pt_BR="pseudoescalar"),
    "multivector": Text(en="multivector", pt_BR="multivetor"),
}


def kind_of(value: Value) -> Kind:
    """The kind of a value."""
    name = _name(value)
    return Kind(name, KINDS_OF_VALUES[name])


def _name(value: Value) -> KindName:
    if not isinstance(value, Multivector):
        return "number"
    if value.algebra is QUATERNIONS:
        return "quaternion"
    return _of_coefficients(coefficients_in_sources(value).tolist())


def _of_coefficients(c: list[float]) -> KindName:
    """The kind of a multivector of Cl(0,3,1): c has the order of its blades, 1 | e1 … e | e1e2 … | e1e2e3 … | I."""
    zero = max(ROUNDING * max(map(abs, c)), NOISE)
    grades = [any(abs(x) > zero for x in part) for part in (c[:1], c[1:5], c[5:11], c[11:15], c[15:])]
    match grades:
        case [False, False, False, False, False]:
            return "zero"
        case [True, False, False, False, False]:
            return "number"
        case [False, True, False, False, False]:
            return "plane" if max(map(abs, c[1:4])) > zero else "far_plane"
        case [False, False, True, False, False]:
            return _of_bivector(c, zero)
        case [False, False, False, True, False]:
            return "point" if abs(c[11]) > zero else "direction"
        case [False, False, False, False, True]:
            return "pseudoscalar"
        case [_, False, _, False, _]:
            return _of_even(c)
    return "multivector"


def _of_bivector(c: list[float], zero: float) -> KindName:
    if max(map(abs, c[5:8])) <= zero:
        return "far_line"
    largest = max(map(abs, c))  # squares of the coefficients themselves could overflow
    xy, xz, yz, x, y, z = (number / largest for number in c[5:11])
    return "line" if abs(yz * x - xz * y + xy * z) <= ROUNDING else "screw"


def _of_even(c: list[float]) -> KindName:
    """A motor M has M M* = 1: its rotor is of size 1, and its dual part orthogonal to it."""
    size = c[0] * c[0] + c[5] * c[5] + c[6] * c[6] + c[7] * c[7]
    skew = c[7] * c[8] - c[6] * c[9] + c[5] * c[10] - c[0] * c[15]
    return "motor" if abs(size - 1) <= ROUNDING and abs(skew) <= ROUNDING * max(map(abs, c)) else "even"
