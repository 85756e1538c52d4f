"""Whether two values are equal, by the rule of the kind of exercise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.console import Value
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lines.exercise import LineExercise

TOLERANCE = 1e-9  # of the largest coefficient; rounding stays below 1e-12


@dataclass(frozen=True)
class EqualityRule:
    """What counts as equal. any_size: a positive factor does not matter; any_sign: neither does a sign."""

    any_size: bool = False
    any_sign: bool = False

    def equal(self, value: Value, expected: Value) -> bool:
        """Whether a value is the expected one. A number and a multivector that is a scalar may be equal."""
        pair = same_blades(value, expected)
        if pair is None:
            return False
        a, b = pair
        factor = 1.0
        if self.any_size and b[1:].any():
            size = float(b @ b)
            factor = float(a @ b) / size if size else 0.0
            if not abs(factor) > TOLERANCE:
                return False
        either_sign = (self.any_sign and bool(b[1:].any())) or (self.any_size and _is_point(b))
        if either_sign and a @ b < 0:
            factor = -abs(factor)
        elif factor < 0:
            return False
        return bool(np.abs(a - factor * b).max() <= TOLERANCE * max(1.0, abs(factor)) * (1.0 + np.abs(b).max()))


EXACT = EqualityRule()


def equality_rule(exercise: LineExercise) -> EqualityRule:
    """The rule of an exercise: a join or a meet may have any size, since 2π is the plane π."""
    return EqualityRule(any_size=exercise.kind == "incidence", any_sign=not exercise.sign_counts)


def same_blades(value: Value, expected: Value) -> tuple[Array, Array] | None:
    """The coefficients of both over the same blades; None if they are of different algebras."""
    a, b = _coefficients(value), _coefficients(expected)
    if len(a) == 1 or len(b) == 1:
        size = max(len(a), len(b))
        return _padded(a, size), _padded(b, size)
    assert isinstance(value, Multivector) and isinstance(expected, Multivector)  # noqa: PT018
    return (a, b) if value.algebra is expected.algebra else None


def _is_point(b: Array) -> bool:
    """Whether a multivector has blades of three vectors alone: a point, which −1 leaves where it is."""
    return len(b) == CL031.count and not b[CL031.grades != 3].any()


def _coefficients(value: Value) -> Array:
    return value.values if isinstance(value, Multivector) else np.array([value])


def _padded(a: Array, size: int) -> Array:
    return np.concatenate([a, np.zeros(size - len(a))])
