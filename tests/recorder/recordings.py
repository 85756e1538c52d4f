"""Motions that are recorded, and recordings of them."""

from __future__ import annotations

from pathlib import Path

from helicoide import gate
from helicoide.advance import advance
from helicoide.kinematics.library import load_robot
from helicoide.recorder.reading import read_recording
from helicoide.recorder.recorder import Recorder
from helicoide.recorder.recording import Recording
from helicoide.state import State, initial_state

PATIENCE = 120.0


def moved(robot: str = "movemaster", seconds: float = 2.0) -> list[State]:
    """The states of an arm whose first joint turns, one for each tick; the first one is at rest."""
    states = [initial_state(load_robot(robot))]
    states.append(gate.set_joint(0, 0.3)(states[0]))
    for _ in range(round(seconds / 0.01)):
        states.append(advance(states[-1], 0.01))
    return [states[0], *states[2:]]


def recorded(states: list[State], path: Path) -> Recorder:
    """The recorder of these states, after its end."""
    recorder = Recorder(path, states[0])
    for state in states[1:]:
        recorder.take(state)
    recorder.end(PATIENCE)
    assert not recorder.running
    return recorder


def recording_of(states: list[State], path: Path) -> Recording:
    """The recording of these states, read from its file."""
    recorded(states, path)
    return read_recording(path, path.name)
