"""Runs of a method along a trajectory, and what is measured on them (Vargas 2013, §2.4, §4.5)."""

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
from helicoide.ik.clik import Aim, Aiming, OrientationError, followed, tool_aim
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import RANK
from helicoide.studies.study import Progress
from helicoide.studies.vargas.paths import Path
from helicoide.text import Text

Key = TypeVar("Key")
Instants = NDArray[np.bool_]

IN_PLANE, WITH_ANGLE, IN_SPACE, POSE = [0, 1], [0, 1, 5], [0, 1, 2], [0, 1, 2, 3, 4, 5]
# how many instants of a run charts and the motion of the arm show
SHOWN = 2000


@dataclass(frozen=True, eq=False)
class Way:
    """A method by its name, with its settings, and what it is called in tables."""

    title: Text
    method: str
    options: Mapping[str, Any] = field(default_factory=dict)


def way(method: str, note: str = "", **options: Any) -> Way:
    """A method with settings; its title, with a note that tells it from others, such as "γ = 25"."""
    title, more = methods.named(method).TITLE, digits(note and f", {note}")
    return Way(Text(en=title.en + more.en, pt_BR=title.pt_BR + more.pt_BR), method, options)


def digits(note: str) -> Text:
    """Symbols and numbers, such as "γ = 2.5", with a comma in Portuguese."""
    return Text(en=note, pt_BR=note.replace(".", ","))


@dataclass(frozen=True, eq=False)
class Run:
    """A run step by step: t (k,), s; q (k, n), rad; e (k, r) and J (k, r, n) in the arm's ℓ; q̇ (k, n), rad/s.

    ahead (k, r): ẋ_d, and −f in the last row of an augmented aim. figures: of the solutions at every `stride`-th step.
    """

    t: Array
    q: Array
    e: Array
    ahead: Array
    rates: Array
    J: Array
    stride: int
    figures: tuple[Mapping[str, float], ...]

    @cached_property
    def size(self) -> Array:
        """‖e‖ (k,)."""
        return sizes(self.e)

    @property
    def shown(self) -> Array:
        """The instants of `figures`, s."""
        return self.t[:: self.stride]

    def figure(self, symbol: str) -> Array:
        """A figure of the method at the instants of `shown`."""
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
        return np.asarray(self.sigma[:, 0] / np.maximum(self.sigma[:, -1], RANK * self.sigma[:, 0]))

    @property
    def push(self) -> Array:
        """The largest joint acceleration from each step to the next, (k − 1,), rad/s²."""
        return np.asarray(np.abs(np.diff(self.rates, axis=0)).max(axis=1) / (self.t[1] - self.t[0]))


def tracking(
    problem: Problem,
    path: Path,
    rows: list[int],
    R_target: Array | None = None,
    measure: OrientationError = "quaternion",
) -> Aiming:
    """Aim at a trajectory, in lengths of the problem's ℓ, with some rows of the twist of the tool."""
    T, ahead, first = np.eye(4), np.zeros(6), len(rows) if rows == list(range(len(rows))) else 0
    if R_target is not None:
        T[:3, :3] = R_target

    def aiming(q: Array, t: float) -> Aim:
        x, v = path(t)
        T[:3, 3], ahead[:3] = x, v
        T[:3, 3] *= problem.length
        ahead[:3] *= problem.length
        poses = link_poses(problem.robot.chain, q)
        aim = tool_aim(problem, poses, T, R_target is not None, ahead, measure)
        picked: Any = slice(first) if first else rows
        return Aim(aim.J[picked], aim.error[picked], aim.ahead[picked])

    return aiming


def record(
    problem: Problem,
    by: Way,
    aiming: Aiming,
    gains: Array | float,
    q: Sequence[float] | Array,
    dt: float,
    seconds: float,
    progress: Progress = lambda share: None,
) -> Run:
    """A run of a method from q (n,), rad, in steps of dt, s; gains: Λ, 1/s."""
    method, steps = methods.named(by.method), round(seconds / dt) + 1
    stride = max(1, steps // SHOWN)
    moments = followed(problem, method, method.Options(**by.options), aiming, gains, np.array(q, float), dt)
    columns: list[tuple[float, Array, Array, Array, Array, Array]] = []
    figures = []
    for i, now in enumerate(islice(moments, steps)):
        columns.append((now.t, now.q, now.aim.error, now.aim.ahead, now.solution.rates, now.aim.J))
        if i % stride == 0:
            figures.append(now.solution.figures)
            progress(i / steps)
    t, at, e, ahead, rates, J = (np.array(column) for column in zip(*columns, strict=True))
    return Run(t, at, e, ahead, rates, J, stride, tuple(figures))


def each(runs: Mapping[Key, Callable[[Progress], Run]], progress: Progress) -> dict[Key, Run]:
    """Runs one after another; progress is told the share of all."""
    done: dict[Key, Run] = {}
    for key, one in runs.items():
        done[key] = one(lambda share: progress((len(done) + share) / len(runs)))
    progress(1.0)
    return done


def compared(
    problem: Problem,
    ways: Mapping[str, Way],
    aiming: Aiming,
    gains: Array | float,
    q: Sequence[float] | Array,
    dt: float,
    seconds: float,
    progress: Progress,
) -> dict[str, Run]:
    """A run of each of several methods, as in `record`."""
    return each(
        {key: partial(record, problem, one, aiming, gains, q, dt, seconds) for key, one in ways.items()}, progress
    )


def turned(axis: int, angle: float) -> Array:
    """Rotation about y (axis 1) or z (axis 2), (3, 3)."""
    c, s = cos(angle), sin(angle)
    return np.array([[[c, 0, s], [0, 1, 0], [-s, 0, c]], [[c, -s, 0], [s, c, 0], [0, 0, 1]]][axis - 1])


def largest(values: Array, when: Instants | slice = slice(None)) -> float:
    """The largest absolute entry over the chosen instants."""
    return float(np.abs(values[when]).max())


def sizes(vectors: Array) -> Array:
    """‖e‖ at every instant, (k,), of e (k, r)."""
    return np.asarray(np.linalg.norm(vectors, axis=1))


def left_at(run: Run, by: float = 0.01) -> float:
    """When some joint has first moved by an angle, rad, from where it began, s; infinite when none has."""
    moved = np.abs(run.q - run.q[0]).max(axis=1) > by
    return float(run.t[moved.argmax()]) if moved.any() else np.inf
