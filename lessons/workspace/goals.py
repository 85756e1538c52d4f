"""What the steps ask for, when they are done, and which mistakes are recognised."""

from __future__ import annotations

from math import pi

import numpy as np

from helicoide import gate
from helicoide.command import MoveToPose
from helicoide.geometry import rotation
from helicoide.seat import Seat
from helicoide.state import State, Update

from .values import (
    AS_ASKED,
    AT_EDGE,
    AT_TARGET,
    ELBOW,
    FOLDED,
    INNER,
    MOVED,
    NEAR,
    NEAR_ELBOW,
    NEARLY,
    OUTER,
    POINT,
    POINT_ELBOW,
    SHOULDER,
    STRETCHED,
    distance,
    has_joints,
    is_at,
    missing,
    ready_place,
    rests,
    target_distance,
    turned,
)

PHASES: tuple[gate.Phase, ...] = ("start", "end")


def start(state: State) -> State:
    """Ask for the arm at `ready`, for positions alone, without obstacles and planes."""
    for _ in state.problem.obstacles.radii:
        state = gate.remove_obstacle(0)(state)
    for change in (gate.clear_planes(), gate.keep_orientation(False), gate.get_ready()):
        state = change(state)
    return state


def target_at(x: float, y: float) -> Update:
    """Ask for a place in the plane of the arm, m."""
    return lambda state: gate.set_target([x, y, 0.0], rotation.from_matrix(state.T_world_tool[:3, :3]))(state)


def dragged_to(x: float, y: float) -> Update:
    """Drag the target to a place, m, and let go."""

    def change(state: State) -> State:
        quat = rotation.from_matrix(state.T_world_tool[:3, :3])
        for phase in PHASES:
            state = gate.drag_target("", phase, [x, y, 0.0], quat)(state)
        return state

    return change


def joints_at(shoulder_deg: float, elbow_deg: float) -> Update:
    """Ask for both joints, °."""
    return gate.set_joints(np.radians([shoulder_deg, elbow_deg]))


def at_inner_edge(state: State, seat: Seat) -> bool:
    """The target is in the hole, and the arm is folded as far as it can be."""
    is_in_hole = target_distance(state) < INNER - AT_EDGE
    return rests(state) and is_in_hole and abs(distance(state) - INNER) <= AT_EDGE


def at_outer_edge(state: State, seat: Seat) -> bool:
    """The target is beyond the outer edge, and the arm is stretched."""
    is_beyond = target_distance(state) > OUTER + AT_EDGE
    return rests(state) and is_beyond and abs(distance(state) - OUTER) <= AT_EDGE


def is_given_back(state: State, seat: Seat) -> bool:
    """The arm is at the inner edge, and the target at the arm: it came back when it was released."""
    is_there = abs(distance(state) - INNER) <= AT_EDGE and missing(state) < AT_TARGET
    return rests(state) and is_there and isinstance(state.request.command, MoveToPose)


def target_reached(state: State, seat: Seat) -> bool:
    """The arm has reached the target."""
    is_there = missing(state) < AT_TARGET and not is_given_back(state, seat)
    return rests(state) and is_there and isinstance(state.request.command, MoveToPose)


def other_elbow(state: State, seat: Seat) -> bool:
    """The tool is where it was at `ready`, with the elbow on the other side."""
    return is_at(state, ready_place(state)) and bool(state.arm.q[ELBOW] < 0)


def elbow_negated(state: State, seat: Seat) -> bool:
    """Only the sign of the elbow was changed."""
    shoulder, elbow = state.robot.poses["ready"]
    return has_joints(state, shoulder, -elbow)


def all_negated(state: State, seat: Seat) -> bool:
    """The signs of both joints were changed."""
    shoulder, elbow = state.robot.poses["ready"]
    return has_joints(state, -shoulder, -elbow)


def same_elbow(state: State, seat: Seat) -> bool:
    """Something has moved, and the elbow is on the same side."""
    has_moved = max(turned(state, SHOULDER), turned(state, ELBOW)) > MOVED
    return rests(state) and has_moved and bool(state.arm.q[ELBOW] > 0)


def is_near(state: State, seat: Seat) -> bool:
    """The tool rests at the distance that was asked for."""
    return rests(state) and abs(distance(state) - NEAR) <= AT_EDGE


def inner_angle(state: State, seat: Seat) -> bool:
    """The angle inside the triangle was used as the elbow angle."""
    return rests(state) and abs(abs(float(state.arm.q[ELBOW])) - (pi - NEAR_ELBOW)) <= AS_ASKED


def shoulder_alone(state: State, seat: Seat) -> bool:
    """Only the shoulder was turned."""
    return rests(state) and turned(state, SHOULDER) > MOVED and turned(state, ELBOW) < AS_ASKED


def at_point_up(state: State, seat: Seat) -> bool:
    """The tool is at the point with the elbow up."""
    return is_at(state, POINT) and bool(state.arm.q[ELBOW] < 0)


def at_point_down(state: State, seat: Seat) -> bool:
    """The tool is at the point with the elbow down."""
    return is_at(state, POINT) and bool(state.arm.q[ELBOW] > 0)


def off_the_point(state: State, seat: Seat) -> bool:
    """The elbow angle is right, and the shoulder angle is not."""
    is_bent = abs(float(state.arm.q[ELBOW]) + POINT_ELBOW) <= AS_ASKED
    return rests(state) and is_bent and not at_point_up(state, seat)


def is_stretched(state: State, seat: Seat) -> bool:
    """The arm rests stretched."""
    return rests(state) and abs(float(state.arm.q[ELBOW])) <= STRETCHED


def is_folded(state: State, seat: Seat) -> bool:
    """The arm rests folded."""
    return rests(state) and abs(float(state.arm.q[ELBOW])) >= FOLDED


def nearly_stretched(state: State, seat: Seat) -> bool:
    """The arm rests nearly stretched."""
    return rests(state) and STRETCHED < abs(float(state.arm.q[ELBOW])) <= NEARLY


def led_up(state: State, seat: Seat) -> bool:
    """A target led the arm to the point with the elbow up."""
    return at_point_up(state, seat) and isinstance(state.request.command, MoveToPose)


def led_down(state: State, seat: Seat) -> bool:
    """A target led the arm to the point with the elbow down."""
    return at_point_down(state, seat) and isinstance(state.request.command, MoveToPose)
