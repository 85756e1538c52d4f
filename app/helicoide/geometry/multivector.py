"""One multivector with operators, for code that people read as formulas."""

from __future__ import annotations

from numbers import Real

import numpy as np
from markupsafe import Markup
from numpy import empty

from helicoide.geometry import notation
from helicoide.geometry.clifford import Algebra, Array
from helicoide.geometry.products import WriteProduct
from helicoide.text import HelicoideError, Text

_new = object.__new__
PRINTED = Markup(
    '<div style="font-size:1.1em">{sources}</div><div style="font-size:0.85em;opacity:0.75">{modern} · {algebra}</div>'
)


class Multivector:
    """An immutable multivector: coefficients and their algebra. ^ | & >> bind weaker than + and need brackets."""

    __slots__ = ("_algebra", "_own")

    # Without this, a numpy scalar on the left would make an object array of the product.
    __array_ufunc__ = None

    _algebra: Algebra
    _own: Array

    def __init__(self, values: Array, algebra: Algebra) -> None:
        """Copy the coefficients, shape (2ⁿ,)."""
        own = np.array(values, dtype=float)
        if own.shape != (algebra.count,):
            raise HelicoideError(
                Text(
                    en=f"a multivector of {algebra} has {algebra.count} coefficients, not the shape {own.shape}",
                    pt_BR=f"um multivetor de {algebra} tem {algebra.count} coeficientes, não a forma {own.shape}",
                )
            )
        self._own, self._algebra = own, algebra

    @property
    def values(self) -> Array:
        """The coefficients, read-only, shape (2ⁿ,)."""
        view = self._own.view()
        view.setflags(write=False)
        return view

    @property
    def algebra(self) -> Algebra:
        """The algebra that the coefficients belong to."""
        return self._algebra

    def __getitem__(self, name: str) -> float:
        """Coefficient of a blade in either naming, as in m["e1e2"] or m["e12"]; m["e21"] is its negative."""
        place, sign = self._algebra.parse_blade(name)
        return sign * float(self._own[place])

    def __add__(self, other: Multivector | float) -> Multivector:
        """Sum; a number is a multiple of 1."""
        return self._make(self._own + self._coefficients(other))

    def __radd__(self, other: float) -> Multivector:
        """Sum with a number."""
        return self + other

    def __sub__(self, other: Multivector | float) -> Multivector:
        """Difference; a number is a multiple of 1."""
        return self._make(self._own - self._coefficients(other))

    def __rsub__(self, other: float) -> Multivector:
        """Difference from a number."""
        return -self + other

    def __neg__(self) -> Multivector:
        """All coefficients negated."""
        return self._make(-self._own)

    def __mul__(self, other: Multivector | float) -> Multivector:
        """Geometric product; a number scales."""
        algebra = self._algebra
        if not isinstance(other, Multivector):
            return self._make(self._number(other) * self._own)
        if other._algebra is not algebra:
            return self._combined(algebra.product_unchecked, other)
        # `_combined` written out, to save calls in the most used operation.
        made = _new(Multivector)
        made._algebra = algebra
        made._own = out = empty(algebra.count)
        algebra.product_unchecked(self._own, other._own, out)
        return made

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
        power = self._make(self._algebra.blade("1"))
        for _ in range(abs(exponent)):
            power = power * factor
        return power

    def __xor__(self, other: Multivector | float) -> Multivector:
        """Outer product a ^ b."""
        return self._make(self._algebra.outer(self._own, self._coefficients(other)))

    def __or__(self, other: Multivector | float) -> Multivector:
        """Left contraction a | b."""
        return self._make(self._algebra.left_contraction(self._own, self._coefficients(other)))

    def __and__(self, other: Multivector | float) -> Multivector:
        """Regressive product a & b."""
        return self._make(self._algebra.regressive(self._own, self._coefficients(other)))

    def __rshift__(self, other: Multivector | float) -> Multivector:
        """Sandwich M >> X = M X M* with the Clifford conjugate: X_a = M_a_b >> X_b."""
        return self._combined(self._algebra.sandwich_into, other)

    def __invert__(self) -> Multivector:
        """Reverse ~a."""
        return self._make(self._algebra.reverse(self._own))

    def conjugate(self) -> Multivector:
        """Clifford conjugate."""
        return self._make(self._algebra.conjugate(self._own))

    def involute(self) -> Multivector:
        """Grade involution."""
        return self._make(self._algebra.involute(self._own))

    def grade(self, k: int) -> Multivector:
        """The part of grade k."""
        return self._make(self._algebra.grade(self._own, k))

    def dual(self) -> Multivector:
        """Hodge star."""
        return self._make(self._algebra.hodge(self._own))

    def inverse_dual(self) -> Multivector:
        """Inverse of the Hodge star."""
        return self._make(self._algebra.inverse_hodge(self._own))

    def norm(self) -> float:
        """Norm √|⟨a ã⟩₀|."""
        return float(self._algebra.norm(self._own))

    def inverse(self) -> Multivector:
        """The multivector with a a⁻¹ = 1; raises HelicoideError if there is none."""
        return self._make(self._algebra.inverse(self._own))

    def __str__(self) -> str:
        """Sum of the blades that are not zero after rounding, such as 0.866 + 0.5 e1e2."""
        return notation.multivector_text(self._own, self._algebra)

    def __repr__(self) -> str:
        """The sum, and the name of the algebra."""
        return f"{self} in {self._algebra}"

    def _repr_latex_(self) -> str:
        """The sum as a formula in a notebook, with the names of the sources."""
        return f"${notation.multivector_latex(self._own, self._algebra)}$"

    def _repr_html_(self) -> Markup:
        """The sum in a notebook, in the colours of the grades: with the names of the sources, then with modern ones."""
        sources = notation.multivector_html(self._own, self._algebra)
        modern = notation.multivector_html(self._own, self._algebra, "compact")
        return PRINTED.format(sources=sources, modern=modern, algebra=str(self._algebra))

    def _make(self, values: Array) -> Multivector:
        """A multivector of the same algebra that keeps the array without a copy: contiguous float64, not shared."""
        made = _new(Multivector)
        made._own, made._algebra = values, self._algebra
        return made

    def _combined(self, of_two: WriteProduct, other: Multivector | float) -> Multivector:
        """The multivector that a function of two operands writes."""
        made = _new(Multivector)
        made._algebra = self._algebra
        made._own = out = empty(self._own.size)
        of_two(self._own, self._coefficients(other), out)
        return made

    def _coefficients(self, other: Multivector | float) -> Array:
        """Coefficients of an operand of the same algebra; a number is a multiple of 1."""
        if not isinstance(other, Multivector):
            return self._number(other) * self._algebra.blade("1")
        if other._algebra is not self._algebra and other._algebra != self._algebra:
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self._algebra} meets one of {other._algebra}: both must be of one algebra",
                    pt_BR=f"um multivetor de {self._algebra} encontra um de {other._algebra}: use uma só álgebra",
                )
            )
        return other._own

    def _number(self, other: float) -> float:
        """A number as an operand; raises HelicoideError for anything else."""
        if not isinstance(other, Real):
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self._algebra} meets {other!r}: use another of its algebra, or a number",
                    pt_BR=f"um multivetor de {self._algebra} encontra {other!r}: use um da mesma álgebra ou número",
                )
            )
        return float(other)
