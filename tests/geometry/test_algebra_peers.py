"""The Python packages kingdon and clifford find the same products, once their blades are called by our names."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import clifford  # type: ignore[import-untyped]
import kingdon  # type: ignore[import-untyped]
import numpy as np
import pytest

from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Algebra, Array

ALGEBRAS = (CL031, PGA, QUATERNIONS, Algebra(3, 0, 0), Algebra(4, 1, 0))
Operation = Callable[..., Any]

# Neither `|` is in the table: kingdon's and clifford's are other inner products than the left contraction.
SAME: dict[str, tuple[Operation, Operation, Operation]] = {
    "geometric": (Algebra.product, lambda a, b: a * b, lambda a, b: a * b),
    "outer": (Algebra.outer, lambda a, b: a ^ b, lambda a, b: a ^ b),
    "left contraction": (Algebra.left_contraction, lambda a, b: a.lc(b), lambda a, b: a.lc(b)),
    "sandwich": (Algebra.sandwich, lambda a, b: a * b * a.conjugate(), lambda a, b: a * b * a.conjugate()),
    "reverse": (Algebra.reverse, lambda a: ~a, lambda a: ~a),
    "involution": (Algebra.involute, lambda a: a.involute(), lambda a: a.gradeInvol()),
    "conjugate": (Algebra.conjugate, lambda a: a.conjugate(), lambda a: a.conjugate()),
}
# Their pseudoscalar has the null generator in front: the star, and what is made with it, turn with its sign.
UP_TO_ORIENTATION: dict[str, tuple[Operation, Operation, Operation]] = {
    "star": (Algebra.hodge, lambda a: a.hodge(), lambda a: a.right_complement()),
    "inverse star": (Algebra.inverse_hodge, lambda a: a.unhodge(), lambda a: a.left_complement()),
    "regressive": (Algebra.regressive, lambda a, b: a.rp(b), lambda a, b: a.vee(b)),
}


@cache
def kingdon_of(algebra: Algebra) -> tuple[Any, list[tuple[int, int]]]:
    """kingdon calls the blade 1 "e" and numbers a null generator 0, as our compact names do."""
    peer = kingdon.Algebra(algebra.p, algebra.q, algebra.r)
    return peer, [algebra.parse_blade("1" if name == "e" else name) for name in peer.canon2bin]


@cache
def clifford_of(algebra: Algebra) -> tuple[Any, list[tuple[int, int]]]:
    """clifford calls the blade 1 "", and numbers generators from 1 with a null one first."""
    peer, _ = clifford.Cl(algebra.p, algebra.q, algebra.r)
    labels = ["e" + "".join(str(int(digit) - algebra.r) for digit in name[1:]) for name in peer.names]
    return peer, [algebra.parse_blade("1" if label == "e" else label) for label in labels]


def theirs(order: list[tuple[int, int]], ours: Array) -> list[float]:
    return [float(sign * ours[place]) for place, sign in order]


def ours(order: list[tuple[int, int]], theirs: list[float]) -> Array:
    values = np.zeros(len(order))
    for (place, sign), value in zip(order, theirs, strict=True):
        values[place] = sign * value
    return values


def in_kingdon(algebra: Algebra, operation: Operation, operands: list[Array]) -> Array:
    peer, order = kingdon_of(algebra)
    keys = tuple(peer.canon2bin.values())
    result = operation(*(peer.multivector(keys=keys, values=theirs(order, a)) for a in operands))
    found = dict(result.items())
    return ours(order, [found.get(key, 0.0) for key in keys])


def in_clifford(algebra: Algebra, operation: Operation, operands: list[Array]) -> Array:
    peer, order = clifford_of(algebra)
    return ours(order, operation(*(peer.MultiVector(theirs(order, a)) for a in operands)).value)


def operands_of(algebra: Algebra, operation: Operation) -> list[Array]:
    count = operation.__code__.co_argcount
    return list(np.random.default_rng(1).uniform(-2, 2, size=(count, len(algebra.blades))))


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
@pytest.mark.parametrize("name", SAME)
def test_peers_find_the_same(name: str, algebra: Algebra) -> None:
    own, with_kingdon, with_clifford = SAME[name]
    operands = operands_of(algebra, with_clifford)
    expected = own(algebra, *operands)
    np.testing.assert_allclose(in_kingdon(algebra, with_kingdon, operands), expected, atol=1e-12)
    np.testing.assert_allclose(in_clifford(algebra, with_clifford, operands), expected, atol=1e-12)


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
@pytest.mark.parametrize("name", UP_TO_ORIENTATION)
def test_peers_find_the_same_up_to_the_order_of_the_pseudoscalar(name: str, algebra: Algebra) -> None:
    own, with_kingdon, with_clifford = UP_TO_ORIENTATION[name]
    _, orientation = algebra.parse_blade(algebra.compact_names[-1])
    assert orientation == (-1 if algebra in (CL031, PGA) else 1)
    operands = operands_of(algebra, with_clifford)
    expected = orientation * own(algebra, *operands)
    np.testing.assert_allclose(in_kingdon(algebra, with_kingdon, operands), expected, atol=1e-12)
    np.testing.assert_allclose(in_clifford(algebra, with_clifford, operands), expected, atol=1e-12)


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
def test_peers_find_the_same_inverse_and_squared_norm(algebra: Algebra) -> None:
    (a,) = operands_of(algebra, lambda a: a)
    found = in_clifford(algebra, lambda a: a.shirokov_inverse(), [a])
    np.testing.assert_allclose(found, algebra.inverse(a), rtol=1e-9, atol=1e-9)
    if algebra.p + algebra.q + algebra.r < 5:  # kingdon takes minutes to write down a general inverse of 32 blades
        found = in_kingdon(algebra, lambda a: a.inv(), [a])
        np.testing.assert_allclose(found, algebra.inverse(a), rtol=1e-9, atol=1e-9)
    peer, order = clifford_of(algebra)
    assert peer.MultiVector(theirs(order, a)).mag2() == pytest.approx(algebra.squared_norm(a), abs=1e-12)
