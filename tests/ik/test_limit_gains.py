"""Algorithm 1: what one update does, and the third demonstration of the Movemaster with it."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.secondary_runs import LoopRun, chosen

from helicoide.arrays import Array, frozen
from helicoide.ik import secondary
from helicoide.ik.limit_gains import GROWTH, clipped
from helicoide.studies.cerbaro_runs.setups import movemaster
from helicoide.studies.cerbaro_runs.tracking import LimitGain, run_free_ellipse, start_of_ellipse

LIMITS = chosen("limit_distance")


def test_a_clip_puts_the_joint_on_its_limit_and_raises_its_gain_by_a_hundredth() -> None:
    lower, upper, q = frozen([-1, -1, -1]), frozen([1, 1, 1]), frozen([-1.2, 0.3, 1.1])
    k0 = frozen([100, 100, 50])
    kept, grown = clipped(q, lower, upper, k0)
    np.testing.assert_array_equal(kept, [-1, 0.3, 1])
    np.testing.assert_array_equal(grown, [101, 100, 50.5])
    again, same = clipped(kept, lower, upper, grown)
    np.testing.assert_array_equal(again, kept)
    np.testing.assert_array_equal(same, grown)
    np.testing.assert_array_equal(k0, [100, 100, 50])


def test_gains_are_the_diagonal_of_k0() -> None:
    here = movemaster()
    q, k0 = here.robot.poses["example"], np.array([1.0, 2, 3, 4, 5])
    one = secondary.push(here, LIMITS, 1.0)(q, 0.0)
    np.testing.assert_allclose(secondary.push(here, LIMITS, k0)(q, 0.0), np.diag(k0) @ one, rtol=1e-15)


def ellipse(q: Array, k0: float, seconds: float, algorithm_1: bool = True) -> LoopRun:
    return run_free_ellipse(q, LimitGain(k0, GROWTH if algorithm_1 else None), 1e-3, seconds=seconds)


def test_from_outside_the_limits_the_gain_grows_five_times_and_the_tool_is_thrown_off_by_75_mm() -> None:
    """Cerbaro 2022, §4.5, recomputed: J3 500 → 525.5, then inside; the error is gone again at once."""
    run = ellipse(start_of_ellipse(-60), 500.0, 0.4)
    k0 = run.last.memory.gains
    np.testing.assert_allclose(k0, [500, 500, 500 * 1.01**5, 500, 500], rtol=1e-14)
    assert k0[2] == pytest.approx(525.5, abs=0.05)
    assert np.degrees(run.q[0, 2]) == pytest.approx(-129.943, abs=1e-3)
    assert np.degrees(run.q[1:, 2]).min() >= -120 - 1e-9
    assert run.position_error.max() == pytest.approx(75, abs=0.5)
    assert run.since(0.05).position_error.max() < 0.05
    plain = ellipse(start_of_ellipse(-60), 500.0, 0.4, algorithm_1=False)
    assert (np.degrees(plain.q[:10, 2]) < -120).all()
    assert plain.position_error.max() == pytest.approx(0.007, abs=2e-4)


def test_from_inside_the_limits_the_error_is_unchanged() -> None:
    """With the gain of the source no clip comes: the same run. Both start at J3 = −119.91°, the limit is −120°."""
    q = start_of_ellipse(-68.2)
    kept, plain = ellipse(q, 500.0, 1.0), ellipse(q, 500.0, 1.0, algorithm_1=False)
    np.testing.assert_array_equal(kept.position_error, plain.position_error)
    np.testing.assert_array_equal(kept.last.memory.gains, 500)


def test_a_gain_that_is_too_small_grows_until_the_joint_stays_inside() -> None:
    """k0 = 0.2: with one gain for all J3 passes its limit by 0.2°; each clip costs the tool some micrometres only."""
    q = start_of_ellipse(-68.2)
    kept, plain = ellipse(q, 0.2, 3.0), ellipse(q, 0.2, 3.0, algorithm_1=False)
    assert np.degrees(plain.q[:, 2].min()) == pytest.approx(-120.2, abs=0.02)
    assert np.degrees(kept.q[:, 2].min()) >= -120 - 1e-9
    assert kept.position_error.max() < 0.005
    k0 = kept.last.memory.gains
    clips = np.log(k0[2] / 0.2) / np.log(1.01)
    assert 90 < clips < 110
    assert clips == pytest.approx(round(clips), abs=1e-9)
    np.testing.assert_array_equal(k0[[0, 1, 3, 4]], 0.2)
    np.testing.assert_allclose(kept.last.q[4], 0, rtol=0, atol=1e-15)
