"""One multivector with operators, for places where people read formulas."""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Real

import numpy as np

from helicoide.geometry import notation
from helicoide.geometry.clifford import Algebra, Array
from helicoide.text import HelicoideError, Text


@dataclass(frozen=True, eq=False)
class Multivector:
    """Coefficients and their algebra; ^ | & >> bind weaker than + and need brackets."""

    values: Array
    algebra: Algebra

    # Without this, numpy scalars on the left would spread the product over an object array.
    __array_ufunc__ = None

    def __post_init__(self) -> None:
        """Keep an own, read-only copy of the coefficients."""
        own = np.array(self.values, dtype=float)
        count = len(self.algebra.blades)
        if own.shape != (count,):
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self.algebra} has {count} coefficients, not an array of shape {own.shape}",
                    pt_BR=f"um multivetor de {self.algebra} tem {count} coeficientes, não a forma {own.shape}",
                )
            )
        own.setflags(write=False)
        object.__setattr__(self, "values", own)

    def __getitem__(self, name: str) -> float:
        """Coefficient of a blade in either naming, as in m["e1e2"] or m["e12"]; m["e21"] is its negative."""
        place, sign = self.algebra.read(name)
        return sign * float(self.values[place])

    def __add__(self, other: Multivector | float) -> Multivector:
        """Sum; a number is a multiple of 1."""
        return self._make(self.values + self._coefficients(other))

    def __radd__(self, other: float) -> Multivector:
        """Sum with a number."""
        return self + other

    def __sub__(self, other: Multivector | float) -> Multivector:
        """Difference; a number is a multiple of 1."""
        return self._make(self.values - self._coefficients(other))

    def __rsub__(self, other: float) -> Multivector:
        """Difference from a number."""
        return -self + other

    def __neg__(self) -> Multivector:
        """All coefficients negated."""
        return self._make(-self.values)

    def __mul__(self, other: Multivector | float) -> Multivector:
        """Geometric product; a number scales."""
        return self._make(self.algebra.product(self.values, self._coefficients(other)))

    def __rmul__(self, other: float) -> Multivector:
        """Scale by a number."""
        return self * other

    def __truediv__(self, other: Multivector | float) -> Multivector:
        """Product with the inverse of the right operand: a / b = a b⁻¹."""
        return self * self._make(self._coefficients(other)).inverse()

    def __rtruediv__(self, other: float) -> Multivector:
        """Multiple of the inverse."""
        return self.inverse() * other

    def __pow__(self, exponent: int) -> Multivector:
        """Repeated geometric product; a negative exponent repeats the inverse."""
        factor = self if exponent >= 0 else self.inverse()
        power = self._make(self.algebra.blade("1"))
        for _ in range(abs(exponent)):
            power = power * factor
        return power

    def __xor__(self, other: Multivector | float) -> Multivector:
        """Outer product a ^ b."""
        return self._make(self.algebra.outer(self.values, self._coefficients(other)))

    def __or__(self, other: Multivector | float) -> Multivector:
        """Left contraction a | b."""
        return self._make(self.algebra.left_contraction(self.values, self._coefficients(other)))

    def __and__(self, other: Multivector | float) -> Multivector:
        """Regressive product a & b."""
        return self._make(self.algebra.regressive(self.values, self._coefficients(other)))

    def __rshift__(self, other: Multivector | float) -> Multivector:
        """Sandwich M >> X = M X M* with the Clifford conjugate: X_a = M_a_b >> X_b."""
        return self._make(self.algebra.sandwich(self.values, self._coefficients(other)))

    def __invert__(self) -> Multivector:
        """Reverse ~a."""
        return self._make(self.algebra.reverse(self.values))

    def conjugate(self) -> Multivector:
        """Clifford conjugate."""
        return self._make(self.algebra.conjugate(self.values))

    def involute(self) -> Multivector:
        """Grade involution."""
        return self._make(self.algebra.involute(self.values))

    def grade(self, k: int) -> Multivector:
        """The part of grade k."""
        return self._make(self.algebra.grade(self.values, k))

    def dual(self) -> Multivector:
        """Hodge star."""
        return self._make(self.algebra.hodge(self.values))

    def undual(self) -> Multivector:
        """Inverse of the Hodge star."""
        return self._make(self.algebra.unhodge(self.values))

    def norm(self) -> float:
        """Norm √|⟨a ã⟩₀|."""
        return float(self.algebra.norm(self.values))

    def inverse(self) -> Multivector:
        """The multivector with a a⁻¹ = 1; raises HelicoideError where there is none."""
        return self._make(self.algebra.inverse(self.values))

    def __str__(self) -> str:
        """Sum of the blades that are not zero after rounding, such as 0.866 + 0.5 e1e2."""
        return notation.text(self.values, self.algebra)

    def _make(self, values: Array) -> Multivector:
        return Multivector(values, self.algebra)

    def _coefficients(self, other: Multivector | float) -> Array:
        """Coefficients of an operand of the same algebra; a number is a multiple of 1."""
        if isinstance(other, Real):
            return float(other) * self.algebra.blade("1")
        if not isinstance(other, Multivector):
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self.algebra} meets {other!r}: use another of its algebra, or a number",
                    pt_BR=f"um multivetor de {self.algebra} encontra {other!r}: use um da mesma álgebra ou número",
                )
            )
        if other.algebra != self.algebra:
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self.algebra} meets one of {other.algebra}: both must be of one algebra",
                    pt_BR=f"um multivetor de {self.algebra} encontra um de {other.algebra}: use uma só álgebra",
                )
            )
        return other.values
