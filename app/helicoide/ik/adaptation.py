"""A path that gives way to planes before the arm comes too near: the source's own rules, with no guard behind them.

Three things happen to a target p of the path. Before the run it is trimmed: not nearer than the warning distance to
walls and bench. In the run, where a point of the arm is nearer than δ_c to a plane, the target is moved away from it,

    p ← p + (1.1 δ_c − d) n                                        eq. 36, corrected; as printed: (δ_c − 1.1 d) n

and where it is nearer than the warning distance the target may not come nearer than the former point,

    p ← p − min(0, (p − p_former)·n) n                             eq. 37 for any plane; as printed: z must not rise

each time with the inverse kinematics once more, until neither applies. n: unit normal to the allowed side. The former
point may be that of the wanted path, or the former target as it ended: then one target holds back all that follow.
Source: Cerbaro 2022, §6.1. As printed, the tenth in eq. 36 is on d, and the ceiling alone is watched.
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
from helicoide.ik.converge import CAP_PER_POINT, INNER, Report, Run, Tolerance, converged
from helicoide.kinematics.forward import link_poses, points_in_world

CAP = 60
MARGIN = 1.1
UP = frozen([0.0, 0.0, 1.0])
STILL = 1e-12
ROUNDING = 1e-9


@dataclass(frozen=True)
class Rule:
    """How targets give way: watched: numbers of the planes; cap: how often at most a target is moved.

    corrected: eq. 36 with the tenth on δ_c instead of on d; level: eq. 37 as printed, where a warning from any plane
    forbids to rise; damps: whether there is eq. 37 at all; ratchets: whether its former point is the former target as
    it ended, not that of the wanted path.
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
    """Points (k, 3), m, moved along n to the warning distance of planes that they are nearer to.

    Planes are taken one after another, again and again until all hold: one may move a point towards another.
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
    """Eq. 36: p + (1.1 δ_c − d) n, or as printed p + (δ_c − 1.1 d) n, which turns round at d = δ_c/1.1.

    Args: target (3,), m; distance d, m, of the critical joint; normal n (3,), unit, inward; critical: δ_c, m.
    """
    by = MARGIN * critical - distance if corrected else critical - MARGIN * distance
    return np.asarray(target + by * normal)


def held_back(target: Array, former: Array, normal: Array) -> Array:
    """Eq. 37 for a plane of any direction: p − min(0, (p − p_former)·n) n. Args: (3,) each; normal: unit, inward."""
    return np.asarray(target - min(0.0, float((target - former) @ normal)) * normal)


def nearest(problem: Problem, q: Array) -> Array:
    """Distance of the nearest moving point of the arm to each plane, (k,), m. Source: Cerbaro 2022, eq. 20."""
    robot, moving = problem.robot, problem.robot.monitored_links > 0
    poses = link_poses(robot.chain, q)
    points = points_in_world(poses, robot.monitored_points[moving], robot.monitored_links[moving])
    return np.asarray(signed_distances(problem.planes.normals, frozen(problem.planes.offsets), points).min(axis=0))


def given_way(target: Array, former: Array | None, near: Array, planes: Planes, zones: Zones, rule: Rule) -> Array:
    """The target after one application of the rule; the same array where none applies.

    Args: target and the former point, (3,), m, None at the first; near (k,), m, of `nearest`.
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
            back = held_back(back, former, -UP if rule.level else planes.normals[i])
    return target if np.abs(back - target).max() < STILL else back


@dataclass(frozen=True, eq=False)
class Track:
    """How a path of k points went, a row for each.

    targets (k, 3), m, as they ended; q (k, n); near (k, planes), m, of `nearest`; errors (k,), m, of the tool from its
    target; moved (k,): how often the target was moved, the rule's cap where it was given up; memory: of the run.
    """

    targets: Array
    q: Array
    near: Array
    errors: Array
    moved: Array
    memory: Any


def adapted(
    problem: Problem,
    run: Run,
    aimed: Callable[[Array], TaskFunction],
    points: Array,
    q: Array,
    rule: Rule = NONE,
    tolerance: Tolerance = INNER,
    cap: int = CAP_PER_POINT,
    memory: Any = None,
    progress: Callable[[float], None] = lambda share: None,
) -> Track:
    """Follow points (k, 3), m, from q (n,): each is met to within the tolerance, then gives way as the rule says.

    run: the inverse kinematics, as in `converge.converged`; aimed: what to aim at for a target (3,), m; cap: steps for
    each. Every target gets a step at least. Source: Cerbaro 2022, §6.1, steps 3–7 (the caps are ours).
    """
    rows: list[tuple[Array, Array, Array, float, int]] = []
    former: Array | None = None
    for i, point in enumerate(points):
        target, moved = np.asarray(point), 0
        report = converged(problem, run, aimed(target), q, tolerance, cap, 1, memory)
        near = nearest(problem, report.q)
        while moved < rule.cap:
            other = given_way(target, former, near, problem.planes, problem.zones, rule)
            if other is target:
                break
            target, moved = other, moved + 1
            report = converged(problem, run, aimed(target), report.q, tolerance, cap, 1, report.memory)
            near = nearest(problem, report.q)
        former = target if rule.ratchets else np.asarray(point)
        q, memory = report.q, report.memory
        rows.append((target, q, near, _missed(report), moved))
        progress((i + 1) / len(points))
    targets, joints, distance, errors, moves = (np.array(column) for column in zip(*rows, strict=True))
    return Track(targets, joints, distance, errors, moves, memory)


def _missed(report: Report) -> float:
    return float(report.errors[-1, 0])
