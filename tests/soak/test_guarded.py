"""A million guarded ticks among random planes and obstacles."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.walks import ARMS, scene, walked

pytestmark = pytest.mark.soak

STEPS, SCENES = 14_000, 12


@pytest.mark.parametrize("name", ARMS)
def test_no_promise_is_broken_in_a_million_steps(name: str) -> None:
    """Half of the scenes with limits of acceleration; the share of steps in which these gave way is printed."""
    for seed in range(SCENES):
        acceleration = (np.inf, 20.0, np.inf, 5.0)[seed % 4]
        found = walked(scene(name, 1000 + seed, obstacles=seed % 4, acceleration=acceleration), STEPS, seed)
        print(name, seed, acceleration, found)
        assert found.unfinished == 0
        assert max(found.closer, found.outside, found.too_fast) <= 1e-9
        assert found.shortened + found.stopped <= 0.1 * STEPS
