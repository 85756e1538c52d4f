"""Laws of time, and paths that run by them."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.trajectory.test_spline import random

from helicoide.trajectory.cerbaro import EQ_33
from helicoide.trajectory.path import path_length
from helicoide.trajectory.timing import (
    ConstantSpeed,
    MinimumJerk,
    TimedJoints,
    TimedPath,
    TimeScaling,
    TrapezoidalVelocity,
)

ramps = st.floats(0.01, 0.5)
laws = st.one_of(st.just(ConstantSpeed()), st.just(MinimumJerk()), st.builds(TrapezoidalVelocity, ramps))


@given(law=laws)
def test_a_law_goes_from_0_to_1_without_turning_back(law: TimeScaling) -> None:
    share, speed, _ = law.at(np.linspace(0, 1, 501))
    assert (share[0], share[-1]) == (0.0, 1.0)
    assert (np.diff(share) >= 0).all()
    assert (speed >= 0).all()
    assert law.corners[0] == 0.0
    assert law.corners[-1] == 1.0


@given(law=laws, place=st.floats(0.01, 0.99))
def test_the_derivatives_of_a_law(law: TimeScaling, place: float) -> None:
    """Between its corners."""
    for start, end in zip(law.corners, law.corners[1:], strict=False):
        u, h = start + place * (end - start), 1e-4 * place * (1 - place) * (end - start)
        if end - start < 1e-6:
            continue
        before, here, after = (law.at(u + way * h) for way in (-1, 0, 1))
        scale = max(1.0, float(here[1]), abs(float(here[2])))
        tolerance = scale * (1e-6 + 4 * np.finfo(float).eps / h)
        assert here[1] == pytest.approx((after[0] - before[0]) / (2 * h), abs=tolerance)
        assert here[2] == pytest.approx((after[1] - before[1]) / (2 * h), abs=tolerance)


@given(law=laws, u=st.floats(0.0, 1.0))
def test_a_law_is_the_same_backwards(law: TimeScaling, u: float) -> None:
    there, back = law.at(u), law.at(1 - u)
    assert there[0] == pytest.approx(1 - back[0], abs=1e-12)
    assert there[1] == pytest.approx(back[1], abs=1e-10)


@pytest.mark.parametrize("law", [MinimumJerk(), TrapezoidalVelocity(0.25), TrapezoidalVelocity(0.5)])
def test_both_ends_are_at_rest(law: TimeScaling) -> None:
    assert law.at(0.0)[1] == law.at(1.0)[1] == 0


def test_the_figures_of_the_laws() -> None:
    """Trapezoid: top speed 1/(1 − β); minimum jerk: top speed 15/8 midway, sharpest 10/√3 at (3 ∓ √3)/6."""
    assert TrapezoidalVelocity(0.25).at(0.5)[1] == pytest.approx(4 / 3)
    assert TrapezoidalVelocity(0.25).at(0.1)[2] == pytest.approx(16 / 3)
    assert TrapezoidalVelocity(0.5).at(0.5 - 1e-12)[1] == pytest.approx(2.0)
    assert MinimumJerk().at(0.5)[1] == pytest.approx(15 / 8)
    assert MinimumJerk().at((3 - np.sqrt(3)) / 6)[2] == pytest.approx(10 / np.sqrt(3))
    assert MinimumJerk().at(0.0)[2] == MinimumJerk().at(1.0)[2] == 0
    assert ConstantSpeed().at(0.3) == (0.3, 1.0, 0.0)


@given(law=laws, duration=st.floats(1.0, 50.0))
def test_a_path_runs_by_its_law(law: TimeScaling, duration: float) -> None:
    path = TimedPath(EQ_33, law, duration)
    share, rate, _ = law.at(0.3)
    np.testing.assert_allclose(path.pose(0.3 * duration), EQ_33.pose(30.0 * float(share)), atol=1e-12)
    expected = float(rate) * 30.0 / duration * EQ_33.twist(30.0 * float(share))
    np.testing.assert_allclose(path.twist(0.3 * duration), expected, atol=1e-12)
    assert path.is_closed


@pytest.mark.parametrize("law", [ConstantSpeed(), MinimumJerk(), TrapezoidalVelocity(0.25)])
def test_the_way_is_as_long_at_any_speed(law: TimeScaling) -> None:
    assert path_length(TimedPath(EQ_33, law, 7.0)) == pytest.approx(path_length(EQ_33), rel=1e-10)


@pytest.mark.parametrize("law", [ConstantSpeed(), MinimumJerk(), TrapezoidalVelocity(0.2), TrapezoidalVelocity(0.5)])
def test_joints_run_by_their_law(law: TimeScaling) -> None:
    base = random(6, 1)
    path = TimedJoints(base, law, 2.5)
    t, h = np.linspace(0.013, 2.48, 61), 1e-5
    t = t[np.abs(t[:, None] - path.knots).min(axis=1) > 2 * h]
    np.testing.assert_allclose(path.rates(t), (path.q(t + h) - path.q(t - h)) / (2 * h), atol=1e-6)
    np.testing.assert_allclose(path.accelerations(t), (path.rates(t + h) - path.rates(t - h)) / (2 * h), atol=1e-5)
    np.testing.assert_array_equal(path.q([0.0, 2.5]), base.samples[[0, -1]])
    np.testing.assert_array_equal(path.q([-1.0, 9.0]), base.samples[[0, -1]])
    assert path.knots[0] == 0.0
    assert path.knots[-1] == 2.5
    passed = path.law.at(path.knots / 2.5)[0] * base.duration
    assert np.abs(base.knots[:, None] - passed).min(axis=1).max() < 1e-5
