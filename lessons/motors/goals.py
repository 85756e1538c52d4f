"""How the steps begin, when each is done, and how its mistakes are recognised."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from math import asin

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady, PathChoice
from helicoide.console import example_sheets, kind_of, sheet_results
from helicoide.geometry import motor, rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import AtSeat
from helicoide.seat import Seat
from helicoide.state import State

from .values import (
    APART,
    AT_REST,
    BELOW,
    FAR_ROLL,
    LEAST_WAIST,
    LITTLE_WAIST,
    MUCH_SLIDE,
    NEAR,
    NEAR_TURN,
    NO_SLIDE,
    ROLL,
    SAME_PLACE,
    SAME_TURN,
    WAIST,
    WANTED,
    WITHIN,
    coefficient,
    halfway,
    product_motor,
    shown_motor,
    straight_halfway,
)

SHEET = "movemaster_forward"
STILL = 0.005
TINY = 1e-6


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, with a held orientation and the path at its beginning."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, path_choice=PathChoice(), path_s=0.0))


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def waist_at(state: State, angle: float) -> bool:
    """Whether the arm rests with the waist at an angle, rad."""
    return abs(float(state.arm.q[WAIST]) - angle) <= WITHIN and rests(state)


def half_angle_found(state: State, seat: Seat) -> bool:
    """The coefficient of e1e2 in the waist's motor is as large as it was asked for."""
    return waist_at(state, 2 * asin(WANTED))


def full_angle_taken(state: State, seat: Seat) -> bool:
    """The sine of the whole angle is as large as it was asked for."""
    return waist_at(state, asin(WANTED))


def waist_turned_back(state: State, seat: Seat) -> bool:
    """The waist was turned to the other side."""
    return bool(state.arm.q[WAIST] < -AT_REST) and rests(state)


def both_numbers(state: State) -> tuple[bool, float]:
    """Whether the waist is turned enough, and the coefficient that is zero without a slide along the axis."""
    return bool(abs(state.arm.q[WAIST]) >= LEAST_WAIST), abs(coefficient(shown_motor(state), "e1e2e3e"))


def slide_undone(state: State, seat: Seat) -> bool:
    """The waist is turned, and yet the screw from the base is a pure turn."""
    turned, slide = both_numbers(state)
    return turned and slide <= NO_SLIDE and rests(state)


def rolled_along(state: State, seat: Seat) -> bool:
    """The roll was turned in the same sense as the waist, which makes the slide longer."""
    turned, slide = both_numbers(state)
    return turned and bool(state.arm.q[WAIST] * state.arm.q[ROLL] > AT_REST**2) and slide >= MUCH_SLIDE and rests(state)


def waist_only(state: State, seat: Seat) -> bool:
    """The waist was turned, the roll not yet."""
    turned, slide = both_numbers(state)
    return turned and bool(abs(state.arm.q[ROLL]) < AT_REST) and slide > NO_SLIDE and rests(state)


def of_sheet(seat: Seat, name: str) -> Array | None:
    """A multivector of the sheet by its name, (16,); None without one."""
    found = {result.name: result.value for result in sheet_results(seat.sheet, None)}.get(name)
    return found.values if isinstance(found, Multivector) and found.algebra is CL031 else None


def from_sheet(state: State, seat: Seat) -> tuple[float, float] | None:
    """How far the tool is from the pose of the sheet, m and rad; None without that pose."""
    if (pose := of_sheet(seat, "pose")) is None or not motor.is_motor(pose, TINY):
        return None
    T = rigid.pose_from_motor(pose)
    turn = rotation.logarithm(T[:3, :3].T @ state.T_world_tool[:3, :3])
    return float(np.linalg.norm(T[:3, 3] - state.T_world_tool[:3, 3])), float(np.linalg.norm(turn))


def sheet_met(state: State, seat: Seat) -> bool:
    """The arm rests in the pose of the sheet."""
    apart = from_sheet(state, seat)
    return apart is not None and apart[0] <= SAME_PLACE and apart[1] <= SAME_TURN and rests(state)


def roll_missing(state: State, seat: Seat) -> bool:
    """The tool is where the sheet says, but turned otherwise."""
    apart = from_sheet(state, seat)
    return apart is not None and apart[0] <= SAME_PLACE and apart[1] > SAME_TURN and rests(state)


def typed(state: State | None, seat: Seat) -> list[Multivector]:
    """The multivectors of the lines that are not in the example sheet, in their order."""
    given = {line.text for line in example_sheets()[SHEET].sheet.lines}
    results = zip(seat.sheet.lines, sheet_results(seat.sheet, state), strict=True)
    values = [result.value for line, result in results if line.text not in given]
    return [value for value in values if isinstance(value, Multivector) and value.algebra is CL031]


