"""The inverse: the one joint velocity that meets the asked one, where there is one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.method import Promise, Solution, Task
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.text import Text

TITLE = Text(en="inverse", pt_BR="inversa")
SOURCE = "Vargas 2013, eqs. 2.33, 4.59; Whitney 1969"
EQUATION = r"\dot q = J^{-1} \nu"
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.EXACT, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "|det J|": Text(
        en="|det J|: zero where there is no inverse, and the arm stands still",
        pt_BR="|det J|: zero onde não há inversa, e o braço fica parado",
    ),
}


@dataclass(frozen=True)
class Options:
    """Nothing can be set."""


def applies(task: Task) -> Text | None:
    """To square tasks, as many rows as joints, in which every row is moved by some joint."""
    r, n = task.J.shape
    if r != n:
        return Text(
            en="The inverse needs as many rows in the task as joints in the arm; here {r} rows meet {n} joints.",
            pt_BR="A inversa exige tantas linhas na tarefa quantas juntas no braço; aqui há {r} linhas e {n} juntas.",
        ).format(r=r, n=n)
    if not task.J.any(axis=1).all():
        return Text(
            en="There is no inverse: one direction of the task is moved by no joint.",
            pt_BR="Não há inversa: nenhuma junta move uma das direções da tarefa.",
        )
    return None


def start(task: Task, options: Options) -> None:
    """Nothing is remembered."""


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = J⁻¹ ν; where J is singular or not square there is no answer, and the arm stands still instead of guessing."""
    r, n = task.J.shape
    sigma = np.linalg.svd(task.J, compute_uv=False)
    if r != n or sigma[-1] <= RANK_TOLERANCE * sigma[0]:
        return Solution(np.zeros(n), {"|det J|": 0.0}, inverse=np.zeros((n, r))), None
    B = np.asarray(np.linalg.inv(task.J))
    return Solution(B @ task.rate, {"|det J|": float(np.prod(sigma))}, inverse=B), None
