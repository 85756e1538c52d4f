"""What the arm is asked to do in one tick, as rows J Δq = v with weights.

Position comes first and orientation yields: one radian counts as much as `ORIENTATION_LENGTH` of the arm's reach, so
that a tool whose orientation cannot be met still reaches its point (an arm with five joints cannot choose its heading
freely). Lengths and speeds of the tool are in terms of the reach, so that small arms and large ones behave alike.
"""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, Chain

GAIN = 12.5
TOOL_SPEED = 0.6
TOOL_TURN = 2.0
ORIENTATION_LENGTH = 0.012
DAMPING = 1.5e-6
FIRM = 30.0
EVERY = -1


@kernel
def rotation_vector(R_to: Array, R_from: Array) -> Array:
    """Rotation vector of R_to R_fromᵀ, the shorter way: θ a with 0 ≤ θ ≤ π, world frame.

    Args: rotations (3, 3), both in the world frame. Near π the axis is read from the symmetric part.
    """
    E = np.zeros((3, 3))
    for a in range(3):
        for b in range(3):
            for c in range(3):
                E[a, b] += R_to[a, c] * R_from[b, c]
    vector = np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]]) / 2.0
    sine = np.sqrt(vector[0] ** 2 + vector[1] ** 2 + vector[2] ** 2)
    cosine = (E[0, 0] + E[1, 1] + E[2, 2] - 1.0) / 2.0
    angle = np.arctan2(sine, cosine)
    if sine > 1e-6:
        return np.asarray(vector * (angle / sine))
    if cosine > 0.0:
        return vector
    largest = np.argmax(np.array([E[0, 0], E[1, 1], E[2, 2]]))
    axis: Array = (E[largest] + E[:, largest]) / 2.0
    axis[largest] += 1.0
    axis *= angle / np.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2)
    return axis


@kernel
def shortened(vector: Array, longest: float) -> Array:
    """The vector, scaled down to a length of at most `longest`."""
    length = np.sqrt(vector[0] ** 2 + vector[1] ** 2 + vector[2] ** 2)
    return np.multiply(vector, min(1.0, longest / length)) if length > 0.0 else vector


@kernel
def levers_damping(J: Array, pull: Array, reach: float) -> Array:
    """The damping of each joint under a pull on the tool: d = λ² + max(0, v·rᵢ), rᵢ the lever of joint i.

    v·rᵢ is what the curvature of the tool's way adds to the Hessian; without it a stretched arm that is pulled further
    trembles. Args: J (6, n) of the tool; pull v (3,), m; reach, m. Returns (n,), m².
    """
    n = J.shape[1]
    damping = np.full(n, DAMPING * reach * reach)
    for i in range(n):
        lever = np.cross(J[:3, i], J[3:, i])
        damping[i] += max(0.0, pull[0] * lever[0] + pull[1] * lever[1] + pull[2] * lever[2])
    return damping


@kernel
def pose_task(
    poses: Array,
    chain: Chain,
    tool: tuple[Array, Array, Array, bool, float],
    ahead: Array,
    dt: float,
) -> tuple[Array, Array, Array, Array]:
    """Move the tool towards a pose: v = ẋ dt + (1 − e^(−K dt)) e, no faster than the tool's speed.

    Args: poses (m + 1, 4, 4) of `forward.link_poses`; chain (m,); tool: T_link_tool and T_world_target (4, 4), m, the
    point nearest to the target that the planes allow (3,), m, whether orientation counts, the arm's reach, m;
    ahead (3,): velocity of the target's point, m/s; dt, s. Returns J (6, n), v (6,), weights (6,), damping (n,), m².
    Source: Cerbaro 2022, §4.4.2 (CLIK).

    What pulls into a plane is taken up by the plane; only the pull towards the allowed point damps.
    """
    T_link_tool, T_world_target, allowed, with_orientation, reach = tool
    last = poses[-1]
    point = last[:3, 3].copy()
    R_tool = np.zeros((3, 3))
    for a in range(3):
        for b in range(3):
            point[a] += last[a, b] * T_link_tool[b, 3]
            for c in range(3):
                R_tool[a, c] += last[a, b] * T_link_tool[b, c]
    J = jacobian.geometric(poses, chain, jacobian.joint_axes(poses, chain), point, chain.shape[0])
    fastest = TOOL_SPEED * reach * dt
    share = 1.0 - np.exp(-GAIN * dt)
    v = np.zeros(6)
    v[:3] = shortened(ahead * dt + share * (T_world_target[:3, 3] - point), fastest)
    weights = np.ones(6)
    weights[3:] = ORIENTATION_LENGTH * reach if with_orientation else 0.0
    if with_orientation:
        v[3:] = shortened(share * rotation_vector(T_world_target[:3, :3], R_tool), TOOL_TURN * dt)
    return J, v, weights, levers_damping(J, shortened(share * (allowed - point), fastest), reach)


@kernel
def joint_task(q: Array, q_target: Array, yielding: int, dt: float) -> tuple[Array, Array, Array, Array]:
    """Move every joint towards its own target: v = (1 − e^(−K dt)) (q_target − q).

    Args: q (n,), rad; yielding: the joint that stops first where a plane is in the way, −1 when all yield alike; dt, s.
    """
    n = q.shape[0]
    weights = np.ones(n)
    if yielding >= 0:
        weights[:] = FIRM
        weights[yielding] = 1.0
    return np.eye(n), (1.0 - np.exp(-GAIN * dt)) * (q_target - q), weights, np.full(n, DAMPING)
