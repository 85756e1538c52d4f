"""Joint values that move the tool along a path, from one known posture to another.

At each point of the path Newton's iteration starts at the linear interpolation of the two postures plus the correction
found at the point before. This correction is scaled down to zero towards the end. The joints therefore end in the
posture that was asked for, also where the arm is redundant. The orientation is followed in the null space of the
position.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.task import rotation_error
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.path import Path

# Points of the path, and the largest joint motion from one to the next, rad or m: more is a jump to another branch.
PLACES, JUMP = 101, 0.2
STEPS, SETTLED, MISSED = 100, 1e-10, 1e-7
# Singular values up to this count as zero; those of the position are divided by the reach.
FAINT = 1e-4


def joints_along(robot: Robot, path: Path, start: Array, end: Array) -> Array | None:
    """Joint values at evenly spaced parameters of a path, (PLACES, n), rad or m.

    Args: start, end (n,): postures at the ends of the path. Returns None where the tool cannot follow within the
    limits, or only with a jump.
    """
    rows, added = [start], np.zeros(len(start))
    shares = np.linspace(0.0, 1.0, PLACES)
    for before, share in pairwise(shares):
        even = (1 - share) * start + share * end
        q = _brought(robot, even + added * (1 - share) / (1 - before), path.pose(share * path.duration))
        if q is None:
            return None
        added = q - even
        rows.append(q)
    found = np.array(rows)
    lower, upper = np.minimum(np.minimum(robot.lower, start), end), np.maximum(np.maximum(robot.upper, start), end)
    outside = np.maximum(lower - found, found - upper).max() > MISSED
    return None if outside or np.abs(np.diff(found, axis=0)).max() > JUMP else found


def _brought(robot: Robot, q: Array, T_world_target: Array) -> Array | None:
    """The posture near q with the tool at the target: Δq = Jp† e_p + (Jo N)† (e_o − Jo Jp† e_p), N = I − Jp† Jp.

    Returns None where the position does not converge.
    """
    chain, R_target = robot.chain, frozen(T_world_target[:3, :3])
    for _ in range(STEPS):
        poses = link_poses(chain, frozen(q))
        T = poses[-1] @ robot.T_link_tool
        J = jacobian.geometric_jacobian(poses, chain, jacobian.joint_axes(poses, chain), T[:3, 3].copy(), len(chain))
        missed, turned = T_world_target[:3, 3] - T[:3, 3], rotation_error(R_target, frozen(T[:3, :3]))
        to_point = _inverse(J[:3], FAINT * robot.reach)
        first = to_point @ missed
        left = J[3:] @ (np.eye(len(q)) - to_point @ J[:3])
        step = first + _inverse(left, FAINT) @ (turned - J[3:] @ first)
        if np.abs(step).max() < SETTLED:
            return q if np.linalg.norm(missed) < MISSED else None
        q = q + step
    return None


def _inverse(A: Array, faint: float) -> Array:
    """A† without the singular values up to `faint`."""
    U, values, Vt = np.linalg.svd(A, full_matrices=False)
    felt = values > faint
    return np.asarray(Vt[felt].T / values[felt] @ U[:, felt].T)
