"""What the tests of the small closed forms share: poses in the plane, arms with other lengths, axes and limits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from helicoide.ik.postures.branch import Answer, wrap
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot


def reversed_axes(robot: Robot, *numbers: int) -> Robot:
    """The same arm with some joints counted the other way."""
    joints = [
        replace(joint, direction=frozen(-joint.direction)) if i in numbers else joint
        for i, joint in enumerate(robot.joints)
    ]
    return replace(robot, joints=tuple(joints))


def with_points(robot: Robot, points: Sequence[Sequence[float]], tool: Array) -> Robot:
    """The same axes through other points, m, and the tool at another place (4, 4), m."""
    joints = zip(robot.joints, points, strict=True)
    moved = tuple(replace(joint, point=frozen(point)) for joint, point in joints)
    return replace(robot, joints=moved, T_world_tool_0=frozen(tool))


def moved(robot: Robot, T: Array) -> Robot:
    """The same arm, standing elsewhere: T (4, 4), m, from its old place to its new one."""
    joints = tuple(
        replace(joint, direction=frozen(T[:3, :3] @ joint.direction), point=frozen(T[:3, :3] @ joint.point + T[:3, 3]))
        for joint in robot.joints
    )
    return replace(robot, joints=joints, T_world_tool_0=frozen(T @ robot.T_world_tool_0))


def recovered(answer: Answer, q: Array) -> float:
    """How far the nearest branch lies from q, the largest joint, rad."""
    return float(min(np.abs(wrap(branch.q - q)).max() for branch in answer.branches))
