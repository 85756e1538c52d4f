"""The full count of the polar arm's closed form: 20,000 postures. Run with `make soak`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from tests.ik.closed.rows import worst
from tests.ik.closed.small_arms import recovered

from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import polar
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot

pytestmark = pytest.mark.soak

COUNT = 20_000


def answers(form: object, robot: Robot, lower: Array, upper: Array) -> Iterator[tuple[Array, Answer]]:
    for q in np.random.default_rng(20).uniform(lower, upper, (COUNT, lower.size)):
        yield q, closed.solve_closed_form(form, robot, tool_at(robot, frozen(q)), robot.poses["ready"])  # type: ignore[attr-defined]


def test_polar() -> None:
    robot = load_robot("polar_rp")
    missed, lost = 0.0, 0.0
    for q, answer in answers(polar, robot, robot.lower, robot.upper):
        missed, lost = max(missed, worst(robot, answer)), max(lost, recovered(answer, q))
    print(f"polar arm: missed {missed:.1e}, generating posture within {lost:.1e}")
    assert missed < 1e-12
    assert lost < 1e-12
