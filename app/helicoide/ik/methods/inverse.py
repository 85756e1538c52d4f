"""The inverse of a square Jacobian: the unique joint velocity that gives the asked velocity, where one exists."""

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
        en="|det J|: zero where J has no inverse; there the arm stops",
        pt_BR="|det J|: zero onde J não tem inversa; ali o braço para",
    ),
}


@dataclass(frozen=True)
class Options:
    """This method has no options."""


def applies(task: Task) -> Text | None:
    """Applies to tasks with as many rows as joints and no zero row in J."""
    r, n = task.J.shape
    if r != n:
        return Text(
            en="The inverse needs as many task rows as joints; here there are {r} rows and {n} joints.",
            pt_BR="A inversa exige tantas linhas da tarefa quantas juntas; aqui há {r} linhas e {n} juntas.",
        ).format(r=r, n=n)
    if not task.J.any(axis=1).all():
        return Text(
            en="There is no inverse: no joint moves along one direction of the task.",
            pt_BR="Não há inversa: nenhuma junta se move ao longo de uma direção da tarefa.",
        )
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = J⁻¹ ν, and q̇ = 0 where J is singular or not square."""
    r, n = task.J.shape
    sigma = np.linalg.svd(task.J, compute_uv=False)
    if r != n or sigma[-1] <= RANK_TOLERANCE * sigma[0]:
        return Solution(np.zeros(n), {"|det J|": 0.0}, inverse=np.zeros((n, r))), None
    B = np.asarray(np.linalg.inv(task.J))
    return Solution(B @ task.rate, {"|det J|": float(np.prod(sigma))}, inverse=B), None
