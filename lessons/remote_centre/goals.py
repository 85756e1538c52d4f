"""The rod, the entry point and the tip in a state; what the steps request, their goals and their mistakes."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToJoints, MoveToPose
from helicoide.geometry import rotation
from helicoide.ik.rcm.residuals import depth, fulcrum_ratio, lateral_distance
from helicoide.readout import target_pose
from helicoide.seat import Seat
from helicoide.state import State, Update, with_joints

SWING, ELBOW, SPIN = 0, 3, 6
JOINTS = 7
MOVED, LITTLE, ALONG = 0.050, 0.020, 0.030
TIP_MOVES, BODY_MOVES = 0.005, 0.005
EVEN, WITHIN = 1.0, 0.1
AT_ENTRY, IN_PLACE, BESIDE = 0.5e-3, 2e-3, 0.020
TURNED, SPUN, STILL = radians(10.0), radians(40.0), radians(1.0)
ASKED_ALONE = radians(5.0)


def at_ready(state: State) -> State:
    """The state with the arm at `ready`."""
    return with_joints(state, np.array(state.robot.poses["ready"]))


def place_of(state: State, frame: str) -> Array:
    """The origin of a named frame of the robot, (3,), m, world."""
    found = state.robot.frames[frame]
    return np.asarray((state.arm.poses[found.link] @ found.T_link_frame)[:3, 3])


def start(state: State) -> State:
    """Ask for the arm at `ready`, its rod through an entry point, with a free orientation."""
    hole = place_of(at_ready(state), "rcm")
    for change in (gate.enforce_entry(True), gate.set_entry(hole), gate.keep_orientation(False), gate.get_ready()):
        state = change(state)
    return state


def rod(state: State) -> Array:
    """The direction of the rod, towards its tip, (3,), world."""
    return state.T_world_tool[:3, 1]


def tip(state: State) -> Array:
    """The tip of the rod, (3,), m, world."""
    return state.T_world_tool[:3, 3]


def hand(state: State) -> Array:
    """The point where the axes of the wrist meet, (3,), m, world."""
    return place_of(state, "wrist")


def entry(state: State) -> Array:
    """The entry point, or where the lesson puts it, (3,), m, world."""
    return place_of(at_ready(state), "rcm") if state.problem.entry is None else state.problem.entry.point


def outside(state: State) -> float:
    """The length of the rod from the wrist to the entry point, m."""
    return -depth(rod(state), hand(state), entry(state))


def inside(state: State) -> float:
    """The length of the rod from the entry point to the tip, m."""
    return depth(rod(state), tip(state), entry(state))


def ratio(state: State) -> float:
    """Outside over inside; a large number where the tip is at the entry point."""
    return float(np.clip(fulcrum_ratio(rod(state), hand(state), tip(state), entry(state)), -1e3, 1e3))


def missed(state: State) -> float:
    """How far the axis of the rod passes from the entry point, m."""
    return lateral_distance(rod(state), tip(state), entry(state))


def split(state: State, moved: Array) -> tuple[float, float]:
    """A displacement (3,), m, as its part along the rod at `ready`, with its sign, and the size of the rest, m."""
    along = rod(at_ready(state))
    return float(moved @ along), float(np.linalg.norm(moved - (moved @ along) * along))


def tip_moved(state: State) -> tuple[float, float]:
    """How far the tip is from where it is at `ready`: along the rod and sideways, m."""
    return split(state, tip(state) - tip(at_ready(state)))


def entry_moved(state: State) -> tuple[float, float]:
    """How far the entry point is from where the lesson puts it: along the rod and sideways, m."""
    return split(state, entry(state) - place_of(at_ready(state), "rcm"))


def hand_moved(state: State) -> float:
    """How far the wrist is from where it is at `ready`, m."""
    return float(np.linalg.norm(hand(state) - hand(at_ready(state))))


def turned(state: State) -> float:
    """How far the end effector is turned from its orientation at `ready`, rad."""
    return float(
        np.linalg.norm(rotation.logarithm(at_ready(state).T_world_tool[:3, :3].T @ state.T_world_tool[:3, :3]))
    )


def tip_missing(state: State) -> float:
    """The distance of the tip from its target, m."""
    return float(np.linalg.norm(target_pose(state)[:3, 3] - tip(state)))


def hand_for_tip(state: State, seat: Seat) -> float:
    """How far the wrist moves for a small sideways motion of the tip, from `ready`, m."""
    return TIP_MOVES * outside(at_ready(state)) / inside(at_ready(state))


def hand_for_body(state: State, seat: Seat) -> float:
    """How far the wrist moves if the tip stays and the entry point moves sideways, from `ready`, m."""
    ready = at_ready(state)
    hole = place_of(ready, "rcm")
    whole, within = (float(np.linalg.norm(point - tip(ready))) for point in (hand(ready), hole))
    return BODY_MOVES * whole / within


def tip_target(sideways: float, along: float) -> Update:
    """Ask for the tip at a displacement from its place at `ready`, across the rod and along it, m."""

    def change(state: State) -> State:
        T = at_ready(state).T_world_tool
        return gate.set_target(T[:3, 3] + sideways * T[:3, 0] + along * T[:3, 1], rotation.from_matrix(T[:3, :3]))(
            state
        )

    return change


def entry_at(sideways: float, along: float) -> Update:
    """Move the entry point from where the lesson puts it, across the rod and along it, m."""

    def change(state: State) -> State:
        ready = at_ready(state)
        T = ready.T_world_tool
        return gate.set_entry(place_of(ready, "rcm") + sideways * T[:3, 0] + along * T[:3, 1])(state)

    return change


# Goals and mistakes.


def has_target(state: State) -> bool:
    """Whether the arm rests after a target was asked for."""
    return isinstance(state.request.command, MoveToPose) and not state.arm.moving


def in_entry(state: State) -> bool:
    """Whether there is an entry point, and the rod passes through it."""
    return state.problem.entry is not None and missed(state) < AT_ENTRY


def no_entry(state: State, seat: Seat) -> bool:
    """The entry point was switched off."""
    return state.problem.entry is None


def tip_sideways(state: State, seat: Seat) -> bool:
    """The tip rests well to the side of where it was, and the rod passes through the entry point."""
    return has_target(state) and in_entry(state) and tip_moved(state)[1] >= MOVED


def tip_along(state: State, seat: Seat) -> bool:
    """The tip was moved along the rod alone."""
    along, sideways = tip_moved(state)
    return has_target(state) and abs(along) >= ALONG and sideways < LITTLE


def as_long_inside(state: State, seat: Seat) -> bool:
    """The rod is as long inside as it is outside."""
    return has_target(state) and in_entry(state) and abs(ratio(state) - EVEN) <= WITHIN


def pulled_out(state: State, seat: Seat) -> bool:
    """The rod was pulled out of the body."""
    return has_target(state) and tip_moved(state)[0] <= -ALONG


def only_swung(state: State, seat: Seat) -> bool:
    """The rod was swung, and is about as deep as before."""
    along, sideways = tip_moved(state)
    return has_target(state) and sideways >= 2 * LITTLE and abs(along) < ALONG


def rod_beside(state: State, seat: Seat) -> bool:
    """The entry point was moved away from the resting rod."""
    rests = isinstance(state.request.command, HoldPosition) and not state.arm.moving
    return rests and state.problem.entry is not None and missed(state) >= BESIDE


def rod_followed(state: State, seat: Seat) -> bool:
    """The arm had a target, so that the rod followed the entry point, and the tip stayed at its target."""
    moved = in_entry(state) and entry_moved(state)[1] >= BESIDE
    return has_target(state) and moved and tip_missing(state) < IN_PLACE


def entry_along(state: State, seat: Seat) -> bool:
    """The entry point was moved along the rod alone, which passes through it as before."""
    along, sideways = entry_moved(state)
    return in_entry(state) and abs(along) >= ALONG and sideways < BESIDE / 2


def orientation_gives_way(state: State, seat: Seat) -> bool:
    """The orientation is asked for and lost; tip and entry point are where they have to be."""
    asked = state.request.with_orientation and tip_sideways(state, seat)
    return asked and turned(state) >= TURNED and tip_missing(state) < IN_PLACE


def not_asked(state: State, seat: Seat) -> bool:
    """The tip was moved, but the orientation is not asked for."""
    return not state.request.with_orientation and has_target(state) and tip_moved(state)[1] >= 2 * LITTLE


def spun(state: State, seat: Seat) -> bool:
    """The last joint has turned the rod about its own axis, and no other joint has moved."""
    by = np.abs(state.arm.q - state.robot.poses["ready"])
    return bool(by[SPIN] >= SPUN and np.delete(by, SPIN).max() < STILL) and in_entry(state) and not state.arm.moving


def stuck(state: State, seat: Seat) -> bool:
    """Another joint was asked alone, and did not move."""
    command = state.request.command
    if not isinstance(command, MoveToJoints) or state.arm.moving:
        return False
    return float(np.abs(command.q - state.arm.q)[:SPIN].max()) >= ASKED_ALONE
