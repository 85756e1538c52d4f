"""Sims. 10 to 13 of Vargas 2013: position of the Zebra-ZERO with three joints, in cm, λ = 2, Θ(0) = 0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arms import REACH, zebra_arm
from helicoide.studies.vargas.paths import PathFunction, path_8, path_points
from helicoide.studies.vargas.runs import (
    POSITION_ROWS,
    Experiment,
    MethodRun,
    MethodSettings,
    TimeMask,
    method_settings,
    row_norms,
    run_methods,
    tracking,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    ERROR_FROM,
    FASTEST_FROM,
    errors_chart,
    fastest_chart,
    figures_chart,
    joint_velocity_chart,
    joints_chart,
    path_chart,
    runs_by_title,
    study_result,
    transient_end,
    w_chart,
    zebra_motions,
)
from helicoide.text import Text

RATE = 2.0
SINCE = transient_end(RATE)
FASTEST_LATER, ERROR_LATER = FASTEST_FROM.format(since=SINCE), ERROR_FROM.format(since=SINCE)
LARGEST_ACCELERATION = Text(
    en="largest acceleration from {since:g} s on", pt_BR="maior aceleração a partir de {since:g} s"
).format(since=SINCE)
DAMPED: dict[str, Any] = {"damping": 300.0, "threshold": 1e3}
DAMPING = method_settings("damped_by_manipulability", **DAMPED)
SQUARED = method_settings("damped_by_manipulability", "(1 − w/w₀)²", **DAMPED, exponent="2")
PSEUDOINVERSE = method_settings("pseudoinverse")


def run_on_zebra(
    path: PathFunction, start: Array, ways: Mapping[str, MethodSettings], dt: float, seconds: float, progress: Progress
) -> dict[str, MethodRun]:
    """A run of each method along a trajectory."""
    arm = zebra_arm()
    return run_methods(Experiment(arm, tracking(arm, path, POSITION_ROWS), RATE, start, dt, seconds), ways, progress)


class Drawing(NamedTuple):
    """A trajectory, the two axes in which it is drawn, and the figures of the source: of the runs, and of the paths."""

    path: PathFunction
    plane: tuple[int, int]
    figure: str
    path_figure: str


def position_result(
    rows: Sequence[Row],
    ways: Mapping[str, MethodSettings],
    runs: Mapping[str, MethodRun],
    drawing: Drawing,
    shown: tuple[str, ...],
) -> Result:
    """The result: rows, charts that the source shows, V_c of the filtered inverses, δ of the damped ones, and motions.

    shown: the runs whose joint velocities are drawn; the joint angles are drawn for the first of them.
    """
    names, plane, place = runs_by_title(ways, runs), drawing.plane, drawing.figure
    filtered = {ways[key].title: run for key, run in runs.items() if ways[key].method.startswith("filtered")}
    damped = {ways[key].title: run for key, run in runs.items() if ways[key].method.startswith("damped")}
    desired = path_points(drawing.path, next(iter(runs.values())).t)
    drawn = {name: (desired - run.e)[:, plane] for name, run in names.items()}
    across, up = (f"{'xyz'[axis]}, cm" for axis in plane)
    charts = [
        errors_chart(names, "cm", place, log=True),
        *(joint_velocity_chart(runs[key], ways[key].title, place) for key in shown),
        figures_chart(Text(en="inversion error of Θ", pt_BR="erro de inversão de Θ"), "V_c", filtered, "", place),
        *([figures_chart(DAMPED_TITLE, "δ", damped, "cm²", place)] if damped else []),
        path_chart({DESIRED: desired[:, plane], **drawn}, across, up, drawing.path_figure),
        w_chart(names, "cm³", place),
        joints_chart(runs[shown[0]], ways[shown[0]].title, place),
        fastest_chart(names),
    ]
    return study_result(rows, charts[:8], zebra_motions(names))


DAMPED_TITLE = Text(en="damping", pt_BR="amortecimento")


# Sims. 12 and 13: trajectory 8 leaves the workspace.


def effector_positions(run: MethodRun) -> Array:
    """The end-effector position on trajectory 8, (k, 3), cm: p = p_d − e."""
    return np.asarray(path_points(path_8, run.t) - run.e)


def outside_workspace(t: Array) -> TimeMask:
    """Whether trajectory 8 is outside the workspace at times t, (k,)."""
    return np.asarray(row_norms(path_points(path_8, t)) > REACH)


def border_dips(run: MethodRun) -> tuple[Array, Array]:
    """Times, s, and depths, cm, at which the end effector moves inwards from the border of the workspace.

    Only while trajectory 8 is outside; dips of less than 1e-3 cm do not count.
    """
    outside = (run.t > 11.41) & (run.t < 13.2)
    depth = REACH - row_norms(effector_positions(run)[outside])
    inner = np.flatnonzero((depth[1:-1] > depth[:-2]) & (depth[1:-1] >= depth[2:]) & (depth[1:-1] > 1e-3)) + 1
    return run.t[outside][inner], depth[inner]


def first_border_dip(run: MethodRun) -> float:
    """The depth, cm, of the first dip; 0 without dips."""
    depth = border_dips(run)[1]
    return float(depth[0]) if depth.size else 0.0


def elbow_frequency(run: MethodRun) -> float:
    """The frequency, Hz, of the elbow outside the workspace; two dips are one period. 0 without dips."""
    when = border_dips(run)[0][:4]
    return float(0.5 / np.diff(when).mean()) if when.size > 1 else 0.0


def border_distance(run: MethodRun) -> float:
    """The largest distance, cm, from the border point nearest to trajectory 8, while the trajectory is outside."""
    outside = (run.t > 11.6) & (run.t < 13.6)
    desired = path_points(path_8, run.t[outside])
    return float(row_norms(effector_positions(run)[outside] - REACH * desired / row_norms(desired)[:, None]).max())


def errors_after_return(run: MethodRun) -> tuple[float, float, float]:
    """‖e‖, cm, 0.25, 0.5 and 1 s after trajectory 8 returns to the workspace at 13.73 s."""
    quarter, half, whole = (float(np.interp(13.73 + after, run.t, run.error_norm)) for after in (0.25, 0.5, 1.0))
    return quarter, half, whole
