"""What the lesson computes: columns and lengths, one step of the inverse, a lap without feedback; and its values."""

from __future__ import annotations

from functools import lru_cache
from math import exp, radians

import numpy as np

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Value, fixed
from helicoide.readout import position_analysis, world_jacobian
from helicoide.state import State
from helicoide.trajectory.cerbaro import ORCA_CIRCLE

SHOULDER, ELBOW, WRIST = range(3)
PLANAR = [0, 1, 5]  # the rows vx, vy, ωz of J, which a planar arm has
UNIT_RATE = 1.0  # rad/s
MOVED = radians(20.0)
THIN = 0.020  # m/s
SHIFT = 0.100
ARRIVED, FIRST_WITHIN = 0.003, radians(1.5)
LAP = 20.0  # s
FEW_STEPS, MANY_STEPS = 60, 240
NEWTON_STEPS = 20
ON_CIRCLE = 0.001
SLOW_GAIN, AFTER = 1.0, 2.0  # 1/s and s
PULLED, SETTLED = 0.080, 0.001


def ready(robot: Robot) -> Array:
    """The joint values of the posture `ready`, (3,), rad."""
    return np.array(robot.poses["ready"])


def turned_by(state: State, joint: int) -> float:
    """How far a joint is from where it is in `ready`, rad."""
    return float(state.arm.q[joint] - state.robot.poses["ready"][joint])


def tool_point(robot: Robot, q: Array) -> Array:
    """The place of the end effector at joint values q (3,), rad; (2,), m."""
    return np.asarray(tool_by_screws(robot, q)[:2, 3])


def axis_point(state: State, joint: int) -> Array:
    """Where the axis of a joint crosses the plane of the arm, (3,), m."""
    return np.asarray(state.arm.poses[1 + joint, :3, 3])


def column_length(state: State, joint: int) -> float:
    """The speed of the end effector if one joint alone turns at 1 rad/s, m/s."""
    return float(np.linalg.norm(world_jacobian(state)[:3, joint]))


def ready_length(robot: Robot, joint: int) -> float:
    """The same in the posture `ready`, m/s."""
    return float(np.linalg.norm(frame_jacobian(robot, ready(robot))[:3, joint]))


def with_inverse(robot: Robot, q: Array, to_x: float, to_y: float) -> Array:
    """Joint values after one step q + J⁻¹ (Δx, Δy, 0), (3,), rad. Args: q (3,), rad; to_x, to_y: Δx, Δy, m."""
    return np.asarray(q + np.linalg.solve(frame_jacobian(robot, q)[PLANAR], [to_x, to_y, 0.0]))


def wanted_point(robot: Robot) -> Array:
    """The place that is asked for in the step with the inverse, (2,), m."""
    return np.asarray(tool_point(robot, ready(robot)) - [0.0, SHIFT])


def first_step(robot: Robot) -> Array:
    """Joint values after one step of the inverse from `ready`, (3,), rad."""
    return with_inverse(robot, ready(robot), 0.0, -SHIFT)


def second_step(robot: Robot) -> Array:
    """Joint values after one more step, with the Jacobian and the error at the new posture, (3,), rad."""
    q = first_step(robot)
    return with_inverse(robot, q, *(wanted_point(robot) - tool_point(robot, q)))


def next_step(state: State) -> Array:
    """Joint values of the step to make now: of the first one until its posture is reached, then of the second, rad."""
    both = np.array([first_step(state.robot), second_step(state.robot)])
    low, high = both.min(axis=0) - FIRST_WITHIN, both.max(axis=0) + FIRST_WITHIN
    return np.asarray(both[int(np.all((low <= state.arm.q) & (state.arm.q <= high)))])


def as_written(point: Array) -> Array:
    """The x and y of a point, m, to a tenth of a millimetre, as the page shows them, (2,), m."""
    return np.round(point[:2], 4)


def elbow_column(state: State) -> Array:
    """vx, vy of the column of the elbow, from the points as the page shows them, (2,), m/s."""
    along = as_written(state.T_world_tool[:3, 3]) - as_written(axis_point(state, ELBOW))
    return np.array([-along[1], along[0]])


def missing(state: State) -> float:
    """How far the end effector is from the place that is asked for, m."""
    return float(np.linalg.norm(state.T_world_tool[:2, 3] - wanted_point(state.robot)))


