"""Taught waypoints: named postures with move type, dwell and gripper action; lists of them are immutable."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import isfinite
from types import MappingProxyType
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.time_optimal import TimingShape

MoveType = Literal["joints", "line", "screw"]
MOVE_TYPES: Mapping[MoveType, Text] = MappingProxyType(
    {
        "joints": Text(en="joint move", pt_BR="movimento de juntas"),
        "line": Text(en="linear move", pt_BR="movimento linear"),
        "screw": Text(en="screw move", pt_BR="movimento helicoidal"),
    }
)
GripperAction = Literal["", "open", "closed"]
GRIPPER_ACTIONS: Mapping[GripperAction, Text] = MappingProxyType(
    {
        "": Text(en="as it is", pt_BR="como está"),
        "open": Text(en="open", pt_BR="aberta"),
        "closed": Text(en="closed", pt_BR="fechada"),
    }
)
# Time for the gripper to open or close, s: the shortest dwell at a waypoint with a gripper action.
GRIPPER_TIME = 0.5
LONGEST_NAME = 60
LONGEST_DWELL = 3600.0
# Largest distance of a posture outside the limits and the named postures of its arm, rad or m.
POSTURE_TOLERANCE = 1e-3


@dataclass(frozen=True, eq=False)
class Waypoint:
    """A taught posture: q (n,), rad or m; move_type: type of the move to it; dwell: time that the arm stays there, s.

    gripper: its action there, before the arm moves on.
    """

    name: str
    q: Array
    move_type: MoveType = "joints"
    dwell: float = 0.0
    gripper: GripperAction = ""

    @property
    def total_dwell(self) -> float:
        """Time that the arm stays, s: the dwell, and at least the time of a gripper action."""
        return max(self.dwell, GRIPPER_TIME) if self.gripper else self.dwell


@dataclass(frozen=True, eq=False)
class WaypointList:
    """The waypoints of one arm, with unique names, in the order in which they are visited.

    shape: time law of the moves.
    """

    robot: Robot
    waypoints: tuple[Waypoint, ...] = ()
    shape: TimingShape = "trapezoid"

    @property
    def names(self) -> tuple[str, ...]:
        """The names in order."""
        return tuple(waypoint.name for waypoint in self.waypoints)

    def index(self, name: str) -> int:
        """The index of a waypoint; raises HelicoideError that lists the known names."""
        if name not in self.names:
            raise HelicoideError(
                Text(
                    en="There is no waypoint {name!r}; waypoints: {names}.",
                    pt_BR="Não há ponto {name!r}; pontos: {names}.",
                ).format(name=name, names=_listed(self.names))
            )
        return self.names.index(name)


def _listed(names: tuple[str, ...]) -> Text:
    words = ", ".join(names)
    return Text(en=words, pt_BR=words) if names else Text(en="none yet", pt_BR="nenhum ainda")


def waypoint(
    robot: Robot, name: str, q: ArrayLike, move_type: str = "joints", dwell: float = 0.0, gripper: str = ""
) -> Waypoint:
    """A checked waypoint of an arm; raises HelicoideError for an invalid name, posture, way, dwell or gripper."""
    if move_type not in MOVE_TYPES:
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} cannot be reached by {way!r}; the move types are: {ways}.",
                pt_BR="Não se chega ao ponto {name!r} por {way!r}; os tipos de movimento são: {ways}.",
            ).format(name=name, way=move_type, ways=_in_words(MOVE_TYPES))
        )
    if not (isfinite(dwell) and 0 <= dwell <= LONGEST_DWELL):
        raise HelicoideError(
            Text(
                en="The dwell at waypoint {name!r} must be 0 to {most:g} s, not {dwell:g}.",
                pt_BR="A espera no ponto {name!r} vai de 0 a {most:g} s, não {dwell:g}.",
            ).format(name=name, most=LONGEST_DWELL, dwell=dwell)
        )
    named = _named(name)
    grip = _gripping(robot, named, gripper)
    return Waypoint(named, _within(robot, named, robot.check_joints(q)), cast(MoveType, move_type), float(dwell), grip)


def _gripping(robot: Robot, name: str, gripper: str) -> GripperAction:
    if gripper not in GRIPPER_ACTIONS:
        raise HelicoideError(
            Text(
                en="The gripper cannot be {gripper!r} at waypoint {name!r}; it may be: {grips}.",
                pt_BR="A garra não pode ficar {gripper!r} no ponto {name!r}; pode ficar: {grips}.",
            ).format(
                name=name,
                gripper=gripper,
                grips=_in_words({grip: told for grip, told in GRIPPER_ACTIONS.items() if grip}),
            )
        )
    if gripper and robot.gripper is None:
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} sets the gripper to {gripper}, but this robot has no gripper.",
                pt_BR="O ponto {name!r} pede a garra {gripper}, e este robô não tem garra.",
            ).format(name=name, gripper=GRIPPER_ACTIONS[cast(GripperAction, gripper)])
        )
    return cast(GripperAction, gripper)


def _in_words(known: Mapping[Any, Text]) -> Text:
    """Keys with their meanings."""
    return Text(
        en=", ".join(f"{key} ({words.en})" if key != words.en else key for key, words in known.items()),
        pt_BR=", ".join(f"{key} ({words.pt_BR})" for key, words in known.items()),
    )


def _named(name: str) -> str:
    if not (name.isprintable() and name == name.strip() and 0 < len(name) <= LONGEST_NAME):
        raise HelicoideError(
            Text(
                en="{name!r} is not a valid waypoint name: a name has 1 to {most} visible characters and no spaces at "
                "its ends.",
                pt_BR="{name!r} não é um nome válido: um nome tem de 1 a {most} caracteres visíveis, sem espaços nas "
                "pontas.",
            ).format(name=name, most=LONGEST_NAME)
        )
    return name


def _within(robot: Robot, name: str, q: Array) -> Array:
    """The posture; raises HelicoideError if it is outside the limits and the range of the named postures."""
    reached = np.array([robot.lower, robot.upper, *robot.poses.values()])
    lower, upper = reached.min(axis=0) - POSTURE_TOLERANCE, reached.max(axis=0) + POSTURE_TOLERANCE
    if (outside := np.flatnonzero((q < lower) | (q > upper))).size:
        i = int(outside[0])
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} sets {joint} to {value:.4g} {unit}; the range is {low:.4g} to {high:.4g}.",
                pt_BR="O ponto {name!r} leva {joint} a {value:.4g} {unit}; a faixa vai de {low:.4g} a {high:.4g}.",
            ).format(
                name=name,
                joint=robot.variables[i].name,
                value=q[i],
                unit="m" if robot.variables[i].is_prismatic else "rad",
                low=lower[i],
                high=upper[i],
            )
        )
    return q


def with_waypoint(taught: WaypointList, at: int, new: Waypoint) -> WaypointList:
    """The list with a waypoint inserted at index `at`, 0 to its length; raises HelicoideError for a name in use."""
    _free(taught, new.name)
    place = _place(at, len(taught.waypoints))
    return replace(taught, waypoints=(*taught.waypoints[:place], new, *taught.waypoints[place:]))


def without_waypoint(taught: WaypointList, name: str) -> WaypointList:
    """The list without a waypoint."""
    i = taught.index(name)
    return replace(taught, waypoints=taught.waypoints[:i] + taught.waypoints[i + 1 :])


def with_waypoint_at(taught: WaypointList, name: str, to: int) -> WaypointList:
    """The list with a waypoint moved to index `to`, 0 to its length − 1; the others keep their order."""
    here = taught.waypoints[taught.index(name)]
    return with_waypoint(without_waypoint(taught, name), to, here)


def with_waypoint_name(taught: WaypointList, name: str, new: str) -> WaypointList:
    """The list with a waypoint renamed."""
    taught.index(name)
    if new != name:
        _free(taught, new)
    return _changed(taught, name, lambda old: replace(old, name=_named(new)))


def with_move_type(taught: WaypointList, name: str, move_type: str) -> WaypointList:
    """The list with another move type of a waypoint."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, old.q, move_type, old.dwell, old.gripper)
    )


