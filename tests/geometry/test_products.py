"""Products of blades by their definition, in every algebra; what is written out is what is generated."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from tests.geometry.write_products import FOLDER, IN_USE, file_of, source_of

from helicoide.geometry.clifford import Algebra, Array
from helicoide.geometry.products import PairProducts, generated_products
from helicoide.kernels import python_function

SMALL = [(p, q, r) for p, q, r in product(range(5), repeat=3) if p + q + r <= 4]
LARGE = [(4, 1, 0), (2, 2, 1), (0, 3, 2), (6, 0, 0), (3, 2, 1), (1, 1, 4)]


def in_order(generators: list[int], squares: tuple[int, ...]) -> tuple[tuple[int, ...], int]:
    """A product of generators, neighbours swapped until they ascend, and squared where they are the same."""
    sign, left = 1, 0
    while left < len(generators) - 1:
        g, h = generators[left : left + 2]
        if g < h:
            left += 1
            continue
        sign *= squares[g] if g == h else -1
        generators = generators[:left] + ([] if g == h else [h, g]) + generators[left + 2 :]
        left = max(left - 1, 0)
    return tuple(generators), sign


def by_definition(algebra: Algebra) -> Array:
    """The products of all blades, (2ⁿ, 2ⁿ, 2ⁿ): those of the first down, of the second across."""
    table = np.zeros([algebra.count] * 3)
    for (i, a), (j, b) in product(enumerate(algebra.blades), repeat=2):
        blade, sign = in_order([*a, *b], algebra.squares)
        table[i, j, algebra.blades.index(blade)] = sign
    return table


@pytest.mark.parametrize("signature", SMALL + LARGE, ids=str)
def test_products_of_all_blades(signature: tuple[int, int, int]) -> None:
    algebra, every = Algebra(*signature), np.eye(2 ** sum(signature))
    expected = by_definition(algebra)
    np.testing.assert_array_equal(algebra.product(every[:, None], every[None, :]), expected)
    alone = [[algebra.product(a, b) for b in every] for a in every]
    np.testing.assert_array_equal(alone, expected)


@pytest.mark.parametrize("signature", SMALL + LARGE, ids=str)
def test_two_alone_are_multiplied_by_definition(signature: tuple[int, int, int]) -> None:
    """And associate: (a b) c = a (b c), and a sandwich is (a b) a*."""
    algebra, rng = Algebra(*signature), np.random.default_rng(sum(signature))
    table, times = by_definition(algebra), algebra.product
    signs = np.array([(-1) ** (len(blade) * (len(blade) + 1) // 2) for blade in algebra.blades])
    for a, b, c in rng.normal(size=(5, 3, algebra.count)):
        ab = np.einsum("ijk,i,j", table, a, b)
        np.testing.assert_allclose(times(a, b), ab, atol=1e-12)
        np.testing.assert_allclose(times(times(a, b), c), times(a, times(b, c)), atol=1e-11)
        np.testing.assert_allclose(algebra.sandwich(a, b), np.einsum("ijk,i,j", table, ab, signs * a), atol=1e-11)


def kernels_of(algebra: Algebra) -> PairProducts:
    found = generated_products(algebra)
    assert found is not None
    return found


@pytest.mark.parametrize("algebra", IN_USE, ids=str)
def test_what_is_written_out_is_what_is_generated(algebra: Algebra) -> None:
    assert file_of(algebra).read_text("utf-8") == source_of(algebra)


def test_nothing_else_is_written_out() -> None:
    assert {*FOLDER.glob("cl_*.py")} == {file_of(algebra) for algebra in IN_USE}
    assert generated_products(Algebra(1, 2, 0)) is None


@pytest.mark.parametrize("algebra", IN_USE, ids=str)
def test_what_is_written_out_is_its_python_function(algebra: Algebra) -> None:
    a, b, out, expected = np.random.default_rng(6).normal(size=(4, algebra.count))
    for compiled in kernels_of(algebra):
        compiled(a, b, out)
        python_function(compiled)(a, b, expected)
        np.testing.assert_allclose(out, expected, atol=1e-14)


@pytest.mark.parametrize("algebra", [*IN_USE, Algebra(1, 2, 0)], ids=str)
def test_kernels_refuse_arrays_of_another_length(algebra: Algebra) -> None:
    right, wrong = np.ones(algebra.count), (np.ones(algebra.count - 1), np.ones(2 * algebra.count))
    for other in wrong:
        for operands in ((other, right), (right, other), (other, other)):
            for kernel in (algebra.product_into, algebra.sandwich_into):
                with pytest.raises(ValueError, match="as many coefficients"):
                    kernel(*operands, np.empty(algebra.count))
