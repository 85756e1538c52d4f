"""A closed loop run to its end and kept step by step."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.clik import Moment
from helicoide.kinematics.chain import Array
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Motion, Progress, Row
from helicoide.text import Text, same

SHOWN = 600
TOLD_EVERY = 500


@dataclass(frozen=True, eq=False)
class Run:
    """A run step by step: t (s,), s; q (s, n); error of position (s,), mm; fastest joint (s,), rad/s; last moment."""

    t: Array
    q: Array
    error: Array
    fastest: Array
    last: Moment

    def since(self, t0: float) -> Run:
        """The same run from t0, s."""
        s = self.t >= t0 - 1e-9
        return Run(self.t[s], self.q[s], self.error[s], self.fastest[s], self.last)

    def degrees(self, joint: int) -> tuple[float, float]:
        """The range of a joint, the first is 1."""
        return float(np.degrees(self.q[:, joint - 1].min())), float(np.degrees(self.q[:, joint - 1].max()))


def ran(moments: Iterable[Moment], seconds: float, progress: Progress = lambda share: None) -> Run:
    """The moments of a closed loop whose lengths are in mm, up to a time."""
    t, q, error, fastest = [], [], [], []
    for step, moment in enumerate(moments):
        if moment.t >= seconds:
            break
        t.append(moment.t)
        q.append(moment.q)
        error.append(np.linalg.norm(moment.aim.error[:3]))
        fastest.append(np.abs(moment.solution.rates).max())
        last = moment
        if step % TOLD_EVERY == 0:
            progress(moment.t / seconds)
    return Run(np.array(t), np.array(q), np.array(error), np.array(fastest), last)


def few(values: Array) -> Array:
    """Some hundred of many samples, evenly, with the first and the last."""
    return np.asarray(values[np.unique(np.linspace(0, len(values) - 1, SHOWN).round().astype(int))])


TIME = Text(en="time (s)", pt_BR="tempo (s)")
ERROR = Text(en="position error (mm)", pt_BR="erro de posição (mm)")


def ranges(run: Run, told: tuple[tuple[float, float], ...], tolerance: float, assumed: Text | None) -> list[Row]:
    """The range of each joint beside the digest's, degrees."""
    rows = []
    for j, bounds in enumerate(told, 1):
        for which, ours, digest in zip(_ENDS, run.degrees(j), bounds, strict=True):
            named = which.format(joint=j)
            rows.append(Row(named, ours, digest, tolerance, "°", FIGURE_ONLY, assumed=assumed))
    return rows


_ENDS = (
    Text(en="J{joint}, least", pt_BR="J{joint}, mínimo"),
    Text(en="J{joint}, largest", pt_BR="J{joint}, máximo"),
)


def error_chart(*named: tuple[Text, Run]) -> Chart:
    """Position errors of runs, mm, over time."""
    lines = tuple(Line(title, few(run.t), few(run.error)) for title, run in named)
    return Chart(Text(en="Position error", pt_BR="Erro de posição"), TIME, ERROR, lines)


def limit_lines(problem: Problem, joint: int, seconds: float) -> tuple[Line, ...]:
    """Both limits of a joint, the first is 1, as level lines, degrees."""
    bounds = (
        (Text(en="lower limit", pt_BR="limite inferior"), problem.limits.lower[joint - 1]),
        (Text(en="upper limit", pt_BR="limite superior"), problem.limits.upper[joint - 1]),
    )
    return tuple(Line(title, np.array([0.0, seconds]), np.full(2, np.degrees(bound))) for title, bound in bounds)


def joint_charts(problem: Problem, joints: tuple[int, ...], *named: tuple[Text, Run]) -> tuple[Chart, ...]:
    """A chart for each joint, the first is 1: the runs between its limits."""
    charts = []
    for j in joints:
        curves = tuple(Line(title, few(run.t), np.degrees(few(run.q)[:, j - 1])) for title, run in named)
        up = Text(en="J{joint} (°)", pt_BR="J{joint} (°)").format(joint=j)
        title = Text(en="J{joint} between its limits", pt_BR="J{joint} entre seus limites").format(joint=j)
        charts.append(Chart(title, TIME, up, curves + limit_lines(problem, j, float(named[0][1].t[-1]))))
    return tuple(charts)


def motion(robot: str, run: Run) -> Motion:
    """A run as the motion of a study."""
    return Motion(robot, few(run.t), few(run.q))


def joint_chart(run: Run, joints: tuple[int, ...]) -> Chart:
    """Joints, degrees, over time; the first is 1."""
    t, q = few(run.t), np.degrees(few(run.q))
    lines = tuple(Line(same(f"J{j}"), t, q[:, j - 1]) for j in joints)
    return Chart(Text(en="Joints", pt_BR="Juntas"), TIME, Text(en="joint (°)", pt_BR="junta (°)"), lines)


def part(progress: Progress, index: int, count: int) -> Progress:
    """The progress of one of several runs of equal length, the first is 0."""
    return lambda share: progress((index + min(1.0, share)) / count)
