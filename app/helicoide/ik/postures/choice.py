"""The choice between postures: the one with the smallest weighted motion of the joints."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.confinement import Obstacles, Zones, planes_of
from helicoide.ik import NEAR, Limits, Problem, Reason, reason_of
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.ik.postures.branch import Branch, wrap
from helicoide.ik.postures.listing import ON_LIMIT
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text, numbers_text

OUT_OF_LIMITS = Text(en="outside the joint limits", pt_BR="fora dos limites de junta")
COLLIDES = Text(en="touches an obstacle", pt_BR="toca um obstáculo")


@dataclass(frozen=True, eq=False)
class Ranked:
    """A posture in the ranking.

    change (n,), rad or m: of every joint, the shorter way round; cost: the weighted sum of |change|; q (n,): the joint
    values after this change, or those of the branch where the limits do not allow them; dropped: why the posture is
    ruled out, or None.
    """

    branch: Branch
    change: Array
    cost: float
    q: Array
    dropped: Text | None


def ranked(
    robot: Robot,
    branches: Sequence[Branch],
    q: Array,
    weights: ArrayLike,
    collides: Callable[[Array], bool] = lambda q: False,
) -> tuple[Ranked, ...]:
    """The postures by increasing Σᵢ wᵢ |wrap(θᵢ − θᵢ_now)|, those that are ruled out last.

    Prismatic joints are not wrapped. Args: q (n,): the current joint values, rad or m; weights (n,), 1/rad or 1/m,
    larger for the joints near the base, so that the small links move; collides: whether a posture (n,) touches
    something.
    Raises HelicoideError for wrong q or weights. Source: Campos 1998, s.17.
    """
    now, w = robot.check_joints(q), _checked(robot, weights)
    rows = [_row(robot, branch, now, w, collides) for branch in branches]
    return tuple(sorted(rows, key=lambda row: (row.dropped is not None, row.cost)))


def touching(robot: Robot, obstacles: Obstacles) -> Callable[[Array], bool]:
    """A function that says whether a body of the arm in a posture (n,), rad or m, touches an obstacle.

    Source: Campos 1998, s.17 (an obstacle may rule out the nearest posture).
    """
    limits = Limits(robot.lower, robot.upper, robot.speed)
    problem = Problem(robot, limits, planes_of(()), Zones(body_clearance=0.0), obstacles=obstacles)
    first = len(robot.self_collision)

    def touches(q: Array) -> bool:
        return bool((clearances(packed(problem), q)[first:] < 0).any())

    return touches


def barrier(problem: Problem, q: Array) -> Reason | None:
    """The constraint with the most violated clearance in a posture (n,), rad or m; None where none is violated."""
    left = clearances(packed(problem), q)
    return reason_of(problem, 2 * len(q) + int(left.argmin())) if left.size and left.min() < -NEAR else None


def equal_weights(robot: Robot) -> Array:
    """Equal weights (n,): 1 per rad, and for a prismatic joint 1 per reach, 1/m."""
    return frozen([1.0 / robot.reach if joint.is_prismatic else 1.0 for joint in robot.variables])


def first_usable(rows: Sequence[Ranked]) -> Ranked | None:
    """The first posture of a ranking that is not dropped; None where all are."""
    return next((row for row in rows if row.dropped is None), None)


def _row(robot: Robot, branch: Branch, now: Array, weights: Array, collides: Callable[[Array], bool]) -> Ranked:
    change = np.where(robot.periodic, wrap(branch.q - now), branch.q - now)
    there = now + change
    kept = (there >= robot.lower - ON_LIMIT) & (there <= robot.upper + ON_LIMIT)
    dropped = COLLIDES if branch.within and collides(branch.q) else None
    return Ranked(
        branch=branch,
        change=frozen(change),
        cost=float(weights @ np.abs(change)),
        q=frozen(np.where(kept, there, branch.q)),
        dropped=dropped if branch.within else OUT_OF_LIMITS,
    )


def _checked(robot: Robot, weights: ArrayLike) -> Array:
    w = np.atleast_1d(np.asarray(weights, dtype=np.float64))
    if w.shape != (len(robot.variables),) or not (np.isfinite(w) & (w >= 0)).all():
        raise HelicoideError(
            Text(
                en="The weights must be {n} finite numbers, one per joint, none negative; not {given}.",
                pt_BR="Os pesos devem ser {n} números finitos, um por junta, nenhum negativo; não {given}.",
            ).format(n=len(robot.variables), given=numbers_text(w.ravel()))
        )
    return w
