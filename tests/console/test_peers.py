"""The console computes what kingdon and scipy compute, sign for sign."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from tests.console.lines import numbers, value, written
from tests.geometry.test_algebra_peers import in_kingdon

from helicoide.arrays import Array
from helicoide.geometry.clifford import CL031, PGA, Algebra
from helicoide.geometry.multivector import Multivector

# `&` and `dual` turn with the sign of the pseudoscalar, which kingdon writes e0123 = −e1e2e3e.
OPERATIONS: dict[str, tuple[str, Callable[..., Any], int]] = {
    "product": ("({a}) * ({b})", lambda a, b: a * b, 1),
    "sum": ("({a}) + ({b})", lambda a, b: a + b, 1),
    "difference": ("({a}) - ({b})", lambda a, b: a - b, 1),
    "outer": ("({a}) ^ ({b})", lambda a, b: a ^ b, 1),
    "left contraction": ("({a}) | ({b})", lambda a, b: a.lc(b), 1),
    "regressive": ("({a}) & ({b})", lambda a, b: a.rp(b), -1),
    "sandwich": ("({a}) >> ({b})", lambda a, b: a * b * a.conjugate(), 1),
    "quotient": ("({a}) / ({b})", lambda a, b: a * b.inv(), 1),
    "reverse": ("~({a})", lambda a: ~a, 1),
    "negative": ("-({a})", lambda a: -a, 1),
    "conjugate": ("conj({a})", lambda a: a.conjugate(), 1),
    "dual": ("dual({a})", lambda a: a.hodge(), -1),
    "undual": ("undual({a})", lambda a: a.unhodge(), -1),
    "grade": ("grade({a}, 2)", lambda a: a.grade(2), 1),
    "cube": ("({a})**3", lambda a: a * a * a, 1),
}


def expressed(coefficients: Array, algebra: Algebra) -> str:
    """A multivector as an expression of the console: one of Cl(3,0,1) is converted blade by blade."""
    if algebra is CL031:
        return written(coefficients, CL031.names)
    signs = np.array([-1.0 if "e" in name.replace("e1", "").replace("e2", "").replace("e3", "") else 1.0
                      for name in PGA.names])  # fmt: skip
    return f"modern({written(coefficients * signs, CL031.names)})"


@pytest.mark.parametrize("algebra", [CL031, PGA], ids=str)
@pytest.mark.parametrize("name", OPERATIONS)
def test_kingdon_finds_the_same(name: str, algebra: Algebra) -> None:
    line, with_kingdon, orientation = OPERATIONS[name]
    generator = np.random.default_rng(7)
    for _ in range(5):
        a, b = generator.uniform(-2, 2, size=(2, 16)).round(3)
        found = value(f"a = {expressed(a, algebra)}", f"b = {expressed(b, algebra)}", line.format(a="a", b="b"))
        assert isinstance(found, Multivector)
        assert found.algebra is algebra
        operands = [a, b][: with_kingdon.__code__.co_argcount]
        expected = orientation * in_kingdon(algebra, with_kingdon, operands)
        np.testing.assert_allclose(found.values, expected, rtol=1e-9, atol=1e-9)


def test_the_exponential_moves_as_the_series_says_in_both_algebras() -> None:
    """exp(B) = 1 + B + B²/2 + …, in the algebra that B is of."""
    generator = np.random.default_rng(3)
    for algebra in (CL031, PGA):
        B = np.where(CL031.grades == 2, generator.uniform(-1, 1, 16).round(3), 0.0)
        series, term = np.eye(16)[0], np.eye(16)[0]
        for n in range(1, 30):
            term = algebra.product(term, B) / n
            series = series + term
        lines = (f"B = {expressed(B, algebra)}", "exp(B)")
        np.testing.assert_allclose(numbers(*lines), series, atol=1e-12)
        np.testing.assert_allclose(numbers(*lines[:1], "log(exp(B))"), B, atol=1e-12)


def quaternion(rotation: Rotation) -> str:
    x, y, z, w = rotation.as_quat()
    return f"quaternion({float(w)!r}, {float(x)!r}, {float(y)!r}, {float(z)!r})"


def wxyz(rotation: Rotation) -> Array:
    return np.roll(rotation.as_quat(canonical=True), 1)


def same_rotation(found: Array, expected: Rotation) -> None:
    np.testing.assert_allclose(found * np.sign(found @ wxyz(expected)), wxyz(expected), atol=1e-12)


def test_scipy_finds_the_same_quaternions() -> None:
    first, second = Rotation.random(8, random_state=1), Rotation.random(8, random_state=2)
    for p, q in zip(first, second, strict=True):
        lines = (f"p = {quaternion(p)}", f"q = {quaternion(q)}")
        same_rotation(numbers(*lines, "p*q"), p * q)
        same_rotation(numbers(*lines, "conj(p)"), p.inv())
        same_rotation(numbers(*lines, "p/q"), p * q.inv())
        same_rotation(numbers(*lines, "slerp(p, q, 0.3)"), Slerp([0, 1], Rotation.concatenate([p, q]))(0.3))
        same_rotation(numbers(*lines, "exp(log(p))"), p)
        np.testing.assert_allclose(2 * numbers(*lines, "log(p)")[1:], p.as_rotvec(), atol=1e-12)
        v = numbers(*lines, "p >> (i + 2*j - 3*k)")
        np.testing.assert_allclose(v[1:], p.apply([1, 2, -3]), atol=1e-12)
        turned = value(*lines, "rotate(p, point(1, 2, -3))")
        assert isinstance(turned, Multivector)
        np.testing.assert_allclose([turned[n] for n in ("e2e3e", "e3e1e", "e1e2e")], p.apply([1, 2, -3]), atol=1e-12)
        np.testing.assert_allclose(numbers(*lines, "motor(p) >> point(1, 2, -3)"), turned.values, atol=1e-12)
