"""A closed-loop run stored step by step, and its charts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import LoopStep
from helicoide.ik.objective import posture_at
from helicoide.ik.secondary import total
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.study import Chart, ChartLine, Interpretation, Motion, Progress, Statement
from helicoide.text import Text, untranslated

MAX_SAMPLES = 400
PROGRESS_EVERY = 500
Named = tuple[Text, "LoopRun"]

# Algorithm 1 against one gain: one measure in all studies.
FARTHER = Statement(
    Text(
        en="the joints tend to stay farther from their limits than with one gain",
        pt_BR="as juntas tendem a ficar mais longe dos limites do que com um só ganho",
    ),
    "fig. 38, §6.3",
    0.0,
    ">",
)
NEAREST = Interpretation(
    Text(en="the joint nearest to its limit counts", pt_BR="conta a junta mais próxima do seu limite"),
    Text(
        en="the mean of −w (eq. 12) is 0.02 % to 0.2 % greater: no farther",
        pt_BR="a média de −w (eq. 12) é 0,02 % a 0,2 % maior: não mais longe",
    ),
)


@dataclass(frozen=True, eq=False)
class LoopRun:
    """A run step by step: t (s,), s; q (s, n); errors (s, r), mm and rad; largest_velocity of a joint
    (s,), rad/s; the last step."""

    t: Array
    q: Array
    errors: Array
    largest_velocity: Array
    last: LoopStep

    @property
    def position_error(self) -> Array:
        """Position error (s,), mm."""
        return np.asarray(np.linalg.norm(self.errors[:, :3], axis=1))

    @property
    def orientation_error(self) -> Array:
        """Orientation error (s,), rad; zero if the orientation is free."""
        return np.asarray(np.linalg.norm(self.errors[:, 3:], axis=1))

    def since(self, t0: float) -> LoopRun:
        """The same run from t0, s."""
        return self._where(self.t >= t0 - 1e-9)

    def until(self, t1: float) -> LoopRun:
        """The same run up to t1, s."""
        return self._where(self.t <= t1 + 1e-9)

    def _where(self, s: NDArray[np.bool_]) -> LoopRun:
        return replace(self, t=self.t[s], q=self.q[s], errors=self.errors[s], largest_velocity=self.largest_velocity[s])

    def degrees(self, joint: int) -> tuple[float, float]:
        """The smallest and largest value of a joint, degrees; the first joint is 1."""
        return float(np.degrees(self.q[:, joint - 1].min())), float(np.degrees(self.q[:, joint - 1].max()))


def collected(moments: Iterable[LoopStep], seconds: float, progress: Progress = lambda share: None) -> LoopRun:
    """Collect the steps of a closed loop, with lengths in mm, up to a time, s."""
    t, q, errors, fastest = [], [], [], []
    for step, moment in enumerate(moments):
        if moment.t >= seconds:
            break
        t.append(moment.t)
        q.append(moment.q)
        errors.append(moment.task_error.error)
        fastest.append(np.abs(moment.solution.rates).max())
        last = moment
        if step % PROGRESS_EVERY == 0:
            progress(moment.t / seconds)
    return LoopRun(np.array(t), np.array(q), np.array(errors), np.array(fastest), last)


def subsampled_loop(values: Array) -> Array:
    """About `SHOWN` evenly spaced samples, including the first and the last."""
    return np.asarray(values[np.unique(np.linspace(0, len(values) - 1, MAX_SAMPLES).round().astype(int))])


def mean_cost(problem: Problem, q: Array) -> float:
    """The mean of −w along postures q (k, n), 1/(2n) Σ (off the middle over the range)² (Cerbaro 2022, eq. 12)."""
    chosen = setups.limit_distance()
    return float(np.mean([total(problem, chosen, posture_at(problem, one)).value for one in subsampled_loop(q)]))


TIME = Text(en="time (s)", pt_BR="tempo (s)")


def error_chart(figure: str, *named: Named) -> Chart:
    """Position errors of runs, mm, over time, logarithmic."""
    title, up = Text(en="Position error", pt_BR="Erro de posição"), Text(en="error (mm)", pt_BR="erro (mm)")
    return Chart(
        title,
        TIME,
        up,
        tuple(ChartLine(words, subsampled_loop(run.t), subsampled_loop(run.position_error)) for words, run in named),
        figure,
        True,
    )


def orientation_error_chart(figure: str, *named: Named) -> Chart:
    """Orientation errors of runs, rad, over time, logarithmic."""
    title, up = Text(en="Orientation error", pt_BR="Erro de orientação"), Text(en="error (rad)", pt_BR="erro (rad)")
    return Chart(
        title,
        TIME,
        up,
        tuple(ChartLine(words, subsampled_loop(run.t), subsampled_loop(run.orientation_error)) for words, run in named),
        figure,
        True,
    )


def limit_lines(problem: Problem, joint: int, seconds: float) -> tuple[ChartLine, ...]:
    """Both limits of a joint as horizontal lines, degrees; the first joint is 1."""
    bounds = (
        (Text(en="lower limit", pt_BR="limite inferior"), problem.limits.lower[joint - 1]),
        (Text(en="upper limit", pt_BR="limite superior"), problem.limits.upper[joint - 1]),
    )
    return tuple(ChartLine(title, np.array([0.0, seconds]), np.full(2, np.degrees(bound))) for title, bound in bounds)


def joint_charts(figure: str, problem: Problem, joints: tuple[int, ...], *named: Named) -> tuple[Chart, ...]:
    """A chart for each joint with its limits; the first joint is 1."""
    charts = []
    for j in joints:
        curves = tuple(
            ChartLine(title, subsampled_loop(run.t), np.degrees(subsampled_loop(run.q)[:, j - 1]))
            for title, run in named
        )
        up = Text(en="J{joint} (°)", pt_BR="J{joint} (°)").format(joint=j)
        title = Text(en="J{joint} between its limits", pt_BR="J{joint} entre seus limites").format(joint=j)
        charts.append(Chart(title, TIME, up, curves + limit_lines(problem, j, float(named[0][1].t[-1])), figure))
    return tuple(charts)


def pitch_chart(figure: str, name: str, *named: Named) -> Chart:
    """`pitch`, degrees, over time. name: its symbol in the source."""
    lines = tuple(
        ChartLine(title, subsampled_loop(run.t), np.degrees(pitch(subsampled_loop(run.q)))) for title, run in named
    )
    title = Text(en="Orientation {name}, left free", pt_BR="Orientação {name}, deixada livre").format(name=name)
    return Chart(title, TIME, untranslated(f"{name} (°)"), lines, figure)


def pitch(q: Array) -> Array:
    """φ = q₁ + q₂ + q₃ of the ORCA, q₂ + q₃ + q₄ of the Movemaster, rad. Args: q (s, n)."""
    return np.asarray((q if q.shape[1] == 3 else q[:, 1:4]).sum(axis=1))


def tool_path_chart(figure: str, problem: Problem, axes: str, wanted: Array, *named: Named) -> Chart:
    """The path of the tool in a plane, such as "xy". Args: wanted (k, 3), m: the path that is asked for."""
    i, j = ("xyz".index(axis) for axis in axes)
    ways = (
        (words, np.array([setups.tool_position(problem, q) for q in subsampled_loop(run.q)])) for words, run in named
    )
    asked = (Text(en="path asked for", pt_BR="trajetória pedida"), wanted)
    lines = tuple(ChartLine(words, 1000 * way[:, i], 1000 * way[:, j]) for words, way in (asked, *ways))
    title = Text(en="Path of the end effector in {plane}", pt_BR="Caminho do efetuador em {plane}").format(plane=axes)
    return Chart(title, untranslated(f"{axes[0]} (mm)"), untranslated(f"{axes[1]} (mm)"), lines, figure)


def loop_motion(robot: str, title: Text, run: LoopRun) -> Motion:
    """A run as a motion of a study."""
    return Motion(robot, subsampled_loop(run.t), subsampled_loop(run.q), title=title)


def joint_chart(figure: str, run: LoopRun, joints: tuple[int, ...]) -> Chart:
    """Joint values, degrees, over time; the first joint is 1."""
    t, q = subsampled_loop(run.t), np.degrees(subsampled_loop(run.q))
    lines = tuple(ChartLine(untranslated(f"J{j}"), t, q[:, j - 1]) for j in joints)
    return Chart(Text(en="Joints", pt_BR="Juntas"), TIME, Text(en="joint (°)", pt_BR="junta (°)"), lines, figure)


def share_of_runs(progress: Progress, index: int, count: int) -> Progress:
    """The progress of one of `count` runs of equal length; the first index is 0."""
    return lambda share: progress((index + min(1.0, share)) / count)
