"""Waypoints taught at the present posture of the arm: record, name, order, edit, delete, read from a file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from helicoide.gate.check import checked, finite
from helicoide.gate.presets import LAWS
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.time_optimal import TimingShape
from helicoide.trajectory.waypoint_file import decode_waypoints
from helicoide.trajectory.waypoints import (
    WaypointList,
    waypoint,
    with_dwell,
    with_gripper_action,
    with_move_type,
    with_posture,
    with_waypoint,
    with_waypoint_at,
    with_waypoint_name,
    without_waypoint,
)

MOST = 60


def record(move_type: str = "joints") -> Update:
    """Record a waypoint at the present posture. way: one of `waypoints.MOVE_TYPES`, from the waypoint before."""

    def change(state: State) -> WaypointList:
        taught = state.taught
        if len(taught.waypoints) >= MOST:
            raise HelicoideError(
                Text(en="At most {most} waypoints are allowed.", pt_BR="Há no máximo {most} pontos.").format(most=MOST)
            )
        name = next(name for k in range(1, MOST + 2) if (name := f"P{k}") not in taught.names)
        return with_waypoint(taught, len(taught.waypoints), waypoint(state.robot, name, state.arm.q, move_type))

    return _changed(change)


def rename_waypoint(name: str, new: str) -> Update:
    """Rename a waypoint."""
    return _changed(lambda state: with_waypoint_name(state.taught, name, new))


def move_waypoint(name: str, to: int) -> Update:
    """Move a waypoint to another index of the list, 0 to length − 1."""
    return _changed(lambda state: with_waypoint_at(state.taught, name, to))


def delete_waypoint(name: str) -> Update:
    """Delete a waypoint."""
    return _changed(lambda state: without_waypoint(state.taught, name))


def set_move_type(name: str, move_type: str) -> Update:
    """Set how a waypoint is reached, one of `waypoints.MOVE_TYPES`."""
    return _changed(lambda state: with_move_type(state.taught, name, move_type))


def set_dwell(name: str, seconds: float) -> Update:
    """Set how long the arm stays at a waypoint, s."""

    def change(state: State) -> WaypointList:
        (value,) = finite([seconds], (1,))
        return with_dwell(state.taught, name, float(value))

    return _changed(change)


def set_grip(name: str, gripper: str) -> Update:
    """Set what the gripper does at a waypoint, one of `waypoints.GRIPPER_ACTIONS`."""
    return _changed(lambda state: with_gripper_action(state.taught, name, gripper))


def teach_again(name: str) -> Update:
    """Replace the joint values of a waypoint by the present ones."""
    return _changed(lambda state: with_posture(state.taught, name, state.arm.q))


def choose_leg_shape(shape: TimingShape) -> Update:
    """Choose the time scaling of the motion to each waypoint."""

    def update(state: State) -> State:
        if shape not in LAWS:
            raise HelicoideError(
                Text(
                    en="There is no time scaling {shape!r}; time scalings: {shapes}.",
                    pt_BR="Não há lei de tempo {shape!r}; leis de tempo: {shapes}.",
                ).format(shape=shape, shapes=", ".join(LAWS))
            )
        return replace(state, taught=replace(state.taught, shape=shape), notice=None)

    return checked(update)


def take_waypoints(content: bytes) -> Update:
    """Replace the waypoints by those of a file."""
    return _changed(lambda state: decode_waypoints(content, state.robot))


def _changed(change: Callable[[State], WaypointList]) -> Update:
    return checked(
        lambda state: replace(state, taught=replace(state.taught, waypoints=change(state).waypoints), notice=None)
    )
