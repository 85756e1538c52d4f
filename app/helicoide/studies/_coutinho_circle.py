"""A circle for the tip of a rod, and the run of one turn."""

from __future__ import annotations

from functools import cache
from itertools import islice

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import clik
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm import rod
from helicoide.ik.rcm.follow import PSEUDOINVERSE
from helicoide.ik.rcm.passage import through
from helicoide.ik.rcm.residuals import depth, lateral_distance
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.studies._coutinho_runs import DEPTH, STRIDE, Run, problem_without_planes
from helicoide.studies.study import Progress

ROBOT = "dia10_rod"
START = frozen([0.4, -0.9, -0.5, 1.3, 0.4, -0.7, 0.0])
RADIUS, PERIOD = 0.03, 20.0
# Of a later Motoman, the SDA10F, to two decimals, rad.
LIMITS = frozen([3.13, 1.90, 2.95, 2.36, 3.13, 1.90, 3.13])


@cache
def rod_arm() -> Robot:
    """The source's arm without its torso, with a straight rod for a tool."""
    return load_robot(ROBOT)


@cache
def scene() -> tuple[Array, Array, Array]:
    """Pose of the tip (4, 4), m, entry point 0.15 m up the shaft (3,), m, direction of the shaft, at the start."""
    T = tool_at(rod_arm(), START)
    return T, T[:3, 3] - DEPTH * T[:3, 1], T[:3, 1]


def tip_reference(t: float) -> rod.TipTask:
    """p_d = p₀ + 0.03 [(cos ωt − 1) e₁ + sin ωt e₂], e₁ = unit(d × z), e₂ = d × e₁. Args: t, s."""
    T, entry, d = scene()
    e1 = np.cross(d, [0.0, 0.0, 1.0])
    e1 /= np.linalg.norm(e1)
    e2, w = np.cross(d, e1), 2 * np.pi / PERIOD
    target = T[:3, 3] + RADIUS * ((np.cos(w * t) - 1) * e1 + np.sin(w * t) * e2)
    ahead = RADIUS * w * (np.cos(w * t) * e2 - np.sin(w * t) * e1)
    return rod.TipTask(target, ahead, entry, np.zeros(2))


def _figures(moment: clik.LoopStep) -> dict[str, float]:
    T, (_, entry, _) = tool_at(rod_arm(), moment.q), scene()
    return {
        "t": moment.t,
        "tip_mm": 1e3 * float(np.linalg.norm(moment.task_error.error[:3])),
        "lateral_mm": 1e3 * lateral_distance(T[:3, 1], T[:3, 3], entry),
        "depth": depth(T[:3, 1], T[:3, 3], entry),
        "rate": float(np.abs(moment.solution.rates).max()),
        "of_limits": float((np.abs(moment.q) / LIMITS).max()),
        "smallest_sigma": float(analyse_jacobian(moment.task_error.J).sigma[-1]),
        "closure": float(np.abs(moment.q - START).max()),
    }


def run_circle_once(
    entry_gain: float, dt: float, seconds: float = PERIOD, progress: Progress = lambda share: None
) -> Run:
    """A run of one turn with Kp = 5 and z₀ = −0.2 (q − q₀): columns of its steps, and q at times t_w, s."""
    problem, passage = problem_without_planes(rod_arm()), through(rod_arm(), 7)
    law = clik.ControlLaw(PSEUDOINVERSE, rod.gains(passage, 5.0, entry_gain), dt)
    aiming = rod.to_points(problem, passage, tip_reference)
    moments = clik.closed_loop(problem, law, aiming, START, push=lambda q, t: -0.2 * (q - START))
    steps, stride = round(seconds / dt) + 1, round(STRIDE / dt)
    rows, seldom = [], []
    for step, moment in enumerate(islice(moments, steps)):
        rows.append(_figures(moment))
        if step % stride == 0:
            seldom.append((moment.t, moment.q))
            progress((step + 1) / steps)
    t_w, q = (np.array(column) for column in zip(*seldom, strict=True))
    return {**{key: np.array([row[key] for row in rows]) for key in rows[0]}, "t_w": t_w, "q": q}
