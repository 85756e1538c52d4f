"""Points of an arm that objectives use, with their Jacobians: the tool, the monitored points, points along the links.

A link is here the straight segment between two consecutive corners. The corners are the joint origins, for a prismatic
joint before and after its slide, and the tool point.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem
from helicoide.ik.method import OneOf, Quantity
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.text import Text, untranslated

# Settings of the objectives that use points of the arm.
WATCHED = OneOf(
    Text(en="points considered", pt_BR="pontos considerados"),
    {
        "tool": Text(en="end effector", pt_BR="efetuador"),
        "guarded": Text(en="monitored points", pt_BR="pontos monitorados"),
        "links": Text(en="points along the links", pt_BR="pontos ao longo dos elos"),
    },
)
PER_LINK = Quantity(Text(en="points per link", pt_BR="pontos por elo"), 1, 40)
# Corners closer than this, m, coincide.
MEETING = 1e-9


@dataclass(frozen=True, eq=False)
class ArmPoints:
    """k points of an arm, p = W c: linear combinations of corners c fixed to its links.

    corners (c, 3), m, each in the frame of its link; links (c,): the link numbers; weights: W (k, c).
    """

    corners: Array
    links: tuple[int, ...]
    weights: Array

    def at(self, poses: Array) -> Array:
        """The points (k, 3), m, base frame. Args: poses (m + 1, 4, 4) of `forward.link_poses`."""
        return np.asarray(self.weights @ self._corners(poses))

    def moving(self, problem: Problem, poses: Array) -> tuple[Array, Array]:
        """The points p (k, 3) and their J (k, 3, n), ṗ = J q̇, both with lengths divided by ℓ (see `method.Task`)."""
        chain, corners = problem.robot.chain, self._corners(poses)
        axes = jacobian.joint_axes(poses, chain)
        moving = zip(corners, self.links, strict=True)
        rows = np.array([jacobian.geometric_jacobian(poses, chain, axes, c, i)[:3] for c, i in moving])
        J = (self.weights @ rows.reshape(len(rows), -1)).reshape(-1, *rows.shape[1:])
        return self.weights @ corners / problem.length, J * problem.joint_units / problem.length

    def _corners(self, poses: Array) -> Array:
        T = poses[list(self.links)]
        return np.asarray(np.einsum("cab,cb->ca", T[:, :3, :3], self.corners) + T[:, :3, 3])


def tool(robot: Robot) -> ArmPoints:
    """The tool alone."""
    return ArmPoints(robot.T_link_tool[None, :3, 3], (len(robot.joints),), np.ones((1, 1)))


def guarded(robot: Robot) -> ArmPoints:
    """The monitored points of the robot."""
    links = tuple(robot.monitored_links.tolist())
    return ArmPoints(robot.monitored_points, links, np.eye(len(links)))


def _line(robot: Robot) -> ArmPoints:
    """The corners in order, from the first joint to the tool."""
    corners, links = [], []
    for i, joint in enumerate(robot.joints):
        corners.append(robot.chain[i]["offset"])
        links.append(i)
        if joint.is_prismatic:
            corners.append(np.zeros(3))
            links.append(i + 1)
    corners.append(robot.T_link_tool[:3, 3])
    return ArmPoints(frozen(corners), (*links, len(robot.joints)), np.eye(len(corners)))


def along_links(robot: Robot, per_link: int) -> ArmPoints:
    """k = `per_link` evenly spaced points on each link, the last at its far end: p = c + (j/k) (c' − c), j = 1 … k.

    Corners that coincide at the lower and the upper joint limits, as in a spherical wrist, have no link between them.
    """
    line = _line(robot)
    extremes = np.array([line.at(link_poses(robot.chain, q)) for q in (robot.lower, robot.upper)])
    apart = np.linalg.norm(np.diff(extremes, axis=1), axis=2).max(axis=0) > MEETING
    start, end = line.weights[:-1][apart], line.weights[1:][apart]
    share = np.arange(1, per_link + 1)[:, None] / per_link
    weights = np.concatenate([a + share * (b - a) for a, b in zip(start, end, strict=True)])
    return ArmPoints(line.corners, line.links, weights)


def coordinate(axis: str) -> Quantity:
    """A setting that is a coordinate of a point in the base frame."""
    return Quantity(untranslated(axis), -1.5, 1.5, "mm", lengths=1)


@lru_cache(maxsize=64)
def watched(robot: Robot, where: str, per_link: int = 1) -> ArmPoints:
    """The points of one choice of `WATCHED`; `per_link` is used only for those along the links."""
    match where:
        case "tool":
            return tool(robot)
        case "guarded":
            return guarded(robot)
        case _:
            return along_links(robot, per_link)
