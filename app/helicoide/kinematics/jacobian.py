"""Jacobians of the tool and of points on any link, in the base frame."""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics.robot import Array


@kernel
def joint_axes(poses: Array, directions: Array) -> Array:
    """Joint axes where the arm stands: sᵢ' = Rᵢ sᵢ.

    Args: poses (n + 1, 4, 4) of `forward.link_poses`; directions (n, 3), unit, at q = 0. Returns (n, 3), world.
    """
    n = directions.shape[0]
    axes = np.empty((n, 3))
    for i in range(n):
        for a in range(3):
            axes[i, a] = (
                poses[i + 1, a, 0] * directions[i, 0]
                + poses[i + 1, a, 1] * directions[i, 1]
                + poses[i + 1, a, 2] * directions[i, 2]
            )
    return axes


@kernel
def geometric(poses: Array, axes: Array, point: Array, link: int) -> Array:
    """Geometric Jacobian of a point on a link: column i is [sᵢ × (p − pᵢ); sᵢ], zero beyond the link.

    Args: poses (n + 1, 4, 4); axes (n, 3) of `joint_axes`; point (3,), m; link: number of the link that carries it.
    Returns J_world (6, n), rows vx vy vz ωx ωy ωz, m/rad and 1. Source: Cerbaro 2022, eq. 67.
    """
    jacobian = np.zeros((6, axes.shape[0]))
    for i in range(link):
        x, y, z = axes[i, 0], axes[i, 1], axes[i, 2]
        rx, ry, rz = point[0] - poses[i + 1, 0, 3], point[1] - poses[i + 1, 1, 3], point[2] - poses[i + 1, 2, 3]
        jacobian[0, i] = y * rz - z * ry
        jacobian[1, i] = z * rx - x * rz
        jacobian[2, i] = x * ry - y * rx
        jacobian[3, i], jacobian[4, i], jacobian[5, i] = x, y, z
    return jacobian
