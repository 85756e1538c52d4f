"""Errors, gains, objective and clearance in a state; what the steps request, their goals and their mistakes."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.confinement import segment_distances
from helicoide.geometry import rotation
from helicoide.ik.controller import GUARDED, SecondaryObjective
from helicoide.ik.task import GAIN
from helicoide.readout import target_pose
from helicoide.seat import Seat
from helicoide.state import State, Update, with_joints

FILTERED, OBJECTIVE = "filtered_modified", "second_arm"
FAR, REACHED = (0.58, 0.0, 0.1885), 0.53
OUTWARDS, TURNED, IN_PLACE = 0.55, radians(15.0), 2e-3
EVEN, LEAST, LIGHT, WITHIN = 5.0, 0.5, 1.0, 0.25
SHORT = 0.030
BALL = (0.25, 0.05, 0.20)
SWUNG, STILL, AS_GOOD = radians(40.0), radians(3.0), 1e-3
USUAL, HEAVY, GIVEN_WAY, CLOSE = 10.0, 100.0, 5e-3, 1e-3
AWAY, NO_BALL = 0.090, 1.0  # m; the last one instead of the distance of a sphere that is not there


def start(state: State) -> State:
    """Ask for the arm at `ready`, with the constrained step, equal gains, no objective and nothing in the way."""
    for change in (
        gate.choose_method(GUARDED),
        gate.compare_with(None),
        gate.choose_objective(None),
        gate.keep_orientation(True),
        *(gate.set_gain(index, GAIN) for index in range(4)),
        gate.get_ready(),
    ):
        state = change(state)
    for index in reversed(range(len(state.problem.obstacles.radii))):
        state = gate.remove_obstacle(index)(state)
    return state


def start_weighed(state: State) -> State:
    """The same with the modified filtered inverse, whose four gains are alike."""
    for change in (start, gate.choose_method(FILTERED), *(gate.set_gain(index, EVEN) for index in range(4))):
        state = change(state)
    return state


def start_beside_ball(state: State) -> State:
    """The same as `start` with a sphere beside the forearm, and the position alone asked for."""
    for change in (start, gate.add_obstacle(), gate.set_obstacle(0, BALL), gate.keep_orientation(False)):
        state = change(state)
    return state


def start_with_objective(state: State) -> State:
    """The same with the objective to keep away from the sphere, in the null space."""
    for change in (start_beside_ball, gate.choose_objective(OBJECTIVE), gate.weigh_objective(USUAL)):
        state = change(state)
    return state


def target_at(x: float, y: float, z: float) -> Update:
    """Ask for the tool at a place, m, turned as it is at `ready`."""
    return lambda state: gate.set_target([x, y, z], rotation.from_matrix(at_ready(state)[:3, :3]))(state)


def target_here(state: State) -> State:
    """Ask for the tool where it is at `ready`."""
    T = at_ready(state)
    return gate.set_target(T[:3, 3], rotation.from_matrix(T[:3, :3]))(state)


def at_ready(state: State) -> Array:
    """The pose of the tool at `ready`, (4, 4), m."""
    return with_joints(state, np.array(state.robot.poses["ready"])).T_world_tool


def missing(state: State) -> float:
    """The distance of the tool from its target, m."""
    return float(np.linalg.norm(target_pose(state)[:3, 3] - state.T_world_tool[:3, 3]))


def turned(state: State) -> float:
    """How far the tool is turned from its orientation at `ready`, rad."""
    return float(np.linalg.norm(rotation.logarithm(at_ready(state)[:3, :3].T @ state.T_world_tool[:3, :3])))


def swung(state: State) -> float:
    """The largest angle between a joint and its value at `ready`, rad."""
    return float(np.abs(state.arm.q - state.robot.poses["ready"]).max())


def clearance(state: State) -> float:
    """The distance of the surface of the arm from the surface of the nearest sphere, m."""
    balls = state.problem.obstacles
    bodies = [body for body in state.robot.bodies if max(body.links) > 0]
    axes = np.array([body.axis_at(state.arm.poses) for body in bodies])
    radii = np.array([body.radius for body in bodies])
    if not len(balls.radii):
        return NO_BALL
    return float((segment_distances(balls.ends[:, 0], axes) - radii - balls.radii[:, None]).min())


def vanishing(state: State) -> float:
    """About how far the arm is from the sphere where each bell of the objective is a thousandth of its height, m.

    The bells are as wide as `Options.radius` of the objective at first; the links are about as thick as the forearm.
    """
    wide, thick = 0.1 * state.robot.reach, float(np.median([body.radius for body in state.robot.bodies]))
    return wide * float(np.sqrt(np.log(1000.0))) - thick - float(state.problem.obstacles.radii.max(initial=0.0))


def objective(state: State) -> SecondaryObjective | None:
    """The secondary objective."""
    return state.request.controller.secondary


def weight(state: State) -> float:
    """The weight k₀ of the secondary objective, 1/s; 0 without one."""
    second = objective(state)
    return 0.0 if second is None else second.weight


# Goals and mistakes.


def has_target(state: State) -> bool:
    """Whether the arm rests after a target was asked for."""
    return isinstance(state.request.command, MoveToPose) and not state.arm.moving


def place_kept(state: State, seat: Seat) -> bool:
    """The tool is far out where it was asked to be, but turned."""
    far = float(state.T_world_tool[0, 3]) >= OUTWARDS and missing(state) < IN_PLACE
    return has_target(state) and state.request.with_orientation and far and turned(state) >= TURNED


def within_reach(state: State, seat: Seat) -> bool:
    """The target is one that the arm reaches in place and orientation."""
    here = float(state.T_world_tool[0, 3])
    moved = abs(here - float(at_ready(state)[0, 3])) > IN_PLACE
    return has_target(state) and moved and here < REACHED and missing(state) < IN_PLACE


def turn_not_asked(state: State, seat: Seat) -> bool:
    """The orientation does not count."""
    return not state.request.with_orientation


def asked_far(state: State) -> bool:
    """Whether the arm rests short of a target that is out of reach."""
    return has_target(state) and missing(state) >= SHORT


def orientation_is_light(state: State, seat: Seat) -> bool:
    """The target is out of reach, the orientation has a small gain, and those of the place are as before."""
    *place, turn = state.request.controller.gains
    return asked_far(state) and min(place) >= EVEN - WITHIN and turn <= LIGHT


def place_is_light(state: State, seat: Seat) -> bool:
    """The gains of the place are small, or that of the orientation is large."""
    *place, turn = state.request.controller.gains
    return asked_far(state) and turn > max(place) + 1.0


def all_are_light(state: State, seat: Seat) -> bool:
    """All gains are smaller and alike."""
    gains = state.request.controller.gains
    return asked_far(state) and max(gains) <= EVEN - 1.0 and max(gains) - min(gains) < WITHIN


def free_joints_swung(state: State, seat: Seat) -> bool:
    """The arm has moved away from the sphere, and the tool is where it was asked to be."""
    is_last = objective(state) is not None and not state.request.with_orientation
    return has_target(state) and is_last and swung(state) >= SWUNG and missing(state) < AS_GOOD


def no_target(state: State, seat: Seat) -> bool:
    """The orientation is kept, but the arm has no target, so that nothing is solved."""
    asked = state.request.with_orientation and objective(state) is not None
    return asked and not isinstance(state.request.command, MoveToPose) and weight(state) >= HEAVY


def weight_in_vain(state: State, seat: Seat) -> bool:
    """The objective has a large weight, and nothing moves: the task leaves no joint."""
    asked = state.request.with_orientation and objective(state) is not None
    return asked and has_target(state) and weight(state) >= HEAVY and swung(state) < STILL


def turn_is_free(state: State, seat: Seat) -> bool:
    """The objective has a large weight, but the orientation is free, so that joints are left."""
    asked = isinstance(state.request.command, MoveToPose)
    return asked and not state.request.with_orientation and weight(state) >= HEAVY


def row_pushes(state: State, seat: Seat) -> bool:
    """The objective is a row of the task, and pushes the tool off its target."""
    second = objective(state)
    return second is not None and second.as_row and has_target(state) and missing(state) >= GIVEN_WAY


def still_last(state: State, seat: Seat) -> bool:
    """The arm has moved away from the sphere, and the objective is not yet a row."""
    second = objective(state)
    return second is not None and not second.as_row and has_target(state) and swung(state) >= SWUNG


def at_the_ball(state: State, seat: Seat) -> bool:
    """The arm rests as near to the sphere as it may come."""
    kept = state.problem.zones.body_clearance
    return isinstance(state.request.command, MoveToPose) and abs(clearance(state) - kept) < CLOSE


def away_from_ball(state: State, seat: Seat) -> bool:
    """The target was moved, but not towards the sphere."""
    moved = float(np.linalg.norm(state.T_world_tool[:3, 3] - at_ready(state)[:3, 3])) > SHORT
    return isinstance(state.request.command, MoveToPose) and moved and clearance(state) > AWAY
