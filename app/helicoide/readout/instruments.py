"""Numbers shown while a method drives the arm: errors, manipulability and the figures of the method."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.command import FollowPath, MoveToJoints, MoveToPose
from helicoide.ik import Reason, reasons
from helicoide.ik.clik import tool_task_error
from helicoide.ik.goal import pose_of_tool
from helicoide.ik.methods import filtered, filtered_normal, named
from helicoide.ik.modal import ModalDiagnosis
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.passage import passage_refusal
from helicoide.ik.rcm.tip_task import passage_of
from helicoide.ik.task import rotation_error
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.kinematics.manipulability import JacobianAnalysis, analyse_jacobian
from helicoide.kinematics.singularity import singularity
from helicoide.state import State
from helicoide.text import Text

ROW_NAMES = ("x", "y", "z", "ωx", "ωy", "ωz")


@dataclass(frozen=True)
class Instrument:
    """A number, its symbol in TeX and its unit. Without a unit, lengths are divided by the characteristic length."""

    title: Text
    symbol: str
    value: float
    unit: str = ""


def target_pose(state: State) -> Array:
    """The target pose, T_world_target (4, 4), m; for target joints their tool pose, else the present tool pose."""
    match state.request.command:
        case MoveToPose(T):
            return T
        case FollowPath(path, s):
            return frozen(path.pose(s))
        case MoveToJoints(q):
            return pose_of_tool(state.problem, link_poses(state.robot.chain, q))
        case _:
            return state.T_world_tool


def mobility(state: State) -> JacobianAnalysis | None:
    """Analysis of the rows of the tool's Jacobian that count, lengths divided by ℓ; None if no row counts."""
    with_orientation = state.request.with_orientation
    rows = counted_rows(state.robot, with_orientation)
    if not rows.any():
        return None
    task = tool_task_error(state.problem, state.arm.poses, state.T_world_tool, True)
    return analyse_jacobian(task.J[rows])


def counted_names(state: State) -> str:
    """The names of the rows that `mobility` counts, such as "x, y, ωz"."""
    rows = counted_rows(state.robot, state.request.with_orientation)
    return ", ".join(name for name, counts in zip(ROW_NAMES, rows, strict=True) if counts)


@lru_cache(maxsize=4)
def instruments(state: State) -> tuple[Instrument, ...]:
    """All instruments of a state in a fixed order, the method's own figures last. Cached, as all windows share them."""
    return (
        *_errors(state),
        Instrument(
            Text(en="joint velocities", pt_BR="velocidades de junta"),
            r"\|\dot q\|",
            _length(state.arm.velocities),
            "rad/s",
        ),
        *_of_jacobian(mobility(state)),
        *_entry(state),
        *_figures(state),
    )


def _of_jacobian(here: JacobianAnalysis | None) -> tuple[Instrument, ...]:
    if here is None:
        return ()
    free, smallest = float(here.V.shape[0] - here.rank), float(here.sigma[-1])
    return (
        Instrument(Text(en="condition number", pt_BR="número de condição"), r"\kappa", here.condition_number),
        Instrument(Text(en="manipulability", pt_BR="manipulabilidade"), "w", here.w),
        Instrument(Text(en="redundant degrees of freedom", pt_BR="graus de redundância"), r"n - r", free),
        Instrument(Text(en="smallest singular value", pt_BR="menor valor singular"), r"\sigma_{\min}", smallest),
    )


@lru_cache(maxsize=4)
def near_singular(state: State) -> Text | None:
    """What is singular, or nearly so, at the present posture, in words; None if nothing is."""
    return singularity(state.robot, state.arm.q, state.request.with_orientation).warning()


def method_modes(state: State) -> ModalDiagnosis | None:
    """The modal diagnosis of the filtered inverse that drives the arm; None if another method drives it."""
    drive = state.request.controller
    if not isinstance(drive.memory, filtered.Memory):
        return None
    options = drive.options(drive.method)
    return filtered.filter_modes(
        drive.memory, options if isinstance(options, filtered.Options) else filtered_normal.law(options)
    )


def limited_by(state: State) -> tuple[Reason, ...]:
    """The constraints that limited the last guarded step, in the order of `ik.reasons`."""
    if state.arm.active_set is None or state.arm.active_set.pull == 0.0:
        return ()
    return reasons(state.problem, state.arm.q, state.arm.active_set.multipliers, state.arm.active_set.pull)


def _length(values: Array) -> float:
    return float(np.linalg.norm(values))


def errors(state: State) -> tuple[float, float]:
    """Position error, m, and orientation error, rad, of the tool against its target; 0 without target pose or path."""
    if not isinstance(state.request.command, MoveToPose | FollowPath):
        return 0.0, 0.0
    T, T_target = state.T_world_tool, target_pose(state)
    turn = rotation_error(T_target[:3, :3].copy(), T[:3, :3].copy())
    return _length(T_target[:3, 3] - T[:3, 3]), _length(turn)


def _errors(state: State) -> tuple[Instrument, ...]:
    """The position error, and the orientation error if orientation counts."""
    way, turn = errors(state)
    position = Instrument(Text(en="position error", pt_BR="erro de posição"), "e_p", 1000 * way, "mm")
    if not counted_rows(state.robot, state.request.with_orientation)[3:].any():
        return (position,)
    turned = float(np.degrees(turn))
    return (position, Instrument(Text(en="orientation error", pt_BR="erro de orientação"), "e_o", turned, "°"))


def _entry(state: State) -> tuple[Instrument, ...]:
    """Position of the shaft in its entry point, and the manipulabilities there; empty without an entry point."""
    problem, entry = state.problem, state.problem.entry
    if entry is None:
        return ()
    passage = passage_of(problem.robot, entry)
    at = constrained(problem, passage, state.arm.q, entry.point)
    place = at.place
    return (
        Instrument(
            Text(en="distance to the entry point", pt_BR="distância ao ponto de entrada"),
            "e_r",
            _mm(place.lateral),
            "mm",
        ),
        Instrument(
            Text(en="shaft length outside", pt_BR="comprimento externo da haste"), "l_a", 1000 * place.outside, "mm"
        ),
        *(
            Instrument(title, symbol, of.w)
            for title, symbol, of in ((OF_ARM, "w_i", at.of_arm), (OF_TOOL, "w_r", at.of_tool))
            if passage_refusal(problem.robot, passage) is None
        ),
    )


OF_ARM = Text(en="manipulability before the entry point", pt_BR="manipulabilidade antes do ponto de entrada")
OF_TOOL = Text(en="manipulability beyond the entry point", pt_BR="manipulabilidade além do ponto de entrada")


def _mm(way: Array) -> float:
    return 1000 * _length(way)


def _figures(state: State) -> tuple[Instrument, ...]:
    """The figures of the method's last solution, in the order of its `FIGURES`."""
    solution, method = state.request.controller.solution, named(state.request.controller.method)
    if solution is None:
        return ()
    return tuple(
        Instrument(title, symbol, solution.figures[symbol])
        for symbol, title in method.FIGURES.items()
        if symbol in solution.figures
    )
