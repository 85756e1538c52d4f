"""From taught waypoints to motion: a time-optimal leg to each waypoint, and all legs as one path."""

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

# Joint values that move the tool along a path from one posture to another: rows at equally spaced parameters, (k, n),
# k ≥ 2; None if the arm cannot follow the path.
Follow = Callable[[Path, Array, Array], Array | None]
# Largest difference of these joint values from the taught postures at the ends, rad or m.
ARRIVES = 1e-6


@dataclass(frozen=True, eq=False)
class Leg:
    """The motion to one waypoint.

    tool: path of the tool for linear and screw moves, with its parameter from 0 to 1 s; else None. joints: path of the
    joints by time; None if nothing moves, or if the arm cannot follow, which sets `blocked`.
    """

    waypoint: Waypoint
    tool: Path | None
    joints: TimedJoints | None
    blocked: bool = False


def legs(taught: Taught, q: Array, follow: Follow, shape: Shape, acceleration: Array) -> Iterator[Leg]:
    """A leg to each waypoint, from rest to rest; the first begins in the current posture q (n,), rad or m.

    Args: acceleration: limits of the joints (n,), rad/s² or m/s²; speed limits are those of the robot.
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
    """The paths of the tool and of the joints to a waypoint, with the parameter from 0 to 1 s."""
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
    """All legs, each followed by its dwell, as one path by time; None if one is blocked or all take no time."""
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
    """The gripper commands on the whole path: time, s, and opening, 0 closed or 1 open."""
    s = 0.0
    for leg in legs:
        s += 0.0 if leg.joints is None else leg.joints.duration
        if leg.waypoint.gripper:
            yield s, float(leg.waypoint.gripper == "open")
        s += leg.waypoint.stay
