"""The full counts of the closed forms: 20,000 poses of the Movemaster, 3 × 1,500 arms of Pieper's."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.closed import test_movemaster, test_pieper

from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import random_spherical_arm

pytestmark = pytest.mark.soak

POSES, ARMS = 20_000, 1_500


def test_the_movemaster_in_all_its_postures(robot: Robot) -> None:
    missed, apart, counts = test_movemaster.there_and_back(robot, POSES, seed=5)
    print(f"missed {missed:.1e}, generating posture {apart:.1e} rad, postures {sorted(counts)}")
    assert missed < 1e-9
    assert apart < 1e-6
    assert counts <= {1, 2, 3, 4}


@pytest.mark.parametrize("right_wrist", [True, False], ids=["wrist ±90°", "any wrist"])
@pytest.mark.parametrize("family", test_pieper.FAMILIES)
def test_random_arms(family: str, right_wrist: bool) -> None:
    draw = np.random.default_rng(1968)
    arms = [random_spherical_arm(draw, family, right_wrist) for _ in range(ARMS)]
    missed, apart, counts = test_pieper.there_and_back(arms, draw)
    print(f"missed {missed:.1e}, generating posture {apart:.1e} rad, postures {sorted(counts)}")
    assert missed < 1e-9
    assert apart < 1e-5
    assert max(counts) <= 8
