"""The pseudoinverse: the smallest joint velocity among those that come nearest to the asked velocity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.method import Promise, Solution, Task
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.text import Text

TITLE = Text(en="pseudoinverse", pt_BR="pseudoinversa")
SOURCE = "Vargas 2013, eq. 2.49; Cerbaro 2022, eq. 70"
EQUATION = r"\dot q = J^\dagger \nu = J^T (J J^T)^{-1} \nu"
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.EXACT})
FIGURES: Mapping[str, Text] = {}


@dataclass(frozen=True)
class Options:
    """This method has no options."""


def applies(task: Task) -> Text | None:
    """Applies to every task: the pseudoinverse exists for every J."""
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = J† ν."""
    B = np.asarray(np.linalg.pinv(task.J, rcond=RANK_TOLERANCE))
    return Solution(B @ task.rate, inverse=B), None
