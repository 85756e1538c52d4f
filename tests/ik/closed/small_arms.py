"""What the tests of the small closed forms share: poses in the plane, arms with other lengths, axes and limits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import cos, sin

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.families.elbow import Annulus
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import wrap
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


def end_of(theta1: float, theta2: float, links: Annulus) -> tuple[float, float]:
    """Where the second link ends: x = l₁c₁ + l₂c₁₂, y = l₁s₁ + l₂s₁₂, m. Source: Campos 1998, s.43."""
    l1, l2, both = links.l1, links.l2, theta1 + theta2
    return l1 * cos(theta1) + l2 * cos(both), l1 * sin(theta1) + l2 * sin(both)
