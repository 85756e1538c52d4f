"""Taught waypoints: postures with a name, how to come there and how long to stay; lists of them are never changed."""

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
        "joints": Text(en="all joints evenly", pt_BR="todas as juntas por igual"),
        "line": Text(en="straight line", pt_BR="linha reta"),
        "screw": Text(en="a single screw motion", pt_BR="um único movimento helicoidal"),
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
# A gripper opens or closes in so many s, for which an arm stays at a waypoint at least.
GRIPPER_TIME = 0.5
LONGEST_NAME = 60
LONGEST_DWELL = 3600.0
# A posture may stand so far outside the limits and the named postures of its arm, rad or m.
POSTURE_TOLERANCE = 1e-3


@dataclass(frozen=True, eq=False)
class Waypoint:
    """A taught posture: q (n,), rad or m; move_type: how to come there from the one before; dwell: how long to stay, s.

    gripper: what it does there, before the arm goes on.
    """

    name: str
    q: Array
    move_type: MoveType = "joints"
    dwell: float = 0.0
    gripper: GripperAction = ""

    @property
    def total_dwell(self) -> float:
        """How long the arm is there, s: as it was told, and at least as long as its gripper takes."""
        return max(self.dwell, GRIPPER_TIME) if self.gripper else self.dwell


@dataclass(frozen=True, eq=False)
class WaypointList:
    """The waypoints of one arm, each name once, in the order in which they are visited.

    shape: the time scaling of the way to each.
    """

    robot: Robot
    waypoints: tuple[Waypoint, ...] = ()
    shape: TimingShape = "trapezoid"

    @property
    def names(self) -> tuple[str, ...]:
        """The names in order."""
        return tuple(waypoint.name for waypoint in self.waypoints)

    def index(self, name: str) -> int:
        """The place of a waypoint; raises HelicoideError that lists the names there are."""
        if name not in self.names:
            raise HelicoideError(
                Text(
                    en="There is no waypoint {name!r}; there is: {names}.",
                    pt_BR="Não há ponto {name!r}; há: {names}.",
                ).format(name=name, names=_listed(self.names))
            )
        return self.names.index(name)


def _listed(names: tuple[str, ...]) -> Text:
    words = ", ".join(names)
    return Text(en=words, pt_BR=words) if names else Text(en="none yet", pt_BR="nenhum ainda")


def waypoint(
    robot: Robot, name: str, q: ArrayLike, move_type: str = "joints", dwell: float = 0.0, gripper: str = ""
) -> Waypoint:
    """A waypoint of an arm; raises HelicoideError for a name, posture, way, time or gripper that cannot be one."""
    if move_type not in MOVE_TYPES:
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} cannot be reached by {way!r}; the ways are: {ways}.",
                pt_BR="Não se chega ao ponto {name!r} por {way!r}; as maneiras são: {ways}.",
            ).format(name=name, way=move_type, ways=_told(MOVE_TYPES))
        )
    if not (isfinite(dwell) and 0 <= dwell <= LONGEST_DWELL):
        raise HelicoideError(
            Text(
                en="The arm can stay at waypoint {name!r} for 0 to {most:g} s, not {dwell:g}.",
                pt_BR="O braço pode ficar no ponto {name!r} de 0 a {most:g} s, não {dwell:g}.",
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
                name=name, gripper=gripper, grips=_told({grip: told for grip, told in GRIPPER_ACTIONS.items() if grip})
            )
        )
    if gripper and robot.gripper is None:
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} is to have the gripper {gripper}, and this robot has none.",
                pt_BR="O ponto {name!r} pede a garra {gripper}, e este robô não tem garra.",
            ).format(name=name, gripper=GRIPPER_ACTIONS[cast(GripperAction, gripper)])
        )
    return cast(GripperAction, gripper)


def _told(known: Mapping[Any, Text]) -> Text:
    """Keys with what they mean."""
    return Text(
        en=", ".join(f"{key} ({words.en})" if key != words.en else key for key, words in known.items()),
        pt_BR=", ".join(f"{key} ({words.pt_BR})" for key, words in known.items()),
    )


def _named(name: str) -> str:
    if not (name.isprintable() and name == name.strip() and 0 < len(name) <= LONGEST_NAME):
        raise HelicoideError(
            Text(
                en="{name!r} names no waypoint: a name has 1 to {most} visible characters, without blanks around it.",
                pt_BR="{name!r} não serve de nome: um ponto tem de 1 a {most} caracteres visíveis, sem espaços nas "
                "pontas.",
            ).format(name=name, most=LONGEST_NAME)
        )
    return name


def _within(robot: Robot, name: str, q: Array) -> Array:
    """The posture, unless it is one that the arm cannot have: outside its limits and beyond its named postures."""
    reached = np.array([robot.lower, robot.upper, *robot.poses.values()])
    lower, upper = reached.min(axis=0) - POSTURE_TOLERANCE, reached.max(axis=0) + POSTURE_TOLERANCE
    if (outside := np.flatnonzero((q < lower) | (q > upper))).size:
        i = int(outside[0])
        raise HelicoideError(
            Text(
                en="Waypoint {name!r} puts {joint} at {value:.4g} {unit}, which must lie from {low:.4g} to {high:.4g}.",
                pt_BR="O ponto {name!r} põe {joint} em {value:.4g} {unit}, mas deve ficar de {low:.4g} a {high:.4g}.",
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
    """The list with one more before the place `at`, 0 to its length; raises HelicoideError where the name is taken."""
    _free(taught, new.name)
    place = _place(at, len(taught.waypoints))
    return replace(taught, waypoints=(*taught.waypoints[:place], new, *taught.waypoints[place:]))


def without_waypoint(taught: WaypointList, name: str) -> WaypointList:
    """The list without a waypoint."""
    i = taught.index(name)
    return replace(taught, waypoints=taught.waypoints[:i] + taught.waypoints[i + 1 :])


def with_waypoint_at(taught: WaypointList, name: str, to: int) -> WaypointList:
    """The list with a waypoint brought to the place `to`, 0 to its length less one; the others keep their order."""
    here = taught.waypoints[taught.index(name)]
    return with_waypoint(without_waypoint(taught, name), to, here)


def with_waypoint_name(taught: WaypointList, name: str, new: str) -> WaypointList:
    """The list with another name for a waypoint."""
    taught.index(name)
    if new != name:
        _free(taught, new)
    return _changed(taught, name, lambda old: replace(old, name=_named(new)))


def with_move_type(taught: WaypointList, name: str, move_type: str) -> WaypointList:
    """The list with another way to a waypoint."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, old.q, move_type, old.dwell, old.gripper)
    )


def with_dwell(taught: WaypointList, name: str, dwell: float) -> WaypointList:
    """The list with another stay at a waypoint, s."""
    return _changed(
        taught, name, lambda old: waypoint(taught.robot, old.name, old.q, old.move_type, dwell, old.gripper)
    )


def with_gripper_action(taught: WaypointList, name: str, gripper: str) -> WaypointList:
    """The list with what the gripper does at a waypoint, one of `GRIPPER_ACTIONS`."""
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
                en="There is a waypoint {name!r} already; taken are: {names}.",
                pt_BR="Já existe um ponto {name!r}; em uso: {names}.",
            ).format(name=name, names=_listed(taught.names))
        )


def _place(at: int, last: int) -> int:
    if not 0 <= at <= last:
        raise HelicoideError(
            Text(
                en="There is no place {at} in the list; the places are 0 to {last}.",
                pt_BR="Não há lugar {at} na lista; os lugares vão de 0 a {last}.",
            ).format(at=at, last=last)
        )
    return at
