"""The long counts: a million ticks, twenty thousand goals. Run with `make soak`."""

from __future__ import annotations

import numpy as np
import pytest
from tests.driving import clear_goal, misses, rough_ride

from helicoide.kinematics.robot import Robot
from helicoide.state import initial_state

pytestmark = pytest.mark.soak

RIDES, TICKS = 20, 50_000
BATCHES, GOALS = 10, 1_000


@pytest.mark.parametrize("seed", range(1_000, 1_000 + RIDES))
def test_no_promise_is_broken_in_a_million_ticks(robot: Robot, seed: int) -> None:
    worst = rough_ride(initial_state(robot), np.random.default_rng(seed), TICKS)
    print(f"seed {seed}: {worst}")
    assert worst.ticks >= TICKS


@pytest.mark.parametrize("with_orientation", [True, False])
@pytest.mark.parametrize("seed", range(2_000, 2_000 + BATCHES))
def test_the_arm_gets_where_the_way_is_clear(robot: Robot, seed: int, with_orientation: bool) -> None:
    """At least 99 of 100 of 20,000 goals in all, batch by batch."""
    rng = np.random.default_rng(seed)
    left = np.array([misses(*clear_goal(rng, initial_state(robot)), with_orientation) for _ in range(GOALS)])
    print(f"seed {seed}, orientation {with_orientation}: {np.mean(left < 1e-3):.2%}, worst {1000 * left.max():.1f} mm")
    assert np.mean(left < 1e-3) >= 0.99
