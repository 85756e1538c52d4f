"""The arms that the tests of kinematics go through: every robot in a folder, and one with a slide and a mimic joint."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from helicoide import content
from helicoide.arrays import Array, frozen
from helicoide.kinematics.forward import screw_displacements
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import Frame
from helicoide.kinematics.urdf_chain import robot_from_urdf

MIXED = "slide and mimic"
NAMES = [*sorted(content.content_folders("robots")), MIXED]

JOINTS = [  # name, type, axis, origin, what else
    ("a", "revolute", "0 0 1", "0.1 0 0.3", ""),
    ("b", "prismatic", "1 0 0.2", "0.2 0.05 0", ""),
    ("c", "revolute", "0 -1 0", "0.3 0 0.1", ""),
    ("d", "revolute", "0 1 0.3", "0.4 0 0", '<mimic joint="c" multiplier="-0.7" offset="0.2"/>'),
    ("e", "prismatic", "0 0 1", "0.1 0.1 0", '<mimic joint="b" multiplier="0.5" offset="0.03"/>'),
    ("f", "revolute", "1 0 0", "0.2 0 0", ""),
]


@cache
def arm(name: str) -> Robot:
    """A robot by its name in `NAMES`."""
    if name != MIXED:
        return load_robot(name)
    links = ["base", *(joint[0] + "_link" for joint in JOINTS)]
    parts = [f'<link name="{link}"/>' for link in links] + [
        f'<joint name="{name}" type="{kind}"><parent link="{before}"/><child link="{name}_link"/>'
        f'<origin xyz="{origin}"/><axis xyz="{axis}"/>{more}'
        '<limit lower="-2" upper="2" velocity="1" effort="1"/></joint>'
        for before, (name, kind, axis, origin, more) in zip(links, JOINTS, strict=False)
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mixed.urdf"
        path.write_text(f'<robot name="mixed">{"".join(parts)}</robot>', encoding="utf-8")
        return robot_from_urdf(path)


def postures(robot: Robot, count: int, seed: int = 0) -> list[Array]:
    """Random postures within the limits."""
    draws = np.random.default_rng(seed).uniform(robot.lower, robot.upper, (count, robot.lower.size))
    return [frozen(q) for q in draws]


def frame_by_screws(robot: Robot, q: Array, frame: Frame) -> Array:
    """Pose of a frame of a link by displacing where it is at q = 0: the road of `forward.tool_by_screws`."""
    T = frame.T_link_frame.copy()
    T[:3, 3] += robot.points[frame.link - 1] if frame.link else 0.0
    return np.asarray(screw_displacements(robot, q)[frame.link] @ T)


def derivative(function: Callable[[Array], Array], q: Array, step: float = 1e-3) -> Array:
    """Central differences of a function of q, extrapolated to an error of fourth order; q runs along the last axis."""
    columns = []
    for way in step * np.eye(q.size):
        near, far = ((function(q + k * way) - function(q - k * way)) / (2 * k * step) for k in (1, 2))
        columns.append((4 * near - far) / 3)
    return np.stack(columns, axis=-1)


def twist_by_differences(pose: Callable[[Array], Array], q: Array) -> Array:
    """The geometric Jacobian of a pose by differences: ω is the antisymmetric part of (dR) Rᵀ."""
    rate, R = derivative(pose, q), pose(q)[:3, :3]
    spin = np.einsum("ijk,lj->ilk", rate[:3, :3], R)
    return np.concatenate([rate[:3, 3], (spin[[2, 0, 1], [1, 2, 0]] - spin[[1, 2, 0], [2, 0, 1]]) / 2])
