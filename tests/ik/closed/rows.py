"""Arms of six turning joints that are made from DH rows, with the base and the tool anywhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics import dh
from helicoide.kinematics.robot import Robot


def backwards(robot: Robot) -> Robot:
    """The arm that stands on its tool and carries what was its base, with q the other way round."""
    T = np.linalg.inv(robot.T_world_tool_0)
    joints = tuple(
        replace(joint, direction=frozen(-T[:3, :3] @ joint.direction), point=frozen(T[:3, :3] @ joint.point + T[:3, 3]))
        for joint in reversed(robot.joints)
    )
    return replace(robot, joints=joints, dh=dh.dh_from_screws(joints, T), T_world_tool_0=frozen(T))


def distance(answer: Answer, q: Array) -> float:
    """How far the nearest of the postures is from joint values (n,), rad, in the joint that differs most."""
    return min((float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches), default=np.inf)


def worst(robot: Robot, answer: Answer) -> float:
    """What the worst posture misses of the goal, entry by entry of the pose (m, and 1 for rotations)."""
    misses = [np.abs(tool_at(robot, branch.q) - answer.T_world_goal).max() for branch in answer.branches]
    return float(max(misses, default=np.inf))
