"""Kernels for the geometric Jacobian of a point on any link, in the world frame, which is that of the base."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Chain


@kernel
def joint_axes(poses: Array, chain: Chain) -> Array:
    """Joint axes in the current posture: aᵢ = Rᵢ sᵢ, where sᵢ is the axis of joint i at q = 0.

    Args: poses (m + 1, 4, 4) of `forward.link_poses`; chain (m,) of `chain.CHAIN`. Returns unit vectors (m, 3), world.
    """
    m = chain.shape[0]
    axes = np.empty((m, 3))
    for i in range(m):
        direction = chain[i]["direction"]
        for a in range(3):
            axes[i, a] = (
                poses[i + 1, a, 0] * direction[0]
                + poses[i + 1, a, 1] * direction[1]
                + poses[i + 1, a, 2] * direction[2]
            )
    return axes


@kernel
def variable_count(chain: Chain) -> int:
    """The number n of joint variables of a chain. Mimic joints have no variable of their own."""
    n = 0
    for i in range(chain.shape[0]):
        n = max(n, chain[i]["driver"] + 1)
    return n


@kernel
def geometric_jacobian(poses: Array, chain: Chain, axes: Array, point: Array, link: int) -> Array:
    """Geometric Jacobian of a point on a link: column i is [aᵢ × (p − pᵢ); aᵢ], or [aᵢ; 0] if joint i is prismatic.

    p is the point, pᵢ a point on the axis aᵢ. Columns of joints after the link are zero. A mimic joint follows another
    joint with a fixed ratio: its column times this ratio is added to the column of that joint.
    Args: poses (m + 1, 4, 4), m; chain (m,); axes (m, 3) of `joint_axes`; point (3,), m, world; link: number of the
    link with the point, 0 for the base. Returns J_world (6, n), rows vx vy vz ωx ωy ωz.
    Source: Cerbaro 2022, eq. 67; Vargas 2013, 2.16–2.21.
    """
    jacobian = np.zeros((6, variable_count(chain)))
    for i in range(link):
        joint = chain[i]
        column, ratio = joint["driver"], joint["ratio"]
        x, y, z = ratio * axes[i, 0], ratio * axes[i, 1], ratio * axes[i, 2]
        if joint["slides"]:
            jacobian[0, column] += x
            jacobian[1, column] += y
            jacobian[2, column] += z
            continue
        rx, ry, rz = point[0] - poses[i + 1, 0, 3], point[1] - poses[i + 1, 1, 3], point[2] - poses[i + 1, 2, 3]
        jacobian[0, column] += y * rz - z * ry
        jacobian[1, column] += z * rx - x * rz
        jacobian[2, column] += x * ry - y * rx
        jacobian[3, column] += x
        jacobian[4, column] += y
        jacobian[5, column] += z
    return jacobian
