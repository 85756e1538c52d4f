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
    "undual": (Multivector.undual, CL031.unhodge),
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
