from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Algebra, Array, multiply_by_table
from helicoide.kernels import python_function
from helicoide.text import HelicoideError

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

# Cerbaro 2022, §5.2.4.
STAR = {
    "1": "e1e2e3e", "e1e2e3e": "1",
    "e1": "e2e3e", "e2": "e3e1e", "e3": "e1e2e", "e": "-e1e2e3",
    "e2e3e": "-e1", "e3e1e": "-e2", "e1e2e": "-e3", "e1e2e3": "e",
    "e1e2": "e3e", "e2e3": "e1e", "e3e1": "e2e", "e3e": "e1e2", "e1e": "e2e3", "e2e": "e3e1",
}  # fmt: skip

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


@given(algebra_and_operands())
def test_products_are_associative_and_distribute(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, c = case
    for times in (algebra.product, algebra.outer, algebra.regressive):
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


def signed(name: str) -> Array:
    return CL031.blade(name.strip("-")) * (-1 if name.startswith("-") else 1)


@pytest.mark.parametrize("name", STAR)
def test_star_of_each_blade_of_the_source(name: str) -> None:
    np.testing.assert_array_equal(CL031.hodge(CL031.blade(name)), signed(STAR[name]))
    np.testing.assert_array_equal(CL031.inverse_hodge(signed(STAR[name])), CL031.blade(name))
    np.testing.assert_array_equal(CL031.product(CL031.blade(name), signed(STAR[name])), CL031.blade("e1e2e3e"))


@given(signatures)
def test_a_blade_and_its_star_span_the_pseudoscalar(signature: tuple[int, int, int]) -> None:
    algebra = Algebra(*signature)
    every = np.eye(len(algebra.blades))
    np.testing.assert_array_equal(algebra.outer(every, algebra.hodge(every)), np.broadcast_to(every[-1], every.shape))


@given(algebra_and_operands())
def test_the_star_comes_back_and_turns_outer_into_regressive(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, _ = case
    np.testing.assert_array_equal(algebra.inverse_hodge(algebra.hodge(a)), a)
    np.testing.assert_array_equal(algebra.hodge(algebra.inverse_hodge(a)), a)
    star = algebra.hodge
    np.testing.assert_allclose(star(algebra.regressive(a, b)), algebra.outer(star(a), star(b)), atol=1e-9)
    np.testing.assert_array_equal(algebra.regressive(a, np.eye(len(a))[-1]), a)


def test_planes_meet_and_points_join() -> None:
    """In Cl(3,0,1): two planes meet by ∧ in a line, two points join by ∨ in one."""
    x_axis = PGA.blade("e23")
    np.testing.assert_array_equal(PGA.outer(PGA.blade("e2"), PGA.blade("e3")), x_axis)
    origin, at_x = PGA.blade("e123"), PGA.blade("e123") + 2 * PGA.blade("e032")
    join = PGA.regressive(origin, at_x)
    np.testing.assert_array_equal(np.abs(join), 2 * x_axis)


@given(algebra_and_operands(), st.integers(0, 5), st.integers(0, 5))
def test_left_contraction_is_the_part_where_grades_subtract(
    case: tuple[Algebra, Array, Array, Array], j: int, k: int
) -> None:
    algebra, a, b, _ = case
    a, b = algebra.grade(a, j), algebra.grade(b, k)
    expected = algebra.grade(algebra.product(a, b), k - j)
    np.testing.assert_allclose(algebra.left_contraction(a, b), expected, atol=1e-9)


@given(algebra_and_operands())
def test_laws_of_the_left_contraction(case: tuple[Algebra, Array, Array, Array]) -> None:
    """(a ∧ b) ⌋ c = a ⌋ (b ⌋ c); ⟨x (a ⌋ b)⟩₀ = ⟨(x ∧ a) b⟩₀; v b = v ⌋ b + v ∧ b for a vector v."""
    algebra, a, b, c = case
    outer, contract = algebra.outer, algebra.left_contraction
    np.testing.assert_allclose(contract(outer(a, b), c), contract(a, contract(b, c)), atol=1e-7)
    left, right = algebra.product(c, contract(a, b))[0], algebra.product(outer(c, a), b)[0]
    np.testing.assert_allclose(left, right, atol=1e-7)
    v = algebra.grade(a, 1)
    np.testing.assert_allclose(contract(v, b) + outer(v, b), algebra.product(v, b), atol=1e-9)


@given(algebra_and_operands())
def test_squared_norm_is_the_scalar_part_of_a_and_its_reverse(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, _, _ = case
    squared = algebra.product(a, algebra.reverse(a))[0]
    np.testing.assert_allclose(algebra.squared_norm(a), squared, atol=1e-9)
    np.testing.assert_allclose(algebra.norm(a) ** 2, abs(squared), atol=1e-9)


def test_squared_norms_of_planes_points_and_motors() -> None:
    plane, point, motor = CL031.blade("e3") + 4 * CL031.blade("e"), CL031.blade("e1e2e3"), CL031.blade("1")
    squared = CL031.squared_norm(np.array([plane, point, motor + 7 * CL031.blade("e1e")]))
    np.testing.assert_array_equal(squared, [-1, -1, 1])
    np.testing.assert_array_equal(CL031.norm(3 * plane), 3)


@given(algebra_and_operands())
def test_an_inverse_stands_on_both_sides(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, _, _ = case
    one = algebra.blade("1")
    a = a + 100 * one  # far from where it divides zero
    inverse = algebra.inverse(a)
    np.testing.assert_allclose(algebra.product(a, inverse), one, atol=1e-8)
    np.testing.assert_allclose(algebra.product(inverse, a), one, atol=1e-8)


def test_inverses_of_every_algebra_up_to_six_generators() -> None:
    rng = np.random.default_rng(4)
    for p, q, r in [(6, 0, 0), (3, 3, 0), (2, 2, 2), (0, 0, 6), (4, 1, 0), (1, 0, 0), (0, 0, 0)]:
        algebra = Algebra(p, q, r)
        a = rng.uniform(-1, 1, size=(5, len(algebra.blades))) + 3 * algebra.blade("1")
        one = np.broadcast_to(algebra.blade("1"), a.shape)
        np.testing.assert_allclose(algebra.product(a, algebra.inverse(a)), one, atol=1e-8)


def test_the_inverse_of_a_motor_far_away_is_its_conjugate() -> None:
    turn = np.cos(0.5) * CL031.blade("1") + np.sin(0.5) * CL031.blade("e2e3")
    motor = CL031.product(CL031.blade("1") + 1e6 * CL031.blade("e1e"), turn)
    np.testing.assert_allclose(CL031.inverse(motor), CL031.conjugate(motor), rtol=1e-12, atol=1e-9)


ONE_PLUS_A_UNIT = np.array([0.5, 0.3, 0.4, 0.0])


@pytest.mark.parametrize(
    ("algebra", "a"),
    [
        (CL031, np.zeros(16)),
        (CL031, CL031.blade("e")),
        (CL031, CL031.blade("1") + CL031.blade("e1e2e3")),
        (PGA, PGA.blade("1") - PGA.blade("e2")),
        (Algebra(2, 0, 0), ONE_PLUS_A_UNIT),
        (Algebra(2, 0, 0), np.array([[1.0, 0, 0, 0], ONE_PLUS_A_UNIT])),
        (CL031, np.full(16, np.nan)),
    ],
)
def test_what_divides_zero_has_no_inverse(algebra: Algebra, a: Array) -> None:
    with pytest.raises(HelicoideError, match="no inverse") as caught:
        algebra.inverse(a)
    assert str(algebra) in caught.value.text.pt_BR


@given(algebra_and_operands())
def test_a_sandwich_is_two_products(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, c = case
    expected = algebra.product(algebra.product(a, b), algebra.conjugate(a))
    np.testing.assert_allclose(algebra.sandwich(a, b), expected, atol=1e-8)
    np.testing.assert_allclose(algebra.sandwich(a, np.array([b, c]))[0], expected, atol=1e-8)
    np.testing.assert_allclose(algebra.sandwich(np.array([c, a]), b)[1], expected, atol=1e-8)


def test_hamiltons_relations() -> None:
    i, j, k = (QUATERNIONS.blade(name) for name in ("e1", "e2", "e12"))
    times, minus_one = QUATERNIONS.product, -QUATERNIONS.blade("1")
    for square in (times(i, i), times(j, j), times(k, k), times(times(i, j), k)):
        np.testing.assert_array_equal(square, minus_one)
    for left, right, product in ((i, j, k), (j, k, i), (k, i, j)):
        np.testing.assert_array_equal(times(left, right), product)
    np.testing.assert_array_equal(QUATERNIONS.conjugate(np.ones(4)), [1, -1, -1, -1])


def test_arrays_of_another_length_are_refused() -> None:
    for a, b in ((np.ones(8), np.ones(8)), (np.ones(16), np.ones(8)), (np.ones(17), np.ones(16))):
        with pytest.raises((ValueError, IndexError)):
            CL031.product(a, b)
        with pytest.raises((ValueError, IndexError)):
            CL031.sandwich(a, b)


def test_read_only_and_strided_arrays_give_the_same() -> None:
    a, b = np.random.default_rng(5).normal(size=(2, 16))
    expected = CL031.product(a, b)
    a.setflags(write=False)
    np.testing.assert_array_equal(CL031.product(a, b), expected)
    np.testing.assert_array_equal(CL031.product(a, np.repeat(b, 2)[::2]), expected)


def test_the_kernel_of_tables_is_its_python_function() -> None:
    algebra = Algebra(2, 0, 1)
    a, b = np.random.default_rng(6).normal(size=(2, 8))
    out = np.empty(8)
    python_function(multiply_by_table)(algebra.table(lambda a, b: True).packed, a, b, out)
    np.testing.assert_allclose(algebra.product(a, b), out, atol=1e-15)


@given(algebra_and_operands())
def test_two_alone_are_what_they_are_among_many(case: tuple[Algebra, Array, Array, Array]) -> None:
    algebra, a, b, _ = case
    for times in (algebra.product, algebra.outer, algebra.left_contraction):
        np.testing.assert_allclose(times(a, b), times(a[None], b[None])[0], rtol=1e-12, atol=1e-12)
