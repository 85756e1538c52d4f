"""Kin of the source's arm, for the tests of what its geometry makes of the entry point."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from helicoide.kinematics.chain import frozen
from helicoide.kinematics.robot import Robot
from helicoide.studies._coutinho_runs import dia10


@cache
def zx_wrist() -> Robot:
    """The same arm with joint 8 about x."""
    joints = dia10().joints
    return replace(dia10(), joints=(*joints[:7], replace(joints[7], direction=frozen([1, 0, 0]))))


@cache
def seven_joints() -> Robot:
    """The same arm without its last joint."""
    robot = dia10()
    frames = {"tool": replace(robot.frames["tool"], link=7)}
    return replace(robot, joints=robot.joints[:7], frames=frames)
