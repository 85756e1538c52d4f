"""Waypoints that are taught by bringing the arm there: recorded, named, ordered, taken away, read from a file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from helicoide.gate.check import checked
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.waypoint_file import decoded
from helicoide.trajectory.waypoints import Taught, deleted, inserted, moved, renamed, waypoint

MOST = 60


def record(way: str = "joints") -> Update:
    """One more waypoint where the arm stands, reached from the one before in a way of `waypoints.WAYS`."""

    def change(state: State) -> Taught:
        taught = state.taught
        if len(taught.waypoints) >= MOST:
            raise HelicoideError(
                Text(en="There are {most} waypoints at most.", pt_BR="Há no máximo {most} pontos.").format(most=MOST)
            )
        name = next(name for k in range(1, MOST + 2) if (name := f"P{k}") not in taught.names)
        return inserted(taught, len(taught.waypoints), waypoint(state.robot, name, state.q, way))

    return _changed(change)


def rename_waypoint(name: str, new: str) -> Update:
    """Another name for a waypoint."""
    return _changed(lambda state: renamed(state.taught, name, new))


def move_waypoint(name: str, to: int) -> Update:
    """A waypoint at another place of the list, 0 to its length less one."""
    return _changed(lambda state: moved(state.taught, name, to))


def delete_waypoint(name: str) -> Update:
    """A waypoint less."""
    return _changed(lambda state: deleted(state.taught, name))


def take_waypoints(content: bytes) -> Update:
    """The waypoints of a file in place of those there are."""
    return _changed(lambda state: decoded(content, state.robot))


def _changed(change: Callable[[State], Taught]) -> Update:
    return checked(lambda state: replace(state, waypoints=change(state).waypoints, notice=None))
