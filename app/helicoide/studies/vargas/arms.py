"""The arms of Vargas 2013, §2 and App. B, without planes.

A scale of 0.01 keeps the centimetres of the source: γ, δ₀ and w₀ then have its numbers, and errors come out in cm.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np

from helicoide.arrays import frozen
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot

LENGTHS = ("l1=2000", "l2=1000", "l3=1000")
FOLDED = frozen([0, pi / 2, -pi])
NEARLY_UPRIGHT = frozen([0, pi / 2 - 0.1, 0.1 - pi / 2])
TOOL_DOWN = frozen([0, pi / 2, -pi, 0, -pi / 2, 0])
REACH = 67.30


def _problem(robot: Robot, scale: float) -> Problem:
    return Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(()), scale=scale)


@cache
def planar_problem() -> Problem:
    """Planar 3R with links (2, 1, 1), unscaled."""
    return _problem(load_robot("planar3r", settings=LENGTHS), 1.0)


def planar_with_limits(joint: int, lower: float, upper: float) -> Problem:
    """The planar arm with other limits, rad, of one joint; the first joint is 0."""
    arm = planar_problem()
    low, high = arm.limits.lower.copy(), arm.limits.upper.copy()
    low[joint], high[joint] = lower, upper
    return replace(arm, limits=Limits(frozen(low), frozen(high), arm.limits.speed))


@cache
def zebra_arm() -> Problem:
    """Zebra-ZERO with its last three joints fixed at 0, in cm."""
    robot = load_robot("zebra_zero")
    return _problem(replace(robot, joints=robot.joints[:3]), 0.01)


@cache
def zebra_wrist() -> Problem:
    """Zebra-ZERO with the tool frame at the wrist point, in cm."""
    robot = load_robot("zebra_zero")
    T = np.eye(4)
    T[:3, 3] = 0.2794, 0, 0.2286
    return _problem(replace(robot, T_world_tool_0=T), 0.01)


@cache
def zebra() -> Problem:
    """Zebra-ZERO with its end effector, in dm."""
    return _problem(load_robot("zebra_zero"), 0.1)
