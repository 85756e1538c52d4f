"""The simulations and the experiment of Coutinho 2015, step by step, and quantities measured on them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from itertools import islice
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.ik.method import ConfiguredMethod
from helicoide.ik.methods import configured_method
from helicoide.ik.methods.filtered import Memory
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.follow import PSEUDOINVERSE, RcmControl, RcmState, RcmStep, rcm_loop
from helicoide.ik.rcm.passage import Passage, through
from helicoide.ik.rcm.paths import PATHS
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies.study import Progress
from helicoide.text import Text

ROBOT = "dia10"
LINK, DEPTH = 6, 0.15
# Chosen, since the source gives none: θ₁, θ₃ and θ₅ follow from the place of the tool in table 4.2.
START = frozen([0.793942, -0.25, -1.25775, -1.65, 0.621815, 1.1, -0.225, 1.57])
# Of the experiment, with the arm as above: the wrist comes through its singularity twice.
E1_START, E1_DEPTH = frozen([*START[:6], 0.142, -2.58]), 0.087
STRIDE = 0.5  # of the figures that are taken less often, s

DLS = configured_method("damped", damping=0.05)
FILTERED = configured_method("filtered_modified", gain=5.0)
# κ = 0.05 (1 − w/0.1)² of eq. 3.44, squared in eq. 3.43
VARIABLE = configured_method("damped_by_manipulability", damping=0.05**2, threshold=0.1, exponent="4")
INVERSES: Mapping[str, tuple[Text, ConfiguredMethod]] = {
    "plain": (Text(en="plain inverse", pt_BR="inversa simples"), PSEUDOINVERSE),
    "damped": (Text(en="damped, κ = 0.05", pt_BR="amortecida, κ = 0,05"), DLS),
    "variable": (Text(en="variably damped", pt_BR="com amortecimento variável"), VARIABLE),
    "filtered": (Text(en="filtered inverse, Γ = 5", pt_BR="inversa filtrada, Γ = 5"), FILTERED),
}

Run = Mapping[str, Array]


def problem_without_planes(robot: Robot, scale: float = 1.0) -> Problem:
    """An arm without planes; ℓ = 1 m leaves the source's metres as they are."""
    return Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes_of(robot.panes), scale=scale)


@cache
def dia10() -> Robot:
    """The source's arm: the torso and the right arm of the Motoman DIA10."""
    return load_robot(ROBOT)


@cache
def zx_wrist() -> Robot:
    """The same arm with joint 8 about x. Source: Coutinho 2015, §3.3, eq. 3.29."""
    joints = dia10().joints
    return replace(dia10(), joints=(*joints[:7], replace(joints[7], direction=frozen([1, 0, 0]))))


@cache
def seven_joints() -> Robot:
    """The same arm without its last joint: too few for a trocar. Source: Coutinho 2015, §5.1."""
    robot = dia10()
    frames = {"tool": replace(robot.frames["tool"], link=7)}
    return replace(robot, joints=robot.joints[:7], frames=frames)


def entry_on(robot: Robot, q: Array, outside: float, link: int = LINK) -> Array:
    """The point (3,), m, on the shaft of a link at the depth l_a, m."""
    T = link_poses(robot.chain, q)[link] @ through(robot, link).T_link_shaft
    return np.asarray(T[:3, 3] + outside * T[:3, 1])


def angle_deg(error: Array) -> float:
    """The rotation angle of an error (e_p, ε̃), degrees."""
    return float(np.degrees(2 * np.arcsin(np.linalg.norm(error[3:]))))


def source_control(
    entry: float = 0.0,
    of_tool: ConfiguredMethod = PSEUDOINVERSE,
    of_arm: ConfiguredMethod = PSEUDOINVERSE,
    position: float = 5.0,
    orientation: float = 10.0,
) -> RcmControl:
    """The source's basis and gains, with drift feedback Kr = entry, 1/s."""
    return RcmControl(of_tool, of_arm, position, orientation, entry, "source")


def sign_changes(values: Array) -> int:
    """The number of sign changes of a curve (k,)."""
    return int(np.count_nonzero(np.diff(np.sign(values))))