def tip_in_order(seat: Seat, names: tuple[str, ...]) -> Array | None:
    """Where the tool at zero is moved by the product of these motors of the sheet, (16,)."""
    found = (of_sheet(seat, name) for name in names)
    factors = [one for one in found if one is not None and motor.is_motor(one, TINY)]
    zero = rigid.point([0.82, 0.0, 0.4])
    return rigid.move(reduce(CL031.product, factors), zero) if len(factors) == len(names) else None


def is_last(seat: Seat, names: tuple[str, ...]) -> bool:
    """Whether the last typed line gives that point."""
    lines, tip = typed(None, seat), tip_in_order(seat, names)
    return bool(lines) and tip is not None and bool(np.allclose(lines[-1].values, tip, atol=TINY))


RIGHT_ORDER = ("h1", "h2", "h3", "h4", "h5")
REVERSED = RIGHT_ORDER[::-1]


def reversed_typed(state: State, seat: Seat) -> bool:
    """The last typed line moves the tool by the factors in the reverse order."""
    return is_last(seat, REVERSED)


def right_typed(state: State, seat: Seat) -> bool:
    """The last typed line moves the tool by the factors in the right order."""
    return is_last(seat, RIGHT_ORDER)


def no_point_typed(state: State, seat: Seat) -> bool:
    """The last typed line is a motor: it moves nothing yet."""
    lines = typed(None, seat)
    return bool(lines) and kind_of(lines[-1]).name == "motor"


def entered_line(text: str) -> AtSeat:
    """Add a line to those of the console."""

    def added(seat: Seat) -> Seat:
        lines = seat.sheet.lines
        return replace(seat, sheet=replace(seat.sheet, lines=(*lines, replace(lines[-1], text=text))))

    return AtSeat(added)


def sign_changed(state: State, seat: Seat) -> bool:
    """The product of the joints' motors has a negative scalar part."""
    return coefficient(product_motor(state), "1") <= BELOW and rests(state)


def turned_alike(state: State, seat: Seat) -> bool:
    """Waist and roll have turned in the same sense."""
    waist, roll = state.arm.q[WAIST], state.arm.q[ROLL]
    return bool(waist * roll > 0 and abs(waist) >= LEAST_WAIST and abs(roll) >= LEAST_WAIST) and rests(state)


def roll_alone(state: State, seat: Seat) -> bool:
    """The roll has turned nearly as far as it can, the waist hardly."""
    return bool(abs(state.arm.q[ROLL]) >= FAR_ROLL and abs(state.arm.q[WAIST]) < LITTLE_WAIST) and rests(state)


def at_halfway(state: State, seat: Seat) -> bool:
    """The tool rests halfway on the screw motion."""
    T = halfway(state.robot)
    turn = rotation.logarithm(T[:3, :3].T @ state.T_world_tool[:3, :3])
    near = np.linalg.norm(T[:3, 3] - state.T_world_tool[:3, 3]) <= NEAR
    return bool(near and np.linalg.norm(turn) <= NEAR_TURN) and rests(state)


def cut_short(state: State, seat: Seat) -> bool:
    """The tool rests near the middle of the straight line."""
    return bool(np.linalg.norm(straight_halfway(state.robot) - state.T_world_tool[:3, 3]) <= 2 * NEAR) and rests(state)


def at_the_end(state: State, seat: Seat) -> bool:
    """The arm is at the end of the motion."""
    return waist_at(state, APART)


def cut_the_corner(state: State) -> State:
    """Ask for the middle of the straight line, with the tool turned as it is."""
    as_it_is = rotation.from_matrix(state.T_world_tool[:3, :3])
    return gate.set_target(straight_halfway(state.robot), as_it_is)(state)


def moved_points(state: State, seat: Seat) -> tuple[float, float] | None:
    """How far the last typed motor moves the elbow and the wrist, m; None without a motor."""
    lines = typed(state, seat)
    if not lines or kind_of(lines[-1]).name != "motor":
        return None
    names = [point.name for point in state.robot.monitored]
    points = state.monitored_points[[names.index("elbow"), names.index("wrist")]]
    moved = rigid.coordinates(rigid.move(lines[-1].values, rigid.point(points)))
    elbow, wrist = np.linalg.norm(moved - points, axis=1)
    return float(elbow), float(wrist)


def only_wrist_moves(state: State, seat: Seat) -> bool:
    """The last typed motor moves the wrist and leaves the elbow in place."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] <= TINY and moved[1] > STILL


def elbow_moves(state: State, seat: Seat) -> bool:
    """The last typed motor moves the elbow."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] > TINY


def neither_moves(state: State, seat: Seat) -> bool:
    """The last typed motor leaves both in place."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] <= TINY and moved[1] <= STILL
