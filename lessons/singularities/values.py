"""What the lesson measures: the ellipse, the damping, both arms of a comparison; and the values of its pages."""

from __future__ import annotations

import numpy as np

from helicoide.command import MoveToPose
from helicoide.lesson import Value, fixed
from helicoide.readout import position_analysis, target_pose
from helicoide.state import State

FLAT = 0.10  # m/s, for the shorter semi-axis
WANTED = 0.50  # m/s
INSIDE, OUTSIDE = 3.0, 4.2  # distances from the base, m
GREAT = 20.0  # rad/s
SMALL_DAMPING, HALF = 0.3, 0.5  # m/rad, and a part of a velocity
LAGGING = 0.020
METRES, DELTA = 0.20, 0.04  # λ, m/rad, and λ², (m/rad)²
INWARDS, SECOND_WITHIN = 0.5, 0.05
LAP = 15.0  # s
SECONDS = 3.0


def short_axis(state: State) -> float:
    """The shorter semi-axis of the velocity ellipse, m/s."""
    return float(position_analysis(state).sigma[1])


def from_base(state: State) -> float:
    """The distance of the end effector from the base, m."""
    return float(np.hypot(*state.T_world_tool[:2, 3]))


def target_from_base(state: State) -> float:
    """The distance of the target from the base, m; 0 without a target."""
    if not isinstance(state.request.command, MoveToPose):
        return 0.0
    return float(np.hypot(*state.request.command.T_world_target[:2, 3]))


def to_target(state: State) -> float:
    """The distance of the end effector from its target, m."""
    return float(np.linalg.norm(target_pose(state)[:2, 3] - state.T_world_tool[:2, 3]))


def second_to_target(state: State) -> float:
    """The same of the second arm, m; 0 without one."""
    second = state.compared_state
    return 0.0 if second is None else to_target(second)


def asked(state: State, arm: int) -> float:
    """The largest joint velocity that a method has asked for, rad/s; 0 without a second arm. arm: 0 or 1."""
    return 0.0 if state.compared is None else float(state.compared.trace.largest[arm, 0])


def damping(state: State) -> float:
    """λ of damped least squares, m/rad."""
    return float(state.request.controller.options("damped").damping) * state.problem.length


def in_mm(metres: float) -> float:
    """A length in mm, for a unit that the pages do not convert."""
    return 1000.0 * metres


VALUES = {
    "long_axis": Value(lambda state, _: position_analysis(state).sigma[0], "m/s", 2),
    "short_axis": Value(lambda state, _: short_axis(state), "m/s", 2),
    "flat": fixed(FLAT, "m/s", 2),
    "wanted": fixed(WANTED, "m/s", 1),
    "needed": fixed(WANTED / FLAT, "rad/s", 0),
    "fastest": Value(lambda state, _: state.problem.limits.speed[0], "rad/s", 1),
    "together": Value(lambda state, _: float(np.linalg.norm(state.problem.limits.speed)), "rad/s", 1),
    "reach": Value(lambda state, _: state.robot.reach, "m", 0),
    "inside": fixed(INSIDE, "m", 0),
    "outside": fixed(OUTSIDE, "m", 1),
    "from_base": Value(lambda state, _: from_base(state), "m", 2),
    "target_out": Value(lambda state, _: float(np.hypot(*target_pose(state)[:2, 3])), "m", 2),
    "asked_first": Value(lambda state, _: asked(state, 0), "rad/s", 1),
    "asked_second": Value(lambda state, _: asked(state, 1), "rad/s", 1),
    "damping": Value(lambda state, _: in_mm(damping(state)), "mm/rad", 0),
    "half": fixed(HALF, "%"),
    "lagging": fixed(LAGGING, "mm"),
    "error": Value(lambda state, _: to_target(state), "mm"),
    "second_error": Value(lambda state, _: second_to_target(state), "mm"),
    "delta": fixed(DELTA, "", 2),
    "as_delta": fixed(in_mm(DELTA), "mm/rad", 0),
    "seconds": fixed(SECONDS, "s", 0),
    "nearest": Value(lambda state, _: max(target_from_base(state) - state.robot.reach, 0.0), "mm"),
}
