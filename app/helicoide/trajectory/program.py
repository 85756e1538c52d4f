"""From taught waypoints to motion: a leg to each, in the least time that the joints allow, and the whole in one."""

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

# The joints that carry the tool along a path from one posture to another: rows at even parameters from its start to its
# end, (k, n), k ≥ 2, or None where the arm cannot follow.
JointFollower = Callable[[Path, Array, Array], Array | None]
# The joints that follow may miss the taught postures at the ends by this much, rad or m.
ENDPOINT_TOLERANCE = 1e-6


@dataclass(frozen=True, eq=False)
class Leg:
    """The way to one waypoint.

    tool_path: that of the tool where it is asked to go straight or on a screw, with the parameter from 0 to 1 s;
    joint_path: that of the joints by time, None where nothing moves, or where the arm cannot follow and so `blocked` is
    true.
    """

    waypoint: Waypoint
    tool_path: Path | None
    joint_path: TimedJoints | None
    blocked: bool = False


def program_legs(
    taught: WaypointList, q: Array, follow: JointFollower, shape: TimingShape, acceleration: Array
) -> Iterator[Leg]:
    """A leg to each waypoint, from rest to rest; the first begins where the arm stands, q (n,), rad or m.

    Args: acceleration: limits of the joints (n,), rad/s² or m/s²; those of speed are the robot's.
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
    """The ways of the tool and of the joints to a waypoint, with the parameter from 0 to 1 s."""
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
    """All legs with the stays at their ends as one path by time; None where one is blocked or nothing lasts."""
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
    """When on the whole path the gripper is asked for something, s, and what: 0 closed, 1 open."""
    s = 0.0
    for leg in legs:
        s += 0.0 if leg.joint_path is None else leg.joint_path.duration
        if leg.waypoint.gripper:
            yield s, float(leg.waypoint.gripper == "open")
        s += leg.waypoint.total_dwell
