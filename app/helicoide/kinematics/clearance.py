"""How far points and lines of an arm are from a plane n·r = d, and the rows that say how this changes with q."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from helicoide.kinematics.chain import Array
from helicoide.kinematics.differential import point_jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot

# Below this cosine a line counts as upright on the plane.
UPRIGHT = 1e-12


@dataclass(frozen=True, eq=False)
class Clearance:
    """A signed distance l, m, positive on the side of the normal, and its row: l̇ = row q̇, (n,)."""

    distance: float
    row: Array


@dataclass(frozen=True, eq=False)
class LineClearance:
    """A piece of line against a plane: of its nearer end, and its angle φ, rad, positive where it leaves the plane.

    end: 0 or 1, the nearer end, 0 where both are equally far; angle_row: φ̇ = angle_row q̇, (n,), zero where the line is
    upright on the plane: there the angle is at its largest and has no derivative.
    """

    end: int
    nearer: Clearance
    angle: float
    angle_row: Array


def point_plane(
    robot: Robot, q: ArrayLike, point_link: ArrayLike, link: int, normal: ArrayLike, offset: float
) -> Clearance:
    """Distance of a point of a link from a plane: l = n·p − d, l̇ = nᵀ J_p q̇.

    Args: q (n,), rad or m; point_link (3,), m, in the frame of the link; link: its number, 0 for the base; normal (3,),
    unit, world; offset, m. Raises HelicoideError for a wrong q. Source: Cerbaro 2022, eqs. 19–20, and its derivative.
    """
    n, T = np.asarray(normal, dtype=np.float64), link_poses(robot.chain, robot.check_joints(q))[link]
    point_world = T[:3, :3] @ np.asarray(point_link, dtype=np.float64) + T[:3, 3]
    row = n @ point_jacobian(robot, q, point_link, link)[:3]
    return Clearance(float(n @ point_world) - offset, row)


def line_plane(
    robot: Robot, q: ArrayLike, ends_link: ArrayLike, link: int, normal: ArrayLike, offset: float
) -> LineClearance:
    """A straight piece of a link, such as its axis, against a plane: l = min(n·p₀, n·p₁) − d, sin φ = n·v.

    The distance is affine along the piece, so the nearer end has the least; it changes by `point_plane`, and
    φ̇ = (v × n/‖v × n‖)ᵀ J_ω q̇, v from the first end to the second.
    Args: q (n,), rad or m; ends_link (2, 3), m, in the frame of the link; normal (3,), unit, world; offset, m.
    Raises HelicoideError for a wrong q. Source: Cerbaro 2022, eqs. 17–20 and §5.2, and their derivatives.
    """
    ends, n = np.asarray(ends_link, dtype=np.float64), np.asarray(normal, dtype=np.float64)
    first, second = (point_plane(robot, q, end, link, n, offset) for end in ends)
    R_world_link = link_poses(robot.chain, robot.check_joints(q))[link, :3, :3]
    v = R_world_link @ (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    across = np.cross(v, n)
    cosine = float(np.linalg.norm(across))
    tilt = across / cosine if cosine > UPRIGHT else np.zeros(3)
    end = int(second.distance < first.distance)
    return LineClearance(
        end=end,
        nearer=(first, second)[end],
        angle=float(np.arctan2(n @ v, cosine)),
        angle_row=tilt @ point_jacobian(robot, q, ends[0], link)[3:],
    )
