"""The family of eq. 31 and its members, number by number."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.kinematics.arms import twist_by_differences

from helicoide.geometry import rotation
from helicoide.trajectory.cerbaro import EQ_33, EQ_34, EQ_35, MOVEMASTER_ELLIPSE, ORCA_CIRCLE, Ellipse
from helicoide.trajectory.path import Path, path_length

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


@pytest.mark.parametrize(
    ("path", "start", "pitch", "roll"),
    [
        (EQ_33, (460, 0, 230), -60, 0),
        (EQ_34, (550, 0, 230), 0, 90),
        (EQ_35, (260, 100, 200), -70, 30),
        (MOVEMASTER_ELLIPSE, (440, 0, 200), -60, 0),
    ],
)
def test_starts_and_orientations(path: Ellipse, start: tuple[float, float, float], pitch: float, roll: float) -> None:
    """Cerbaro 2022, eqs. 33 to 35 and §4.4.4; ϑ = −1.2217 and ψ = 0.5236 of eq. 35 are −70° and 30°."""
    T = path.pose(0.0)
    np.testing.assert_allclose(1000 * T[:3, 3], start, rtol=0, atol=1e-9)
    heading, about_y, about_x = np.degrees(rotation.roll_pitch_yaw_zyx(T[:3, :3]))
    assert heading == pytest.approx(np.degrees(np.arctan2(start[1], start[0])), abs=1e-9)
    assert (-about_y, about_x) == (pytest.approx(pitch, abs=1e-9), pytest.approx(roll, abs=1e-9))
    assert path.duration == (60.0 if path is MOVEMASTER_ELLIPSE else 30.0)


@pytest.mark.parametrize(
    ("path", "lowest", "highest"),
    [
        (EQ_33, (460, -280, 90), (580, 280, 370)),
        (EQ_34, (550, -250, 180), (550, 250, 280)),
        (EQ_35, (260, -120, 200), (700, 320, 200)),
        (MOVEMASTER_ELLIPSE, (440, -80, 150), (600, 80, 250)),
        (ORCA_CIRCLE, (260, 80, 0), (460, 280, 0)),
    ],
)
def test_limits(path: Path, lowest: tuple[float, ...], highest: tuple[float, ...]) -> None:
    points = 1000 * np.array([path.pose(s)[:3, 3] for s in np.linspace(0, path.duration, 241)])
    np.testing.assert_allclose(points.min(axis=0), lowest, rtol=0, atol=1e-9)
    np.testing.assert_allclose(points.max(axis=0), highest, rtol=0, atol=1e-9)


def test_the_line_goes_between_its_two_ends() -> None:
    """Cerbaro 2022, §6.1: A = (550, 250, 280), B = (550, −250, 180) mm, from mid-way; two widths make a turn."""
    a, b = 1000 * EQ_34.point(7.5), 1000 * EQ_34.point(22.5)
    np.testing.assert_allclose([a, b], [[550, 250, 280], [550, -250, 180]], rtol=0, atol=1e-9)
    np.testing.assert_allclose(1000 * EQ_34.point(0.0), (a + b) / 2, atol=1e-9)
    # the speed has a corner at either end, which lies between two of 64 pieces
    assert 1000 * path_length(EQ_34) == pytest.approx(2 * np.hypot(500, 100), rel=1e-12)


def test_the_circle_is_level() -> None:
    """Eq. 35: parallel to xy, a circle of 220 mm about (480, 100), once round."""
    points = 1000 * np.array([EQ_35.point(s) for s in np.linspace(0, 30, 97)])
    np.testing.assert_allclose(np.hypot(points[:, 0] - 480, points[:, 1] - 100), 220, rtol=1e-12)
    assert 1000 * path_length(EQ_35) == pytest.approx(2 * np.pi * 220, rel=1e-12)


def test_the_first_turn_is_clockwise_seen_from_above() -> None:
    """Experiment 1; so are the demonstrations here."""
    for path in (EQ_33, MOVEMASTER_ELLIPSE, ORCA_CIRCLE):
        p, v = path.pose(0.0)[:3, 3], path.twist(0.0)[:3]
        to_centre = path.pose(path.duration / 2)[:3, 3] - p
        assert np.cross(to_centre, v)[2] > 0


def test_eq_32_is_not_the_derivative() -> None:
    """Eq. 32: (π/4) (sin πt, cos πt, cos πt) is printed for every path; that of eq. 31 is (2π rᵢ/T) (sin, cos, cos)."""
    w = 2 * np.pi / 30
    expected = [0.06 * w * np.sin(2 * w), 0.28 * w * np.cos(2 * w), 0.14 * w * np.cos(2 * w)]
    np.testing.assert_allclose(EQ_33.twist(2.0)[:3], expected, rtol=1e-14)


def test_the_orca_keeps_its_orientation() -> None:
    """Cerbaro 2022, §4.4.3: from (260, 180) round (360, 180), φ = 0, in 60 s."""
    np.testing.assert_allclose(1000 * ORCA_CIRCLE.pose(0.0)[:3, 3], [260, 180, 0], atol=1e-12)
    np.testing.assert_array_equal(ORCA_CIRCLE.pose(17.0)[:3, :3], np.eye(3))
    in_eq_31 = Ellipse((0.36, 0.18, 0.0), (0.1, 0.1, 0.0), 0.0, 0.0, 60.0)
    for s in (0.0, 11.0, 40.0):
        np.testing.assert_allclose(ORCA_CIRCLE.pose(s)[:3, 3], in_eq_31.point(s), atol=1e-15)
        np.testing.assert_allclose(ORCA_CIRCLE.twist(s)[:3], in_eq_31.velocity(s), atol=1e-15)


@given(path=ellipses, s=st.floats(0.0, 1.0))
def test_the_twist_is_the_derivative_of_the_pose(path: Ellipse, s: float) -> None:
    """Where the heading can be told: its differences are taken 2e-3 of a period to both sides."""
    here = np.linspace(s - 0.003, s + 0.003, 13) * path.period
    assume(min(np.hypot(*path.point(at)[:2]) for at in here) > 0.2)
    scale = path.period
    expected = twist_by_differences(lambda at: path.pose(float(at[0]) * scale), np.array([s]))[:, 0]
    np.testing.assert_allclose(scale * path.twist(s * scale), expected, rtol=0, atol=1e-5)


def test_above_the_waist_nothing_turns() -> None:
    through_the_axis = Ellipse((0.0, 0.0, 0.5), (0.2, 0.0, 0.0), 0.0, 0.0, 4.0)
    assert through_the_axis.point(1.0)[0] == pytest.approx(0.0, abs=1e-16)
    still_there = Ellipse((0.0, 0.0, 0.5), (0.0, 0.0, 0.1), 0.0, 0.0, 4.0)
    np.testing.assert_array_equal(still_there.twist(0.5)[3:], np.zeros(3))
