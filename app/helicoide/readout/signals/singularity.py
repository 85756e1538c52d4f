"""How near the arm is to a singular posture: singular values, manipulability and condition number."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.kinematics.manipulability import JacobianAnalysis
from helicoide.readout.instruments import mobility
from helicoide.readout.signal import PhasePlane, Signal, scalar, subscript
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Singularity", pt_BR="Singularidade")
ORDER = 4
PRESET = ("singular values", "manipulability", "condition number")
PHASES: tuple[PhasePlane, ...] = ()


@lru_cache(maxsize=8)  # the signals of one state share it
def _analysis(state: State) -> JacobianAnalysis | None:
    return mobility(state)


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """Of the rows of J that count, lengths divided by the characteristic length ℓ; none if no row counts."""
    count = min(int(counted_rows(problem.robot, with_orientation).sum()), len(problem.robot.variables))
    if count == 0:
        return
    sigma = tuple(untranslated(subscript("σ", i + 1)) for i in range(count))
    title = Text(en="Singular values of J", pt_BR="Valores singulares de J")
    yield Signal("singular values", title, "σ", "", sigma, _of(lambda here: here.sigma), positive=True)
    title = Text(en="Manipulability", pt_BR="Manipulabilidade")
    w, kappa = (untranslated("w"),), (untranslated("κ"),)
    yield Signal("manipulability", title, "w", "", w, _of(lambda here: scalar(here.w)), positive=True)
    title = Text(en="Condition number", pt_BR="Número de condição")
    condition = _of(lambda here: scalar(here.condition_number))
    yield Signal("condition number", title, "κ", "", kappa, condition, positive=True)


def _of(read: Callable[[JacobianAnalysis], Array]) -> Callable[[State], Array]:
    """A signal of the analysis; NaN where there is none."""

    def values(state: State) -> Array:
        here = _analysis(state)
        return np.array(np.nan) if here is None else read(here)

    return values
