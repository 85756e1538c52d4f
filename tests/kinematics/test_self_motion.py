"""Self-motion keeps the tool in place while the joint that it follows moves."""

from __future__ import annotations

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.generic_rank import counted_rows, generic_rank
from helicoide.kinematics.self_motion import freest_joint, self_motion_step

STEP, STEPS = 0.02, 20


@pytest.mark.parametrize("with_orientation", [True, False])
@pytest.mark.parametrize("name", NAMES)
def test_the_tool_stays_while_a_joint_moves(name: str, with_orientation: bool) -> None:
    robot = arm(name)
    rows = counted_rows(robot, with_orientation)
    redundant = len(robot.variables) - generic_rank(robot, 6 if rows[3:].any() else 3)
    for q in [robot.poses["ready"], *postures(robot, 3)]:
        joint = freest_joint(robot, q, rows)
        assert (joint is not None) == (redundant > 0)
        if joint is None:
            continue
        start, moved = tool_by_screws(robot, q), q
        for _ in range(STEPS):
            moved = self_motion_step(robot, moved, start, rows, joint, STEP)
        there = tool_by_screws(robot, moved)
        np.testing.assert_allclose(there[:3, 3], start[:3, 3], rtol=0, atol=1e-3 * robot.reach)
        if rows[3:].any():
            np.testing.assert_allclose(there[:3, :3], start[:3, :3], rtol=0, atol=1e-3)
        assert np.linalg.norm(moved - q) > STEP
        settled = self_motion_step(robot, moved, start, rows, joint, 0.0)
        assert np.abs(tool_by_screws(robot, settled)[:3, 3] - start[:3, 3]).max() < 1e-6 * robot.reach
