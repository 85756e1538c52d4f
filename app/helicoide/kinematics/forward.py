"""Forward kinematics: three independent formulations for people and tests, and the kernels of the control loop.

The formulations share nothing but linear algebra, so their agreement checks each robot's file. Each also gives its
partial results: the DH frames, the displacement of every link by screws, and the same displacements as motors.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.kernels import kernel
from helicoide.kinematics import dh
from helicoide.kinematics.chain import Chain, Joint, joint_positions
from helicoide.kinematics.robot import Robot


def dh_frames(robot: Robot, q: Array) -> list[Array]:
    """Poses of the DH frames: T₀ A₁ … Aᵢ, i = 0 to m, each (4, 4), m.

    Args: q (n,), rad or m. Source: Cerbaro 2022, eq. 59; Campos 1998, s.40 (modified rows).
    """
    return dh.dh_poses(robot.dh, robot.joints, joint_positions(robot.chain, q))


def tool_by_dh(robot: Robot, q: Array) -> Array:
    """Tool pose from the DH rows: T = T₀ A₁ A₂ … Aₘ · T_dh_tool.

    Args: q (n,), rad or m. Returns T_world_tool (4, 4), m. Source: Cerbaro 2022, eq. 59, tab. 6 (d₁ = 400 mm).
    """
    return np.asarray(dh_frames(robot, q)[-1] @ robot.dh.T_dh_tool)


def screw_transform(joint: Joint, value: float) -> Array:
    """Displacement by a joint: R = I + sinθ [s]ₓ + (1 − cosθ) [s]ₓ², d = (I − R) s₀; a prismatic joint has d = x s.

    Args: value: θ, rad, or x, m. Returns (4, 4), base frame. Source: Cerbaro 2022, eqs. 61–62 (signs corrected).
    """
    displacement = np.eye(4)
    if joint.is_prismatic:
        displacement[:3, 3] = value * joint.direction
        return displacement
    x, y, z = joint.direction
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + np.sin(value) * cross + (1 - np.cos(value)) * cross @ cross
    displacement[:3, :3] = rotation
    displacement[:3, 3] = joint.point - rotation @ joint.point
    return displacement


def screw_displacements(robot: Robot, q: Array) -> list[Array]:
    """Displacements of the links from their poses at q = 0: H₁ … Hᵢ, i = 0 to m, each (4, 4), base frame, m.

    Args: q (n,), rad or m. Source: Cerbaro 2022, App. D.
    """
    displacements = [np.eye(4)]
    for joint, value in zip(robot.joints, joint_positions(robot.chain, q), strict=True):
        displacements.append(displacements[-1] @ screw_transform(joint, value))
    return displacements


def tool_by_screws(robot: Robot, q: Array) -> Array:
    """Tool pose from successive screws: T = H₁ H₂ … Hₘ T₀.

    Args: q (n,), rad or m. Returns T_world_tool (4, 4), m. Source: Cerbaro 2022, App. D, tab. 8.
    """
    return np.asarray(screw_displacements(robot, q)[-1] @ robot.T_world_tool_0)


def joint_motor(joint: Joint, value: float) -> Array:
    """Displacement by a joint as a motor of Cl(0,3,1): exp(θL/2); of a prismatic joint the translator 1 + ½ x s e.

    Args: value: θ, rad, or x, m. Returns (16,). Source: Cerbaro 2022, eqs. 96–99.
    """
    if joint.is_prismatic:
        return rigid.translator(value * joint.direction)
    return rigid.screw_motor(joint.direction, joint.point, value)


def link_motors(robot: Robot, q: Array) -> list[Array]:
    """Displacements of the links from their poses at q = 0 as motors: m₁ … mᵢ, i = 0 to m, each (16,), m.

    Args: q (n,), rad or m. Source: Cerbaro 2022, §5.1 (order and product corrected).
    """
    motors = [CL031.blade("1")]
    for joint, value in zip(robot.joints, joint_positions(robot.chain, q), strict=True):
        motors.append(CL031.product(motors[-1], joint_motor(joint, value)))
    return motors


def tool_motor(robot: Robot, q: Array) -> Array:
    """Tool pose as a motor of Cl(0,3,1): M = m₁ m₂ … mₘ M₀ (even part: dual quaternions).

    Args: q (n,), rad or m. Returns M_world_tool (16,), m. Source: Cerbaro 2022, §5.1 (order and product corrected).
    """
    return CL031.product(link_motors(robot, q)[-1], rigid.motor_from_pose(robot.T_world_tool_0))


def tool_by_dual_quaternions(robot: Robot, q: Array) -> Array:
    """Tool pose from dual quaternions: the matrix T_world_tool (4, 4), m, of `tool_motor`; q (n,), rad or m."""
    return rigid.pose_from_motor(tool_motor(robot, q))


FORMULATIONS = {"dh": tool_by_dh, "screws": tool_by_screws, "dual_quaternions": tool_by_dual_quaternions}


def formulation_difference(robot: Robot, q: Array) -> float:
    """Largest difference between entries of the tool poses of the three formulations (positions in m)."""
    poses = np.array([road(robot, q) for road in FORMULATIONS.values()])
    return float(np.max(poses.max(axis=0) - poses.min(axis=0)))


@kernel
def link_poses(chain: Chain, q: Array) -> Array:
    """Poses of the base and all links: R ← R Rot(sᵢ, xᵢ), p ← p + R (s₀ᵢ − s₀ᵢ₋₁), and + R xᵢ sᵢ if joint i slides.

    Args: chain (m,) of `chain.CHAIN`; q (n,), rad or m; the value of joint i is xᵢ = ratio · q[driver] + shift.
    Returns Ts_world_link (m + 1, 4, 4); link 0 is the base, the origin of link i is the point of joint i.
    """
    m = chain.shape[0]
    poses = np.zeros((m + 1, 4, 4))
    for i in range(m + 1):
        poses[i, 3, 3] = 1.0
    for a in range(3):
        poses[0, a, a] = 1.0
    for i in range(m):
        joint = chain[i]
        direction, offset = joint["direction"], joint["offset"]
        angle = joint["ratio"] * q[joint["driver"]] + joint["shift"]
        x, y, z = direction[0], direction[1], direction[2]
        ox, oy, oz = offset[0], offset[1], offset[2]
        if joint["slides"]:
            ox, oy, oz = ox + angle * x, oy + angle * y, oz + angle * z
            angle = 0.0
        s, c = np.sin(angle), np.cos(angle)
        v = 1.0 - c
        r00, r01, r02 = c + x * x * v, x * y * v - z * s, x * z * v + y * s
        r10, r11, r12 = y * x * v + z * s, c + y * y * v, y * z * v - x * s
        r20, r21, r22 = z * x * v - y * s, z * y * v + x * s, c + z * z * v
        before, here = poses[i], poses[i + 1]
        for a in range(3):
            b0, b1, b2 = before[a, 0], before[a, 1], before[a, 2]
            here[a, 0] = b0 * r00 + b1 * r10 + b2 * r20
            here[a, 1] = b0 * r01 + b1 * r11 + b2 * r21
            here[a, 2] = b0 * r02 + b1 * r12 + b2 * r22
            here[a, 3] = before[a, 3] + b0 * ox + b1 * oy + b2 * oz
    return poses


def points_in_world(poses: Array, points: Array, links: NDArray[np.int64]) -> Array:
    """World coordinates of points on links: p' = R p + T.

    Args: poses (m + 1, 4, 4) of `link_poses`; points (p, 3), m, each in the frame of its link; links (p,): number of
    the link that carries each, 0 for the base. Returns (p, 3), m.
    """
    carriers = poses[links, :3]
    return np.asarray(np.einsum("pij,pj->pi", carriers[:, :, :3], points) + carriers[:, :, 3])
