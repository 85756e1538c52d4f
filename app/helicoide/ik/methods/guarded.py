"""The guarded step as a method: least squares under joint limits, planes, obstacles and acceleration limits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem, reasons
from helicoide.ik.guard.guarded import ONE_LEVEL, indices
from helicoide.ik.guard.rows import DAMPER_GAIN
from helicoide.ik.guard.work import work_for
from helicoide.ik.method import Promise, Quantity, Solution, Task, YesNo
from helicoide.ik.packing import packed
from helicoide.ik.step import step_task
from helicoide.ik.task import DAMPING, ORIENTATION_LENGTH
from helicoide.text import Text

TITLE = Text(en="constrained QP step", pt_BR="passo com restrições (QP)")
SOURCE = "Helicoide; Goldfarb and Idnani 1983; Faverjon and Tournassoud 1987; Cerbaro 2022, §7 (future work)"
EQUATION = (
    r"\min_{\Delta q} \|W (J \Delta q - \nu \Delta t)\|^2 + \lambda^2 \|\Delta q\|^2"
    r", \quad \underline{b} \le A \Delta q \le \overline{b}"
)
REMEMBERS: Text | None = Text(
    en="the joint velocities of the previous step", pt_BR="as velocidades de junta do passo anterior"
)
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.KEEPS_LIMITS})
FIGURES: Mapping[str, Text] = {
    "share": Text(en="fraction of the step taken", pt_BR="fração dada do passo"),
}


@dataclass(frozen=True)
class Options:
    """damping: λ, in units of ℓ per radian; turn: the weight of one radian relative to one ℓ.

    gain: κ of the velocity dampers, 1/s; levels: whether position has priority over orientation.
    """

    damping: Annotated[
        float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 1e-4, 1.0, "mm/rad", lengths=1, decades=True)
    ] = DAMPING**0.5
    turn: Annotated[
        float,
        Quantity(Text(en="orientation weight", pt_BR="peso da orientação"), 1e-3, 1.0, decades=True),
    ] = ORIENTATION_LENGTH
    gain: Annotated[
        float,
        Quantity(Text(en="velocity-damper gain κ", pt_BR="ganho dos amortecedores de velocidade κ"), 1.0, 50.0, "1/s"),
    ] = DAMPER_GAIN
    levels: Annotated[bool, YesNo(Text(en="prioritise position", pt_BR="priorizar a posição"))] = False


def applies(task: Task) -> Text | None:
    """Applies to tasks whose unknowns are the joints of the arm, because limits are given for joints."""
    if task.J.shape[1] == len(task.q):
        return None
    return Text(
        en="The constrained QP step solves for the joints of the arm; this task has {r} other unknowns.",
        pt_BR="O passo com restrições (QP) resolve as juntas do braço; esta tarefa tem {r} outras incógnitas.",
    ).format(r=task.J.shape[1])


def start(task: Task, options: Options) -> Array:
    """Zero joint velocities, (n,)."""
    return frozen(np.zeros(len(task.q)))


def step(problem: Problem, task: Task, memory: Array, options: Options) -> tuple[Solution, Array]:
    """One guarded step from task.q. memory: the joint velocities of the previous step, (n,), rad/s or m/s."""
    units, q = problem.joint_units, task.q.copy()
    v, weights = task.rate * task.dt, np.ones(len(task.rate))
    weights[3:] = options.turn
    split = indices([3]) if options.levels and len(v) > 3 else ONE_LEVEL
    arm = packed(problem, gain=options.gain)
    work = work_for(arm)
    work.rates[:] = memory
    J, damping = np.ascontiguousarray(task.J / units), (options.damping / units) ** 2
    share = step_task(arm, q, J, v, weights, damping, split, task.dt, work.memory)
    rates = frozen(work.rates)
    return Solution(rates / units, {"share": share}, reasons=reasons(problem, q, work.multipliers, work.pull)), rates
