"""The long counts of the numerical solver: a thousand and ten thousand poses, and all postures of a thousand."""

from __future__ import annotations

import pytest
from tests.ik.postures.test_numeric import MEASURED, failures, robot_of, same_postures
from tests.kinematics.arms import postures

from helicoide.ik import closed
from helicoide.ik.postures import numeric
from helicoide.ik.postures.branch import tool_at

pytestmark = pytest.mark.soak


@pytest.mark.parametrize("count", [1_000, 10_000])
@pytest.mark.parametrize("name", MEASURED)
def test_every_reachable_pose_is_reached(name: str, count: int) -> None:
    assert failures(robot_of(name), count, seed=count) == []


def test_all_eight_postures_of_the_puma_are_found() -> None:
    robot = robot_of("puma560")
    form = closed.closed_forms()["puma560"]
    for q in postures(robot, 1_000, seed=9):
        goal = tool_at(robot, q)
        assert same_postures(
            robot, numeric.branches(robot, goal, q), closed.solve_closed_form(form, robot, goal, q), 1e-5
        )
