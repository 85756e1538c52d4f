"""From taught waypoints to motion: a time-optimal leg to each waypoint, and all legs as one path."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.joints import JointMove, tool_pose_in
from helicoide.trajectory.path import JointPath, Path, SmoothJointPath
from helicoide.trajectory.path_chain import GAP_TOLERANCE, JointPathChain, chain_joint_paths
from helicoide.trajectory.pose_paths import LinePath, ScrewPath
from helicoide.trajectory.spline import JointSpline
from helicoide.trajectory.time_optimal import TimingShape, time_optimal_timing
from helicoide.trajectory.timing import TimedJoints
from helicoide.trajectory.waypoints import Waypoint, WaypointList

# Joint values that move the tool along a path from one posture to another: rows at equally spaced parameters, (k, n),
# k ≥ 2; None if the arm cannot follow the path.
JointFollower = Callable[[Path, Array, Array], Array | None]
# Largest difference of these joint values from the taught postures at the ends, rad or m.
ENDPOINT_TOLERANCE = 1e-6


@dataclass(frozen=True, eq=False)
class Leg:
    """The motion to one waypoint.

    tool_path: path of the tool for linear and screw moves, with its parameter from 0 to 1 s; else None. joint_path:
    path of the joints by time; None if nothing moves, or if the arm cannot follow, which sets `blocked`.
    """

    waypoint: Waypoint
    tool_path: Path | None
    joint_path: TimedJoints | None
    blocked: bool = False


def program_legs(
    taught: WaypointList, q: Array, follow: JointFollower, shape: TimingShape, acceleration: Array
) -> Iterator[Leg]:
    """A leg to each waypoint, from rest to rest; the first begins in the current posture q (n,), rad or m.

    Args: acceleration: limits of the joints (n,), rad/s² or m/s²; speed limits are those of the robot.
    """
    for waypoint in taught.waypoints:
        yield _leg(taught.robot, q, waypoint, follow, shape, acceleration)
        q = waypoint.q


def _leg(robot: Robot, q: Array, to: Waypoint, follow: JointFollower, shape: TimingShape, acceleration: Array) -> Leg:
    if np.abs(q - to.q).max() <= GAP_TOLERANCE:
        return Leg(to, None, None)
    tool, joints = _ways(robot, q, to, follow)
    if joints is None:
        return Leg(to, tool, None, blocked=True)
    return Leg(to, tool, time_optimal_timing(joints, shape, robot.speed, acceleration))


def _ways(robot: Robot, q: Array, to: Waypoint, follow: JointFollower) -> tuple[Path | None, SmoothJointPath | None]:
    """The paths of the tool and of the joints to a waypoint, with the parameter from 0 to 1 s."""
    if to.move_type == "joints":
        return None, JointMove(q, to.q, 1.0)
    kind = LinePath if to.move_type == "line" else ScrewPath
    tool = kind(tool_pose_in(robot, q), tool_pose_in(robot, to.q), 1.0)
    rows = follow(tool, q, to.q)
    if rows is None or max(np.abs(rows[0] - q).max(), np.abs(rows[-1] - to.q).max()) > ENDPOINT_TOLERANCE:
        return tool, None
    exact = np.vstack([q, rows[1:-1], to.q])
    return tool, JointSpline(np.linspace(0.0, 1.0, len(exact)), exact)


def program_path(legs: Sequence[Leg]) -> JointPathChain | None:
    """All legs, each followed by its dwell, as one path by time; None if one is blocked or all take no time."""
    if any(leg.blocked for leg in legs):
        return None
    parts = [part for leg in legs for part in _parts(leg)]
    return chain_joint_paths(parts) if parts else None


def _parts(leg: Leg) -> Iterator[JointPath]:
    if leg.joint_path is not None:
        yield leg.joint_path
    if leg.waypoint.total_dwell > 0:
        yield JointMove(leg.waypoint.q, leg.waypoint.q, leg.waypoint.total_dwell)


def gripper_commands(legs: Sequence[Leg]) -> Iterator[tuple[float, float]]:
    """The gripper commands on the whole path: time, s, and opening, 0 closed or 1 open."""
    s = 0.0
    for leg in legs:
        s += 0.0 if leg.joint_path is None else leg.joint_path.duration
        if leg.waypoint.gripper:
            yield s, float(leg.waypoint.gripper == "open")
        s += leg.waypoint.total_dwell
