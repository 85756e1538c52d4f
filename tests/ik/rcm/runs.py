"""The source's arm, and what its runs along the source's paths come to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from itertools import islice

import numpy as np

from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.ik.methods.filtered import Memory
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.follow import PSEUDOINVERSE, Control, Inverse, Moment, followed, inverse
from helicoide.ik.rcm.passage import through
from helicoide.ik.rcm.paths import PATHS
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot

LINK = 6
START = frozen([0.731912, -0.229593, -1.110216, -1.636104, 0.676517, 1.117805, -0.616407, 1.5708])
E1_START = frozen([*START[:6], np.pi / 4, -np.pi / 2])


def problem_of(robot: Robot, scale: float = 1.0) -> Problem:
    """An arm without planes; ℓ = 1 m leaves the source's metres as they are."""
    return Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(robot.panes), scale=scale)


@cache
def dia10() -> Robot:
    return load("dia10")


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


def entry_on(robot: Robot, q: Array, outside: float, link: int = LINK) -> Array:
    """A point on the shaft of a link at a depth l_a, (3,), m."""
    T = link_poses(robot.chain, q)[link] @ through(robot, link).T_link_shaft
    return np.asarray(T[:3, 3] + outside * T[:3, 1])


def tool_at(robot: Robot, q: Array) -> Array:
    return np.asarray(link_poses(robot.chain, q)[-1] @ robot.T_link_tool)


def angle_deg(error: Array) -> float:
    """The angle of an error (e_p, ε̃)."""
    return float(np.degrees(2 * np.arcsin(np.linalg.norm(error[3:]))))


def _figures(moment: Moment) -> dict[str, float]:
    place = moment.at.place
    return {
        "tip_mm": 1e3 * float(np.linalg.norm(moment.error[:3])),
        "angle_deg": angle_deg(moment.error),
        "lateral_mm": 1e3 * float(np.linalg.norm(place.lateral)),
        "slip_mm_s": 1e3 * float(np.abs(moment.entry_slip).max()),
        "q7": float(moment.q[6]),
        "outside": place.outside,
        "inside": place.inside,
        "rate": float(np.abs(moment.rates).max()),
    }


def run(
    name: str, control: Control, dt: float, start: Array = START, seconds: float | None = None
) -> Mapping[str, Array]:
    """What the steps of a run along a path of the source measured, a column each; from l_a = 0.15 m.

    w_r and w_i are taken every half second. A filtered inverse begins with Θ = J^r†.
    """
    robot, path = dia10(), PATHS[name]
    problem, passage = problem_of(robot), through(robot, LINK, path.across)
    wished, entry = path.wished(tool_at(robot, start)), entry_on(robot, start, 0.15)
    filtered = control.of_tool.method.REMEMBERS is not None
    at = constrained(problem, passage, start, entry, control.basis)
    memory = (Memory(np.linalg.pinv(at.J)) if filtered else None, None)
    steps = followed(problem, passage, control, wished, start, entry, dt, memory)
    rows, indices, stride = [], [], round(0.5 / dt)
    for step, moment in enumerate(islice(steps, round((seconds or path.duration) / dt) + 1)):
        rows.append(_figures(moment))
        if step % stride == 0:
            indices.append((moment.at.of_tool.w, moment.at.of_arm.w))
    w_r, w_i = np.array(indices).T
    return {key: np.array([row[key] for row in rows]) for key in rows[0]} | {"w_r": w_r, "w_i": w_i}


DLS = inverse("damped", damping=0.05)
FILTERED = inverse("filtered_modified", gain=5.0)
# κ = 0.05 (1 − w/0.1)² of eq. 3.44, squared in eq. 3.43
VARIABLE = inverse("damped_by_manipulability", damping=0.05**2, threshold=0.1, exponent="4")


def control(
    entry: float = 0.0,
    of_tool: Inverse = PSEUDOINVERSE,
    of_arm: Inverse = PSEUDOINVERSE,
    position: float = 5.0,
    orientation: float = 10.0,
) -> Control:
    """The source's basis and gains, with drift feedback Kr = entry."""
    return Control(of_tool, of_arm, position, orientation, entry, "source")


def as_printed(value: float, printed: str, last: float = 0.55) -> bool:
    """Whether a value is what stands in a table: within `last` units of its last digit, or as it is rounded."""
    digits = len(printed.partition(".")[2])
    return abs(value - float(printed)) <= last * 10.0**-digits
