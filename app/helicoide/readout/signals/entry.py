"""The entry point of an instrument: the distance of its shaft, and its length outside."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache, partial

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.tip_task import passage_of
from helicoide.readout.signal import PhasePlane, Signal, scalar
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Entry point", pt_BR="Ponto de entrada")
ORDER = 6
PRESET = ("entry distance", "shaft outside")
PHASES: tuple[PhasePlane, ...] = ()


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """None without an entry point."""
    if problem.entry is None:
        return
    title = Text(en="Distance to the entry point", pt_BR="Distância ao ponto de entrada")
    yield Signal("entry distance", title, "e_r", "mm", (untranslated("e_r"),), partial(_part, 0), positive=True)
    title = Text(en="Shaft length outside", pt_BR="Comprimento externo da haste")
    yield Signal("shaft outside", title, "l_a", "mm", (untranslated("l_a"),), partial(_part, 1))


@lru_cache(maxsize=8)
def entry_lengths(state: State) -> Array:
    """The distance of the shaft from its entry point, and its length outside, (2,), mm."""
    problem, entry = state.problem, state.problem.entry
    if entry is None:
        return np.full(2, np.nan)
    place = constrained(problem, passage_of(problem.robot, entry), state.arm.q, entry.point).place
    return 1000 * np.array([np.linalg.norm(place.lateral), place.outside])


def _part(part: int, state: State) -> Array:
    return scalar(entry_lengths(state)[part])
