"""The postures for one tool pose, each with its name, and what is said where there are none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from helicoide.ik.postures.measure import left
from helicoide.ik.task import rotation_vector
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

# What rounding may add to a joint that rests on its limit, rad or m, and what may miss of a rotation matrix.
ON_LIMIT, ORTHONORMAL = 1e-9, 1e-6


@dataclass(frozen=True, eq=False)
class Branch:
    """One posture: its name, q (n,), rad or m, and what its tool leaves of the goal: missed, m, and turned, rad.

    The goal is the one that was asked for, whatever was solved for in its place. within: whether every joint keeps its
    limits.
    """

    name: Text
    q: Array
    missed: float
    turned: float
    within: bool


@dataclass(frozen=True, eq=False)
class Answer:
    """Every posture for a goal.

    T_world_goal (4, 4), m: what was solved for, the asked pose or, for an arm that cannot take every pose, the nearest
    one of its subspace; moved, m, and turned, rad: from the one to the other; left: what the first branch leaves of
    what was solved for, m and rad. short: how far the goal lies beyond the edge of the workspace, m, 0 inside. free:
    joints that may take any value here (the current one was kept). words: what is to be said. values: what the form
    worked out on the way, by symbol, for one branch after another; once, where there is no branch.
    """

    branches: tuple[Branch, ...]
    T_world_goal: Array
    words: Text
    moved: float = 0.0
    turned: float = 0.0
    short: float = 0.0
    free: tuple[int, ...] = ()
    values: tuple[Mapping[str, float], ...] = field(default=(MappingProxyType({}),))
    left: tuple[float, float] | None = None


class Form(Protocol):
    """A module of `ik/closed/`: a closed form for a family of arms. EQUATIONS: its steps, in TeX, in order.

    RANK: of several that apply to an arm the lowest is chosen: 0 for the form of one arm, 1 for that of every arm with
    a spherical wrist, then the families of methods, which solve again what these solve. OF_POINTS: whether its goals
    are points.
    """

    TITLE: Text
    SOURCE: str
    RANK: int
    OF_POINTS: bool
    EQUATIONS: tuple[str, ...]

    def applies(self, robot: Robot) -> Text | None:
        """Why the form does not apply to a robot; None where it does."""

    def solve(self, robot: Robot, T_world_tool: Array, q: Array) -> Answer:
        """Every posture for a tool pose (4, 4), m; q (n,), rad or m: kept where a joint is free."""


def branch_of(robot: Robot, name: Text, q: ArrayLike, T_world_goal: Array, with_orientation: bool = True) -> Branch:
    """The branch of joint values (n,), rad or m, with what its tool leaves of the goal (4, 4), m, that was asked for.

    Angles are wrapped into (−π, π], and moved by whole turns into the joint's limits where that is possible.
    Raises HelicoideError unless there are n finite values.
    """
    turned = turned_into_limits(robot, robot.check_joints(q))
    missed, angle = left(robot, turned, T_world_goal, with_orientation)
    within = bool(np.all((turned >= robot.lower - ON_LIMIT) & (turned <= robot.upper + ON_LIMIT)))
    return Branch(name, turned, missed, angle, within)


def turned_into_limits(robot: Robot, q: Array) -> Array:
    """q (n,) with angles in (−π, π], or 2πk away where only that lies within the joint's limits; slides as they are."""
    wrapped = np.where(robot.turns_whole, wrap(q), q)
    turns = np.ceil((robot.lower - ON_LIMIT - wrapped) / (2 * np.pi)).clip(min=0)
    turns += np.floor((robot.upper + ON_LIMIT - wrapped) / (2 * np.pi)).clip(max=0)
    moved = wrapped + 2 * np.pi * turns
    fits = (moved >= robot.lower - ON_LIMIT) & (moved <= robot.upper + ON_LIMIT)
    return frozen(np.where(fits & robot.turns_whole, moved, wrapped))


def wrap(angle: ArrayLike) -> Array:
    """The same angle in (−π, π]: π − ((π − θ) mod 2π), (...), rad."""
    wrapped = np.pi - np.mod(np.pi - np.asarray(angle, dtype=np.float64), 2 * np.pi)
    return np.where(wrapped > -np.pi, wrapped, np.pi)  # rounding may bring the remainder to 2π


def tool_at(robot: Robot, q: Array) -> Array:
    """T_world_tool (4, 4), m, at joint values (n,), rad or m."""
    return np.asarray(link_poses(robot.chain, q)[-1] @ robot.T_link_tool)


def between(T_world_a: Array, T_world_b: Array) -> tuple[float, float]:
    """From one pose (4, 4), m, to another: the distance of their origins, m, and the angle of R_b R_aᵀ, rad."""
    turn = rotation_vector(T_world_b[:3, :3].copy(), T_world_a[:3, :3].copy())
    return float(np.linalg.norm(T_world_b[:3, 3] - T_world_a[:3, 3])), float(np.linalg.norm(turn))


def sentences(*parts: Text | None) -> Text:
    """Several sentences as one text; None is left out."""
    said = [part for part in parts if part is not None]
    return Text(en=" ".join(part.en for part in said), pt_BR=" ".join(part.pt_BR for part in said))


def check_pose(T: ArrayLike) -> Array:
    """A pose as a read-only array (4, 4), m; raises HelicoideError unless it is a finite rotation and translation."""
    pose = np.asarray(T, dtype=np.float64)
    if pose.shape != (4, 4) or not np.isfinite(pose).all() or not _is_rigid(pose):
        raise HelicoideError(
            Text(
                en="A goal is a 4 × 4 pose of finite numbers: a rotation, a position, and the last row 0, 0, 0, 1.",
                pt_BR="Um alvo é uma pose 4 × 4 de números finitos: rotação, posição e a última linha 0, 0, 0, 1.",
            )
        )
    return frozen(pose)


def _is_rigid(pose: Array) -> bool:
    R = pose[:3, :3]
    is_orthonormal = np.abs(R.T @ R - np.eye(3)).max() < ORTHONORMAL
    return bool(is_orthonormal and np.linalg.det(R) > 0 and (pose[3] == [0, 0, 0, 1]).all())
