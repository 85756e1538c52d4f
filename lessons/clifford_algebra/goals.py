"""How the steps begin, when each is done, and how its mistakes are recognised."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.console import Value as ConsoleValue
from helicoide.console import example_sheets, sheet_results
from helicoide.geometry import incidence, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import AtSeat, Solution, StepGoal
from helicoide.seat import Seat
from helicoide.state import State, Update, with_joints

from .values import (
    ASIDE,
    BENCH,
    CEILING,
    E3,
    LIFTED,
    RAISED,
    SHIFTED,
    SHOULDER,
    TILTED,
    TOOL_POINT,
    WAIST,
    WRIST_POINT,
    ceiling_shift,
    ceiling_tilt,
    plane,
    point,
)

TOLERANCE = 1e-6
MOTION, STARS, DISTANCE, THROUGH = "rigid_motion", "hodge_star", "plane_distance", "plane_through_points"


def start(state: State) -> State:
    """Ask for the arm at `ready` among the measured planes, with a held orientation."""
    for change in (gate.restore_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def target_moved(dx: float, dy: float, dz: float) -> Update:
    """Ask for the tool as it now is, but for a displacement, m."""

    def change(state: State) -> State:
        T = state.T_world_tool
        return gate.set_target(T[:3, 3] + [dx, dy, dz], rotation.from_matrix(T[:3, :3]))(state)

    return change


def ceiling_moved(up: float, tilt: float = 0.0) -> Update:
    """Move the ceiling up, m, and tilt it about the y axis, rad."""

    def change(state: State) -> State:
        normal, offset = state.robot.panes[CEILING].normal, state.robot.panes[CEILING].offset
        turned = rotation.rotate(rotation.from_axis_angle([0.0, 1.0, 0.0], tilt), normal)
        return gate.set_plane(CEILING, turned, offset - up)(state)

    return change


def typed(text: str) -> Solution:
    """A line entered into the console."""

    def entered(seat: Seat) -> Seat:
        line = replace(seat.sheet.lines[0], text=text)
        return replace(seat, sheet=replace(seat.sheet, lines=(*seat.sheet.lines, line)))

    return ((AtSeat(entered), 0.0),)


def typed_values(state: State, seat: Seat, sheet: str) -> Iterator[tuple[ConsoleValue, ConsoleValue]]:
    """The value of each line that the example sheet does not have, as the arm is and with its waist turned."""
    given = {line.text for line in example_sheets()[sheet].sheet.lines}
    new = [n for n, line in enumerate(seat.sheet.lines) if line.text not in given]
    if not new:
        return
    now, later = sheet_results(seat.sheet, state), sheet_results(seat.sheet, elsewhere(state))
    for n in new:
        here, there = now[n].value, later[n].value
        if here is not None and there is not None:
            yield here, there


def elsewhere(state: State) -> State:
    """The state with the arm at another posture, at which a formula holds too, but a number that was read off fails."""
    q = np.array(state.robot.poses["ready"])
    q[WAIST] += radians(20.0)
    q[SHOULDER] -= radians(15.0)
    return with_joints(state, q)


def has_line(sheet: str, expected: Callable[[State], Array | float], factor: float = 1.0) -> StepGoal:
    """Whether a typed line is a number, or a multivector (16,), times a factor, at both postures."""

    def is_met(state: State, seat: Seat) -> bool:
        wanted = [factor * np.asarray(expected(each)) for each in (state, elsewhere(state))]
        return any(
            all(is_same(value, right) for value, right in zip(pair, wanted, strict=True))
            for pair in typed_values(state, seat, sheet)
        )

    return is_met


def is_same(value: ConsoleValue, right: Array) -> bool:
    """Whether a value of the console is this number, or has these coefficients."""
    if isinstance(value, Multivector) and value.algebra is not CL031:
        return False
    one = CL031.blade("1")
    given = value.values if isinstance(value, Multivector) else value * one
    return bool(np.abs(given - (right if right.ndim else right * one)).max() < TOLERANCE)


def any_of(*goals: StepGoal) -> StepGoal:
    """Whether one of the goals is met."""
    return lambda state, seat: any(goal(state, seat) for goal in goals)


def rotor_turning(target: Multivector) -> StepGoal:
    """Whether a typed line is a rotor of unit size that carries e3 there."""

    def is_met(state: State, seat: Seat) -> bool:
        return any(carries_e3_to(value, target) for value, _ in typed_values(state, seat, MOTION))

    return is_met


def carries_e3_to(value: ConsoleValue, target: Multivector) -> bool:
    """Whether a value is a rotor that carries e3 to a vector."""
    if not isinstance(value, Multivector) or value.algebra is not CL031:
        return False
    is_even = not value.values[CL031.grades % 2 == 1].any()
    return is_even and is_same(value * value.conjugate(), CL031.blade("1")) and is_same(value >> E3, target.values)


def hand_on_bench(state: State) -> Array:
    """Where the line from the wrist to the end effector meets the bench."""
    return incidence.meet(incidence.join(point(state, WRIST_POINT), point(state, TOOL_POINT)), plane(state, BENCH))


def lift(state: State) -> float:
    """How far the shoulder has turned from `ready`, rad."""
    return float(state.arm.q[SHOULDER] - state.robot.poses["ready"][SHOULDER])


def shoulder_lifted(state: State, seat: Seat) -> bool:
    """The shoulder rests, lifted, and not at `home`, from where the arm may still come."""
    return LIFTED <= lift(state) <= 2 * LIFTED and not state.arm.moving


def shoulder_lowered(state: State, seat: Seat) -> bool:
    """The shoulder was lowered."""
    return lift(state) <= -LIFTED / 2


def moved(state: State) -> Array:
    """How far the tool is from where it is at `ready`, (3,), m."""
    ready = with_joints(state, np.array(state.robot.poses["ready"]))
    return state.T_world_tool[:3, 3] - ready.T_world_tool[:3, 3]


def tool_raised(state: State, seat: Seat) -> bool:
    """The tool rests, raised straight up."""
    x, y, z = moved(state)
    return bool(z >= RAISED and np.hypot(x, y) <= ASIDE) and not state.arm.moving


def tool_aside(state: State, seat: Seat) -> bool:
    """The tool was moved to the side or forward."""
    return bool(np.hypot(*moved(state)[:2]) > ASIDE)


def ceiling_shifted(state: State, seat: Seat) -> bool:
    """The ceiling was moved along its normal."""
    return ceiling_shift(state) >= SHIFTED and ceiling_tilt(state) < TILTED


def ceiling_tilted(state: State, seat: Seat) -> bool:
    """The ceiling was tilted."""
    return ceiling_tilt(state) >= TILTED
