"""Charts of live signals and the numbers of the block diagram, without a page."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import MagicMock

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.arrays import frozen
from helicoide.kinematics.library import load_robot
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY, SignalHistory
from helicoide.readout.signals import needed_signals, signals_of
from helicoide.seat import Seat
from helicoide.state import State, initial_state
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import untranslated
from helicoide.view.chart_plot import ChartPlot
from helicoide.view.loop_diagram import drawn_loop
from helicoide.view.rows import Plot
from helicoide.view.signal_charts import live_charts
from helicoide.view.signal_rows import _note, _saved, with_charts
from helicoide.view.window_view import View


def moving(state: State) -> State:
    return gate.set_target(state.T_world_tool[:3, 3] + 0.05, [1.0, 0.0, 0.0, 0.0])(state)


def sampled(state: State, shown: tuple[str, ...]) -> tuple[SignalHistory, State]:
    history = NO_SIGNAL_HISTORY
    for _ in range(4):
        state = after(state, 0.05)
        history = history.with_sample(state, needed_signals(state, shown))
    return history, state


def view_of(state: State, history: SignalHistory, shown: tuple[str, ...]) -> View:
    return View(state, with_charts(Seat("a", "en"), shown=shown), None, True, False, history=history)  # type: ignore[arg-type]


def test_a_plane_that_is_new_since_the_last_sample_is_charted_after_the_next(state: State) -> None:
    history, last = sampled(moving(state), ("planes",))
    assert len(live_charts(view_of(last, history, ("planes",)))) == 1
    wider = gate.add_plane([0.0, 0.0, 1.0, -0.9])(last)
    view = view_of(wider, history, ("planes",))
    assert live_charts(view) == ()
    assert _saved(view).content.decode("utf-8-sig").splitlines()[0] == "t [s]"
    assert history.is_due(wider, needed_signals(wider, ("planes",)))
    (chart,) = live_charts(view_of(wider, history.with_sample(wider, needed_signals(wider, ("planes",))), ("planes",)))
    assert len(chart.lines) == len(wider.problem.planes.panes)


def test_a_signal_that_is_not_sampled_yet_is_not_called_undefined(state: State) -> None:
    history, last = sampled(moving(state), ("positions",))
    assert "Not defined" not in _note(view_of(last, history, ("positions", "manipulability")))
    history, last = sampled(moving(state), ("inversion error",))
    assert "Not defined" in _note(view_of(last, history, ("inversion error",)))


def test_a_logarithmic_axis_is_drawn_also_if_the_range_stays() -> None:
    x = np.array([0.0, 1.0])
    words = untranslated("κ")
    linear = Chart(words, words, words, (ChartLine(words, x, np.array([2.0, 9.0])),), y_range=(1.0, 10.0))
    charts, gui, view = [linear], MagicMock(), SimpleNamespace(seat=Seat("a", "en"))
    plot = ChartPlot(gui, Plot(lambda _: charts, 0), view)  # type: ignore[arg-type]
    charts[0] = replace(linear, log=True)
    plot.refresh(view)  # type: ignore[arg-type]
    assert [call.kwargs["scales"]["y"].get("distr") for call in gui.add_uplot.call_args_list] == [None, 3]


def test_the_arrow_of_the_method_has_the_speed_that_it_asks_for(state: State) -> None:
    """The arm itself moves at another speed, which is on the arrow of the guarded step."""
    last = after(moving(gate.choose_method("transpose")(state)), 0.1)
    last = replace(last, arm=replace(last.arm, velocities=frozen(0.5 * last.arm.velocities)))
    asked, actual = signals_of(last)["asked speed"].read(last)
    assert asked > 1.5 * actual > 0
    drawing = str(drawn_loop(last, "en"))
    assert f"‖q̇‖ = {asked:.3g} rad/s" in drawing
    assert f"‖q̇‖ = {actual:.3g} rad/s" in drawing


@pytest.mark.parametrize("name", ["planar2r", "movemaster"])
def test_of_several_values_the_diagram_shows_the_least_and_the_largest(name: str) -> None:
    start = initial_state(load_robot(name))
    shares = signals_of(start)["positions"].read(start)
    assert f"{min(shares):.3g} … {max(shares):.3g} %".replace("-", "−") in str(drawn_loop(start, "en"))
