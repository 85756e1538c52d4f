from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from helicoide.geometry.clifford import CL031, Algebra, Array, Multivector
from helicoide.text import HelicoideError

ORDER = "1 e1 e2 e3 e e1e2 e1e3 e2e3 e1e e2e e3e e1e2e3 e1e2e e1e3e e2e3e e1e2e3e"

# Cerbaro 2022, App. F: row × column, with a, b, c, n for e1, e2, e3, e, and a dot for zero.
TABLE = """
1    a     b     c     n    ab    ac    bc   an    bn    cn    abc   abn   acn   bcn   abcn
a    -1    ab    ac    an   -b    -c    abc  -n    abn   acn   -bc   -bn   -cn   abcn  -bcn
b    -ab   -1    bc    bn   a     -abc  -c   -abn  -n    bcn   ac    an    -abcn -cn   acn
c    -ac   -bc   -1    cn   abc   a     b    -acn  -bcn  -n    -ab   abcn  an    bn    -abn
n    -an   -bn   -cn   .    abn   acn   bcn  .     .     .     -abcn .     .     .     .
ab   b     -a    abc   abn  -1    bc    -ac  bn    -an   abcn  -c    -n    bcn   -acn  -cn
ac   c     -abc  -a    acn  -bc   -1    ab   cn    -abcn -an   b     -bcn  -n    abn   bn
bc   abc   c     -b    bcn  ac    -ab   -1   abcn  cn    -bn   -a    acn   -abn  -n    -an
an   n     -abn  -acn  .    -bn   -cn   abcn .     .     .     bcn   .     .     .     .
bn   abn   n     -bcn  .    an    -abcn -cn  .     .     .     -acn  .     .     .     .
cn   acn   bcn   n     .    abcn  an    bn   .     .     .     abn   .     .     .     .
abc  -bc   ac    -ab   abcn -c    b     -a   -bcn  acn   -abn  1     -cn   bn    -an   n
abn  -bn   an    -abcn .    -n    bcn   -acn .     .     .     cn    .     .     .     .
acn  -cn   abcn  an    .    -bcn  -n    abn  .     .     .     -bn   .     .     .     .
bcn  -abcn -cn   bn    .    acn   -abn  -n   .     .     .     an    .     .     .     .
abcn bcn   -acn  abn   .    -cn   bn    -an  .     .     .     -n    .     .     .     .
"""

signatures = st.tuples(*[st.integers(0, 5)] * 3).filter(lambda pqr: sum(pqr) <= 5)
coefficients = st.floats(-10, 10)


def multivectors(algebra: Algebra) -> st.SearchStrategy[Array]:
    return arrays(float, len(algebra.blades), elements=coefficients)


@st.composite
def algebra_and_operands(draw: st.DrawFn) -> tuple[Algebra, Array, Array, Array]:
    algebra = Algebra(*draw(signatures))
    a, b, c = (draw(multivectors(algebra)) for _ in range(3))
    return algebra, a, b, c


def from_letters(entry: str) -> Array:
    if entry == ".":
        return np.zeros(16)
    letters = str.maketrans({"a": "e1", "b": "e2", "c": "e3", "n": "e"})
    return CL031.blade(entry.strip("-").translate(letters)) * (-1 if entry.startswith("-") else 1)


def test_blades_stand_in_the_order_of_the_source() -> None:
    assert " ".join(CL031.names) == ORDER
    assert CL031.blades[8] == (0, 3)
    assert CL031.grades.tolist() == [0] + [1] * 4 + [2] * 6 + [3] * 4 + [4]


def test_product_table_of_cerbaro_appendix_f() -> None:
    rows = [line.split() for line in TABLE.strip().splitlines()]
    expected = np.array([[from_letters(entry) for entry in row] for row in rows])
    np.testing.assert_array_equal(CL031.product(np.eye(16)[:, None], np.eye(16)[None, :]), expected)


@given(signatures)
def test_generators_square_to_the_signature_and_anticommute(signature: tuple[int, int, int]) -> None:
    algebra = Algebra(*signature)
    generators = np.eye(len(algebra.blades))[algebra.grades == 1]
    one = algebra.blade("1")
    assert sorted(algebra.product(g, g) @ one for g in generators) == sorted(algebra.squares)
    assert algebra.squares == (1,) * signature[0] + (-1,) * signature[1] + (0,) * signature[2]
    for g, h in pairwise(generators):
        np.testing.assert_array_equal(algebra.product(g, h), -algebra.product(h, g))


def test_more_null_generators_are_numbered() -> None:
    assert Algebra(1, 0, 2).names == ("1", "e1", "e2", "e3", "e1e2", "e1e3", "e2e3", "e1e2e3")


