"""A `Problem` and the settings of the guarded step, packed into one table for the kernels."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.guard.packed import packed_rows
from helicoide.ik.guard.rows import DAMPER_GAIN
from helicoide.ik.task import DAMPING, ORIENTATION_LENGTH
from helicoide.kinematics import tool_kernels


@lru_cache(maxsize=64)
def packed(
    problem: Problem,
    damping: float = DAMPING,
    turn: float = ORIENTATION_LENGTH,
    gain: float = DAMPER_GAIN,
    position_first: bool = False,
) -> Array:
    """A problem packed for the kernels, (k, 16), with the rows and columns of `guard.packed`.

    Args: damping: λ², for lengths divided by the reach; turn: weight of the orientation, the fraction of the reach that
    counts as much as 1 rad, 0 for none; gain: κ of the velocity dampers, 1/s; position_first: whether orientation is
    solved in the null space of the position.
    """
    robot, entry, limits, planes = problem.robot, problem.entry, problem.limits, problem.planes
    *joints, end = tool_kernels.arm_array(robot)
    points, pairs = _points(problem), _pairs(problem)
    counts = len(joints), len(limits.lower), len(points), len(robot.monitored_points), len(planes.normals), len(pairs)
    numbers = problem.zones.critical, gain, robot.reach, damping, turn, position_first
    instrument = [*entry.shaft.ravel(), *entry.point] if entry is not None else []
    return packed_rows(
        [*counts, *numbers, entry.link if entry is not None else 0],
        np.array([end]),
        np.array([instrument]),
        np.array(joints),
        np.column_stack([limits.lower, limits.upper, limits.speed, limits.acceleration]),
        points,
        np.column_stack([planes.normals, planes.offsets]),
        pairs,
    )


def _points(problem: Problem) -> Array:
    """Points with their links, (p, 4): the monitored points, then, if there are pairs, the axis ends of all bodies.

    The ends of obstacles are on link 0.
    """
    robot, obstacles = problem.robot, problem.obstacles
    places, links = [*robot.monitored_points], [*robot.monitored_links]
    if problem.pairs:
        for body in robot.bodies:
            places.extend(body.ends)
            links.extend(body.links)
        places.extend(obstacles.ends.reshape(-1, 3))
        links.extend([0] * (2 * len(obstacles.radii)))
    return np.column_stack([np.reshape(places, (-1, 3)), links])


def _pairs(problem: Problem) -> Array:
    """For each pair, (b, 5): the numbers of its four axis ends, and the smallest distance of the two axes, m."""
    first = len(problem.robot.monitored_points)
    radii = [*(body.radius for body in problem.robot.bodies), *problem.obstacles.radii]
    rows = [
        (*(first + 2 * body + end for body in pair for end in (0, 1)), sum(radii[body] for body in pair))
        for pair in problem.pairs
    ]
    pairs = np.reshape(np.array(rows, dtype=np.float64), (-1, 5))
    pairs[:, 4] += problem.zones.body_clearance
    return pairs
