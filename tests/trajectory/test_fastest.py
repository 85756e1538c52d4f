"""The fastest scaling of a joint path: no limit is passed, one is met, and textbook times come out."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import arm, postures

from helicoide.arrays import Array
from helicoide.text import HelicoideError
from helicoide.trajectory.joints import JointMove
from helicoide.trajectory.path import SmoothJointPath
from helicoide.trajectory.spline import JointSpline
from helicoide.trajectory.time_optimal import MARGIN, TimingShape, limit_ratio, time_optimal_timing
from helicoide.trajectory.timing import TimedJoints, TrapezoidalVelocity

ARMS = ("movemaster", "puma560", "planar3r", "scara", "dia10", "polar_rp")
AT_REST: list[TimingShape] = ["trapezoid", "minimum jerk"]
FREE = np.full(2, np.inf)


def through(name: str, knots: int, seed: int) -> JointSpline:
    """Through random postures of an arm, at random instants."""
    rng = np.random.default_rng(seed)
    s = np.append(0.0, np.cumsum(rng.uniform(0.2, 1.0, knots - 1)))
    return JointSpline(s, np.array(postures(arm(name), knots, seed)))


def excess(path: TimedJoints, speed: Array, acceleration: Array, seed: int) -> float:
    """By how much a limit is passed, rad/s, rad/s² or in m, at many random instants and close to every corner."""
    near = (path.knots[:, None] + path.duration * np.array([-1e-7, 0.0, 1e-7])).ravel()
    t = np.append(np.random.default_rng(seed).uniform(0, path.duration, 20_000), near)
    return float(max((np.abs(path.rates(t)) - speed).max(), (np.abs(path.accelerations(t)) - acceleration).max()))


@given(
    name=st.sampled_from(ARMS),
    shape=st.sampled_from(AT_REST),
    knots=st.integers(2, 40),
    sharp=st.floats(0.2, 50.0),
    seed=st.integers(0, 1000),
)
def test_no_limit_is_passed_and_one_is_met(name: str, shape: TimingShape, knots: int, sharp: float, seed: int) -> None:
    """At instants of the test's own, by more than 1e-9; the least time is not missed by more than the margin."""
    speed = arm(name).speed
    acceleration = sharp * speed
    path = time_optimal_timing(through(name, knots, seed), shape, speed, acceleration)
    assert excess(path, speed, acceleration, seed) <= 1e-9
    assert limit_ratio(path, speed, acceleration) == pytest.approx(1 / (1 + MARGIN), rel=1e-3)


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("shape", AT_REST)
def test_the_ends_are_kept_exactly(name: str, shape: TimingShape) -> None:
    base = through(name, 9, 5)
    path = time_optimal_timing(base, shape, arm(name).speed, 3 * arm(name).speed)
    np.testing.assert_array_equal(path.q([0.0, path.duration]), base.samples[[0, -1]])
    np.testing.assert_array_equal(path.rates([0.0, path.duration]), np.zeros((2, base.samples.shape[1])))


@given(way=st.floats(0.01, 5.0), speed=st.floats(0.1, 3.0), acceleration=st.floats(0.1, 30.0))
def test_a_joint_move_takes_the_textbook_time(way: float, speed: float, acceleration: float) -> None:
    """d/v + v/a where the top speed is reached, else 2 √(d/a)."""
    textbook = way / speed + speed / acceleration if way > speed**2 / acceleration else 2 * np.sqrt(way / acceleration)
    limits = np.array([speed]), np.array([acceleration])
    move = JointMove(np.zeros(1), np.array([way]), 1.0)
    # the shortest ramp costs up to its own share where the acceleration hardly matters
    assert textbook <= time_optimal_timing(move, "trapezoid", *limits).duration <= textbook * 1.012
    jerk = max(15 / 8 * way / speed, np.sqrt(10 / np.sqrt(3) * way / acceleration))
    assert time_optimal_timing(move, "minimum jerk", *limits).duration == pytest.approx((1 + MARGIN) * jerk, rel=1e-5)


def test_the_slowest_joint_sets_the_time() -> None:
    move = JointMove(np.zeros(2), np.array([1.0, 0.5]), 4.0)
    limits = np.array([2.0, 0.25])
    assert time_optimal_timing(move, "constant speed", limits, FREE).duration == pytest.approx(2 * (1 + MARGIN))
    np.testing.assert_allclose(
        time_optimal_timing(move, "trapezoid", limits, FREE).duration, 2 * (1 + MARGIN) / 0.99, rtol=1e-9
    )


@pytest.mark.parametrize("shape", ["trapezoid", "minimum jerk", "constant speed"])
def test_the_time_does_not_depend_on_that_of_the_path(shape: TimingShape) -> None:
    slow, speed = through("puma560", 6, 2), arm("puma560").speed
    quick = JointSpline(slow.knots / 7, slow.samples)
    times = [time_optimal_timing(path, shape, speed, np.full(6, np.inf)).duration for path in (slow, quick)]
    assert times[0] == pytest.approx(times[1], rel=1e-9)


@pytest.mark.parametrize("sharp", [0.3, 2.0, 10.0])
@pytest.mark.parametrize("seed", range(5))
def test_the_best_ramp_is_better_than_others(seed: int, sharp: float) -> None:
    """No other ramp of a fine comb takes less time by more than a thousandth."""
    path, speed = through("puma560", 7, seed), arm("puma560").speed
    limits = speed, sharp * speed
    found = time_optimal_timing(path, "trapezoid", *limits).duration / (1 + MARGIN)
    combed = [
        limit_ratio(TimedJoints(path, TrapezoidalVelocity(ramp), 1.0), *limits) for ramp in np.linspace(0.01, 0.5, 50)
    ]
    assert found <= min(combed) * 1.001


def test_an_overload_is_the_factor_on_the_time() -> None:
    path, speed = through("scara", 6, 1), arm("scara").speed
    timed = time_optimal_timing(path, "minimum jerk", speed, speed)
    hurried = TimedJoints(path, timed.law, timed.duration / 3)
    assert limit_ratio(hurried, speed, speed) == pytest.approx(3 / (1 + MARGIN), rel=1e-12)


def test_constant_speed_is_refused_where_it_would_need_a_jump() -> None:
    move = JointMove(np.zeros(2), np.array([1.0, 0.0]), 1.0)
    speed = np.ones(2)
    with pytest.raises(HelicoideError, match=r"do not allow: 1\. Use a trapezoidal velocity or minimum jerk"):
        time_optimal_timing(move, "constant speed", speed, np.array([5.0, 5.0]))
    free_first = np.array([np.inf, 5.0])
    assert time_optimal_timing(move, "constant speed", speed, free_first).duration == pytest.approx(1 + MARGIN)


def test_constant_speed_keeps_the_acceleration_on_the_way() -> None:
    """A path that begins and ends at rest itself."""
    base = time_optimal_timing(JointMove(np.zeros(1), np.ones(1), 1.0), "minimum jerk", np.ones(1), np.ones(1))
    assert time_optimal_timing(base, "constant speed", np.ones(1), np.ones(1)).duration == pytest.approx(
        base.duration, rel=2e-3
    )


@pytest.mark.parametrize("shape", ["trapezoid", "minimum jerk", "constant speed"])
def test_a_path_without_motion_has_no_time(shape: TimingShape) -> None:
    still: SmoothJointPath = JointMove(np.ones(2), np.ones(2), 1.0)
    with pytest.raises(HelicoideError, match="No joint moves"):
        time_optimal_timing(still, shape, np.ones(2), FREE)