def _figures(moment: RcmStep) -> dict[str, float]:
    at, place = moment.at, moment.at.place
    V = at.J_arm @ moment.rates[: at.J_arm.shape[1]]
    return {
        "t": moment.t,
        "tip_mm": 1e3 * float(np.linalg.norm(moment.error[:3])),
        "angle_deg": angle_deg(moment.error),
        "lateral_mm": 1e3 * float(np.linalg.norm(place.lateral)),
        "slip_mm_s": 1e3 * float(np.abs(moment.entry_slip).max()),
        "v_x": 1e3 * float(V[0] - place.outside * V[5]),
        "v_z": 1e3 * float(V[2] + place.outside * V[3]),
        **{f"nu_{axis}": 1e3 * float(value) for axis, value in zip("xyz", moment.command[:3], strict=True)},
        "q7": float(moment.q[6]),
        "outside": place.outside,
        "inside": place.inside,
        "rate": float(np.abs(moment.rates).max()),
        "of_speed": float(np.abs(moment.rates / at.problem.limits.speed).max()),
    }


def run_columns(moments: Iterator[RcmStep], steps: int, dt: float, progress: Progress) -> Run:
    """The figures of so many steps, a column each; q (k, n), w_r and w_i every half second, at the times t_w, s.

    v_x, v_z: velocity of the shaft's point at the entry across the shaft, mm/s; nu: that which the tool is asked, mm/s;
    moved_mm_s: how fast the shaft left its entry point from step to step.
    """
    rows, aside, seldom, stride = [], [], [], round(STRIDE / dt)
    for step, moment in enumerate(islice(moments, steps)):
        rows.append(_figures(moment))
        aside.append(1e3 * moment.at.place.lateral)
        if step % stride == 0:
            seldom.append((moment.t, moment.q, moment.at.of_tool.w, moment.at.of_arm.w))
            progress((step + 1) / steps)
    t_w, q, w_r, w_i = (np.array(column) for column in zip(*seldom, strict=True))
    columns = {key: np.array([row[key] for row in rows]) for key in rows[0]}
    moved = np.linalg.norm(np.diff(aside, axis=0, prepend=aside[:1]), axis=1) / dt
    return {**columns, "moved_mm_s": moved, "t_w": t_w, "q": q, "w_r": w_r, "w_i": w_i}


class RunStart(NamedTuple):
    """How the arm starts: joint values q (n,), rad, and the depth l_a of the entry point on the shaft, m."""

    q: Array = START
    depth: float = DEPTH


INSERTION = RunStart()


def path_steps(name: str, control: RcmControl, dt: float, insertion: RunStart = INSERTION) -> Iterator[RcmStep]:
    """The steps of a run along a path of the source. dt: sample time, s."""
    start, depth = insertion
    robot, path = dia10(), PATHS[name]
    problem, passage = problem_without_planes(robot), through(robot, LINK, path.across)
    entry = entry_on(robot, start, depth)
    begin = initial_rcm_state(problem, passage, control, start, entry)
    return rcm_loop(problem, passage, control, path.task(tool_at(robot, start)), begin, dt)


def initial_rcm_state(problem: Problem, passage: Passage, control: RcmControl, start: Array, entry: Array) -> RcmState:
    """The state at the start, where a filtered inverse remembers Θ = J^r†. Args: start (n,), rad; entry (3,), m."""
    if control.of_tool.method.REMEMBERS is None:
        return RcmState(start, entry)
    J = constrained(problem, passage, start, entry, control.basis).J
    return RcmState(start, entry, (Memory(np.asarray(np.linalg.pinv(J), dtype=np.float64)), None))


def run_path(
    name: str,
    control: RcmControl,
    dt: float,
    insertion: RunStart = INSERTION,
    seconds: float | None = None,
    progress: Progress = lambda share: None,
) -> Run:
    """The columns of `measured` for a run along a path of the source, of `seconds` or to its end; dt: s."""
    steps = round((seconds or PATHS[name].duration) / dt) + 1
    return run_columns(path_steps(name, control, dt, insertion), steps, dt, progress)
