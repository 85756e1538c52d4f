"""Move an object by one coefficient of its multivector: the target, a plane or the entry point."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.gate.check import driven, finite
from helicoide.gate.entry import NONE_HELD, set_entry
from helicoide.gate.planes import check_movable, set_plane
from helicoide.gate.target import set_target
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.given_coefficient import motor_with_coefficient, plane_with_coefficient
from helicoide.seat import Selection
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text

FOLLOWS = Text(
    en="This object cannot be moved by itself: it follows the joints. Move the end effector, the target, a plane, the "
    "entry point, or a joint.",
    pt_BR="Este objeto não se move sozinho: ele acompanha as juntas. Mova o efetuador, o alvo, um plano, o ponto de "
    "entrada ou uma junta.",
)
NOT_OF_POINT = Text(
    en="A point moves by its coordinates: the blades e23, e31 and e12 with the null generator.",
    pt_BR="Um ponto se move por suas coordenadas: as lâminas e23, e31 e e12 com o gerador nulo.",
)


def set_coefficient(selection: Selection, blade: str, value: float) -> Update:
    """Move an object so that the coefficient of a blade of `CL031` has this value; the others adapt.

    The tool and the target get a new target pose. Objects that follow the joints are refused.
    """

    def change(state: State) -> State:
        (given,) = map(float, finite([value], (1,)))
        match selection.kind:
            case "tool" | "target":
                return _target(state, selection, blade, given)
            case "plane":
                return _plane(state, selection.index, blade, given)
            case "entry":
                return _entry(state, blade, given)
            case _:
                raise HelicoideError(FOLLOWS)

    return driven(change)


def _target(state: State, selection: Selection, blade: str, value: float) -> State:
    command = state.request.command
    T = state.T_world_tool
    if selection.kind == "target" and isinstance(command, MoveToPose):
        T = command.T_world_target
    M = motor_with_coefficient(rigid.motor_from_pose(T), blade, value)
    moved = rigid.pose_from_motor(M)
    return set_target(moved[:3, 3], rotation.from_matrix(moved[:3, :3]))(state)


def _plane(state: State, index: int, blade: str, value: float) -> State:
    check_movable(state, index)
    planes = state.problem.planes
    plane = rigid.plane(planes.normals[index], planes.offsets[index])
    normal, offset = rigid.normal_and_offset(plane_with_coefficient(plane, blade, value))
    return set_plane(index, normal, float(offset))(state)


def _entry(state: State, blade: str, value: float) -> State:
    if state.problem.entry is None:
        raise HelicoideError(NONE_HELD)
    at, sign = CL031.parse_blade(blade)
    coordinates: Array = np.array(state.problem.entry.point)
    for axis, name in enumerate(("e2e3e", "e3e1e", "e1e2e")):
        index, orientation = CL031.parse_blade(name)
        if index == at:
            coordinates[axis] = sign * orientation * value
            return set_entry(coordinates)(state)
    raise HelicoideError(NOT_OF_POINT)
