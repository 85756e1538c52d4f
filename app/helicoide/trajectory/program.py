"""From taught waypoints to motion: a leg to each, in the least time that the joints allow, and the whole in one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.chained import MEETS, JointChain, joint_chain
from helicoide.trajectory.fastest import Shape, fastest
from helicoide.trajectory.joints import JointMove, tool_at
from helicoide.trajectory.path import JointPath, Path, SmoothJointPath
from helicoide.trajectory.spline import Spline
from helicoide.trajectory.straight import Line, Screw
from helicoide.trajectory.timing import TimedJoints
from helicoide.trajectory.waypoints import Taught, Waypoint

# The joints that carry the tool along a path from one posture to another: rows at even parameters from its start to its
# end, (k, n), k ≥ 2, or None where the arm cannot follow.
Follow = Callable[[Path, Array, Array], Array | None]
# The joints that follow may miss the taught postures at the ends by this much, rad or m.
ARRIVES = 1e-6


@dataclass(frozen=True, eq=False)
class Leg:
    """The way to one waypoint.

    tool: that of the tool where it is asked to go straight or on a screw, with the parameter from 0 to 1 s; joints:
    that of the joints by time, None where nothing moves, or where the arm cannot follow and so `blocked` is true.
    """

    waypoint: Waypoint
    tool: Path | None
    joints: TimedJoints | None
    blocked: bool = False


def legs(taught: Taught, q: Array, follow: Follow, shape: Shape, acceleration: Array) -> Iterator[Leg]:
    """A leg to each waypoint, from rest to rest; the first begins where the arm stands, q (n,), rad or m.

    Args: acceleration: limits of the joints (n,), rad/s² or m/s²; those of speed are the robot's.
    """
    for waypoint in taught.waypoints:
        yield _leg(taught.robot, q, waypoint, follow, shape, acceleration)
        q = waypoint.q


def _leg(robot: Robot, q: Array, to: Waypoint, follow: Follow, shape: Shape, acceleration: Array) -> Leg:
    if np.abs(q - to.q).max() <= MEETS:
        return Leg(to, None, None)
    tool, joints = _ways(robot, q, to, follow)
    if joints is None:
        return Leg(to, tool, None, blocked=True)
    return Leg(to, tool, fastest(joints, shape, robot.speed, acceleration))


def _ways(robot: Robot, q: Array, to: Waypoint, follow: Follow) -> tuple[Path | None, SmoothJointPath | None]:
    """The ways of the tool and of the joints to a waypoint, with the parameter from 0 to 1 s."""
    if to.way == "joints":
        return None, JointMove(q, to.q, 1.0)
    kind = Line if to.way == "line" else Screw
    tool = kind(tool_at(robot, q), tool_at(robot, to.q), 1.0)
    rows = follow(tool, q, to.q)
    if rows is None or max(np.abs(rows[0] - q).max(), np.abs(rows[-1] - to.q).max()) > ARRIVES:
        return tool, None
    exact = np.vstack([q, rows[1:-1], to.q])
    return tool, Spline(np.linspace(0.0, 1.0, len(exact)), exact)


def whole(legs: Sequence[Leg]) -> JointChain | None:
    """All legs with the stays at their ends as one path by time; None where one is blocked or nothing lasts."""
    if any(leg.blocked for leg in legs):
        return None
    parts = [part for leg in legs for part in _parts(leg)]
    return joint_chain(parts) if parts else None


def _parts(leg: Leg) -> Iterator[JointPath]:
    if leg.joints is not None:
        yield leg.joints
    if leg.waypoint.stay > 0:
        yield JointMove(leg.waypoint.q, leg.waypoint.q, leg.waypoint.stay)


def grips(legs: Sequence[Leg]) -> Iterator[tuple[float, float]]:
    """When on the whole path the gripper is asked for something, s, and what: 0 closed, 1 open."""
    s = 0.0
    for leg in legs:
        s += 0.0 if leg.joints is None else leg.joints.duration
        if leg.waypoint.gripper:
            yield s, float(leg.waypoint.gripper == "open")
        s += leg.waypoint.stay
