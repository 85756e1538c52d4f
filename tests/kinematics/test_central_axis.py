"""The central axis of a twist or wrench: on it the moment is parallel, and it moves with the scene."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from helicoide.arrays import Array
from helicoide.kinematics.central_axis import central_axis

vectors = st.tuples(*[st.floats(-10, 10)] * 3).map(np.array)
turning = vectors.filter(lambda v: float(np.linalg.norm(v)) > 1e-2)


@given(turning, vectors, vectors)
def test_on_the_axis_the_moment_is_the_pitch_times_the_vector(s: Array, m: Array, p: Array) -> None:
    axis = central_axis(s, m, p, 1.0)
    assert axis is not None
    there = m + np.cross(s, axis.point - p)
    np.testing.assert_allclose(there, axis.pitch * s, rtol=0, atol=1e-9)
    np.testing.assert_allclose(axis.size * axis.direction, s, rtol=0, atol=1e-12)
    assert abs((axis.point - p) @ s) < 1e-7 * (1 + np.linalg.norm(axis.point - p) * np.linalg.norm(s))


@given(turning, vectors, vectors)
def test_it_is_the_screw_of_the_matrix_exponential(omega: Array, v: Array, p: Array) -> None:
    """exp of the twist turns about the axis by |ω| and slides along it by h |ω|: points of the axis stay on it."""
    axis = central_axis(omega, v, p, 1.0)
    assert axis is not None
    x, y, z = omega
    twist = np.zeros((4, 4))
    twist[:3, :3] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    twist[:3, 3] = v - np.cross(omega, p)
    T = expm(twist)
    far = axis.point + 0.7 * axis.direction
    size = 1 + np.linalg.norm(far) + abs(axis.along)
    np.testing.assert_allclose(T[:3, :3] @ far + T[:3, 3], far + axis.along * axis.direction, rtol=0, atol=1e-9 * size)
    np.testing.assert_allclose(T[:3, :3], Rotation.from_rotvec(omega).as_matrix(), rtol=0, atol=1e-9)


def test_without_a_rotation_it_is_the_direction_and_without_anything_none() -> None:
    still, p = np.zeros(3), np.array([1.0, 2.0, 3.0])
    axis = central_axis(still, np.array([0.0, 3.0, 4.0]), p, 1.0)
    assert axis is not None
    assert (axis.size, axis.along, axis.pitch) == (0.0, 5.0, np.inf)
    np.testing.assert_array_equal(axis.direction, [0, 0.6, 0.8])
    assert central_axis(still, still, p, 1.0) is None


def test_an_axis_that_is_very_far_away_counts_as_none() -> None:
    """A straight motion has a rotation by the small errors of the step: its axis would be drawn kilometres away."""
    v = np.array([0.1, 0.0, 0.0])
    axis = central_axis(np.array([0.0, 0.0, 1e-6]), v, np.zeros(3), 1.0)
    assert axis is not None
    assert (axis.size, axis.along) == (0.0, 0.1)
    np.testing.assert_array_equal(axis.direction, [1.0, 0.0, 0.0])
