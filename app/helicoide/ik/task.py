"""The task of one tick, as rows J Δq = v with weights.

Position outweighs orientation: one radian counts as much as `ORIENTATION_LENGTH` times the reach. A tool whose
orientation cannot be met therefore still reaches its point (an arm with five joints cannot choose its heading freely).
Tool lengths and speeds are divided by the reach, so that small and large arms behave alike.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.packed import (
    CRITICAL,
    FIRST,
    OFFSET,
    ORIENTATION,
    REACH,
    SETTING,
    TOOL,
    At,
    PlacedArm,
    array_parts,
)
from helicoide.ik.guard.packed import DAMPING as LEAST_DAMPING
from helicoide.ik.guard.qp import SOLVED, Constraints, project_into_limits
from helicoide.ik.guard.rows import Task, Vector, point_displacement
from helicoide.kernels import kernel, kernel_into
from helicoide.kinematics.tool_kernels import ANGLE_RATIO, DRIVER, Row, rotation_to, tool_row, tool_rows

GAIN = 12.5
TOOL_SPEED = 0.6
TOOL_TURN = 2.0
ORIENTATION_LENGTH = 0.012
DAMPING = 1.5e-6
FIRM = 30.0
EVERY = -1


@kernel
def rotation_error(R_to: Array, R_from: Array) -> Array:
    """Rotation vector of R_to R_fromᵀ, the shorter way: θ a with 0 ≤ θ ≤ π, world frame; (3,).

    Args: rotations (3, 3), or poses, both in the world frame. See `tool_kernels.rotation_to`.
    """
    vector = np.empty(3)
    vector[0], vector[1], vector[2] = rotation_to(R_to, pose_row(R_from, 0), pose_row(R_from, 1), pose_row(R_from, 2))
    return vector


@kernel_into
def pose_row(R: Array, a: int) -> Row:
    """Row a of a rotation, as a row of a pose with zero translation."""
    return R[a, 0], R[a, 1], R[a, 2], 0.0


@kernel_into
def shortened(x: float, y: float, z: float, longest: float) -> Vector:
    """A vector scaled down to a length of at most `longest`."""
    length = np.sqrt(x * x + y * y + z * z)
    share = min(1.0, longest / length) if length > 0.0 else 1.0
    return share * x, share * y, share * z


@kernel_into
def levers_damping(J: Array, pull: Vector, least: float, damping: Array) -> None:
    """Write the damping of each joint for a tool displacement v: d = λ² + max(0, v·rᵢ).

    rᵢ is the perpendicular from axis i to the tool point. v·rᵢ is the term that the curved path of the tool adds to the
    Hessian; without it a stretched arm oscillates when its target is out of reach.
    Args: J (6, n) of the tool; pull: v (3,), m; least: λ², m². Writes damping (n,), m².
    """
    for i in range(J.shape[1]):
        x = J[1, i] * J[5, i] - J[2, i] * J[4, i]
        y = J[2, i] * J[3, i] - J[0, i] * J[5, i]
        z = J[0, i] * J[4, i] - J[1, i] * J[3, i]
        damping[i] = least + max(0.0, pull[0] * x + pull[1] * y + pull[2] * z)


@kernel_into
def pose_task(placed: PlacedArm, T_world_target: Array, ahead: Array, dt: float, task: Task) -> None:
    """Move the tool towards a pose: v = ẋ dt + (1 − e^(−K dt)) e, scaled down to the largest speeds of the tool.

    The damping uses only the displacement towards the nearest point that the planes allow: a displacement into a plane
    is stopped by the plane itself.

    Args: T_world_target (4, 4), m; ahead (3,): velocity of the target point, m/s; dt, s. Writes J (6, n), v (6,),
    weights (6,), damping (n,), m².
    Source: Cerbaro 2022, §4.4.2 (CLIK).
    """
    (arm, at, _, poses, _), (J, v, weights, damping) = placed, task
    T, last = tool_rows(arm[TOOL]), poses[at.m]
    x, y, z = rotated_row(last, 0, T), rotated_row(last, 1, T), rotated_row(last, 2, T)
    jacobian_into(placed, (x[3], y[3], z[3]), J)
    reach, turning, share = arm[SETTING, REACH], arm[SETTING, ORIENTATION], 1.0 - np.exp(-GAIN * dt)
    fastest = TOOL_SPEED * reach * dt
    there = (T_world_target[0, 3], T_world_target[1, 3], T_world_target[2, 3])
    v[0], v[1], v[2] = shortened(
        ahead[0] * dt + share * (there[0] - x[3]),
        ahead[1] * dt + share * (there[1] - y[3]),
        ahead[2] * dt + share * (there[2] - z[3]),
        fastest,
    )
    angle = rotation_to(T_world_target, x, y, z) if turning > 0.0 else (0.0, 0.0, 0.0)
    v[3], v[4], v[5] = shortened(share * angle[0], share * angle[1], share * angle[2], TOOL_TURN * dt)
    for s in range(3):
        weights[s], weights[3 + s] = 1.0, turning * reach
    near = allowed_point(arm, at, there)
    pull = shortened(share * (near[0] - x[3]), share * (near[1] - y[3]), share * (near[2] - z[3]), fastest)
    levers_damping(J, pull, arm[SETTING, LEAST_DAMPING] * reach * reach, damping)


@kernel_into
def rotated_row(pose: Array, a: int, tool: tuple[Row, Row, Row]) -> Row:
    """Row a of T_world_link T_link_tool."""
    return tool_row((pose[a, 0], pose[a, 1], pose[a, 2], pose[a, 3]), tool)


@kernel_into
def jacobian_into(placed: PlacedArm, point: Vector, J: Array) -> None:
    """Write the geometric Jacobian of a point of the last link, m, world, into J (6, n)."""
    arm, at, _, poses, axes = placed
    J[:] = 0.0
    for i in range(at.m):
        joint = FIRST + i
        column, turns = int(arm[joint, DRIVER]), arm[joint, ANGLE_RATIO]
        v = point_displacement(arm, i, poses, axes, point)
        for a in range(3):
            J[a, column] += v[a]
            J[3 + a, column] += turns * axes[i, a]


@kernel_into
def allowed_point(arm: Array, at: At, point: Vector) -> Vector:
    """The point nearest to a given one, m, that the planes allow for the tool; itself where they allow none."""
    is_allowed = True
    for p in range(at.planes, at.pairs):
        height = arm[p, 0] * point[0] + arm[p, 1] * point[1] + arm[p, 2] * point[2]
        is_allowed = is_allowed and height >= arm[p, OFFSET] + arm[SETTING, CRITICAL]
    if is_allowed:
        return point
    return nearest_allowed(arm, at, point)


@kernel
def nearest_allowed(arm: Array, at: At, point: Vector) -> Vector:
    """`allowed_point` for a point that the planes do not allow."""
    k = at.pairs - at.planes
    normals, bounds, desired = np.empty((k, 3)), np.empty((2, k)), np.empty(3)
    for p in range(k):
        for a in range(3):
            normals[p, a] = arm[at.planes + p, a]
        bounds[0, p], bounds[1, p] = arm[at.planes + p, OFFSET] + arm[SETTING, CRITICAL], np.inf
    desired[0], desired[1], desired[2] = point
    (found, _), verdict = project_into_limits(Constraints(normals, bounds[0], bounds[1]), desired)
    return (found[0], found[1], found[2]) if verdict == SOLVED else point


@kernel
def allowed(arm: Array, point: Array) -> Array:
    """`allowed_point` of a packed arm for a point (3,), m, as an array (3,), m."""
    found = np.empty(3)
    found[0], found[1], found[2] = allowed_point(arm, array_parts(arm), (point[0], point[1], point[2]))
    return found


@kernel
def joint_task(q: Array, q_target: Array, yielding: int, dt: float) -> tuple[Array, Array, Array, Array]:
    """Move every joint towards its own target: v = (1 − e^(−K dt)) (q_target − q).

    Args: q, q_target (n,), rad or m; yielding: the joint with the smallest weight, which gives way first to a
    constraint, −1 for equal weights; dt, s. Returns J (n, n), v (n,), rad or m, weights (n,) and damping (n,),
    both dimensionless, as J is.
    """
    n = q.shape[0]
    weights = np.ones(n)
    if yielding >= 0:
        weights[:] = FIRM
        weights[yielding] = 1.0
    return np.eye(n), (1.0 - np.exp(-GAIN * dt)) * (q_target - q), weights, np.full(n, DAMPING)
