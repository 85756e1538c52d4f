"""Formulas with operators say what the algebra calculates."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Algebra, Array
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError


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
    assert repr(2 * e1) == "2 e1 in Cl(0,3,1)"


def test_coefficients_are_read_by_blade_name() -> None:
    m = 3 * blade("e1e2") - 2 * blade("e")
    assert m["e1e2"] == 3
    assert m["e"] == -2
    assert m["e12"] == -m["e21"] == 3
    assert m["e0"] == -2
    with pytest.raises(HelicoideError, match='no blade "e4"'):
        m["e4"]


def test_a_multivector_cannot_be_changed() -> None:
    source = np.zeros(16)
    m = Multivector(source, CL031)
    source[0] = 1
    assert m["1"] == 0
    with pytest.raises(ValueError, match="read-only"):
        m.values[0] = 1
    with pytest.raises(AttributeError):
        m.values = source  # type: ignore[misc]
    with pytest.raises(AttributeError):
        m.algebra = CL031  # type: ignore[misc]


@pytest.mark.parametrize("algebra", [CL031, Algebra(0, 3, 1)], ids=["the same", "an equal one"])
def test_results_cannot_be_changed_and_change_no_operand(algebra: Algebra) -> None:
    a, b = random(4), Multivector(random(5).values, algebra)
    before = [a.values.copy(), b.values.copy()]
    for result in [operator(a, b) for operator, _ in BINARY.values()] + [operator(a) for operator, _ in UNARY.values()]:
        assert not result.values.flags.writeable
        assert not any(np.shares_memory(result.values, operand.values) for operand in (a, b))
        assert result.algebra is CL031
    np.testing.assert_array_equal([a.values, b.values], before)


GIVEN: dict[str, Array] = {
    "whole numbers": np.arange(16),
    "of single precision": np.arange(16, dtype=np.float32),
    "every second of others": np.arange(32.0)[::2],
    "backwards": np.arange(16.0)[::-1],
    "a column": np.asfortranarray(np.arange(48.0).reshape(3, 16))[1],
    "in the other order of bytes": np.arange(16, dtype=">f8"),
    "read-only": np.broadcast_to(np.float64(3), 16),
}


@pytest.mark.parametrize("kind", GIVEN)
def test_products_are_the_same_whatever_array_was_given(kind: str) -> None:
    """The kernel under a * b reads numbers that lie side by side, and looks at nothing: all else is copied before."""
    given, other = GIVEN[kind], random(6)
    m, expected = Multivector(given, CL031), np.asarray([float(value) for value in given])
    np.testing.assert_array_equal((m * other).values, CL031.product(expected, other.values))
    np.testing.assert_array_equal((other * m).values, CL031.product(other.values, expected))


def test_coefficients_always_lie_side_by_side() -> None:
    a, b = random(7), random(8)
    made = [operator(a, b) for operator, _ in BINARY.values()] + [operator(a) for operator, _ in UNARY.values()]
    made += [operator(a, 3) for operator, _ in BINARY.values()]
    made += [a + b, a - 1, 1 - a, -a, 2 * a, a * np.float32(2), a.grade(2), a**0, a**3, a**-1]
    made += [Multivector(given, CL031) for given in GIVEN.values()]
    for m in made:
        assert m.values.flags.c_contiguous
        assert m.values.dtype == np.dtype("=f8")
        assert m.values.shape == (16,)


@pytest.mark.parametrize("number", [2, 2.5, np.float32(0.5), np.int64(-3), True])
def test_a_number_scales_as_the_multiple_of_one_does(number: float) -> None:
    a = random(9)
    expected = CL031.product(a.values, float(number) * CL031.blade("1"))
    np.testing.assert_array_equal((a * number).values, expected)
    np.testing.assert_array_equal((number * a).values, expected)


def test_operands_of_another_algebra_or_shape_are_refused() -> None:
    other = Algebra(3, 0, 1)
    with pytest.raises(HelicoideError, match=r"Cl\(0,3,1\) meets one of Cl\(3,0,1\)"):
        blade("e1") * Multivector(other.blade("e1"), other)
    with pytest.raises(HelicoideError, match="16 coefficients"):
        Multivector(np.zeros(8), CL031)


def random(seed: int) -> Multivector:
    return Multivector(np.random.default_rng(seed).normal(size=16), CL031)


BINARY: dict[str, tuple[Callable[..., Multivector], Callable[[Array, Array], Array]]] = {
    "a * b": (lambda a, b: a * b, CL031.product),
    "a ^ b": (lambda a, b: a ^ b, CL031.outer),
    "a | b": (lambda a, b: a | b, CL031.left_contraction),
    "a & b": (lambda a, b: a & b, CL031.regressive),
    "a >> b": (lambda a, b: a >> b, CL031.sandwich),
    "a / b": (lambda a, b: a / b, lambda a, b: CL031.product(a, CL031.inverse(b))),
}
UNARY: dict[str, tuple[Callable[[Multivector], Multivector], Callable[[Array], Array]]] = {
    "~a": (lambda a: ~a, CL031.reverse),
    "conjugate": (Multivector.conjugate, CL031.conjugate),
    "involute": (Multivector.involute, CL031.involute),
    "dual": (Multivector.dual, CL031.hodge),
    "undual": (Multivector.inverse_dual, CL031.inverse_hodge),
    "inverse": (Multivector.inverse, CL031.inverse),
    "1 / a": (lambda a: 1 / a, CL031.inverse),
}


@pytest.mark.parametrize("formula", BINARY)
def test_operators_of_two(formula: str) -> None:
    operator, function = BINARY[formula]
    a, b = random(1), random(2)
    np.testing.assert_array_equal(operator(a, b).values, function(a.values, b.values))
    np.testing.assert_array_equal(operator(a, 3).values, function(a.values, 3 * CL031.blade("1")))


@pytest.mark.parametrize("formula", UNARY)
def test_operators_of_one(formula: str) -> None:
    operator, function = UNARY[formula]
    np.testing.assert_array_equal(operator(random(1)).values, function(random(1).values))


def test_powers() -> None:
    a = random(3)
    np.testing.assert_array_equal((a**0).values, CL031.blade("1"))
    np.testing.assert_array_equal((a**3).values, (a * a * a).values)
    np.testing.assert_allclose((a**-2 * a * a).values, CL031.blade("1"), atol=1e-9)


def test_a_norm_is_a_number() -> None:
    assert (3 * blade("e1")).norm() == 3.0
    assert type(blade("e1").norm()) is float


def test_a_motor_moves_a_point() -> None:
    """X_a = M_a_b >> X_b."""
    M = Multivector(rigid.translator((1, 2, 3)), CL031)
    X = Multivector(rigid.point((10, 20, 30)), CL031)
    np.testing.assert_allclose(rigid.coordinates((M >> X).values), [11, 22, 33])


@pytest.mark.parametrize("divisor", [blade("e"), 1 + blade("e1e2e3"), 0])
def test_division_by_what_has_no_inverse_is_refused(divisor: Multivector | float) -> None:
    with pytest.raises(HelicoideError, match="no inverse"):
        blade("e1") / divisor


def test_a_negative_power_needs_an_inverse() -> None:
    with pytest.raises(HelicoideError, match="no inverse"):
        blade("e") ** -1


def test_operands_that_are_no_multivectors_are_refused() -> None:
    with pytest.raises(HelicoideError, match="meets 'e2': use another of its algebra, or a number") as caught:
        blade("e1") * "e2"  # type: ignore[operator]
    assert "número" in caught.value.text.pt_BR
