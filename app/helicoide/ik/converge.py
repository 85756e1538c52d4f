"""Iterating to a pose that stands still, and along a path where no point is left before it is met.

    q ← q + κ · method(J, e),   κ the step factor, until ‖e_p‖ and ‖e_o‖ are small

Source: Cerbaro 2022, §4.4.2–4.4.4 (iterative convergence) and §6.1 (inner convergence along a path).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from enum import Enum
from itertools import islice
from math import inf
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import LoopStep, TaskError, TaskFunction, closed_loop
from helicoide.ik.method import Method
from helicoide.text import Text

CAP, CAP_PER_POINT = 200, 60
# An arm that so many times moves less than this, rad or m, stands still; a method that starts from nothing may pause.
PAUSES, AT_REST = 5, 1e-9
# Below this cosine between an error and the rows of J no joint motion makes it smaller.
UNFELT = 1e-6

# A closed loop that is still to be told what to aim at, where to start, and what it remembers: `by_method` makes one.
Run = Callable[[TaskFunction, Array, Any], Iterator[LoopStep]]


@dataclass(frozen=True)
class Tolerance:
    """What is near enough: position, m, orientation, rad."""

    position: float = 1e-3
    orientation: float = 0.01

    def holds(self, position: float, orientation: float) -> bool:
        """Whether errors, m and rad, are within it."""
        return position <= self.position and orientation <= self.orientation


INNER = Tolerance(position=0.010, orientation=inf)


class Convergence(Enum):
    """How an iteration ended, in words."""

    CONVERGED = Text(
        en="Converged after {n} iterations; {mm:.2g} mm and {rad:.2g} rad are left.",
        pt_BR="Convergiu em {n} iterações; restam {mm:.2g} mm e {rad:.2g} rad.",
    )
    CAPPED = Text(
        en="Not there after {n} iterations, the most that are tried; {mm:.3g} mm and {rad:.3g} rad are left.",
        pt_BR="Não chegou em {n} iterações, o máximo que se tenta; restam {mm:.3g} mm e {rad:.3g} rad.",
    )
    UNFELT = Text(
        en="The arm stands still after {n} iterations with {mm:.3g} mm and {rad:.3g} rad left: it is at a singular "
        "posture or at the edge of its reach, and no joint motion brings the tool nearer.",
        pt_BR="O braço parou após {n} iterações, faltando {mm:.3g} mm e {rad:.3g} rad: está numa postura singular ou "
        "na borda do alcance, e nenhum movimento das juntas aproxima o efetuador.",
    )
    HELD = Text(
        en="The arm stands still after {n} iterations with {mm:.3g} mm and {rad:.3g} rad left: joint motions that "
        "would bring the tool nearer exist, but the method does not give them.",
        pt_BR="O braço parou após {n} iterações, faltando {mm:.3g} mm e {rad:.3g} rad: há movimentos das juntas que "
        "aproximariam o efetuador, mas o método não os dá.",
    )


@dataclass(frozen=True, eq=False)
class Report:
    """How an iteration went.

    q (n,), rad or m, at the end; errors (k + 1, 2): position, m, and orientation, rad, at the start and after each of
    k iterations; memory: of the run, to go on with.
    """

    q: Array
    errors: Array
    outcome: Convergence
    memory: Any = None

    @property
    def iterations(self) -> int:
        """How many steps were taken."""
        return len(self.errors) - 1

    @property
    def reached(self) -> bool:
        """Whether the error came within the tolerance."""
        return self.outcome is Convergence.CONVERGED

    @property
    def words(self) -> Text:
        """The outcome as a sentence."""
        position, orientation = self.errors[-1]
        return self.outcome.value.format(n=self.iterations, mm=1000 * position, rad=orientation)


def loop_of(
    problem: Problem,
    method: Method,
    options: Any,
    factor: float,
    push: Callable[[Array, float], Array] | None = None,
    dt: float = 1.0,
) -> Run:
    """The closed loop of a method with Λ Δt = κ, the step factor.

    dt, s: how long an iteration lasts, for q̇₀ and for methods that count time.
    """
    return lambda aiming, q, memory: closed_loop(problem, method, options, aiming, factor / dt, q, dt, push, memory)


def frozen_reference(aiming: TaskFunction, t: float) -> TaskFunction:
    """The same aim as it is at one instant, s, without its velocity; objectives are added to it afterwards."""

    def aim(q: Array, _: float) -> TaskError:
        now = aiming(q, t)
        return replace(now, feedforward=np.zeros(len(now.feedforward)))

    return aim


def error_norms(problem: Problem, aim: TaskError) -> tuple[float, float]:
    """‖e_p‖, m, and ‖e_o‖, rad, of an aim whose first three rows are the position."""
    return problem.length * float(np.linalg.norm(aim.error[:3])), float(np.linalg.norm(aim.error[3:]))


def converged(
    problem: Problem,
    run: Run,
    aiming: TaskFunction,
    q: Array,
    tolerance: Tolerance = Tolerance(),
    cap: int = CAP,
    least: int = 0,
    memory: Any = None,
) -> Report:
    """Iterate from q (n,) until the error is within the tolerance, the arm stands still, or `cap` steps are taken.

    aiming: at what stands still, see `still`; least: steps that are taken in any case.
    """
    errors: list[tuple[float, float]] = []
    outcome, pauses, coming = Convergence.CAPPED, 0, memory
    for moment in islice(run(aiming, q, memory), cap + 1):
        pauses = pauses + 1 if errors and np.abs(moment.q - q).max() < AT_REST else 0
        q, memory, coming = moment.q, coming, moment.memory
        errors.append(error_norms(problem, moment.task_error))
        if len(errors) > least and tolerance.holds(*errors[-1]):
            outcome = Convergence.CONVERGED
            break
        if pauses == PAUSES:
            outcome = _at_rest(moment.task_error)
            break
    return Report(q, np.array(errors), outcome, memory)


def _at_rest(aim: TaskError) -> Convergence:
    """Why the arm stands still: because Jᵀ e = 0, or because of the method."""
    felt = np.linalg.norm(aim.J.T @ aim.error)
    return (
        Convergence.UNFELT if felt <= UNFELT * np.linalg.norm(aim.J) * np.linalg.norm(aim.error) else Convergence.HELD
    )


@dataclass(frozen=True, eq=False)
class PathReport:
    """How a sampled path went: a report for each of its points."""

    reports: tuple[Report, ...]

    @property
    def refused(self) -> dict[int, float]:
        """The points that were not met within the tolerance: index and error of position, m."""
        return {i: float(report.errors[-1, 0]) for i, report in enumerate(self.reports) if not report.reached}


def converge_along(
    problem: Problem,
    run: Run,
    aims: Iterable[TaskFunction],
    q: Array,
    tolerance: Tolerance = INNER,
    cap: int = CAP_PER_POINT,
    memory: Any = None,
) -> PathReport:
    """One point of a path after another from q (n,), each step by step until the tool is within the tolerance.

    Every point gets a step at least. One that is not met after `cap` steps is left, and the next is tried from there.
    Source: Cerbaro 2022, §6.1 (position to 10 mm; the cap is ours).
    """
    reports = []
    for aiming in aims:
        report = converged(problem, run, aiming, q, tolerance, cap, 1, memory)
        q, memory = report.q, report.memory
        reports.append(report)
    return PathReport(tuple(reports))
