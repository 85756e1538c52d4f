"""What is shown of an entry point: distance, depth, lever."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.geometry.clifford import CL031
from helicoide.ik.rcm.residuals import depth, fulcrum_ratio, lateral_distance

coordinate = st.floats(-1, 1)
point = st.tuples(coordinate, coordinate, coordinate).map(np.array)
direction = point.filter(lambda v: np.linalg.norm(v) > 0.1).map(rotation.unit_vector)


def vector(v: Array) -> Array:
    return np.asarray(v @ np.array([CL031.blade("e1"), CL031.blade("e2"), CL031.blade("e3")]))


@given(direction, point, point, st.floats(-2, 2))
def test_the_distance_is_the_size_of_a_bivector(d: Array, on_shaft: Array, entry: Array, along: float) -> None:
    """|d × (p − o)| = |(p − o) ∧ d|, and any point of the shaft will do."""
    distance = lateral_distance(d, on_shaft, entry)
    assert np.linalg.norm(CL031.outer(vector(entry - on_shaft), vector(d))) == pytest.approx(distance, abs=1e-12)
    assert lateral_distance(d, on_shaft + along * d, entry) == pytest.approx(distance, abs=1e-12)


@given(direction, point, st.floats(-1, 1), st.floats(0, 1))
def test_distance_and_depth_are_the_legs_of_a_triangle(d: Array, tip: Array, beyond: float, aside: float) -> None:
    across = np.linalg.svd(d[None, :])[2][1]
    entry = tip - beyond * d + aside * across
    assert depth(d, tip, entry) == pytest.approx(beyond, abs=1e-12)
    assert lateral_distance(d, tip, entry) == pytest.approx(aside, abs=1e-12)


@given(direction, point, st.floats(0.05, 0.5), st.floats(0.05, 0.5), point)
def test_the_handle_moves_against_the_tip(d: Array, entry: Array, outside: float, inside: float, turn: Array) -> None:
    """§1.2.2: about a fixed entry point handle and tip displacement are as −(outside/inside), however far it turns."""
    handle, tip = entry - outside * d, entry + inside * d
    R = rotation.exponential(turn)
    of_handle, of_tip = (R - np.eye(3)) @ (handle - entry), (R - np.eye(3)) @ (tip - entry)
    ratio = fulcrum_ratio(d, handle, tip, entry)
    assert ratio == pytest.approx(outside / inside, rel=1e-9)
    np.testing.assert_allclose(of_handle, -ratio * of_tip, atol=1e-12)


def test_no_lever_with_the_tip_at_the_entry() -> None:
    d, tip = np.array([0.0, 1.0, 0.0]), np.zeros(3)
    assert fulcrum_ratio(d, np.array([0.0, -0.3, 0.0]), tip, tip) == np.inf
