"""The Jacobians of an arm: of the tool, of any frame or point, in the base frame or in the frame of the body."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import Frame


def frame_pose(robot: Robot, q: ArrayLike, frame: Frame | None = None) -> Array:
    """Pose of a frame of a link, T_world_frame = T_world_link T_link_frame; by default that of the tool.

    Args: q (n,), rad or m. Returns (4, 4), m. Raises HelicoideError for a wrong q.
    """
    carried = frame or robot.frames["tool"]
    return np.asarray(link_poses(robot.chain, robot.check_joints(q))[carried.link] @ carried.T_link_frame)


def point_jacobian(robot: Robot, q: ArrayLike, point_link: ArrayLike, link: int) -> Array:
    """Geometric Jacobian of a point of a link: column i is [sᵢ × (p − pᵢ); sᵢ], or [sᵢ; 0] where joint i slides.

    Args: q (n,), rad or m; point_link (3,), m, in the frame of the link; link: its number, 0 for the base.
    Returns J_world (6, n), rows vx vy vz ωx ωy ωz. Raises HelicoideError for a wrong q.
    Source: Vargas 2013, eqs. 2.16–2.21; Cerbaro 2022, eq. 67.
    """
    poses = link_poses(robot.chain, robot.check_joints(q))
    point_world = poses[link, :3, :3] @ np.asarray(point_link, dtype=np.float64) + poses[link, :3, 3]
    return jacobian.geometric_jacobian(poses, robot.chain, jacobian.joint_axes(poses, robot.chain), point_world, link)


def frame_jacobian(robot: Robot, q: ArrayLike, frame: Frame | None = None) -> Array:
    """Geometric Jacobian of a frame, by default the tool: V_world = [v; ω] = J q̇, v the velocity of its origin.

    Args: q (n,), rad or m. Returns J_world (6, n), rows vx vy vz ωx ωy ωz; its first three are the position part.
    Raises HelicoideError for a wrong q. Source: Vargas 2013, eqs. 2.16–2.21; Cerbaro 2022, eq. 67.
    """
    carried = frame or robot.frames["tool"]
    return point_jacobian(robot, q, carried.T_link_frame[:3, 3], carried.link)


def body_jacobian(robot: Robot, q: ArrayLike, frame: Frame | None = None) -> Array:
    """Geometric Jacobian in the axes of the frame itself: J_body = diag(Rᵀ, Rᵀ) J_world.

    Args: q (n,), rad or m. Returns J_frame (6, n), rows vx vy vz ωx ωy ωz. Raises HelicoideError for a wrong q.
    Source: Coutinho 2015, eqs. 2.42–2.54, 3.12.
    """
    R_frame_world = frame_pose(robot, q, frame)[:3, :3].T
    return rotated_twist(R_frame_world, frame_jacobian(robot, q, frame))


def adjoint(T_a_b: Array) -> Array:
    """Adjoint of a pose: V_a = Ad V_b, Ad = [[R, [p]ₓ R], [0, R]], V at the origin of its frame, along its axes.

    Args: T_a_b (4, 4), m. Returns (6, 6), for twists (v, ω). Source: Coutinho 2015, eqs. 2.43–2.45.
    """
    R, p = T_a_b[:3, :3], T_a_b[:3, 3]
    return np.block([[R, rotation.skew(p) @ R], [np.zeros((3, 3)), R]])


def rotated_twist(R_a_b: Array, J: Array) -> Array:
    """A Jacobian, or a twist, expressed in other axes: [v; ω]_a = diag(R_a_b, R_a_b) [v; ω]_b, at the same point.

    Args: R_a_b (3, 3); J (6, ...). Returns (6, ...). Source: Coutinho 2015, eq. 2.43 with p = 0.
    """
    return np.concatenate([R_a_b @ J[:3], R_a_b @ J[3:]])
