"""The generators of a Clifford algebra Cl(p, q, r), its blades with their names, and the signs of their products."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helicoide.text import HelicoideError, Text

Array = NDArray[np.float64]
Blade = tuple[int, ...]
MAX_GENERATORS = 6


class ProductTable(NamedTuple):
    """The structure constants of a product, arranged for the matrix of either operand.

    (a b)ₖ = Σⱼ left[k, j] a[partner[k, j]] b[j] = Σᵢ right[k, i] a[i] b[partner[k, i]].
    """

    left: Array
    right: Array
    partner_index: NDArray[np.intp]

    packed: NDArray[np.intp]
    """`left` and `partner_index` as one integer array (2, 2ⁿ, 2ⁿ): a kernel with fewer arguments is called faster."""


@dataclass(frozen=True)
class Signature:
    """Cl(p, q, r): anticommuting generators, p that square to +1, then q to −1, then r to 0.

    Raises HelicoideError for a negative count or more than six generators. Source: Cerbaro 2022, eqs. 73–74.
    """

    p: int
    q: int
    r: int

    def __post_init__(self) -> None:
        """Raise HelicoideError for signatures whose tables would be too large."""
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
    def count(self) -> int:
        """Number of blades, 2ⁿ."""
        return len(self.blades)

    @cached_property
    def grades(self) -> NDArray[np.intp]:
        """The grade of each blade, shape (2ⁿ,)."""
        return np.array([len(blade) for blade in self.blades])

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The blades as the sources write them, such as "1", "e1" and "e1e2e"; a single null generator is "e"."""
        generators = ["e" if label == "0" else f"e{label}" for label in self._labels]
        return tuple("".join(generators[g] for g in blade) or "1" for blade in self.blades)

    @cached_property
    def compact_names(self) -> tuple[str, ...]:
        """The blades as modern texts write them, such as "e12"; a single null generator is 0 and comes first.

        Moving it to the front changes the sign, so "e01" is −e1e: `parse_blade` gives the sign.
        """
        return tuple("e" + "".join(sorted(self._labels[g] for g in blade)) if blade else "1" for blade in self.blades)

    def parse_blade(self, name: str) -> tuple[int, int]:
        """Index and sign of a blade in either naming, generators in any order: "e31" gives the index of e1e3, and −1.

        Raises HelicoideError for a name that is not a blade of this algebra.
        """
        well_formed = name == "1" or re.fullmatch(r"(e\d*)+", name)
        factors = [label for labels in re.findall(r"e(\d*)", name) for label in labels or "0"]
        if not well_formed or not set(factors) <= set(self._labels) or len(set(factors)) < len(factors):
            raise HelicoideError(self._no_blade(name))
        blade = [self._labels.index(label) for label in factors]
        return self._places[frozenset(blade)], _parity(combinations(blade, 2))

    def blade(self, name: str) -> Array:
        """The basis blade called `name`, as `read` understands it, shape (2ⁿ,)."""
        place, sign = self.parse_blade(name)
        return np.asarray(np.eye(self.count)[place] * sign)

    def blade_factor(self, a: Blade, b: Blade) -> int:
        """Factor ±1 or 0 of the product of two blades: sign of the permutation times squares of shared generators."""
        return _parity(product(a, b)) * prod(self.squares[g] for g in set(a) & set(b))

    @cached_property
    def product_index(self) -> NDArray[np.intp]:
        """Index, up to sign, of the product of blades i and j; also of the blade whose product with i is j."""
        sets = [frozenset(blade) for blade in self.blades]
        return np.array([[self._places[a ^ b] for b in sets] for a in sets])

    def table(self, keeps: Callable[[set[int], set[int]], bool]) -> ProductTable:
        """The table of the product that keeps the pairs of blades for which `keeps` is true and drops the others."""
        factors = [[self.blade_factor(a, b) * keeps(set(a), set(b)) for b in self.blades] for a in self.blades]
        table, places = np.array(factors, dtype=float), np.arange(self.count)
        left, right = table[self.product_index, places], table[places, self.product_index]
        return ProductTable(left, right, self.product_index, np.array([left, self.product_index], dtype=np.intp))

    @cached_property
    def _labels(self) -> tuple[str, ...]:
        """The digit of each generator in compact names."""
        labels = [str(g + 1) for g in range(len(self.squares))]
        return (*labels[:-1], "0") if self.r == 1 else tuple(labels)

    @cached_property
    def _places(self) -> dict[frozenset[int], int]:
        return {frozenset(blade): i for i, blade in enumerate(self.blades)}

    def _no_blade(self, name: str) -> Text:
        generators = ", ".join(self.names[1 : len(self.squares) + 1]) or "1"
        whole = f"{self.names[-1]}, {self.compact_names[-1]}"
        return Text(
            en=f'{self} has no blade "{name}": join {generators}, each at most once, as in {whole}',
            pt_BR=f'{self} não tem a lâmina "{name}": junte {generators}, cada um no máximo uma vez, como em {whole}',
        )


def _parity(pairs: Iterable[tuple[int, int]]) -> int:
    """Sign of the permutation with these pairs: −1 if an odd number of them is out of order."""
    return -1 if sum(i > j for i, j in pairs) % 2 else 1
