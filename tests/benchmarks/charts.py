"""The tab of charts with four charts: what a sample and an update of the tab cost, and nothing while none is shown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from time import perf_counter_ns

import viser
from tests.benchmarks.report import p50, spread, verdict

from helicoide import gate
from helicoide.advance import advance
from helicoide.kinematics.library import load_robot
from helicoide.readout.signal_history import LONGEST, NO_SIGNAL_HISTORY, SPACING, SignalHistory
from helicoide.readout.signals import needed_signals
from helicoide.seat import Seat
from helicoide.session.preparing import TICK, exercise
from helicoide.state import State, initial_state
from helicoide.view.panels import charts
from helicoide.view.placed_rows import place_rows
from helicoide.view.signal_rows import with_chart, with_group
from helicoide.view.window_view import View

TITLE = "Four live charts of the Movemaster, two methods in each"
GROUPS = ("joints", "distances", "singularity", "filter")
FOUR = ("positions", "planes", "singular values", "phase d")
SAMPLES = 200
# µs: of each tick, a sample being taken in every fifth; ms: of each update of the tab, at most five times a second
GOAL_TICK, GOAL_UPDATE = 300.0, 20.0


def _moving() -> list[State]:
    """Two arms on their way, a state for each sample."""
    state = gate.compare_with("damped")(gate.choose_method("filtered")(initial_state(load_robot("movemaster"))))
    states = []
    for k in range(SAMPLES):
        if k % 20 == 0:
            side = 0.1 if k % 40 else -0.1
            state = gate.set_target(state.T_world_tool[:3, 3] + [0.02, side, 0.02], [1.0, 0.0, 0.0, 0.0])(state)
        for _ in range(round(SPACING / TICK)):
            state = advance(state, TICK)
        states.append(state)
    return states


def _timed(function: Callable[[], object]) -> float:
    """µs of one call."""
    began = perf_counter_ns()
    function()
    return (perf_counter_ns() - began) / 1000


def _full(states: list[State], shown: tuple[str, ...]) -> SignalHistory:
    """A minute of samples that ends before the first state."""
    history = NO_SIGNAL_HISTORY
    for k in range(round(LONGEST / SPACING)):
        state = replace(states[k % len(states)], t=k * SPACING - LONGEST)
        history = history.with_sample(state, needed_signals(state, shown))
    return history


def _samples(name: str, states: list[State], shown: tuple[str, ...]) -> float:
    """Print what a sample costs each tick; gives the median, µs."""
    history, took = _full(states, shown), []
    for state in states:
        fresh = replace(state, notice=None)  # nothing that was computed for this state is found again
        began = perf_counter_ns()
        history = history.with_sample(fresh, needed_signals(fresh, shown))
        took.append((perf_counter_ns() - began) / 1000)
    per_tick = [one * TICK / SPACING for one in took]
    spread(f"a sample of {name}, per tick", per_tick, "µs", 99)
    return p50(per_tick)


def _updates(states: list[State], span: float) -> float:
    """Print what an update of the tab costs; gives the median, ms."""
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    try:
        seat = Seat("", "en")
        for k, name in enumerate(FOUR):
            seat = with_chart(seat, k, name)
        seat = replace(seat, charts=replace(seat.charts, span=span))
        history, took = _full(states, FOUR), []
        rows = place_rows(server.gui, charts.rows(states[0].robot), View(states[0], seat, history=history), print)
        for state in states:
            history = history.with_sample(state, needed_signals(state, FOUR))
            view = View(state, seat, history=history)
            took.append(_timed(lambda view=view: [row.refresh(view) for row in rows]) / 1000)  # type: ignore[misc]
    finally:
        server.stop()
    spread(f"an update of the tab, {span:.0f} s shown", took, "ms", 99)
    return p50(took)


def run() -> None:
    exercise("movemaster")
    states = _moving()
    dearest = max(_samples(name, states, with_group(Seat("", "en"), name).charts.shown) for name in GROUPS)
    _samples("four groups' first", states, FOUR)
    verdict("dearest group, p50 per tick", dearest, GOAL_TICK, " µs")
    verdict("an update of the tab, p50", max(_updates(states, span) for span in (20.0, 60.0)), GOAL_UPDATE, " ms")
