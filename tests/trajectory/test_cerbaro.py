"""The family of eq. 31 and its members, number by number."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from helicoide.trajectory.cerbaro import EQ_33, Ellipse

lengths = st.tuples(*[st.floats(-0.6, 0.6)] * 3)
angles = st.floats(-np.pi, np.pi)
ellipses = st.builds(Ellipse, centre=lengths, radii=lengths, pitch=angles, roll=angles, period=st.floats(1.0, 60.0))
parameters = st.floats(-60, 60)


@given(path=ellipses, s=parameters)
def test_the_velocity_is_the_derivative(path: Ellipse, s: float) -> None:
    h = 1e-4 * path.period
    difference = (path.point(s + h) - path.point(s - h)) / (2 * h)
    np.testing.assert_allclose(path.velocity(s), difference, rtol=0, atol=1e-6 * max(1.0, 1.0 / path.period) * 10)


@given(path=ellipses, s=parameters)
def test_the_path_is_closed(path: Ellipse, s: float) -> None:
    assume(np.hypot(*path.point(s)[:2]) > 1e-3)  # above the waist there is no heading
    np.testing.assert_allclose(path.pose(s + path.period), path.pose(s), rtol=0, atol=1e-9)


@given(path=ellipses, s=parameters)
def test_poses_are_rigid_and_stand_on_the_path(path: Ellipse, s: float) -> None:
    T = path.pose(s)
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-12)
    assert np.linalg.det(T[:3, :3]) > 0
    np.testing.assert_array_equal(T[:3, 3], path.point(s))
    np.testing.assert_array_equal(T[3], [0, 0, 0, 1])


@given(path=ellipses.filter(lambda path: abs(path.pitch) < 1.5), s=parameters)
def test_the_tool_heads_away_from_the_waist_at_its_pitch(path: Ellipse, s: float) -> None:
    T, (x, y, _) = path.pose(s), path.point(s)
    r = np.hypot(x, y)
    assert abs(T[2, 0] - np.sin(path.pitch)) < 1e-12
    np.testing.assert_allclose(r * T[:2, 0], np.cos(path.pitch) * np.array([x, y]), atol=1e-12)


def test_where_the_first_experiment_begins() -> None:
    """Cerbaro 2022, eq. 33: (460, 0, 230) mm, the tool 60 degrees below level; one turn clockwise seen from above."""
    np.testing.assert_allclose(1000 * EQ_33.point(0), [460, 0, 230], atol=1e-9)
    np.testing.assert_allclose(EQ_33.pose(0)[:3, 0], [0.5, 0, -np.sqrt(0.75)], atol=1e-12)
    np.testing.assert_allclose(1000 * EQ_33.point(7.5), [520, 280, 370], atol=1e-9)
    np.testing.assert_allclose(1000 * EQ_33.point(15), [580, 0, 230], atol=1e-9)
