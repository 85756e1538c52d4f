"""An arm as the peers of the inverse kinematics read it: URDF with limits and guarded points, and standard DH rows."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
from tests.benchmarks.kinematics import urdf_of

from helicoide.arrays import Array
from helicoide.geometry import euler
from helicoide.kinematics import dh
from helicoide.kinematics.robot import Robot


def urdf_with_limits(robot: Robot) -> str:
    """The chain of `urdf_of` with the robot's limits."""
    root = ElementTree.fromstring(urdf_of(robot))
    for limit, joint in zip(root.iter("limit"), robot.variables, strict=True):
        ends = {"lower": joint.lower, "upper": joint.upper, "velocity": joint.speed}
        limit.attrib |= {name: f"{value:.17g}" for name, value in ends.items()}
    return ElementTree.tostring(root, encoding="unicode")


def points_on_links(robot: Robot) -> list[Array]:
    """The guarded points in the frames of the URDF's links, (3,), m: 0 is the base, i what joint i carries."""
    frames = [np.eye(4)]
    for joint in ElementTree.fromstring(urdf_of(robot)).iter("joint"):
        origin = joint.find("origin")
        assert origin is not None
        xyz, rpy = (np.array(origin.attrib[key].split(), float) for key in ("xyz", "rpy"))
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = euler.euler_matrix(rpy, "extrinsic xyz"), xyz
        frames.append(frames[-1] @ T)
    return [
        frames[link][:3, :3].T @ (_centre(robot, link) + point - frames[link][:3, 3])
        for link, point in zip(robot.monitored_links, robot.monitored_points, strict=True)
    ]


def _centre(robot: Robot, link: int) -> Array:
    """Where the frame of a link stands at q = 0, (3,), m."""
    return np.asarray(robot.points[link - 1] if link else np.zeros(3))


def standard_rows(robot: Robot) -> dict[str, object]:
    """Standard rows θ, d, a, α (n, 4), what stands before and behind them, and the guarded points in their frames."""
    table = dh.dh_from_screws(robot.joints, robot.T_world_tool_0)
    frames = dh.dh_poses(table, robot.joints, np.zeros(len(robot.joints)))
    points = [
        frames[link][:3, :3].T @ (_centre(robot, link) + point - frames[link][:3, 3])
        for link, point in zip(robot.monitored_links, robot.monitored_points, strict=True)
    ]
    rows = [[row.theta, row.d, row.a, row.alpha] for row in table.rows]
    start, tool = table.T_world_dh.tolist(), table.T_dh_tool.tolist()
    return {"rows": rows, "start": start, "tool": tool, "points": [point.tolist() for point in points]}
