"""A path whose targets are moved away from planes: the rules of the source, without the guarded step.

A target p of the path is changed in three ways. Before the run it is trimmed: moved to at least the warning distance
from walls and bench. In the run, where a point of the arm is nearer than δ_c to a plane, p is moved away from it,

    p ← p + (1.1 δ_c − d) n                                        eq. 36, corrected; as printed: (δ_c − 1.1 d) n

and where it is nearer than the warning distance, p may not be nearer to the plane than the former point,

    p ← p − min(0, (p − p_former)·n) n                             eq. 37 for any plane; as printed: z must not rise

After each change the inverse kinematics is solved again, until neither rule applies. n: unit normal to the allowed
side. The former point is that of the path as given, or the former target after its changes. In the second case one
changed target limits all that follow.
Source: Cerbaro 2022, §6.1. As printed, the factor 1.1 of eq. 36 is on d, and only the ceiling is watched.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes, Zones, signed_distances
from helicoide.ik import Problem
from helicoide.ik.clik import TaskFunction
from helicoide.ik.converge import IterativeSolver, Report, converged
from helicoide.kinematics.forward import link_poses, points_in_world

CAP = 60
MARGIN = 1.1
UP = frozen([0.0, 0.0, 1.0])
STILL = 1e-12
ROUNDING = 1e-9


@dataclass(frozen=True)
class Rule:
    """How targets are changed.

    watched: numbers of the planes; corrected: eq. 36 with the factor 1.1 on δ_c instead of d; level: eq. 37 as printed,
    where near any plane no target may be above the former point; damps: whether eq. 37 is used; ratchets: whether its
    former point is the former target after its changes, not that of the path as given; cap: how often a target is moved
    at most.
    """

    watched: tuple[int, ...]
    corrected: bool = True
    level: bool = False
    damps: bool = True
    ratchets: bool = False
    cap: int = CAP


NONE = Rule(())


def everywhere(planes: Planes) -> Rule:
    """The corrected rule for every plane."""
    return Rule(tuple(range(len(planes.normals))))


def trimmed(points: Array, planes: Planes, which: Sequence[int], warning: float) -> Array:
    """Points (k, 3), m; those nearer to a plane than the warning distance, m, are moved along n to that distance.

    The planes are applied in turn, repeatedly until all hold: one may move a point towards another.
    which: numbers of the planes. Source: Cerbaro 2022, §6.1 (walls and bench; the ceiling is left to the rules).
    """
    points, which = points.copy(), list(which)
    for _ in range(CAP):
        if (points @ planes.normals[which].T - planes.offsets[which] >= warning - ROUNDING).all():
            break
        for i in which:
            left = points @ planes.normals[i] - planes.offsets[i]
            points += np.maximum(0.0, warning - left)[:, None] * planes.normals[i]
    return points


def moved_away(target: Array, distance: float, normal: Array, critical: float, corrected: bool) -> Array:
    """Eq. 36: p + (1.1 δ_c − d) n, or as printed p + (δ_c − 1.1 d) n, which changes its sense at d = δ_c/1.1.

    Args: target p (3,), m; distance d, m, of the nearest point of the arm; normal n (3,), unit, to the allowed side;
    critical: δ_c, m; corrected: whether not as printed.
    """
    by = MARGIN * critical - distance if corrected else critical - MARGIN * distance
    return np.asarray(target + by * normal)


def with_distances_kept(target: Array, former: Array, normal: Array) -> Array:
    """Eq. 37 for any plane: p − min(0, (p − p_former)·n) n. Args: (3,) each; normal: unit, to the allowed side."""
    return np.asarray(target - min(0.0, float((target - former) @ normal)) * normal)


def moving_point_distances(problem: Problem, q: Array) -> Array:
    """Distance of the nearest moving monitored point to each plane, (k,), m. Source: Cerbaro 2022, eq. 20."""
    robot, moving = problem.robot, problem.robot.monitored_links > 0
    poses = link_poses(robot.chain, q)
    points = points_in_world(poses, robot.monitored_points[moving], robot.monitored_links[moving])
    return np.asarray(signed_distances(problem.planes.normals, frozen(problem.planes.offsets), points).min(axis=0))


def with_target_moved(
    target: Array, former: Array | None, near: Array, planes: Planes, zones: Zones, rule: Rule
) -> Array:
    """The target after one application of the rule; the same array where the rule does not apply.

    Args: target and former point, (3,), m, former None for the first target; near (k,), m, of `moving_point_distances`.
    """
    watched = list(rule.watched)
    if not watched:
        return target
    worst = watched[int(near[watched].argmin())]
    if near[worst] < zones.critical:
        return moved_away(target, float(near[worst]), planes.normals[worst], zones.critical, rule.corrected)
    if former is None or not rule.damps:
        return target
    back = target
    for i in watched:
        if near[i] < zones.warning:
            back = with_distances_kept(back, former, -UP if rule.level else planes.normals[i])
    return target if np.abs(back - target).max() < STILL else back


@dataclass(frozen=True, eq=False)
class TargetPoints:
    """The points of a path, one after another, and the task of each. points (k, 3), m; task: for a target (3,), m."""

    points: Array
    task: Callable[[Array], TaskFunction]


@dataclass(frozen=True, eq=False)
class Track:
    """The results along a path of k points, a row for each.

    targets (k, 3), m, after their changes; q (k, n), rad or m; near (k, planes), m, of
    `moving_point_distances`; errors (k,), m, between tool and target; moved (k,): how often the target was moved, at
    most the cap; memory: of the loop.
    """

    targets: Array
    q: Array
    near: Array
    errors: Array
    moved: Array
    memory: Any


def adapted(
    solver: IterativeSolver,
    path: TargetPoints,
    q: Array,
    rule: Rule = NONE,
    memory: Any = None,
    progress: Callable[[float], None] = lambda share: None,
) -> Track:
    """Follow the points of a path from q (n,): iterate to each by the solver, then change it by the rule.

    memory: of the loop, None at the start. Source: Cerbaro 2022, §6.1, steps 3–7.
    """
    problem = solver.problem
    rows: list[tuple[Array, Array, Array, float, int]] = []
    former: Array | None = None
    for i, point in enumerate(path.points):
        target, moved = np.asarray(point), 0
        report = converged(solver, path.task(target), q, memory)
        near = moving_point_distances(problem, report.q)
        while moved < rule.cap:
            other = with_target_moved(target, former, near, problem.planes, problem.zones, rule)
            if other is target:
                break
            target, moved = other, moved + 1
            report = converged(solver, path.task(target), report.q, report.memory)
            near = moving_point_distances(problem, report.q)
        former = target if rule.ratchets else np.asarray(point)
        q, memory = report.q, report.memory
        rows.append((target, q, near, _missed(report), moved))
        progress((i + 1) / len(path.points))
    targets, joints, distance, errors, moves = (np.array(column) for column in zip(*rows, strict=True))
    return Track(targets, joints, distance, errors, moves, memory)


def _missed(report: Report) -> float:
    return float(report.errors[-1, 0])
