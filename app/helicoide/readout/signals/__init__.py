"""All signals, in groups. The module of a group defines TITLE, ORDER, PRESET, PHASES and `signals`.

TITLE names the group; PRESET: the names of the signals and phase planes that the group shows together; PHASES: its
phase planes; signals(problem, with_orientation): its signals for an arm and its surroundings.
"""

from __future__ import annotations

from functools import cache, lru_cache
from types import ModuleType

from helicoide import content
from helicoide.ik import Problem
from helicoide.readout.signal import PhasePlane, Signal
from helicoide.state import State


@cache
def signal_groups() -> tuple[ModuleType, ...]:
    """Every group, sorted by ORDER."""
    return tuple(sorted(content.modules(__name__).values(), key=lambda group: group.ORDER))


@cache
def phase_planes() -> dict[str, PhasePlane]:
    """Every phase plane, by name."""
    return {phase.name: phase for group in signal_groups() for phase in group.PHASES}


def signals_of(state: State) -> dict[str, Signal]:
    """Every signal of a state, by name."""
    return _signals(state.problem, state.request.with_orientation)


@lru_cache(maxsize=128)  # enough for a class of thirty, each with its own arm, while planes are dragged
def _signals(problem: Problem, with_orientation: bool) -> dict[str, Signal]:
    found = (signal for group in signal_groups() for signal in group.signals(problem, with_orientation))
    return {signal.name: signal for signal in found}


def needed_signals(state: State, shown: tuple[str, ...]) -> tuple[Signal, ...]:
    """The signals that the charts of these names need, each once; names that the state does not know are left out."""
    known, phases = signals_of(state), phase_planes()
    names = [name for one in shown for name in ((phases[one].across, phases[one].up) if one in phases else (one,))]
    return tuple(known[name] for name in dict.fromkeys(names) if name in known)
