"""Runs of a method along a trajectory, and quantities measured on them (Vargas 2013, §2.4, §4.5)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import islice
from math import cos, sin
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.ik import Problem, methods
from helicoide.ik.clik import ControlLaw, OrientationError, TaskError, TaskFunction, closed_loop, tool_task_error
from helicoide.ik.methods import configured_method
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.studies.study import Progress
from helicoide.studies.vargas.paths import PathFunction
from helicoide.text import Text, with_decimal_comma

Key = TypeVar("Key")
TimeMask = NDArray[np.bool_]

PLANAR_ROWS, WITH_ANGLE, POSITION_ROWS, POSE = [0, 1], [0, 1, 5], [0, 1, 2], [0, 1, 2, 3, 4, 5]
# number of times of a run that charts show
MAX_POINTS = 2000


@dataclass(frozen=True, eq=False)
class MethodSettings:
    """A method with options, and its title in tables."""

    title: Text
    method: str
    options: Mapping[str, Any] = field(default_factory=dict)


def method_settings(method: str, note: str = "", **options: Any) -> MethodSettings:
    """A method with options; its title ends with a note that distinguishes it, such as "γ = 25"."""
    title, more = methods.named(method).TITLE, with_decimal_comma(note and f", {note}")
    return MethodSettings(Text(en=title.en + more.en, pt_BR=title.pt_BR + more.pt_BR), method, options)


@dataclass(frozen=True, eq=False)
class MethodRun:
    """A run step by step: t (k,), s; q (k, n), rad; e (k, r) and J (k, r, n) in the arm's ℓ; q̇ (k, n), rad/s.

    feedforward (k, r): ẋ_d, and −f in the last row of an augmented task. figures: what the method
    reports at every `stride`-th step.
    """

    t: Array
    q: Array
    e: Array
    feedforward: Array
    joint_velocities: Array
    J: Array
    stride: int
    figures: tuple[Mapping[str, float], ...]

    @cached_property
    def error_norm(self) -> Array:
        """‖e‖ (k,)."""
        return row_norms(self.e)

    @property
    def figure_times(self) -> Array:
        """The times of `figures`, s."""
        return self.t[:: self.stride]

    def figure(self, symbol: str) -> Array:
        """A quantity that the method reports, at the times of `shown`."""
        return np.array([one[symbol] for one in self.figures])

    @cached_property
    def sigma(self) -> Array:
        """The singular values of J, (k, p)."""
        return np.asarray(np.linalg.svd(self.J, compute_uv=False))

    @property
    def w(self) -> Array:
        """Manipulability (k,), the product of the singular values. Source: Vargas 2013, eq. 3.5."""
        return np.asarray(self.sigma.prod(axis=1))

    @property
    def condition(self) -> Array:
        """Condition number (k,), σ₁/σₚ, at most 1/`RANK`. Source: Vargas 2013, §3.3."""
        return np.asarray(self.sigma[:, 0] / np.maximum(self.sigma[:, -1], RANK_TOLERANCE * self.sigma[:, 0]))

    @property
    def joint_acceleration(self) -> Array:
        """The largest joint acceleration between consecutive steps, (k − 1,), rad/s²."""
        return np.asarray(np.abs(np.diff(self.joint_velocities, axis=0)).max(axis=1) / (self.t[1] - self.t[0]))


def tracking(
    problem: Problem,
    path: PathFunction,
    rows: list[int],
    R_target: Array | None = None,
    measure: OrientationError = "quaternion",
) -> TaskFunction:
    """The task of following a trajectory, in the length unit ℓ of the problem, with chosen rows of the tool's twist."""
    T, ahead, first = np.eye(4), np.zeros(6), len(rows) if rows == list(range(len(rows))) else 0
    if R_target is not None:
        T[:3, :3] = R_target

    def aiming(q: Array, t: float) -> TaskError:
        x, v = path(t)
        T[:3, 3], ahead[:3] = x, v
        T[:3, 3] *= problem.length
        ahead[:3] *= problem.length
        poses = link_poses(problem.robot.chain, q)
        aim = tool_task_error(problem, poses, T, R_target is not None, ahead, measure)
        picked: Any = slice(first) if first else rows
        return TaskError(aim.J[picked], aim.error[picked], aim.feedforward[picked])

    return aiming


@dataclass(frozen=True, eq=False)
class Experiment:
    """What all methods of a comparison share: arm, task, gains Λ, 1/s, start (n,), rad, step and duration, s."""

    problem: Problem
    aiming: TaskFunction
    gains: Array | float
    start: Sequence[float] | Array
    dt: float
    seconds: float


def run_method(experiment: Experiment, by: MethodSettings, progress: Progress = lambda share: None) -> MethodRun:
    """A run of a method in an experiment."""
    steps = round(experiment.seconds / experiment.dt) + 1
    stride = max(1, steps // MAX_POINTS)
    law = ControlLaw(configured_method(by.method, **by.options), experiment.gains, experiment.dt)
    moments = closed_loop(experiment.problem, law, experiment.aiming, np.array(experiment.start, float))
    columns: list[tuple[float, Array, Array, Array, Array, Array]] = []
    figures = []
    for i, now in enumerate(islice(moments, steps)):
        columns.append(
            (now.t, now.q, now.task_error.error, now.task_error.feedforward, now.solution.rates, now.task_error.J)
        )
        if i % stride == 0:
            figures.append(now.solution.figures)
            progress(i / steps)
    t, at, e, ahead, rates, J = (np.array(column) for column in zip(*columns, strict=True))
    return MethodRun(t, at, e, ahead, rates, J, stride, tuple(figures))


def run_each(runs: Mapping[Key, Callable[[Progress], MethodRun]], progress: Progress) -> dict[Key, MethodRun]:
    """Do runs one after another; progress gets the completed fraction of all."""
    done: dict[Key, MethodRun] = {}
    for key, one in runs.items():
        done[key] = one(lambda share: progress((len(done) + share) / len(runs)))
    progress(1.0)
    return done


def run_methods(experiment: Experiment, ways: Mapping[str, MethodSettings], progress: Progress) -> dict[str, MethodRun]:
    """A run of each of several methods in the same experiment."""
    return run_each({key: partial(run_method, experiment, one) for key, one in ways.items()}, progress)


def rotation_about(axis: int, angle: float) -> Array:
    """Rotation about y (axis 1) or z (axis 2), (3, 3)."""
    c, s = cos(angle), sin(angle)
    return np.array([[[c, 0, s], [0, 1, 0], [-s, 0, c]], [[c, -s, 0], [s, c, 0], [0, 0, 1]]][axis - 1])


def largest_absolute(values: Array, when: TimeMask | slice = slice(None)) -> float:
    """The largest absolute value at the chosen times."""
    return float(np.abs(values[when]).max())


def row_norms(vectors: Array) -> Array:
    """‖e‖ at each time, (k,), of e (k, r)."""
    return np.asarray(np.linalg.norm(vectors, axis=1))


def first_motion_time(run: MethodRun, by: float = 0.01) -> float:
    """The time, s, at which a joint has first moved by an angle, rad, from its start; infinite if none has."""
    moved = np.abs(run.q - run.q[0]).max(axis=1) > by
    return float(run.t[moved.argmax()]) if moved.any() else np.inf
