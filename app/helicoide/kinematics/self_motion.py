"""Self-motion: joint motions that leave the tool where it is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.generic_rank import in_reaches
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot

# A joint whose share of the null space is smaller does not move by itself; singular values below the second fraction of
# the largest count as zero: near a singularity the null space would jump.
SHARE, SMALL = 1e-6, 1e-6

Rows = NDArray[np.bool_]


def freest_joint(robot: Robot, q: Array, rows: Rows) -> int | None:
    """The joint variable that moves most in the null space of these rows (6,) of J; None if the null space is empty."""
    shares = np.diag(analyse_jacobian(in_reaches(robot, frame_jacobian(robot, q))[rows]).null_projector)
    return int(shares.argmax()) if shares.max(initial=0.0) > SHARE else None


def self_motion_step(robot: Robot, q: Array, T_world_tool: Array, rows: Rows, joint: int, step: float) -> Array:
    """Joint values one step along a self-motion: q + ε N Nᵀ eⱼ/|N Nᵀ eⱼ|, then q + J† e, which keeps the tool in place.

    Args: q (n,), rad or m; T_world_tool (4, 4), m: the pose that is kept, in these rows (6,) of the tool's twist;
    joint: j, whose own motion is followed; step ε, rad, for a prismatic joint in reaches. Returns (n,).
    """
    units = np.array([robot.reach if variable.is_prismatic else 1.0 for variable in robot.variables])
    way = analyse_jacobian(in_reaches(robot, frame_jacobian(robot, q))[rows]).null_projector[joint]
    moved = q + units * way * (step / max(float(np.linalg.norm(way)), SHARE))
    here = link_poses(robot.chain, moved)[-1] @ robot.T_link_tool
    turn = rotation.logarithm(T_world_tool[:3, :3] @ here[:3, :3].T)
    error = np.concatenate([(T_world_tool[:3, 3] - here[:3, 3]) / robot.reach, turn])[rows]
    J = in_reaches(robot, frame_jacobian(robot, moved))[rows]
    return np.asarray(moved + units * (np.linalg.pinv(J, rcond=SMALL) @ error))
