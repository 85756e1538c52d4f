"""The arms, aims and runs that the tests of secondary objectives share."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from tests.kinematics.arms import arm

from helicoide.arrays import Array
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem, objectives
from helicoide.ik.methods import configured_method
from helicoide.ik.secondary import Chosen
from helicoide.studies.cerbaro_runs.runs import LoopRun, collected
from helicoide.studies.cerbaro_runs.setups import fixed_point, point_along, position_task, solved_posture, tool_position

PINV, DAMPED = configured_method("pseudoinverse"), configured_method("damped")


def problem(name: str, scale: float | None = None, **limits: tuple[float, float]) -> Problem:
    """An arm without planes; limits: of joints by name, where they are not its own, rad."""
    robot = arm(name)
    lower, upper = robot.lower.copy(), robot.upper.copy()
    for i, joint in enumerate(robot.variables):
        lower[i], upper[i] = limits.get(joint.name, (lower[i], upper[i]))
    return Problem(robot, Limits(lower, upper, robot.speed), planes_of(()), scale=scale)


def chosen(name: str, **options: Any) -> Chosen:
    """One objective with some of its options."""
    objective = objectives.named(name)
    return [(objective, replace(objective.Options(), **options))]


def at(x: float, y: float, z: float = 0.0) -> Array:
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


__all__ = ["LoopRun", "collected", "fixed_point", "point_along", "position_task", "solved_posture", "tool_position"]
