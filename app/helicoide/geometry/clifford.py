"""Any small Clifford algebra Cl(p, q, r): products and conjugations of bare arrays, and a wrapper for formulas."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from math import prod

import numpy as np
from numpy.typing import NDArray

from helicoide.text import HelicoideError, Text

Array = NDArray[np.float64]
Blade = tuple[int, ...]
MAX_GENERATORS = 6
DECIMALS = 3


@dataclass(frozen=True)
class Algebra:
    """Cl(p, q, r): anticommuting generators, p that square to +1, then q to −1, then r to 0.

    A multivector is an array whose last axis holds one coefficient a blade, in the order of `blades`; the other
    axes broadcast. Raises HelicoideError for a negative count or more than six generators.
    Source: Cerbaro 2022, eqs. 73–74.
    """

    p: int
    q: int
    r: int

    def __post_init__(self) -> None:
        """Refuse signatures whose tables would be too large."""
        if min(self.p, self.q, self.r) < 0 or self.p + self.q + self.r > MAX_GENERATORS:
            raise HelicoideError(
                Text(
                    en=f"{self} is not available: use p, q, r ≥ 0 and p + q + r ≤ {MAX_GENERATORS}",
                    pt_BR=f"{self} não está disponível: use p, q, r ≥ 0 e p + q + r ≤ {MAX_GENERATORS}",
                )
            )

    def __str__(self) -> str:
        """The name of the algebra, such as Cl(0,3,1)."""
        return f"Cl({self.p},{self.q},{self.r})"

    @cached_property
    def squares(self) -> tuple[int, ...]:
        """The square of each generator."""
        return (1,) * self.p + (-1,) * self.q + (0,) * self.r

    @cached_property
    def blades(self) -> tuple[Blade, ...]:
        """Generator indices of each blade: by grade, blades without null generators first, then lexicographic."""
        count = len(self.squares)
        every = [blade for grade in range(count + 1) for blade in combinations(range(count), grade)]
        nulls = range(self.p + self.q, count)
        return tuple(sorted(every, key=lambda blade: (len(blade), sum(g in nulls for g in blade), blade)))

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The blades as they are written, such as "1", "e1" and "e1e2e"; a single null generator is "e"."""
        generators = [f"e{g + 1}" for g in range(len(self.squares))]
        if self.r == 1:
            generators[-1] = "e"
        return tuple("".join(generators[g] for g in blade) or "1" for blade in self.blades)

    @cached_property
    def grades(self) -> NDArray[np.intp]:
        """The grade of each blade, shape (2ⁿ,)."""
        return np.array([len(blade) for blade in self.blades])

    def index(self, name: str) -> int:
        """Place of the blade called `name`; raises HelicoideError with the valid names."""
        if name not in self.names:
            valid = ", ".join(self.names)
            raise HelicoideError(
                Text(
                    en=f'{self} has no blade "{name}"; its blades are {valid}',
                    pt_BR=f'{self} não tem a lâmina "{name}"; as lâminas são {valid}',
                )
            )
        return self.names.index(name)

    def blade(self, name: str) -> Array:
        """The basis blade called `name`, shape (2ⁿ,)."""
        return np.asarray(np.eye(len(self.blades))[self.index(name)])

    def product(self, a: Array, b: Array) -> Array:
        """Geometric product a b of shapes (..., 2ⁿ) (Cerbaro 2022, eqs. 73–74)."""
        return self._combine(self._geometric_signs, a, b)

    def outer(self, a: Array, b: Array) -> Array:
        """Outer product a ∧ b of shapes (..., 2ⁿ): the part of a b in which the grades add up."""
        return self._combine(self._outer_signs, a, b)

    def grade(self, a: Array, k: int) -> Array:
        """The part ⟨a⟩ₖ of grade k."""
        return np.where(self.grades == k, a, 0.0)

    def reverse(self, a: Array) -> Array:
        """Reverse ã, each product of vectors read backwards: ⟨a⟩ₖ → (−1)^(k(k−1)/2) ⟨a⟩ₖ."""
        return a * self._reverse_signs

    def involute(self, a: Array) -> Array:
        """Grade involution, each generator negated: ⟨a⟩ₖ → (−1)ᵏ ⟨a⟩ₖ."""
        return a * self._involute_signs

    def conjugate(self, a: Array) -> Array:
        """Clifford conjugate a*, reverse and involution: ⟨a⟩ₖ → (−1)^(k(k+1)/2) ⟨a⟩ₖ (Cerbaro 2022, eq. 75)."""
        return a * self._conjugate_signs

    def _combine(self, signs: tuple[Array, Array], a: Array, b: Array) -> Array:
        """Turn the smaller operand into its matrix, so that one motor on a whole cloud builds one matrix."""
        left, right = signs
        if a.size <= b.size:
            matrix, vector = left * a.take(self._partner, axis=-1), b
        else:
            matrix, vector = right * b.take(self._partner, axis=-1), a
        return np.asarray((matrix @ vector[..., None])[..., 0])

    @cached_property
    def _partner(self) -> NDArray[np.intp]:
        """Place of the blade that takes blade i to blade j; also of their product, as blades are their own inverse."""
        place = {frozenset(blade): i for i, blade in enumerate(self.blades)}
        return np.array([[place[frozenset(a) ^ frozenset(b)] for b in self.blades] for a in self.blades])

    @cached_property
    def _geometric_signs(self) -> tuple[Array, Array]:
        return self._arrange([[self._sign(a, b) for b in self.blades] for a in self.blades])

    @cached_property
    def _outer_signs(self) -> tuple[Array, Array]:
        return self._arrange([[0 if set(a) & set(b) else self._sign(a, b) for b in self.blades] for a in self.blades])

    def _sign(self, a: Blade, b: Blade) -> int:
        """Factor of the product of two blades: one swap for each inversion, then the squares of shared generators."""
        swaps = sum(i > j for i in a for j in b)
        return (-1 if swaps % 2 else 1) * prod(self.squares[g] for g in set(a) & set(b))

    def _arrange(self, factors: list[list[int]]) -> tuple[Array, Array]:
        """Factors of row × column, sorted as the matrix of the left operand and that of the right one need them."""
        table = np.array(factors, dtype=float)
        places = np.arange(len(table))
        return table[self._partner, places], table[places, self._partner]

    @cached_property
    def _reverse_signs(self) -> Array:
        return np.where(self.grades * (self.grades - 1) // 2 % 2, -1.0, 1.0)

    @cached_property
    def _involute_signs(self) -> Array:
        return np.where(self.grades % 2, -1.0, 1.0)

    @cached_property
    def _conjugate_signs(self) -> Array:
        return self._reverse_signs * self._involute_signs


CL031 = Algebra(0, 3, 1)


@dataclass(frozen=True, eq=False)
class Multivector:
    """One multivector with the operators of its algebra, for places where people read formulas."""

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
        """Coefficient of a blade, as in m["e1e2"]."""
        return float(self.values[self.algebra.index(name)])

    def __mul__(self, other: Multivector | float) -> Multivector:
        """Geometric product; a number scales."""
        return self._make(self.algebra.product(self.values, self._coefficients(other)))

    def __rmul__(self, other: float) -> Multivector:
        """Scale by a number."""
        return self * other

    def __truediv__(self, other: float) -> Multivector:
        """Divide by a number."""
        return self._make(self.values / other)

    def __xor__(self, other: Multivector | float) -> Multivector:
        """Outer product; ^ binds weaker than + and needs brackets."""
        return self._make(self.algebra.outer(self.values, self._coefficients(other)))

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

    def __invert__(self) -> Multivector:
        """Reverse."""
        return self._make(self.algebra.reverse(self.values))

    def grade(self, k: int) -> Multivector:
        """The part of grade k."""
        return self._make(self.algebra.grade(self.values, k))

    def __str__(self) -> str:
        """Sum of the blades that are not zero after rounding, such as 0.866 + 0.5 e1e2."""
        rounded = np.round(self.values, DECIMALS)
        terms = [_term(float(c), name) for c, name in zip(rounded, self.algebra.names, strict=True) if c != 0]
        text = " + ".join(terms) or "0"
        return text.replace("+ -", "- ")

    def _make(self, values: Array) -> Multivector:
        return Multivector(values, self.algebra)

    def _coefficients(self, other: Multivector | float) -> Array:
        """Coefficients of an operand of the same algebra; a number is a multiple of 1."""
        if not isinstance(other, Multivector):
            return float(other) * self.algebra.blade("1")
        if other.algebra != self.algebra:
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self.algebra} meets one of {other.algebra}: both must be of one algebra",
                    pt_BR=f"um multivetor de {self.algebra} encontra um de {other.algebra}: use uma só álgebra",
                )
            )
        return other.values


def _term(coefficient: float, name: str) -> str:
    if name == "1":
        return f"{coefficient:.12g}"
    if abs(coefficient) == 1:
        return name if coefficient > 0 else f"-{name}"
    return f"{coefficient:.12g} {name}"
