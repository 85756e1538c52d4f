"""The list of postures: angles within the limits where possible, with errors, and in order: kernels."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy import empty

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.measure import COLUMNS, measured, remains, stand_of
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot

# Columns of a variable: its limits, whether a full turn changes nothing, and the cost of its motion, 1/rad or 1/m.
LOWER, UPPER, WHOLE, WEIGHT = range(4)
TURN = 7  # column of the tool: 1 if the orientation counts, else 0
# Columns of a posture after its q: its errors against the asked pose, m and rad; whether every joint is within its
# limits; its number in the order found; its errors against the pose that was solved for; the cost of the motion.
MISSED, TURNED, WITHIN, NUMBER, LEFT, LEFT_TURNED, COST = range(7)
NOWHERE = frozen(np.empty(0))  # no current joint values
ON_LIMIT = 1e-9  # rounding tolerance for a joint at its limit, rad or m
REACHED = 1e-5  # the largest errors of a goal that counts as reached, m and rad


@lru_cache(maxsize=64)
def listing_table(robot: Robot, with_orientation: bool) -> Array:
    """A robot packed for the kernel, (m + 1 + n, 10): the rows of `measured`, then those of the variables.

    All variables have equal weights, as in `choice.alike`.
    """
    arm = measured(robot).copy()
    arm[-1, TURN] = with_orientation
    joints = np.zeros((len(robot.variables), COLUMNS))
    joints[:, LOWER], joints[:, UPPER], joints[:, WHOLE] = robot.lower, robot.upper, robot.periodic
    joints[:, WEIGHT] = [1.0 / robot.reach if joint.is_prismatic else 1.0 for joint in robot.variables]
    return np.concatenate([arm, joints])


def listed_in_order(
    robot: Robot, found: Array, T_asked: Array, solved: Array, q: Array, with_orientation: bool
) -> Array:
    """Postures in order: those that reach the solved pose first, among them those within the limits, then by cost.

    Each periodic joint takes the shorter way from q where its limits allow it.
    Args: found (k, ≥ n): q of each, rad or m; asked, solved: poses (4, 4), m; q (n,): the current joint values, rad or
    m. Returns (k, n + 7), with the columns above.
    """
    rows = empty((len(found), len(q) + 7))
    list_into(listing_table(robot, with_orientation), found, T_asked, solved, q, rows)
    return rows


def listed_as_found(robot: Robot, found: Array, T_asked: Array, solved: Array, with_orientation: bool) -> Array:
    """Postures in the order in which they were found, with angles in (−π, π] where the limits allow it.

    Arguments and result as in `listed_in_order`.
    """
    rows = empty((len(found), len(robot.variables) + 7))
    list_into(listing_table(robot, with_orientation), found, T_asked, solved, NOWHERE, rows)
    return rows


def column(rows: Array, which: int) -> Array:
    """A column after the q of rows, (k,)."""
    return rows[:, which - 1 - COST]


@kernel_into
def wrapped_angle(x: float) -> float:
    """The same angle in (−π, π]."""
    y = x - 2 * np.pi * np.ceil((x - np.pi) / (2 * np.pi))
    return y if y > -np.pi else np.pi


@kernel_into
def keeps(joint: Array, x: float) -> bool:
    """Whether a value is within a joint's limits."""
    return bool(joint[LOWER] - ON_LIMIT <= x <= joint[UPPER] + ON_LIMIT)


@kernel_into
def into_limits(joint: Array, x: float) -> float:
    """An angle in (−π, π], or plus 2πk where only that is within the limits; a joint that is not periodic: x itself."""
    if joint[WHOLE] == 0.0:
        return x
    angle = wrapped_angle(x)
    if keeps(joint, angle):
        return angle
    turns = max(np.ceil((joint[LOWER] - ON_LIMIT - angle) / (2 * np.pi)), 0.0)
    turns += min(np.floor((joint[UPPER] + ON_LIMIT - angle) / (2 * np.pi)), 0.0)
    moved = angle + 2 * np.pi * turns
    return moved if keeps(joint, moved) else angle


@kernel_into
def way_to(joint: Array, x: float, now: float) -> float:
    """The displacement of a joint from `now` to a value, the shorter one if it is periodic."""
    return wrapped_angle(x - now) if joint[WHOLE] > 0.0 else x - now


@kernel_into
def follows(one: Array, other: Array) -> bool:
    """Whether a posture comes after another one in the list, by the columns after q."""
    far = max(one[LEFT], one[LEFT_TURNED]) > REACHED
    if far != (max(other[LEFT], other[LEFT_TURNED]) > REACHED):
        return bool(far)
    if one[WITHIN] != other[WITHIN]:
        return bool(one[WITHIN] < other[WITHIN])
    return bool(one[COST] > other[COST])


@kernel_into
def list_into(table: Array, found: Array, T_asked: Array, solved: Array, now: Array, rows: Array) -> None:
    """Write the rows of `listed_in_order`, or those of `listed_as_found` if `now` is empty.

    Args: table of `listing_table`; rows (k, n + 7), written. Source: Campos 1998, s.17 (the choice of the nearest).
    """
    n, k, ordered = rows.shape[1] - 7, found.shape[0], now.shape[0] > 0
    arm, joints = table[: table.shape[0] - n], table[table.shape[0] - n :]
    target, goal = stand_of(T_asked), stand_of(solved)
    as_asked = target == goal
    turns = arm[arm.shape[0] - 1, TURN]
    for i in range(k):
        row = rows[i]
        said, within, cost = row[n:], True, 0.0
        for j in range(n):
            x = into_limits(joints[j], found[i, j])
            within = within and keeps(joints[j], x)
            if ordered:
                way = way_to(joints[j], x, now[j])
                cost += joints[j, WEIGHT] * abs(way)
                x = now[j] + way if keeps(joints[j], now[j] + way) else x
            row[j] = x
        missed, turned = remains(arm, row, target)
        said[MISSED], said[TURNED], said[WITHIN], said[NUMBER] = missed, turns * turned, within, i
        if not as_asked:
            missed, turned = remains(arm, row, goal)
        said[LEFT], said[LEFT_TURNED], said[COST] = missed, turns * turned, cost
    if ordered:
        for i in range(1, k):
            for j in range(i, 0, -1):
                if not follows(rows[j - 1, n:], rows[j, n:]):
                    break
                for a in range(n + 7):
                    rows[j - 1, a], rows[j, a] = rows[j, a], rows[j - 1, a]
