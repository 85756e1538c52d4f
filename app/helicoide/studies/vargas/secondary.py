"""Vargas 2013, §4.7: the planar arm with the modified law and one additional row, Λ = 5 I."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import objectives
from helicoide.ik.arm_points import along_links
from helicoide.ik.clik import TaskFunction
from helicoide.ik.secondary import Chosen, augmented
from helicoide.kinematics.forward import link_poses
from helicoide.studies.study import Chart, Progress
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import PathFunction, path_5, path_points
from helicoide.studies.vargas.runs import PLANAR_ROWS, Experiment, MethodRun, method_settings, run_method, tracking
from helicoide.studies.vargas.table import ERROR_FROM, FASTEST_FROM, over_time, transient_end
from helicoide.text import Text

SECONDS, RATE = 32.0, 5.0
SINCE = transient_end(RATE)
FASTEST_LATER, ERROR_LATER = FASTEST_FROM.format(since=SINCE), ERROR_FROM.format(since=SINCE)
NEAREST_LATER = Text(en="least distance from 2 s on", pt_BR="menor distância a partir de 2 s")
MODIFIED = "filtered_modified"
LENGTH = 4.0
COST = Text(en="cost of the additional row", pt_BR="custo da linha adicional")


def no_progress(share: float) -> None:
    """Ignore progress."""


def single_objective(name: str, **options: Any) -> Chosen:
    """One secondary objective with changed options."""
    objective = objectives.named(name)
    return [(objective, replace(objective.Options(), **options))]


def planar_tracking(path: PathFunction) -> TaskFunction:
    """The task of following a trajectory with the planar arm; its orientation is free."""
    return tracking(planar_problem(), path, PLANAR_ROWS)


def run_modified_filter(
    aiming: TaskFunction, start: Sequence[float], gain: float, dt: float, progress: Progress, seconds: float
) -> MethodRun:
    """A run with the modified law and gain γ."""
    return run_method(
        Experiment(planar_problem(), aiming, RATE, start, dt, seconds), method_settings(MODIFIED, gain=gain), progress
    )


def cost_chart(runs: Mapping[Text, MethodRun], figure: str) -> Chart:
    """The cost f; the last row of ν₊ is −f."""
    return over_time(COST, "f", runs, lambda run: -run.feedforward[:, -1], figure)


def tool_points(run: MethodRun, path: PathFunction) -> Array:
    """The tool position, (k, 2), ℓ: p = p_d − e."""
    return np.asarray(path_points(path, run.t)[:, :2] - run.e[:, :2])


def link_distances(run: MethodRun, points: Callable[[float], Array], every: float = 0.05) -> tuple[Array, Array]:
    """The least distances, ℓ, between forty points on each link and `points`(t) (k, 3).

    Returns times, s, `every` s apart, and the distances.
    """
    arm, step = planar_problem().robot, max(1, round(every / (run.t[1] - run.t[0])))
    fine, t = along_links(arm, 40), run.t[::step]
    away = [
        np.linalg.norm(fine.at(link_poses(arm.chain, q))[:, None] - points(now), axis=2).min()
        for q, now in zip(run.q[::step], t, strict=True)
    ]
    return t, np.array(away)


def least_link_distance(run: MethodRun, points: Callable[[float], Array]) -> float:
    """The least distance after the transient, ℓ."""
    t, away = link_distances(run, points)
    return float(away[t >= SINCE - 1e-9].min())


def obstacle_near_links(
    mu: tuple[float, float],
    per_link: int,
    gain: float,
    dt: float,
    seconds: float,
    progress: Progress = no_progress,
) -> tuple[MethodRun, float]:
    """Fig. 4.42: trajectory 5 with an obstacle at μ (x, y), ℓ, whose cost acts on `per_link` points of each link.

    Returns the run, and the least distance of the arm from μ after the transient, ℓ. per_link 0: no cost.
    """
    aiming = planar_tracking(path_5)
    if per_link:
        at = {"x": mu[0], "y": mu[1], "z": 0.0, "a": 0.2, "b": 0.2, "c": 0.2}
        hill = single_objective("ellipsoid", weight=2.0, where="links", per_link=per_link, **at)
        aiming = augmented(planar_problem(), hill, aiming)
    run = run_modified_filter(aiming, (0.9, -1.2, -0.6), gain, dt, progress, seconds)
    return run, least_link_distance(run, lambda t: np.array([[*mu, 0.0]]))
