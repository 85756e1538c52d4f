"""The matrices of a state with named rows and columns: pose, Jacobian, singular values, Θ, inverse and damping."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.method import Quantity, settings
from helicoide.ik.methods import filtered, named
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.generic_rank import movable_rows
from helicoide.readout.instruments import ROW_NAMES, mobility
from helicoide.readout.signal import subscript
from helicoide.state import State
from helicoide.text import Text, untranslated


@dataclass(frozen=True, eq=False)
class NamedMatrix:
    """A matrix (r, c) with the names of its rows, (r,), and columns, (c,), with units; note: what it is."""

    values: Array
    rows: tuple[Text, ...]
    columns: tuple[Text, ...]
    note: Text


TITLES: dict[str, Text] = {
    "H": Text(en="H, pose of the end effector", pt_BR="H, pose do efetuador"),
    "J": Text(en="J, Jacobian", pt_BR="J, jacobiana"),
    "σ": Text(en="σ, singular values of J", pt_BR="σ, valores singulares de J"),
    "Θ": Text(en="Θ, filtered inverse", pt_BR="Θ, inversa filtrada"),
    "B": Text(en="B, inverse of the method", pt_BR="B, inversa do método"),
    "λ": Text(en="λ, damping", pt_BR="λ, amortecimento"),
}
SCALED = Text(
    en="Lengths are divided by ℓ = {length:.4g} mm.", pt_BR="Os comprimentos são divididos por ℓ = {length:.4g} mm."
)


def _scaled(state: State) -> Text:
    return SCALED.format(length=1000 * state.problem.length)


def _joint_names(state: State, units: bool) -> tuple[Text, ...]:
    """q̇ᵢ, with the unit that joint velocities have in J."""
    joints = enumerate(state.robot.variables, 1)
    return tuple(
        untranslated(f"{subscript('q̇', i)} [{'mm' if joint.is_prismatic else 'rad'}/s]" if units else subscript("q̇", i))
        for i, joint in joints
    )


def _pose(state: State) -> NamedMatrix:
    values = state.T_world_tool.copy()
    values[:3, 3] *= 1000
    note = Text(
        en="Columns: the axes of the end effector and its position, world frame.",
        pt_BR="Colunas: os eixos do efetuador e sua posição, no referencial do mundo.",
    )
    return NamedMatrix(values, _texts("x", "y", "z", ""), _texts("x", "y", "z", "p [mm]"), note)


def _jacobian(state: State) -> NamedMatrix:
    scale = np.where([joint.is_prismatic for joint in state.robot.variables], 1e-3, 1.0)
    values = frame_jacobian(state.robot, state.arm.q) * scale
    values[:3] *= 1000
    rows = _texts("vx [mm/s]", "vy [mm/s]", "vz [mm/s]", "ωx [rad/s]", "ωy [rad/s]", "ωz [rad/s]")
    note = Text(
        en="Velocity of the end effector, world frame, for joint velocities of one unit.",
        pt_BR="Velocidade do efetuador, no referencial do mundo, para velocidades de junta de uma unidade.",
    )
    return NamedMatrix(values, rows, _joint_names(state, True), note)


def _singular_values(state: State) -> NamedMatrix | None:
    here = mobility(state)
    if here is None:
        return None
    rows = tuple(untranslated(subscript("σ", i + 1)) for i in range(len(here.sigma)))
    return NamedMatrix(here.sigma[:, None], rows, _texts(""), _scaled(state))


def _theta(state: State) -> NamedMatrix | None:
    memory = state.request.controller.memory
    return _of_task(state, memory.Theta) if isinstance(memory, filtered.Memory) else None


def _inverse(state: State) -> NamedMatrix | None:
    solution = state.request.controller.solution
    return None if solution is None or solution.inverse is None else _of_task(state, solution.inverse)


def _of_task(state: State, values: Array) -> NamedMatrix:
    """A matrix from velocities of the task to joint velocities; named by joints and task rows where these fit."""
    joints, (n, r) = _joint_names(state, False), values.shape
    if state.problem.entry is not None:  # the task is that of the entry point, whose unknowns may not be joints
        return NamedMatrix(values, _numbers(n), _numbers(r), _scaled(state))
    moving = movable_rows(state.robot)[: 6 if state.request.with_orientation else 3]
    task = _texts(*(name for name, moves in zip(ROW_NAMES, moving, strict=False) if moves))
    is_of_normal_equations = r == len(joints) and r != len(task)
    columns = joints if is_of_normal_equations else task if len(task) == r else _numbers(r)
    return NamedMatrix(values, joints if n == len(joints) else _numbers(n), columns, _scaled(state))


def _damping(state: State) -> NamedMatrix | None:
    """The setting of the method that is a damping, and the dampings that it computed."""
    drive, method = state.request.controller, named(state.request.controller.method)
    found: list[tuple[Text, float]] = []
    setting = settings(method.Options).get("damping")
    if isinstance(setting, Quantity):
        unit = (1000 * state.problem.length) ** setting.lengths
        title = untranslated("{title} [{unit}]").format(title=setting.title, unit=setting.unit)
        found.append((title, unit * drive.options(drive.method).damping))
    figures = drive.solution.figures if drive.solution is not None else {}
    found += [(method.FIGURES[symbol], figures[symbol]) for symbol in ("δ", "λₚ") if symbol in figures]
    if not found:
        return None
    return NamedMatrix(
        np.array([[value] for _, value in found]), tuple(title for title, _ in found), _texts(""), _scaled(state)
    )


def _texts(*names: str) -> tuple[Text, ...]:
    return tuple(map(untranslated, names))


def _numbers(count: int) -> tuple[Text, ...]:
    return _texts(*(str(i + 1) for i in range(count)))


_MADE: dict[str, Callable[[State], NamedMatrix | None]] = {
    "H": _pose,
    "J": _jacobian,
    "σ": _singular_values,
    "Θ": _theta,
    "B": _inverse,
    "λ": _damping,
}


def named_matrix(state: State, name: str) -> NamedMatrix | None:
    """The matrix of a name in `TITLES`; None where the state does not define it."""
    return _MADE[name](state)
