"""Small Clifford algebras Cl(p, q, r): products, conjugations, duals and inverses of coefficient arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy import empty
from numpy.typing import NDArray

from helicoide.geometry.products import PairProducts, WriteProduct, generated_products
from helicoide.geometry.signature import Array, ProductTable, Signature
from helicoide.kernels import kernel_into, typed_entry
from helicoide.text import HelicoideError, Text

__all__ = ["CL031", "PGA", "QUATERNIONS", "Algebra", "Array"]

BladeIndices = NDArray[np.intp]

# If a is a zero divisor, rounding makes the computed inverse huge, or a a⁻¹ differs from 1 by about 1.
WORST_CONDITION = 1e12
INVERSE_TOLERANCE = 1e-6


@kernel_into
def multiply_by_table(table: BladeIndices, a: Array, b: Array, out: Array) -> None:
    """Product of two multivectors by `ProductTable.packed` (f and partner): outₖ = Σⱼ f[k, j] a[partner] b[j]."""
    count = out.size
    if a.size != count or b.size != count:
        raise ValueError("each multivector needs as many coefficients as the algebra has blades")
    for k in range(count):
        total = 0.0
        for j in range(count):
            # An unsigned index saves the check for negative indices.
            total += table[0, k, j] * (a[np.uintp(table[1, k, j])] * b[j])
        out[k] = total


@dataclass(frozen=True)
class Algebra(Signature):
    """The operations of Cl(p, q, r) on arrays.

    A multivector is an array whose last axis holds one coefficient for each blade, in the order of `blades`; the other
    axes broadcast. Products of two single multivectors are computed by a kernel.
    """

    def product(self, a: Array, b: Array) -> Array:
        """Geometric product a b of shapes (..., 2ⁿ) (Cerbaro 2022, eqs. 73–74)."""
        if a.ndim == b.ndim == 1:
            out = empty(self.count)
            self.product_into(a, b, out)
            return out
        return self._combine(self._geometric, a, b)

    def outer(self, a: Array, b: Array) -> Array:
        """Outer product a ∧ b of shapes (..., 2ⁿ): the part of a b whose grade is the sum of the grades."""
        return self._combine(self._outer, a, b)

    def left_contraction(self, a: Array, b: Array) -> Array:
        """Left contraction, an inner product: a ⌋ b = Σ ⟨⟨a⟩ⱼ ⟨b⟩ₖ⟩ₖ₋ⱼ, shapes (..., 2ⁿ).

        Source: Dorst 2002, §2.
        """
        return self._combine(self._contraction, a, b)

    def regressive(self, a: Array, b: Array) -> Array:
        """Regressive product, the dual of the outer one: a ∨ b = ⋆⁻¹(⋆a ∧ ⋆b), shapes (..., 2ⁿ)."""
        return self.inverse_hodge(self.outer(self.hodge(a), self.hodge(b)))

    def sandwich(self, a: Array, b: Array) -> Array:
        """Sandwich a b a* with the Clifford conjugate, by which a motor a moves b, shapes (..., 2ⁿ).

        Source: Cerbaro 2022, eq. 95 as corrected for points, lines and planes.
        """
        if a.ndim == b.ndim == 1:
            out = empty(self.count)
            self.sandwich_into(a, b, out)
            return out
        return self.product(self.product(a, b), self.conjugate(a))

    def grade(self, a: Array, k: int) -> Array:
        """The part ⟨a⟩ₖ of grade k."""
        return np.where(self.grades == k, a, 0.0)

    def reverse(self, a: Array) -> Array:
        """Reverse ã, with the order of vectors in each product reversed: ⟨a⟩ₖ → (−1)^(k(k−1)/2) ⟨a⟩ₖ."""
        return a * self._reverse_signs

    def involute(self, a: Array) -> Array:
        """Grade involution, each generator negated: ⟨a⟩ₖ → (−1)ᵏ ⟨a⟩ₖ."""
        return a * self._involute_signs

    def conjugate(self, a: Array) -> Array:
        """Clifford conjugate a*, reverse and involution: ⟨a⟩ₖ → (−1)^(k(k+1)/2) ⟨a⟩ₖ (Cerbaro 2022, eq. 75)."""
        return a * self._conjugate_signs

    def hodge(self, a: Array) -> Array:
        """Hodge star ⋆a: the linear map with b ∧ ⋆b = e1e2…eₙ for every blade b, null generators or not.

        a: (..., 2ⁿ). In Cl(0,3,1) it is that of Selig 2000. Source: Cerbaro 2022, §5.2.4.
        """
        return np.asarray((a * self._star_signs).take(self._complement, axis=-1))

    def inverse_hodge(self, a: Array) -> Array:
        """Inverse of the Hodge star: ⋆⁻¹(⋆a) = a, shape (..., 2ⁿ)."""
        return np.asarray(a.take(self._complement, axis=-1) * self._star_signs)

    def squared_norm(self, a: Array) -> Array:
        """Squared norm ⟨a ã⟩₀, which may be negative where generators square to −1.

        a: (..., 2ⁿ); returns (...). A plane of Cl(0,3,1) with unit normal has −1, a unit motor 1.
        """
        return np.asarray((a * a) @ self._norm_signs)

    def norm(self, a: Array) -> Array:
        """Norm √|⟨a ã⟩₀|. a: (..., 2ⁿ); returns (...)."""
        return np.sqrt(np.abs(self.squared_norm(a)))

    def inverse(self, a: Array) -> Array:
        """Inverse, by the characteristic polynomial: a a⁻¹ = a⁻¹ a = 1.

        a⁻¹ = u_{N−1}/⟨a u_{N−1}⟩₀ with u₀ = 1, uₖ = a uₖ₋₁ − (N/k) ⟨a uₖ₋₁⟩₀, N = 2^⌊(n+1)/2⌋.
        a: (..., 2ⁿ). Raises HelicoideError if a is a zero divisor. Source: Shirokov 2021.
        """
        one = self.blade("1")
        count = 2 ** ((len(self.squares) + 1) // 2)
        u = np.broadcast_to(one, a.shape)
        with np.errstate(all="ignore"):
            for k in range(1, count):
                u = self.product(a, u)
                u = u - count / k * u[..., :1] * one
            inverse = np.asarray(u / self.product(a, u)[..., :1])
            condition = np.linalg.norm(a * self._without_null, axis=-1) * np.linalg.norm(
                inverse * self._without_null, axis=-1
            )
            error = np.abs(self.product(a, inverse) - one).max(axis=-1)
        if not np.all((condition < WORST_CONDITION) & (error < INVERSE_TOLERANCE)):
            raise HelicoideError(
                Text(
                    en=f"a multivector of {self} has no inverse: its product with another that is not 0 is 0; "
                    "motors, rotors and blades whose square is not 0 have one",
                    pt_BR=f"um multivetor de {self} não tem inverso: o produto dele com outro não nulo é 0; "
                    "motores, rotores e lâminas de quadrado não nulo têm",
                )
            )
        return inverse

    @cached_property
    def product_into(self) -> WriteProduct:
        """Function that writes the product of two (2ⁿ,) into a third: generated in `products`, else by the table."""
        return self._pair_products.product

    @cached_property
    def product_unchecked(self) -> WriteProduct:
        """The same for contiguous float64 arrays, without checks: a `Multivector` holds no others."""
        return typed_entry(self.product_into, *np.zeros((3, self.count)))

    @cached_property
    def sandwich_into(self) -> WriteProduct:
        """Function that writes the sandwich of two (2ⁿ,) into a third."""
        return self._pair_products.sandwich

    @cached_property
    def _pair_products(self) -> PairProducts:
        return generated_products(self) or self._by_table

    @cached_property
    def _by_table(self) -> PairProducts:
        times = partial(multiply_by_table, self._geometric.packed)

        def sandwich(a: Array, b: Array, out: Array) -> None:
            half = empty(self.count)
            times(a, b, half)
            times(half, self.conjugate(a), out)

        return PairProducts(times, sandwich)

    def _combine(self, table: ProductTable, a: Array, b: Array) -> Array:
        """Two single multivectors by the kernel; for many, the smaller operand is converted to its matrix."""
        left, right, partner, whole = table
        if a.ndim == b.ndim == 1:
            out = empty(self.count)
            multiply_by_table(whole, a, b, out)
            return out
        if a.size <= b.size:
            matrix, vector = left * a.take(partner, axis=-1), b
        else:
            matrix, vector = right * b.take(partner, axis=-1), a
        return np.asarray((matrix @ vector[..., None])[..., 0])

    @cached_property
    def terms(self) -> tuple[NDArray[np.intp], Array]:
        """All terms of the geometric product that are not 0: places (k, i, j) and factors f of (a b)ₖ = Σ f aᵢ bⱼ."""
        left, _, partner, _ = self._geometric
        k, j = np.nonzero(left)
        return np.stack([k, partner[k, j], j], axis=-1), left[k, j]

    @cached_property
    def _geometric(self) -> ProductTable:
        return self.table(lambda a, b: True)

    @cached_property
    def _outer(self) -> ProductTable:
        return self.table(set.isdisjoint)

    @cached_property
    def _contraction(self) -> ProductTable:
        return self.table(set.issubset)

    @cached_property
    def _complement(self) -> NDArray[np.intp]:
        """Index of the complementary blade, with all other generators."""
        return np.asarray(self.product_index[-1])

    @cached_property
    def _star_signs(self) -> Array:
        pairs = zip(self.blades, self._complement, strict=True)
        return np.array([float(self.blade_factor(blade, self.blades[rest])) for blade, rest in pairs])

    @cached_property
    def _norm_signs(self) -> Array:
        squares = [float(self.blade_factor(blade, blade)) for blade in self.blades]
        return self._reverse_signs * squares

    @cached_property
    def _without_null(self) -> NDArray[np.bool_]:
        """Blades without null generators; the others are nilpotent and do not affect invertibility."""
        return np.array([all(self.squares[g] for g in blade) for blade in self.blades])

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
"""The algebra of the sources; its even part Cl⁺(0,3,1) is that of the dual quaternions (dictionary in `rigid`)."""

PGA = Algebra(3, 0, 1)
"""The algebra of modern projective geometric algebra; its null generator is named e here, and e0 in compact names."""

QUATERNIONS = Algebra(0, 2, 0)
"""Hamilton's quaternions with i = e1, j = e2, k = e1e2, so that the blades stand in the order w, x, y, z."""
