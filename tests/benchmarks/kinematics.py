"""The tool's pose and Jacobian, one at a time and many, beside the libraries that compute them."""

from __future__ import annotations

from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
from tests.benchmarks.children.answer import Task
from tests.benchmarks.peers import Child, Peer, compare, started, ways_of
from tests.benchmarks.report import judge

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler
from helicoide.kinematics.library import load_robot, robot_names
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_blocks import tool_poses
from helicoide.kinematics.tool_kernels import arm_array, tool_jacobian, tool_pose, tool_pose_into

TITLE = "Pose and Jacobian of the tool beside Pinocchio, the Robotics Toolbox and ikpy; ratios are ours/peer"
PEERS = (
    Peer("pin", "with_pinocchio.py"),
    Peer("roboticstoolbox-python", "with_toolbox.py"),
    Peer("ikpy", "with_ikpy.py"),
)
ROBOTS = ("puma560", "movemaster", "panda")
MANY = 10_000
YARDSTICK = "pin"
GOALS = {"pose": 1.0, "pose, no new array": 1.0, "Jacobian": 1.0, "10,000 poses": 0.04}
HOW = (
    "Each call gives back a new array, Pinocchio's too: its pose as a matrix, or its Jacobian.",
    "Without one, ours writes into T, and Pinocchio into its data, of which it gives back a reference.",
)
URDF = "extrinsic xyz"


def _frames(robot: Robot) -> list[Array]:
    """The base, a frame on each joint with z along its axis, and the tool, all at q = 0."""
    frames = [np.eye(4)]
    for (x, y, z), point in zip(robot.directions, robot.points, strict=True):
        T = np.eye(4)
        T[:3, :3] = euler.euler_matrix([0.0, np.arctan2(np.hypot(x, y), z), np.arctan2(y, x)], URDF)
        T[:3, 3] = point
        frames.append(T)
    return [*frames, robot.T_world_tool_0]


def urdf_of(robot: Robot) -> str:
    """The bare chain, in the form that suits all peers: links from base to tool, joints that turn about z."""
    root = ElementTree.Element("robot", name=robot.name)
    links = ["base", *(f"link{i}" for i in range(len(robot.joints))), "tool"]
    for link in links:
        ElementTree.SubElement(root, "link", name=link)
    for (parent, before), (child, after) in pairwise(zip(links, _frames(robot), strict=True)):
        T = frozen(np.linalg.solve(before, after))
        rpy = euler.euler_angles(T[:3, :3], URDF).values
        turns = child != "tool"
        joint = ElementTree.SubElement(root, "joint", name=f"to_{child}", type="revolute" if turns else "fixed")
        ElementTree.SubElement(joint, "parent", link=parent)
        ElementTree.SubElement(joint, "child", link=child)
        ElementTree.SubElement(joint, "origin", xyz=_words(T[:3, 3]), rpy=_words(rpy))
        if turns:
            ElementTree.SubElement(joint, "axis", xyz="0 0 1")
            ElementTree.SubElement(joint, "limit", lower="-10", upper="10", velocity="1", effort="1")
    return ElementTree.tostring(root, encoding="unicode")


def _words(numbers: Array) -> str:
    return " ".join(map(repr, numbers.tolist()))


def _ours(robot: Robot, qs: Array) -> list[Task]:
    known = {"arm": arm_array(robot), "qs": qs, "q": qs[0], "T": np.empty((4, 4)), "tool_pose_into": tool_pose_into}
    known |= {"tool_pose": tool_pose, "tool_jacobian": tool_jacobian, "tool_poses": tool_poses}
    pose, jacobian, poses = "tool_pose(arm, q)", "tool_jacobian(arm, q)", "tool_poses(arm, qs)"
    pose_into = "tool_pose_into(arm, q, T)"
    return [
        Task("pose", pose, pose, known),
        Task("pose, no new array", pose_into, f"[{pose_into}, T][1]", known),
        Task("Jacobian", jacobian, f"[{jacobian} for q in qs[:100]]", known),
        Task("10,000 poses", poses, poses, known),
    ]


def _measure(robot: Robot, children: list[Child]) -> None:
    qs = np.random.default_rng(0).uniform(robot.lower, robot.upper, (MANY, len(robot.variables)))
    ways = ways_of(children, urdf=urdf_of(robot), tool="tool", postures=qs.tolist())
    for ours in _ours(robot, qs):
        print(f"  {robot.name}, {ours.figure}")
        ratios = compare(ours, ways)
        pinocchio = [ratio for way, ratio in ratios.items() if way.child.name == YARDSTICK]
        judge(f"{robot.name}, {ours.figure}, beside {YARDSTICK}", pinocchio, GOALS[ours.figure])


def run() -> None:
    print("\n".join(f"  {line}" for line in HOW))
    with started(PEERS) as children:
        for name in ROBOTS:
            if name in robot_names():
                _measure(load_robot(name), children)
            else:
                print(f"  {name} is LEFT OUT: it is not installed")
