"""A posture for a tool pose with its name, and functions that check poses, wrap angles and join sentences."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy import empty
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.ik.task import rotation_error
from helicoide.kernels import kernel_into
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

ORTHONORMAL = 1e-6  # the tolerance of RᵀR = I


@dataclass(frozen=True, eq=False)
class Branch:
    """One posture: its name, q (n,), rad or m, and its errors: missed, m, and turned, rad.

    The errors are against the asked pose, also where another one was solved for. within: whether every joint is within
    its limits.
    """

    name: Text
    q: Array
    missed: float
    turned: float
    within: bool


def wrap(angle: ArrayLike) -> Array:
    """The same angle in (−π, π]: π − ((π − θ) mod 2π), (...), rad."""
    wrapped = np.pi - np.mod(np.pi - np.asarray(angle, dtype=np.float64), 2 * np.pi)
    return np.where(wrapped > -np.pi, wrapped, np.pi)  # rounding may bring the remainder to 2π


def tool_at(robot: Robot, q: Array) -> Array:
    """T_world_tool (4, 4), m, at joint values (n,), rad or m."""
    return np.asarray(link_poses(robot.chain, q)[-1] @ robot.T_link_tool)


def between(T_world_a: Array, T_world_b: Array) -> tuple[float, float]:
    """From one pose (4, 4), m, to another: the distance of their origins, m, and the angle of R_b R_aᵀ, rad."""
    turn = rotation_error(T_world_b[:3, :3].copy(), T_world_a[:3, :3].copy())
    return float(np.linalg.norm(T_world_b[:3, 3] - T_world_a[:3, 3])), float(np.linalg.norm(turn))


def sentences(*parts: Text | None) -> Text:
    """Several sentences as one text; None is skipped."""
    said = [part for part in parts if part is not None]
    return Text(en=" ".join(part.en for part in said), pt_BR=" ".join(part.pt_BR for part in said))


def check_pose(T: ArrayLike) -> Array:
    """A pose as a read-only array (4, 4), m; raises HelicoideError unless it is a finite rotation and translation."""
    pose = pose_of(T)
    pose.setflags(write=False)
    return pose


def pose_of(T: ArrayLike) -> Array:
    """`check_pose` as a copy that may be written."""
    given, pose = np.ascontiguousarray(T, dtype=np.float64), empty((4, 4))
    if given.shape != (4, 4) or not taken(given, pose):
        raise HelicoideError(
            Text(
                en="A goal is a 4 × 4 pose of finite numbers: a rotation, a position, and the last row 0, 0, 0, 1.",
                pt_BR="Um alvo é uma pose 4 × 4 de números finitos: rotação, posição e a última linha 0, 0, 0, 1.",
            )
        )
    return pose


@kernel_into
def taken(T: Array, pose: Array) -> bool:
    """Write a copy of T (4, 4), m, and say whether it is a pose.

    RᵀR = I up to `ORTHONORMAL`, det R > 0, the position (3,) is finite, and the last row is 0, 0, 0, 1.
    """
    for i in range(4):
        for j in range(4):
            pose[i, j] = T[i, j]
    for i in range(3):
        for j in range(i, 3):
            product = T[0, i] * T[0, j] + T[1, i] * T[1, j] + T[2, i] * T[2, j]
            if not abs(product - (1.0 if i == j else 0.0)) < ORTHONORMAL:
                return False
    volume = T[0, 0] * (T[1, 1] * T[2, 2] - T[1, 2] * T[2, 1])
    volume += T[0, 1] * (T[1, 2] * T[2, 0] - T[1, 0] * T[2, 2])
    volume += T[0, 2] * (T[1, 0] * T[2, 1] - T[1, 1] * T[2, 0])
    at_rest = T[3, 0] == 0.0 and T[3, 1] == 0.0 and T[3, 2] == 0.0 and T[3, 3] == 1.0
    return volume > 0.0 and at_rest and bool(np.isfinite(T[0, 3] + T[1, 3] + T[2, 3]))
