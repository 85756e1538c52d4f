"""Forward kinematics: three independent roads to the tool for people and tests, and the kernel that the loop runs.

The roads share nothing but linear algebra, so that their agreement says something about each robot's file.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.kernels import kernel
from helicoide.kinematics.robot import Array, DhRow, Robot


def dh_transform(row: DhRow, angle: float) -> Array:
    """Pose of a DH frame in the one before it: A = Rz(θ) Tz(d) Tx(a) Rx(α), θ = row.theta + angle.

    Args: angle: joint angle, rad. Returns (4, 4), m. Source: Cerbaro 2022, eq. 57.
    """
    c, s = np.cos(row.theta + angle), np.sin(row.theta + angle)
    ca, sa = np.cos(row.alpha), np.sin(row.alpha)
    return np.array(
        [
            [c, -s * ca, s * sa, row.a * c],
            [s, c * ca, -c * sa, row.a * s],
            [0.0, sa, ca, row.d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def tool_by_dh(robot: Robot, q: Array) -> Array:
    """Tool pose from the DH rows: T = A₁ A₂ … Aₙ · T_dh_tool.

    Args: q (n,), rad. Returns T_world_tool (4, 4), m. Source: Cerbaro 2022, eq. 59, tab. 6 (d₁ = 400 mm).
    """
    pose = np.eye(4)
    for joint, angle in zip(robot.joints, q, strict=True):
        pose = pose @ dh_transform(joint.dh, angle)
    pose[:3, :3] = pose[:3, :3] @ robot.R_dh_tool
    return pose


def screw_transform(direction: Array, point: Array, angle: float) -> Array:
    """Displacement by a rotation about a fixed axis: R = I + sinθ [s]ₓ + (1 − cosθ) [s]ₓ², d = (I − R) s₀.

    Args: direction (3,), unit; point (3,), m, on the axis; angle, rad; all in the base frame. Returns (4, 4).
    Source: Cerbaro 2022, eqs. 61–62 (signs corrected).
    """
    x, y, z = direction
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    displacement = np.eye(4)
    displacement[:3, :3] = rotation
    displacement[:3, 3] = point - rotation @ point
    return displacement


def tool_by_screws(robot: Robot, q: Array) -> Array:
    """Tool pose from successive screws: T = H₁ H₂ … Hₙ T₀.

    Args: q (n,), rad. Returns T_world_tool (4, 4), m. Source: Cerbaro 2022, App. D, tab. 8.
    """
    displacement = np.eye(4)
    for joint, angle in zip(robot.joints, q, strict=True):
        displacement = displacement @ screw_transform(joint.direction, joint.point, angle)
    return displacement @ robot.T_world_tool_0


def tool_motor(robot: Robot, q: Array) -> Array:
    """Tool pose as a motor of Cl(0,3,1): M = m₁ m₂ … mₙ M₀, mᵢ = exp(θᵢ Lᵢ / 2) (even part: dual quaternions).

    Args: q (n,), rad. Returns M_world_tool (16,), m. Source: Cerbaro 2022, §5.1 (order and product corrected).
    """
    motor = CL031.blade("1")
    for joint, angle in zip(robot.joints, q, strict=True):
        motor = CL031.product(motor, rigid.screw_motor(joint.direction, joint.point, angle))
    return CL031.product(motor, rigid.motor_from_pose(robot.T_world_tool_0))


def tool_by_dual_quaternions(robot: Robot, q: Array) -> Array:
    """The pose that `tool_motor` stands for: T_world_tool (4, 4), m, from q (n,), rad."""
    return rigid.pose_from_motor(tool_motor(robot, q))


ROADS = {"dh": tool_by_dh, "screws": tool_by_screws, "dual_quaternions": tool_by_dual_quaternions}


@kernel
def link_poses(directions: Array, points: Array, q: Array) -> Array:
    """Poses of the base and all links: R ← R Rot(sᵢ, θᵢ), p ← p + R (s₀ᵢ − s₀ᵢ₋₁).

    Args: directions (n, 3) unit and points (n, 3) m of the joint axes at q = 0, base frame; q (n,), rad.
    Returns Ts_world_link (n + 1, 4, 4); link 0 is the base, link i sits at the point of joint i.
    """
    n = q.shape[0]
    poses = np.zeros((n + 1, 4, 4))
    for i in range(n + 1):
        poses[i, 3, 3] = 1.0
    for a in range(3):
        poses[0, a, a] = 1.0
    for i in range(n):
        x, y, z = directions[i, 0], directions[i, 1], directions[i, 2]
        s, c = np.sin(q[i]), np.cos(q[i])
        v = 1.0 - c
        r00, r01, r02 = c + x * x * v, x * y * v - z * s, x * z * v + y * s
        r10, r11, r12 = y * x * v + z * s, c + y * y * v, y * z * v - x * s
        r20, r21, r22 = z * x * v - y * s, z * y * v + x * s, c + z * z * v
        before, here = poses[i], poses[i + 1]
        ox, oy, oz = points[i, 0], points[i, 1], points[i, 2]
        if i > 0:
            ox, oy, oz = ox - points[i - 1, 0], oy - points[i - 1, 1], oz - points[i - 1, 2]
        for a in range(3):
            b0, b1, b2 = before[a, 0], before[a, 1], before[a, 2]
            here[a, 0] = b0 * r00 + b1 * r10 + b2 * r20
            here[a, 1] = b0 * r01 + b1 * r11 + b2 * r21
            here[a, 2] = b0 * r02 + b1 * r12 + b2 * r22
            here[a, 3] = before[a, 3] + b0 * ox + b1 * oy + b2 * oz
    return poses


@kernel
def carried_points(poses: Array, points: Array, links: NDArray[np.int64]) -> Array:
    """World coordinates of points on links: p' = R p + T.

    Args: poses (n + 1, 4, 4) of `link_poses`; points (m, 3), m, each in the frame of its link; links (m,): number of
    the link that carries each, 0 for the base. Returns (m, 3), m.
    """
    moved = np.empty_like(points)
    for j in range(points.shape[0]):
        pose = poses[links[j]]
        for a in range(3):
            moved[j, a] = pose[a, 0] * points[j, 0] + pose[a, 1] * points[j, 1] + pose[a, 2] * points[j, 2] + pose[a, 3]
    return moved
