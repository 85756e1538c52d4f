"""The end effector against its target, and the joint speed that the method asks for and that the arm has."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from helicoide.arrays import Array
from helicoide.command import FollowPath, MoveToPose
from helicoide.ik import Problem
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.readout.instruments import errors, target_pose
from helicoide.readout.signal import PhasePlane, Signal, scalar
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Errors", pt_BR="Erros")
ORDER = 2
PRESET = ("position error", "orientation error", "asked speed")
PHASES: tuple[PhasePlane, ...] = ()


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """The errors, and ‖q̇‖, to which a prismatic joint adds its velocity in m/s."""
    e_p, e_o, speed = untranslated("e_p"), untranslated("e_o"), untranslated("‖q̇‖")
    yield Signal(
        "position error",
        Text(en="Position error", pt_BR="Erro de posição"),
        "e_p",
        "mm",
        (e_p,),
        position_error,
        positive=True,
    )
    yield Signal(
        "position error by axis",
        Text(en="Position error by axis", pt_BR="Erro de posição por eixo"),
        "e",
        "mm",
        tuple(map(untranslated, "xyz")),
        position_errors,
    )
    if counted_rows(problem.robot, with_orientation)[3:].any():
        title = Text(en="Orientation error", pt_BR="Erro de orientação")
        yield Signal("orientation error", title, "e_o", "°", (e_o,), angle_error, positive=True)
    asked, had = Text(en="asked", pt_BR="pedida"), Text(en="actual", pt_BR="efetiva")
    title = Text(en="Joint velocity, asked and actual", pt_BR="Velocidade de junta, pedida e efetiva")
    yield Signal("asked speed", title, "‖q̇‖", "rad/s", (asked, had), speeds, positive=True)
    title = Text(en="Joint velocity", pt_BR="Velocidade de junta")
    yield Signal("speed", title, "‖q̇‖", "rad/s", (speed,), lambda state: speeds(state)[1:], positive=True)


def _has_target(state: State) -> bool:
    return isinstance(state.request.command, MoveToPose | FollowPath)


def position_error(state: State) -> Array:
    """The distance of the tool from its target, (1,), mm; NaN without a target pose or path."""
    return scalar(1000 * errors(state)[0] if _has_target(state) else np.nan)


def position_errors(state: State) -> Array:
    """From the tool to its target, (3,), mm, world frame; NaN without a target pose or path."""
    if not _has_target(state):
        return np.full(3, np.nan)
    return 1000 * (target_pose(state)[:3, 3] - state.T_world_tool[:3, 3])


def angle_error(state: State) -> Array:
    """The angle between the tool and its target, (1,), degrees; NaN without a target pose or path."""
    return scalar(np.degrees(errors(state)[1]) if _has_target(state) else np.nan)


def speeds(state: State) -> Array:
    """‖q̇‖ that the method asked for and that the arm has, (2,), rad/s; the first is NaN if no method gave one.

    With an entry point and the orientation, the unknowns of the method are not joint velocities.
    """
    solution, units = state.request.controller.solution, state.problem.joint_units
    through_entry = state.problem.entry is not None and state.request.with_orientation
    if solution is None or through_entry or not _has_target(state) or len(solution.rates) != len(units):
        return np.array([np.nan, np.linalg.norm(state.arm.velocities)])
    return np.array([np.linalg.norm(units * solution.rates), np.linalg.norm(state.arm.velocities)])