def with_dwell(taught: WaypointList, name: str, dwell: float) -> WaypointList:
    """The list with another dwell of a waypoint, s."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, old.q, old.move_type, dwell, old.gripper)
    )


def with_gripper_action(taught: WaypointList, name: str, gripper: str) -> WaypointList:
    """The list with another gripper action at a waypoint, one of `GRIPPER_ACTIONS`."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, old.q, old.move_type, old.dwell, gripper)
    )


def with_posture(taught: WaypointList, name: str, q: ArrayLike) -> WaypointList:
    """The list with another posture of a waypoint, (n,), rad or m."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, q, old.move_type, old.dwell, old.gripper)
    )


def _changed(taught: WaypointList, name: str, change: Callable[[Waypoint], Waypoint]) -> WaypointList:
    i = taught.index(name)
    return replace(taught, waypoints=(*taught.waypoints[:i], change(taught.waypoints[i]), *taught.waypoints[i + 1 :]))


def _free(taught: WaypointList, name: str) -> None:
    if name in taught.names:
        raise HelicoideError(
            Text(
                en="There is already a waypoint {name!r}; names in use: {names}.",
                pt_BR="Já existe um ponto {name!r}; nomes em uso: {names}.",
            ).format(name=name, names=_listed(taught.names))
        )


def _place(at: int, last: int) -> int:
    if not 0 <= at <= last:
        raise HelicoideError(
            Text(
                en="There is no position {at} in the list; the positions are 0 to {last}.",
                pt_BR="Não há posição {at} na lista; as posições vão de 0 a {last}.",
            ).format(at=at, last=last)
        )
    return at
