"""Scenes with random planes and obstacles, and long walks of guarded ticks through them with every promise measured."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from tests.kinematics.arms import arm

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes
from helicoide.ik import Limits, Problem
from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.packed import ACCELERATION, LOWER, ORIENTATION, REACH, SETTING, SPEED, UPPER, array_parts
from helicoide.ik.guard.work import REPORT, SHARE, work_for
from helicoide.ik.packing import packed
from helicoide.ik.step import step, step_task
from helicoide.ik.task import joint_task
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Chain
from helicoide.kinematics.forward import link_poses, points_in_world

ARMS = ("movemaster", "puma560", "planar3r", "scara", "dia10", "zebra_zero")
STAY = 60


def left(problem: Problem, q: Array) -> Array:
    """What is left of every clearance at q, m."""
    return clearances(packed(problem), frozen(q))


def scene(name: str, seed: int, planes: int = 3, obstacles: int = 2, acceleration: float = np.inf) -> Problem:
    """An arm among random planes and obstacles that are clear of it at `ready`."""
    rng, robot = np.random.default_rng(seed), arm(name)
    limits = Limits(robot.lower, robot.upper, robot.speed, frozen(np.full(len(robot.lower), acceleration)))
    q, reach = robot.poses["ready"], robot.reach
    at = points_in_world(link_poses(robot.chain, q), robot.monitored_points, robot.monitored_links)
    normals = rng.normal(size=(planes, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    least = (at @ normals.T).min(axis=0) - rng.uniform(0.1, 0.6, planes) * reach - 0.1
    problem = Problem(robot, limits, Planes(frozen(normals), frozen(normals * least[:, None])))
    while len(problem.obstacles.radii) < obstacles:
        start = rng.uniform(-reach, reach, 3)
        end = start + rng.choice([0.0, 1.0]) * rng.uniform(-reach, reach, 3) / 2
        more = problem.obstacles.with_capsule(start, end, rng.uniform(0.02, 0.1) * reach)
        tried = Problem(robot, limits, problem.planes, obstacles=more)
        if left(tried, q).min() > 0.02:
            problem = tried
    return problem


@kernel
def walk(
    arm: Array, chain: Chain, q: Array, T_link_tool: Array, turn: float, steps: int, seed: int, memory: Array,
    figures: Array,
) -> Array:  # fmt: skip
    """Targets that jump and run, ticks of 1 to 50 ms; fills in `Figures` and gives the last joint values.

    Args: arm: packed, one that the walk may write into; turn: the weight of orientation, which comes and goes.
    """
    np.random.seed(seed)
    at, reach = array_parts(arm), arm[SETTING, REACH]
    rates, n, begins = memory[REPORT : REPORT + at.n], at.n, np.empty(0, dtype=np.int64)
    q, was, before_rates, dt, kind = q.copy(), q.copy(), np.zeros(at.n), 0.01, 0
    q_target, T, drift = q.copy(), link_poses(chain, q)[-1].copy(), np.zeros(3)
    before = clearances(arm, q)
    for k in range(steps):
        if k % STAY == 0:
            dt, kind = np.exp(np.random.uniform(np.log(0.001), np.log(0.05))), np.random.randint(4)
            for i in range(n):
                q_target[i] = np.random.uniform(arm[at.limits + i, LOWER], arm[at.limits + i, UPPER])
            T = link_poses(chain, q_target)[-1] @ T_link_tool
            for a in range(3):
                drift[a] = np.random.uniform(-0.3, 0.3) * reach * (kind == 1)
                T[a, 3] += np.random.uniform(-2.0, 2.0) * reach * (kind == 2)
        for a in range(3):
            T[a, 3] += drift[a] * dt
        was[:], before_rates[:] = q, rates
        arm[SETTING, ORIENTATION] = turn if k % (5 * STAY) > STAY else 0.0
        if kind == 3:
            J, v, weights, damping = joint_task(q, q_target, -1, dt)
            step_task(arm, q, J, v, weights, damping, begins, dt, memory)
        else:
            step(arm, q, T, drift, dt, memory)
        share, after, sharpest = memory[SHARE], clearances(arm, q), 0.0
        for i in range(n):
            limit, now = at.limits + i, (q[i] - was[i]) / dt
            figures[1] = max(figures[1], min(arm[limit, LOWER], was[i]) - q[i], q[i] - max(arm[limit, UPPER], was[i]))
            figures[2] = max(figures[2], abs(now) - arm[limit, SPEED])
            sharpest = max(sharpest, (abs(now - before_rates[i]) - 1e-9) / (arm[limit, ACCELERATION] * dt))
        for r in range(after.shape[0]):
            figures[0] = max(figures[0], min(0.0, before[r]) - after[r])
            figures[7] += after[r] < 1e-3
        figures[3] += 1
        figures[4] += 0.0 < share < 1.0
        figures[5] += share == 0.0
        figures[6] += sharpest > 1.0 + 1e-6 and share == 1.0
        figures[8] = max(figures[8], sharpest if share == 1.0 else 0.0)
        figures[9] += not np.isfinite(q).all()
        before = after
    return q


@dataclass(frozen=True)
class Figures:
    """What came nearest to breaking a promise in a walk, m, rad and rad/s, and how often what happened."""

    closer: float
    outside: float
    too_fast: float
    steps: float
    shortened: float
    stopped: float
    gave_way: float
    near: float
    sharpest: float
    unfinished: float


def walked(problem: Problem, steps: int, seed: int) -> Figures:
    """A walk from `ready`, at rest."""
    figures, robot = np.zeros(len(fields(Figures))), problem.robot
    figures[:3] = -np.inf
    arm, q, memory = packed(problem).copy(), robot.poses["ready"].copy(), work_for(packed(problem)).memory
    walk(arm, robot.chain, q, robot.T_link_tool.copy(), float(arm[SETTING, ORIENTATION]), steps, seed, memory, figures)
    return Figures(*map(float, figures))
