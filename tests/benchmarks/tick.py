"""One tick of the Movemaster with its planes, beside a matrix solve of the same size in plain numpy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from time import perf_counter_ns
from typing import Any
from unittest.mock import patch

import numpy as np
from tests.benchmarks.report import p50, spread, verdict

from helicoide import gate
from helicoide.advance import advance
from helicoide.arrays import Array, frozen
from helicoide.command import Command, MoveToJoints, MoveToPose
from helicoide.foresight import foreseen
from helicoide.ik.step import step, step_task
from helicoide.kinematics.library import load_robot
from helicoide.session.preparing import TICK, exercise
from helicoide.state import State, initial_state, with_command

TITLE = "One tick of the Movemaster with its planes"
TICKS = 1500
LAP = 200
STAY = 20
GOAL_ADVANCE, GOAL_KERNEL = 25.0, 5.0
REPEATED = 50
X, Y, Z = np.eye(3)
J, V = np.random.default_rng(0).normal(size=(6, 5)), np.ones(6)


@dataclass(frozen=True)
class Situation:
    """What the arm is asked in each tick of `dt` seconds; None keeps the command."""

    name: str
    command: Callable[[State, int], Command | None]
    dt: float = TICK
    with_orientation: bool = True


def _around(centre: Array, along: Array, across: Array) -> Callable[[State, int], Command]:
    """A target that goes around an ellipse, once in `LAP` ticks."""
    T_world_tool = initial_state(load_robot("movemaster")).T_world_tool

    def command(state: State, tick: int) -> Command:
        angle = 2 * np.pi * tick / LAP
        T = T_world_tool.copy()
        T[:3, 3] = centre + np.cos(angle) * along + np.sin(angle) * across
        return MoveToPose(frozen(T))

    return command


def _to_and_fro(state: State, tick: int) -> Command | None:
    if tick % LAP:
        return None
    ready = state.robot.poses["ready"]
    return MoveToJoints(frozen(ready + (0.5 if tick // LAP % 2 else -0.3) * np.array([1.0, 0.5, -0.5, 1.0, 1.0])))


def _anywhere(state: State, tick: int) -> Command | None:
    """Another point each time the arm has had time to come near, beyond the planes as often as not."""
    if tick % STAY:
        return None
    T = initial_state(state.robot).T_world_tool.copy()
    T[:3, 3] = np.random.default_rng(tick).uniform([-0.6, -0.8, -0.3], [1.0, 0.8, 1.1])
    return MoveToPose(frozen(T))


EDGE = _around(np.array([0.27, -0.45, 0.95]), 0.20 * X, 0.10 * Y)
SITUATIONS = (
    Situation("holding", lambda state, tick: None),
    Situation("dragged, clear of planes", _around(np.array([0.60, 0.0, 0.17]), 0.04 * Y, 0.04 * Z)),
    Situation("pressed into an edge", EDGE, with_orientation=False),
    Situation("joints to and fro", _to_and_fro),
)


def _states(situation: Situation) -> Iterator[State]:
    """The arm before each of its ticks."""
    state = gate.keep_orientation(situation.with_orientation)(initial_state(load_robot("movemaster")))
    for tick in range(TICKS):
        command = situation.command(state, tick)
        state = state if command is None else with_command(state, command)
        yield state
        state = advance(state, situation.dt)


def _solve(_: State) -> Array:
    """Damped least squares as plain numpy does it: the solve that any tick contains, without limits or planes."""
    return np.asarray(np.linalg.solve(J.T @ J + 1e-6 * np.eye(5), J.T @ V))


def _timed(function: Callable[[State], object], state: State) -> float:
    """How long one call takes, in µs."""
    begun = perf_counter_ns()
    function(state)
    return (perf_counter_ns() - begun) / 1000


def _asked(states: list[State], dt: float) -> list[tuple[Any, ...]]:
    """What `advance` asks of the kernels in these states, first the kernel; nothing when the arm holds."""
    asked: list[tuple[Any, ...]] = []

    def noted(kernel: Callable[..., float]) -> Callable[..., float]:
        def call(arm: Array, q: Array, *rest: Any) -> float:
            *task, memory = rest
            asked.append((kernel, arm, q.copy(), *task, memory.copy()))
            return kernel(arm, q, *rest)

        return call

    with patch("helicoide.advance.step", noted(step)), patch("helicoide.advance.step_task", noted(step_task)):
        for state in states:
            advance(state, dt)
    return asked


def _alone(asked: tuple[Any, ...]) -> float:
    """How long the kernel takes when it is called from Python, in µs."""
    kernel, arm, q, *task, memory = asked
    took = []
    for _ in range(REPEATED):
        given = (arm, q.copy(), *task, memory.copy())
        begun = perf_counter_ns()
        kernel(*given)
        took.append((perf_counter_ns() - begun) / 1000)
    return p50(took)


def _measure(situation: Situation) -> tuple[float, float]:
    """Print one situation; gives the median of `advance` and of the kernel alone, µs."""
    took, solves, states = [], [], list(_states(situation))
    for state in states:
        took.append(_timed(lambda state: advance(state, situation.dt), state))
        solves.append(_timed(_solve, state))
    spread(f"advance, {situation.name}", took, "µs", 99)
    print(f"    {p50(took) / p50(solves):.2f} × the numpy solve ({p50(solves):.1f} µs)")
    steps = _asked(states[::10], situation.dt)
    if not steps:
        return p50(took), 0.0
    alone = [_alone(asked) for asked in steps]
    spread("  the step alone", alone, "µs", 99)
    print(f"    {p50(alone) / p50(solves):.2f} × the numpy solve")
    return p50(took), p50(alone)


def _foreseen() -> None:
    """The goal that is foreseen at the scene's rate: up to 250 guarded steps, until the arm rests."""
    for situation in SITUATIONS[1:]:
        states = [replace(state, request=replace(state.request, goal=None)) for state in _states(situation)][::5]
        took, solves = [], []
        for state in states:
            took.append(_timed(foreseen, state))
            solves.append(_timed(_solve, state))
        spread(f"foreseen, {situation.name}", took, "µs", 99)
        print(f"    {p50(took) / p50(solves):.1f} × the numpy solve")


def run() -> None:
    exercise("movemaster")
    figures = [_measure(situation) for situation in SITUATIONS]
    _foreseen()
    verdict("slowest p50 of advance from Python", max(took for took, _ in figures), GOAL_ADVANCE, " µs")
    verdict("slowest p50 of `step` or `step_task` alone", max(alone for _, alone in figures), GOAL_KERNEL, " µs")
