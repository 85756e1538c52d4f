"""Arms of the slides: the PUMA from its DH rows, arms with six revolute joints from any DH rows, planar arms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics import dh
from helicoide.kinematics.chain import Joint
from helicoide.kinematics.dh import DhRow, DhTable
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot

# a2, a3, d3, d4, m: as published for the machine, and three other sets; the slides give none
LENGTHS = [
    (0.4318, *rest) for rest in [(0.0203, 0.1244, 0.4318), (-0.0203, 0.1501, 0.4331), (0, 0, 0.4), (-0.2, -0.1, -0.3)]
]
Rows = Sequence[tuple[float, float, float]]


def arm_from_dh(rows: Rows, T_world_dh: Array, T_dh_tool: Array, shifts: Sequence[float] | Array = (0,) * 6) -> Robot:
    """An arm with six revolute joints, ±180°, from modified DH rows (α, a, d), rad and m; shifts: θ at q = 0, rad."""
    puma = load_robot("puma560")
    table = DhTable(
        "modified",
        tuple(DhRow(shift, d, a, alpha) for shift, (alpha, a, d) in zip(shifts, rows, strict=True)),
        frozen(T_world_dh),
        frozen(T_dh_tool),
    )
    frames = dh.dh_poses(table, puma.joints, np.zeros(6))
    joints = tuple(
        replace(joint, direction=frozen(T[:3, 2]), point=frozen(T[:3, 3]), lower=-np.pi, upper=np.pi)
        for joint, T in zip(puma.joints, frames[1:], strict=True)
    )
    T_world_tool_0 = frames[-1] @ T_dh_tool
    return replace(puma, joints=joints, dh=table, T_world_tool_0=frozen(T_world_tool_0))


def puma_rows(a2: float, a3: float, d3: float, d4: float) -> Rows:
    """The modified rows of the PUMA (α, a, d), rad and m. Source: Campos 1998, s.55."""
    right = np.pi / 2
    return [(0, 0, 0), (-right, 0, 0), (0, a2, d3), (-right, a3, d4), (right, 0, 0), (-right, 0, 0)]


@cache
def revolute_joint() -> Joint:
    """A revolute joint."""
    return load_robot("puma560").joints[0]


def puma_wrist_pose(lengths: tuple[float, ...], theta: Array) -> Array:
    """The pose (4, 4) of frame 6, m, as the product of the DH transforms of s.55; theta (6,), rad."""
    T = np.eye(4)
    for (alpha, a, d), angle in zip(puma_rows(*lengths), theta, strict=True):
        T = T @ dh.dh_transform("modified", dh.DhRow(0, d, a, alpha), revolute_joint(), angle)
    return T


def puma_with_lengths(a2: float, a3: float, d3: float, d4: float) -> Robot:
    """A PUMA with other lengths, m, and with random base pose, tool pose and joint zeros."""
    draw = np.random.default_rng(560)
    return arm_from_dh(puma_rows(a2, a3, d3, d4), random_pose(draw), random_pose(draw), draw.uniform(-3, 3, 6))


def random_spherical_arm(draw: np.random.Generator, family: str, right_wrist: bool = True) -> Robot:
    """A random arm with its wrist last: "general", "a1 = 0" or "sin α1 = 0"; wrist angles ±90° or any."""
    alpha = draw.uniform(-np.pi, np.pi, 6)
    alpha[4:] = [np.pi / 2, -np.pi / 2] if right_wrist else draw.uniform(0.4, 2.7, 2) * draw.choice([-1, 1], 2)
    a, d = draw.uniform(-1, 1, (2, 6))
    a[4:], d[4:] = 0, 0
    if family == "a1 = 0":
        a[1] = 0
    if family == "sin α1 = 0":
        alpha[1] = draw.choice([0, np.pi])
    rows = [(float(x), float(y), float(z)) for x, y, z in zip(alpha, a, d, strict=True)]
    return arm_from_dh(rows, random_pose(draw), random_pose(draw), draw.uniform(-3, 3, 6))


def random_pose(draw: np.random.Generator) -> Array:
    """A random pose (4, 4), m."""
    T = np.eye(4)
    T[:3, :3] = np.linalg.qr(draw.normal(size=(3, 3)))[0]
    T[:3, 0] *= np.linalg.det(T[:3, :3])
    T[:3, 3] = draw.uniform(-1, 1, 3)
    return T


@cache
def planar_with_lengths(name: str, *lengths: float) -> Robot:
    """A planar robot of the library with other link lengths, m."""
    return load_robot(name, settings=[f"l{i + 1}={1000 * length}" for i, length in enumerate(lengths)])


def planar_pose(x: float, y: float, phi: float = 0.0, z: float = 0.0) -> Array:
    """The pose (4, 4) at (x, y, z), m, rotated by phi, rad, about the vertical."""
    c, s = np.cos(phi), np.sin(phi)
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])


def with_joint_limits(robot: Robot, lower: Sequence[float], upper: Sequence[float]) -> Robot:
    """The same arm with other joint limits, rad or m."""
    joints = zip(robot.joints, lower, upper, strict=True)
    return replace(robot, joints=tuple(replace(joint, lower=low, upper=high) for joint, low, high in joints))
