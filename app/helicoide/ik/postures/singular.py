"""A singular posture of an arm within its limits and planes, and a target just out of its reach there."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik import Problem
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.kinematics.differential import frame_jacobian, frame_pose
from helicoide.kinematics.generic_rank import (
    counted_rows,
    generic_rank,
    in_reaches,
    largest_singular_value,
    singular_value,
)
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.singularity import NEAR_SINGULAR

BEYOND = 0.1  # displacement of the target, as a fraction of the reach and in rad
SAMPLES = 2000  # random postures; the best of them is improved joint by joint
VALUES, ZOOMS = 9, 5  # values of a joint that are tried around the last one, and how often their range is reduced


def singular_posture(problem: Problem, with_orientation: bool) -> Array | None:
    """Joint values (n,), rad or m, with the smallest singular value that was found; None where none is nearly singular.

    The smallest value is that of the rows that count (`generic_rank.counted_rows`), over its largest.
    """
    rng, limits = np.random.default_rng(0), problem.limits
    samples = rng.uniform(limits.lower, limits.upper, (SAMPLES, len(limits.lower)))
    clear = [q for q in samples if _is_clear(problem, q)]
    if not clear:
        return None
    best = min(clear, key=lambda q: _relative(problem, q, with_orientation))
    span = (limits.upper - limits.lower) / VALUES
    for _ in range(ZOOMS):
        for joint in range(len(best)):
            best = _improved(problem, best, joint, span[joint], with_orientation)
        span = span / 4
    return frozen(best) if _relative(problem, best, with_orientation) < NEAR_SINGULAR else None


def pose_beyond(robot: Robot, q: Array, T_from: Array, with_orientation: bool) -> Array:
    """The tool pose in a singular posture, moved along the velocity that is lost there: T_world_target (4, 4), m.

    The lost velocity is the left singular vector u of the smallest singular value, with the sign that points away from
    the pose T_from (4, 4), m. Args: q (n,), rad or m: the singular posture.
    """
    T, rows = frame_pose(robot, q).copy(), _rows(robot, with_orientation)
    u = np.zeros(6)
    u[:rows] = analyse_jacobian(in_reaches(robot, frame_jacobian(robot, q)[:rows])).U[:, generic_rank(robot, rows) - 1]
    turned = rotation.logarithm(T[:3, :3] @ T_from[:3, :3].T)
    along = u @ np.append((T[:3, 3] - T_from[:3, 3]) / robot.reach, turned)
    step = BEYOND * (u if along >= 0 else -u)
    T[:3, :3] = rotation.exponential(step[3:]) @ T[:3, :3]
    T[:3, 3] += robot.reach * step[:3]
    return frozen(T)


def _improved(problem: Problem, q: Array, joint: int, span: float, with_orientation: bool) -> Array:
    """The best of q and several postures in which one joint differs from q by up to `span`, rad or m."""
    tried = np.tile(q, (VALUES, 1))
    tried[:, joint] += np.linspace(-span, span, VALUES)
    tried = np.clip(tried, problem.limits.lower, problem.limits.upper)
    clear = (there for there in tried if _is_clear(problem, there))
    return min((q, *clear), key=lambda there: _relative(problem, there, with_orientation))


def _is_clear(problem: Problem, q: Array) -> bool:
    return bool((clearances(packed(problem), q) > 0).all())


def _relative(problem: Problem, q: Array, with_orientation: bool) -> float:
    robot, rows = problem.robot, _rows(problem.robot, with_orientation)
    value = singular_value(robot, frame_jacobian(robot, q)[:rows], generic_rank(robot, rows))
    return value / largest_singular_value(robot, rows)


def _rows(robot: Robot, with_orientation: bool) -> int:
    return 6 if counted_rows(robot, with_orientation)[3:].any() else 3