@given(algebra_and_operands())
def test_products_are_associative_and_distribute(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, c = case
    for times in (algebra.product, algebra.outer):
        np.testing.assert_allclose(times(times(a, b), c), times(a, times(b, c)), atol=1e-8)
        np.testing.assert_allclose(times(a, b + c), times(a, b) + times(a, c), atol=1e-9)


@given(algebra_and_operands())
def test_conjugations_turn_products_round_or_keep_them(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, _ = case
    ab = algebra.product(a, b)
    for turn in (algebra.reverse, algebra.conjugate):
        np.testing.assert_allclose(turn(ab), algebra.product(turn(b), turn(a)), atol=1e-9)
    np.testing.assert_allclose(
        algebra.involute(ab), algebra.product(algebra.involute(a), algebra.involute(b)), atol=1e-9
    )
    np.testing.assert_array_equal(algebra.conjugate(a), algebra.reverse(algebra.involute(a)))


@given(algebra_and_operands(), st.integers(0, 5), st.integers(0, 5))
def test_outer_product_is_the_part_where_grades_add(case: tuple[Algebra, Array, Array, Array], j: int, k: int) -> None:
    algebra, a, b, _ = case
    a, b = algebra.grade(a, j), algebra.grade(b, k)
    np.testing.assert_allclose(algebra.outer(a, b), algebra.grade(algebra.product(a, b), j + k), atol=1e-9)


@given(multivectors(CL031))
def test_grades_add_up(a: Array) -> None:
    np.testing.assert_array_equal(sum(CL031.grade(a, k) for k in range(5)), a)


def test_signs_of_the_conjugations_by_grade() -> None:
    ones = np.ones(16)
    assert [CL031.conjugate(ones)[CL031.grades == k][0] for k in range(5)] == [1, -1, -1, 1, 1]
    assert [CL031.reverse(ones)[CL031.grades == k][0] for k in range(5)] == [1, 1, -1, -1, 1]
    assert [CL031.involute(ones)[CL031.grades == k][0] for k in range(5)] == [1, -1, 1, -1, 1]


def test_products_broadcast_over_leading_axes() -> None:
    rng = np.random.default_rng(1)
    a, b = rng.normal(size=(3, 1, 16)), rng.normal(size=(5, 16))
    expected = np.array([[CL031.product(x, y) for y in b] for x in a[:, 0]])
    np.testing.assert_allclose(CL031.product(a, b), expected, atol=1e-14)
    np.testing.assert_allclose(CL031.product(b, a)[2, 4], CL031.product(b[4], a[2, 0]), atol=1e-14)
    np.testing.assert_allclose(CL031.product(a[0, 0], b)[3], CL031.product(a[0, 0], b[3]), atol=1e-14)


@pytest.mark.parametrize("signature", [(4, 3, 0), (-1, 3, 1)])
def test_signatures_out_of_range_are_refused(signature: tuple[int, int, int]) -> None:
    with pytest.raises(HelicoideError, match=r"p \+ q \+ r ≤ 6"):
        Algebra(*signature)


def blade(name: str) -> Multivector:
    return Multivector(CL031.blade(name), CL031)


def test_formulas_read_like_formulas() -> None:
    e1, e2, e = blade("e1"), blade("e2"), blade("e")
    assert str(np.cos(np.pi / 6) + np.sin(np.pi / 6) * e1 * e2) == "0.866 + 0.5 e1e2"
    assert str(-blade("e3") - 4 * e) == "-e3 - 4 e"
    assert str(1 - (e2 ^ e1) / 3 + 1e-9 * e) == "1 + 0.333 e1e2"
    assert str(e * e) == "0"
    assert str((1 + e1).grade(1) * 1010.14079) == "1010.141 e1"
    assert str(~(e1 * e2)) == "-e1e2"
    assert str(np.float64(2) * e1 + e2 - e2) == "2 e1"


def test_coefficients_are_read_by_blade_name() -> None:
    m = 3 * blade("e1e2") - 2 * blade("e")
    assert m["e1e2"] == 3
    assert m["e"] == -2
    with pytest.raises(HelicoideError, match=r"1, e1, e2, e3, e, e1e2, .*e1e2e3e$"):
        m["e4"]


def test_a_multivector_cannot_be_changed() -> None:
    source = np.zeros(16)
    m = Multivector(source, CL031)
    source[0] = 1
    assert m["1"] == 0
    with pytest.raises(ValueError, match="read-only"):
        m.values[0] = 1


def test_operands_of_another_algebra_or_shape_are_refused() -> None:
    other = Algebra(3, 0, 1)
    with pytest.raises(HelicoideError, match=r"Cl\(0,3,1\) meets one of Cl\(3,0,1\)"):
        blade("e1") * Multivector(other.blade("e1"), other)
    with pytest.raises(HelicoideError, match="16 coefficients"):
        Multivector(np.zeros(8), CL031)