@lru_cache(maxsize=4)
def drift(robot: Robot, steps: int) -> float:
    """How far from its start a lap round the circle ends that adds up q + J⁻¹ ẋ_d Δt, without feedback, m."""
    start, q = np.array(ORCA_CIRCLE.pose(0.0)[:2, 3]), ready(robot)
    for _ in range(NEWTON_STEPS):
        q = with_inverse(robot, q, *(start - tool_point(robot, q)))
    dt = ORCA_CIRCLE.duration / steps
    for k in range(steps):
        q = with_inverse(robot, q, *(dt * ORCA_CIRCLE.twist(k * dt)[:2]))
    return float(np.linalg.norm(tool_point(robot, q) - start))


def target_shift(state: State) -> float:
    """How far the target is from the place of the end effector at `ready`, m; 0 without a target."""
    if not isinstance(state.request.command, MoveToPose):
        return 0.0
    target = state.request.command.T_world_target[:2, 3]
    return float(np.linalg.norm(target - tool_point(state.robot, ready(state.robot))))


def to_target(state: State) -> float:
    """The distance of the end effector from its target, m; 0 without a target."""
    if not isinstance(state.request.command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(state.request.command.T_world_target[:2, 3] - state.T_world_tool[:2, 3]))


def wrist_column(state: State, point: Array) -> Array:
    """vx, vy of a point (3,), m, if the wrist alone turns at 1 rad/s, (2,), m/s."""
    along = point - axis_point(state, WRIST)
    return np.array([-along[1], along[0]])


VALUES = {
    "moved": fixed(MOVED, "°"),
    "radius": Value(lambda state, _: ready_length(state.robot, SHOULDER), "mm"),
    "speed": Value(lambda state, _: ready_length(state.robot, SHOULDER), "mm/s"),
    "length_1": Value(lambda state, _: column_length(state, SHOULDER), "mm/s"),
    "length_2": Value(lambda state, _: column_length(state, ELBOW), "mm/s"),
    "length_3": Value(lambda state, _: column_length(state, WRIST), "mm/s"),
    "column_2": Value(lambda state, _: elbow_column(state), "mm/s", 1),
    "elbow_at": Value(lambda state, _: axis_point(state, ELBOW)[:2], "mm", 1),
    "tool_at": Value(lambda state, _: state.T_world_tool[:2, 3], "mm", 1),
    "of_tool": Value(lambda state, _: wrist_column(state, state.T_world_tool[:3, 3]), "mm/s"),
    "of_wrist": Value(lambda state, _: wrist_column(state, axis_point(state, WRIST)), "mm/s"),
    "long_axis": Value(lambda state, _: position_analysis(state).sigma[0], "m/s", 3),
    "short_axis": Value(lambda state, _: position_analysis(state).sigma[1], "m/s", 3),
    "thin": fixed(THIN, "m/s", 2),
    "shift": fixed(SHIFT, "mm"),
    "first": Value(lambda state, _: first_step(state.robot), "°", 1),
    "next": Value(lambda state, _: next_step(state), "°", 1),
    "begun_at": Value(lambda state, _: tool_point(state.robot, ready(state.robot)), "mm"),
    "wanted": Value(lambda state, _: wanted_point(state.robot), "mm"),
    "joints": Value(lambda state, _: state.arm.q, "°", 1),
    "missing": Value(lambda state, _: missing(state), "mm"),
    "left_by_first": Value(
        lambda state, _: float(
            np.linalg.norm(tool_point(state.robot, first_step(state.robot)) - wanted_point(state.robot))
        ),
        "mm",
    ),
    "arrived": fixed(ARRIVED, "mm"),
    "few": fixed(FEW_STEPS, "", 0),
    "many": fixed(MANY_STEPS, "", 0),
    "drift_few": Value(lambda state, _: drift(state.robot, FEW_STEPS), "mm", 1),
    "drift_many": Value(lambda state, _: drift(state.robot, MANY_STEPS), "mm", 1),
    "lap": fixed(LAP, "s", 0),
    "path_s": Value(lambda state, _: state.request.path_s, "s", 1),
    "gain": fixed(SLOW_GAIN, "s⁻¹", 0),
    "pulled": fixed(PULLED, "mm"),
    "settled": fixed(SETTLED, "mm"),
    "after": fixed(AFTER, "s", 0),
    "left": fixed(SHIFT * exp(-SLOW_GAIN * AFTER), "mm", 1),
    "left_one": fixed(exp(-1.0), "%"),
    "to_target": Value(lambda state, _: to_target(state), "mm", 1),
    "shifted": Value(lambda state, _: target_shift(state), "mm"),
}
