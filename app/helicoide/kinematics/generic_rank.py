"""What an arm can do in almost every posture: rank of its Jacobian, the rows that move, and the rows that count."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot

SAMPLED_POSTURES = 64  # random ones
STILL = 1e-9  # a row of J without a larger value in any of them is zero, m or rad per rad or m


@lru_cache(maxsize=32)
def generic_rank(robot: Robot, rows: int = 6) -> int:
    """Rank of the tool's Jacobian in almost every posture: of all six rows, or of the three of its position."""
    return analyse_jacobian(_sampled(robot)[0][:rows]).rank


@lru_cache(maxsize=32)
def largest_singular_value(robot: Robot, rows: int) -> float:
    """The largest value that the smallest singular value has in any sampled posture, rows as for `generic_rank`."""
    rank = generic_rank(robot, rows)
    return max(singular_value(robot, J[:rows], rank) for J in _sampled(robot))


def singular_value(robot: Robot, J: Array, number: int) -> float:
    """Singular value σ of that number of J (6, n), or of its first three rows (3, n), with lengths in reaches.

    It is 1 for number 0.
    """
    return 1.0 if number == 0 else float(np.linalg.svd(in_reaches(robot, J), compute_uv=False)[number - 1])


def in_reaches(robot: Robot, J: Array) -> Array:
    """J (6, n), or its first three rows (3, n), with every length divided by the arm's reach."""
    scaled = J * np.where([joint.is_prismatic for joint in robot.variables], robot.reach, 1.0)
    scaled[:3] /= robot.reach
    return np.asarray(scaled)


@lru_cache(maxsize=32)
def movable_rows(robot: Robot) -> NDArray[np.bool_]:
    """Which of vx vy vz ωx ωy ωz the tool of a robot can have at all, (6,): an arm in a plane has no others."""
    return np.asarray(np.abs(_sampled(robot)).max(axis=(0, 2)) > STILL)


@lru_cache(maxsize=32)
def counted_rows(robot: Robot, with_orientation: bool = True) -> NDArray[np.bool_]:
    """Which rows vx vy vz ωx ωy ωz of the tool's Jacobian say how well it moves, (6,): those that move at all.

    Rows of the orientation do not count where the position alone needs every joint: a planar arm of two joints turns
    its tool as it moves it, and cannot choose.
    """
    rows = movable_rows(robot).copy()
    if not with_orientation or len(robot.variables) <= generic_rank(robot, 3):
        rows[3:] = False
    rows.flags.writeable = False  # one array for all callers
    return rows


@lru_cache(maxsize=32)
def _sampled(robot: Robot) -> Array:
    """The tool's Jacobian in random postures, (SAMPLED_POSTURES, 6, n)."""
    postures = np.random.default_rng(0).uniform(robot.lower, robot.upper, (SAMPLED_POSTURES, len(robot.lower)))
    return np.array([frame_jacobian(robot, q) for q in postures])
