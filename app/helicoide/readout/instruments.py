"""The numbers of a method at work: how far the target is, how well the arm can move, what the method remembers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.command import FollowPath, MoveToJoints, MoveToPose
from helicoide.ik import Reason, reasons
from helicoide.ik.controller import closed_loop_task
from helicoide.ik.goal import tool_pose
from helicoide.ik.methods import filtered, filtered_normal, named
from helicoide.ik.modal import Diagnosis
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.passage import refusal
from helicoide.ik.rcm.tip_task import passage_of
from helicoide.ik.task import rotation_vector
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import JacobianAnalysis, analyse_jacobian
from helicoide.kinematics.singularity import singularity
from helicoide.state import State
from helicoide.text import Text

_STILL = frozen(np.zeros(3))


@dataclass(frozen=True)
class Instrument:
    """A number, its symbol in TeX and its unit; without a unit lengths are counted in the arm's reach."""

    title: Text
    symbol: str
    value: float
    unit: str = ""


def target(state: State) -> Array | None:
    """The pose that the tool is driven to, T_world_target (4, 4), m; None when no pose is asked for."""
    match state.request.command:
        case MoveToPose(T):
            return T
        case FollowPath(path, s):
            return frozen(path.pose(s))
        case _:
            return None


def target_pose(state: State) -> Array:
    """The pose that is asked for, T_world_target (4, 4), m: that of the tool where nothing else is."""
    match state.request.command:
        case MoveToPose(T):
            return T
        case FollowPath(path, s):
            return frozen(path.pose(s))
        case MoveToJoints(q):
            return tool_pose(state.problem, link_poses(state.robot.chain, q))
        case _:
            return state.T_world_tool


def mobility(state: State) -> JacobianAnalysis:
    """What the rows of the task let the arm do where it stands, lengths in terms of the characteristic length."""
    T, drive = state.T_world_tool, state.request.controller
    task = closed_loop_task(
        state.problem, state.arm.q, state.arm.poses, T, state.request.with_orientation, _STILL, drive.gains, 0.0
    )
    return analyse_jacobian(task.J)


@lru_cache(maxsize=4)
def instruments(state: State) -> tuple[Instrument, ...]:
    """Everything that can be read off a method at work, in a fixed order; the method's own figures come last.

    All windows ask the same of a state.
    """
    here = mobility(state)
    return (
        *_errors(state),
        Instrument(
            Text(en="joint rates", pt_BR="velocidades de junta"), r"\|\dot q\|", _length(state.arm.velocities), "rad/s"
        ),
        Instrument(Text(en="condition number", pt_BR="número de condição"), r"\kappa", here.condition_number),
        Instrument(Text(en="manipulability", pt_BR="manipulabilidade"), "w", here.w),
        Instrument(Text(en="joints left free", pt_BR="juntas livres"), r"n - r", _free(here)),
        Instrument(Text(en="least singular value", pt_BR="menor valor singular"), r"\sigma_{\min}", _least(here)),
        *_entry(state),
        *_figures(state),
    )


@lru_cache(maxsize=4)
def near_singular(state: State) -> Text | None:
    """What is singular where the arm stands, or nearly so, in words; None where nothing is."""
    return singularity(state.robot, state.arm.q).warning()


def modes(state: State) -> Diagnosis | None:
    """The modal diagnosis of the filtered inverse that drives the arm; None where another method does."""
    drive = state.request.controller
    if not isinstance(drive.memory, filtered.Memory):
        return None
    options = drive.options(drive.method)
    return filtered.modes(
        drive.memory, options if isinstance(options, filtered.Options) else filtered_normal.law(options)
    )


def held_by(state: State) -> tuple[Reason, ...]:
    """What held the last guarded step back, the hardest first."""
    if state.arm.active_set is None or state.arm.active_set.pull == 0.0:
        return ()
    return reasons(state.problem, state.arm.q, state.arm.active_set.multipliers, state.arm.active_set.pull)


def _length(values: Array) -> float:
    return float(np.linalg.norm(values))


def _free(here: JacobianAnalysis) -> float:
    return float(here.V.shape[0] - here.rank)


def _least(here: JacobianAnalysis) -> float:
    return float(here.sigma[-1])


def errors(state: State) -> tuple[float, float]:
    """How far the tool is from its target: the way, m, and the turn, rad; none where no pose is asked for."""
    T = state.T_world_tool
    wished = target(state)
    if wished is None:
        return 0.0, 0.0
    turn = rotation_vector(wished[:3, :3].copy(), T[:3, :3].copy())
    return _length(wished[:3, 3] - T[:3, 3]), _length(turn)


def _errors(state: State) -> tuple[Instrument, ...]:
    way, turn = errors(state)
    return (
        Instrument(Text(en="to the target", pt_BR="até o alvo"), "e_p", 1000 * way, "mm"),
        Instrument(Text(en="turn to the target", pt_BR="giro até o alvo"), "e_o", float(np.degrees(turn)), "°"),
    )


def _entry(state: State) -> tuple[Instrument, ...]:
    """How the instrument stands in its entry point, and how well it can move there; nothing without one."""
    problem, entry = state.problem, state.problem.entry
    if entry is None:
        return ()
    passage = passage_of(problem.robot, entry)
    at = constrained(problem, passage, state.arm.q, entry.point)
    place = at.place
    return (
        Instrument(
            Text(en="beside the entry point", pt_BR="fora do ponto de entrada"), "e_r", _mm(place.lateral), "mm"
        ),
        Instrument(Text(en="shaft outside", pt_BR="haste do lado de fora"), "l_a", 1000 * place.outside, "mm"),
        *(
            Instrument(title, symbol, of.w)
            for title, symbol, of in ((OF_ARM, "w_i", at.of_arm), (OF_TOOL, "w_r", at.of_tool))
            if refusal(problem.robot, passage) is None
        ),
    )


OF_ARM = Text(en="manipulability before the entry", pt_BR="manipulabilidade antes da entrada")
OF_TOOL = Text(en="manipulability beyond it", pt_BR="manipulabilidade depois dela")


def _mm(way: Array) -> float:
    return 1000 * _length(way)


def _figures(state: State) -> tuple[Instrument, ...]:
    """The figures of the method's last answer, in the order of its file."""
    solution, method = state.request.controller.solution, named(state.request.controller.method)
    if solution is None:
        return ()
    return tuple(
        Instrument(title, symbol, solution.figures[symbol])
        for symbol, title in method.FIGURES.items()
        if symbol in solution.figures
    )
