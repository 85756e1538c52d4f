"""Lists of waypoints that the tests of teaching share."""

from __future__ import annotations

from collections.abc import Sequence

from tests.kinematics.arms import arm, postures

from helicoide.trajectory.waypoints import MOVE_TYPES, WaypointList, waypoint


def taught(name: str, names: Sequence[str] = ("a", "b", "c"), seed: int = 0) -> WaypointList:
    """Waypoints of an arm at random postures, coming there in every way, staying 0, 0.5, 1, … s."""
    robot, ways = arm(name), list(MOVE_TYPES)
    return WaypointList(
        robot,
        tuple(
            waypoint(robot, each, q, ways[i % len(ways)], 0.5 * i)
            for i, (each, q) in enumerate(zip(names, postures(robot, len(names), seed), strict=True))
        ),
    )
