"""Iteration to a fixed pose, and along a path, one point after another.

    q ← q + κ · method(J, e),   κ the step factor, until ‖e_p‖ and ‖e_o‖ are within a tolerance

Source: Cerbaro 2022, §4.4.2–4.4.4 (iterative convergence) and §6.1 (inner convergence along a path).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from enum import Enum
from itertools import islice
from math import inf
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import ControlLaw, LoopStep, NullSpaceVelocity, TaskError, TaskFunction, closed_loop
from helicoide.ik.method import ConfiguredMethod
from helicoide.text import Text

CAP, CAP_PER_POINT = 200, 60
# The arm stands still after PAUSES consecutive steps shorter than AT_REST, rad or m. A method whose memory starts at
# zero may need several steps before it moves.
PAUSES, AT_REST = 5, 1e-9
# Jᵀ e counts as zero up to this fraction of ‖J‖ ‖e‖: no joint motion reduces the error.
UNFELT = 1e-6

# A closed loop as a function of the task, the initial q and the memory.
Run = Callable[[TaskFunction, Array, Any], Iterator[LoopStep]]


@dataclass(frozen=True)
class Tolerance:
    """The largest accepted errors: position, m, orientation, rad."""

    position: float = 1e-3
    orientation: float = 0.01

    def holds(self, position: float, orientation: float) -> bool:
        """Whether errors, m and rad, are within the tolerance."""
        return position <= self.position and orientation <= self.orientation


@dataclass(frozen=True)
class StoppingCriterion:
    """When an iteration ends: within the tolerance, but after `least` steps, or after `cap` steps in any case."""

    tolerance: Tolerance = Tolerance()
    cap: int = CAP
    least: int = 0


POSE = StoppingCriterion()
# Along a path each point takes at least one step. Source: Cerbaro 2022, §6.1 (position to 10 mm; the cap is assumed).
INNER = StoppingCriterion(Tolerance(position=0.010, orientation=inf), CAP_PER_POINT, 1)


@dataclass(frozen=True, eq=False)
class IterativeSolver:
    """An iteration to a fixed pose: the closed loop of an arm, and when it ends. `solver_of` makes one of a method."""

    problem: Problem
    run: Run
    until: StoppingCriterion = POSE


class Convergence(Enum):
    """How an iteration ended; each value is the sentence shown for it."""

    CONVERGED = Text(
        en="Converged after {n} iterations; remaining error {mm:.2g} mm and {rad:.2g} rad.",
        pt_BR="Convergiu em {n} iterações; erro restante de {mm:.2g} mm e {rad:.2g} rad.",
    )
    CAPPED = Text(
        en="Not converged after {n} iterations, the maximum; remaining error {mm:.3g} mm and {rad:.3g} rad.",
        pt_BR="Não convergiu em {n} iterações, o máximo; erro restante de {mm:.3g} mm e {rad:.3g} rad.",
    )
    UNFELT = Text(
        en="The arm stopped after {n} iterations with an error of {mm:.3g} mm and {rad:.3g} rad: the posture is "
        "singular or at the boundary of the workspace, and no joint motion brings the end effector closer.",
        pt_BR="O braço parou após {n} iterações com erro de {mm:.3g} mm e {rad:.3g} rad: a postura é singular ou está "
        "na borda do espaço de trabalho, e nenhum movimento das juntas aproxima o efetuador.",
    )
    HELD = Text(
        en="The arm stopped after {n} iterations with an error of {mm:.3g} mm and {rad:.3g} rad: some joint motions "
        "would bring the end effector closer, but the method does not find them.",
        pt_BR="O braço parou após {n} iterações com erro de {mm:.3g} mm e {rad:.3g} rad: há movimentos das juntas que "
        "aproximariam o efetuador, mas o método não os encontra.",
    )


@dataclass(frozen=True, eq=False)
class Report:
    """The result of an iteration.

    q (n,), rad or m, at the end; errors (k + 1, 2): position, m, and orientation, rad, at the start and after each of
    k iterations; memory: of the loop at q, to continue from there.
    """

    q: Array
    errors: Array
    outcome: Convergence
    memory: Any = None

    @property
    def iterations(self) -> int:
        """Number of steps taken."""
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


def solver_of(
    problem: Problem,
    inverse: ConfiguredMethod,
    factor: float,
    until: StoppingCriterion = POSE,
    push: NullSpaceVelocity | None = None,
    dt: float = 1.0,
) -> IterativeSolver:
    """The iteration of a method with Λ Δt = κ, the step factor.

    Args: factor: κ; push: q̇₀ at q and t, (n,); dt, s: duration of an iteration, for q̇₀ and for methods that use it.
    """
    law = ControlLaw(inverse, factor / dt, dt)
    return IterativeSolver(problem, lambda aiming, q, memory: closed_loop(problem, law, aiming, q, push, memory), until)


def frozen_reference(aiming: TaskFunction, t: float) -> TaskFunction:
    """The task at the fixed instant t, s, with zero feedforward.

    Add the row of a secondary objective afterwards: it is a feedforward too and would be set to zero.
    """

    def aim(q: Array, _: float) -> TaskError:
        now = aiming(q, t)
        return replace(now, feedforward=np.zeros(len(now.feedforward)))

    return aim


def error_norms(problem: Problem, aim: TaskError) -> tuple[float, float]:
    """‖e_p‖, m, and ‖e_o‖, rad, of a task whose first three rows are the position."""
    return problem.length * float(np.linalg.norm(aim.error[:3])), float(np.linalg.norm(aim.error[3:]))


def converged(solver: IterativeSolver, aiming: TaskFunction, q: Array, memory: Any = None) -> Report:
    """Iterate from q (n,) until the solver's criterion holds or the arm stands still.

    aiming: the task, with a fixed target (see `frozen_reference`); memory: of the loop, None at the start.
    """
    errors: list[tuple[float, float]] = []
    until = solver.until
    outcome, pauses, coming = Convergence.CAPPED, 0, memory
    for moment in islice(solver.run(aiming, q, memory), until.cap + 1):
        pauses = pauses + 1 if errors and np.abs(moment.q - q).max() < AT_REST else 0
        q, memory, coming = moment.q, coming, moment.memory
        errors.append(error_norms(solver.problem, moment.task_error))
        if len(errors) > until.least and until.tolerance.holds(*errors[-1]):
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
