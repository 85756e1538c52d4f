"""Drive the arm: a joint, a place, an orientation, a plane, a stop. For someone who meets a robot arm here first."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToPose, PathChoice
from helicoide.geometry import rotation
from helicoide.lesson import Step
from helicoide.readout import plane_distances
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

TITLE = Text(en="Drive the arm", pt_BR="Conduza o braço")
ROBOT = "movemaster"

ELBOW, CEILING = 2, 0
BENT, BENT_WITHIN = np.radians(-100.0), np.radians(2.0)
LEFT, LOW = 0.120, 0.130
TURNED = np.radians(20.0)
HELD_WITHIN = 1e-3
FOLLOWED, NEAR_PATH = 2.0, 0.1


def start(state: State) -> State:
    """Ask for the arm at `ready`, the measured planes, a held orientation and the path at its beginning."""
    for change in (gate.restore_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, path_choice=PathChoice(), path_s=0.0))


def target_at(x: float, y: float, z: float, about_z_deg: float = 0.0) -> Update:
    """Ask for a place, m, with the tool as it now is but for a turn about the vertical."""

    def change(state: State) -> State:
        turn = rotation.from_axis_angle([0.0, 0.0, 1.0], np.radians(about_z_deg))
        quat = rotation.multiply(turn, rotation.from_matrix(state.T_world_tool[:3, :3]))
        return gate.set_target([x, y, z], quat)(state)

    return change


def elbow_bent(state: State, seat: Seat) -> bool:
    """The elbow rests where it was asked to."""
    return bool(abs(state.arm.q[ELBOW] - BENT) <= BENT_WITHIN) and not state.arm.moving


def low_on_the_left(state: State, seat: Seat) -> bool:
    """The target brought the tool to the left and down, and the tool rests there."""
    _, y, z = state.T_world_tool[:3, 3]
    return isinstance(state.request.command, MoveToPose) and bool(y >= LEFT and z <= LOW) and not state.arm.moving


def out_of_plane(T_world_tool: Array) -> float:
    """The angle of a tool's x axis with the vertical plane through the waist axis and the tool, rad.

    No joint but the waist, which moves the tool away, leads out of that plane.
    """
    x, y, _ = T_world_tool[:3, 3]
    sideways = np.array([-y, x, 0.0]) / np.hypot(x, y)
    return float(np.arcsin(np.clip(sideways @ T_world_tool[:3, 0], -1.0, 1.0)))


def turn_refused(state: State, seat: Seat) -> bool:
    """The target asks for a turn that five joints do not have; the tool keeps its place and rests."""
    if not isinstance(state.request.command, MoveToPose) or not state.request.with_orientation or state.arm.moving:
        return False
    T_world_target = state.request.command.T_world_target
    missing = np.linalg.norm(T_world_target[:3, 3] - state.T_world_tool[:3, 3])
    return bool(missing < HELD_WITHIN) and abs(out_of_plane(T_world_target)) >= TURNED


def held_by_the_ceiling(state: State, seat: Seat) -> bool:
    """The target is beyond the ceiling, and a guarded point of the arm is as near to it as any may come."""
    if not isinstance(state.request.command, MoveToPose):
        return False
    planes = state.problem.planes
    beyond = planes.normals[CEILING] @ state.request.command.T_world_target[:3, 3] < planes.offsets[CEILING]
    nearest = plane_distances(state)[:, CEILING].min()
    return bool(beyond and abs(nearest - state.problem.zones.critical) <= HELD_WITHIN)


def stopped_on_the_path(state: State, seat: Seat) -> bool:
    """Stopped after following the path for a while; walls may hold the tool some way off the curve."""
    on_path = gate.path_of(state.robot, state.request.path_choice).pose(state.request.path_s)
    away = np.linalg.norm(on_path[:3, 3] - state.T_world_tool[:3, 3])
    return (
        state.request.command == HoldPosition(stopped=True)
        and state.request.path_s >= FOLLOWED
        and bool(away < NEAR_PATH)
    )


STEPS = (
    Step("joint", start, elbow_bent, ((gate.set_joint(ELBOW, BENT), 2.0),), joints=(ELBOW,)),
    Step("target", start, low_on_the_left, ((target_at(0.60, 0.16, 0.11), 3.0),)),
    Step("orientation", start, turn_refused, ((target_at(0.6029, 0.0, 0.1671, about_z_deg=60.0), 3.0),)),
    Step("plane", start, held_by_the_ceiling, ((target_at(0.60, 0.0, 0.70), 4.0),)),
    Step("stop", start, stopped_on_the_path, ((gate.play(), 5.0), (gate.stop(), 0.5))),
)
