"""A closed loop run to its end and kept step by step."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from helicoide.ik.clik import Moment
from helicoide.kinematics.chain import Array
from helicoide.studies.study import Line, Motion, Progress
from helicoide.text import Text

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


def motion(robot: str, run: Run) -> Motion:
    """A run as the motion of a study."""
    return Motion(robot, few(run.t), few(run.q))


def joint_lines(run: Run, joints: tuple[int, ...], suffix: Text | None = None) -> tuple[Line, ...]:
    """Curves of joints, degrees, over time; the first joint is 1."""
    t, q = few(run.t), np.degrees(few(run.q))
    end = suffix or Text(en="", pt_BR="")
    return tuple(Line(Text(en=f"J{j}{end.en}", pt_BR=f"J{j}{end.pt_BR}"), t, q[:, j - 1]) for j in joints)


def part(progress: Progress, index: int, count: int) -> Progress:
    """The progress of one of several runs of equal length, the first is 0."""
    return lambda share: progress((index + min(1.0, share)) / count)
