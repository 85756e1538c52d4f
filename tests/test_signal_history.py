"""The history of charted signals: bounded, of one arm, with the values of its states; and its file read again."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.export.history_csv import history_csv
from helicoide.kinematics.library import load_robot
from helicoide.readout.signal_history import LONGEST, NO_SIGNAL_HISTORY, SPACING, SignalHistory
from helicoide.readout.signals import needed_signals, signals_of
from helicoide.state import State, initial_state
from helicoide.text import untranslated

SHOWN = ("positions", "planes", "phase d")


def sampled(history: SignalHistory, state: State) -> SignalHistory:
    return history.with_sample(state, needed_signals(state, SHOWN))


def driven(state: State, ticks: int) -> tuple[SignalHistory, list[State]]:
    """The history of an arm that moves, and the states that were sampled."""
    state = gate.set_target(state.T_world_tool[:3, 3] + 0.05, [1.0, 0.0, 0.0, 0.0])(state)
    history, states = NO_SIGNAL_HISTORY, []
    for _ in range(ticks):
        state = after(state, 0.01)
        if history.is_due(state, needed_signals(state, SHOWN)):
            history = sampled(history, state)
            states.append(state)
    return history, states


def test_samples_are_the_values_of_the_states_at_their_times(state: State) -> None:
    history, states = driven(gate.choose_method("filtered")(state), 50)
    assert len(states) == 10
    np.testing.assert_allclose(history.times, [state.t for state in states])
    for name in ("positions", "planes", "filter σ", "filter d"):
        for values, state in zip(history.values[name], states, strict=True):
            np.testing.assert_array_equal(values[0], signals_of(state)[name].read(state))
            assert np.isnan(values[1]).all()


def test_it_is_bounded(state: State) -> None:
    history = NO_SIGNAL_HISTORY
    for k in range(int(1.2 * LONGEST / SPACING)):
        history = sampled(history, replace(state, t=k * SPACING))
    assert len(history.times) == pytest.approx(LONGEST / SPACING, abs=1)
    assert all(len(values) == len(history.times) for values in history.values.values())
    assert history.times[-1] - history.times[0] < LONGEST
    assert history.since(10.0).start == pytest.approx(len(history.times) - 10 / SPACING, abs=2)


def test_another_arm_begins_anew(state: State) -> None:
    history, _ = driven(state, 30)
    other = replace(initial_state(load_robot("puma560")), t=state.t + 1)
    assert history.is_due(other, ())
    fresh = sampled(history, other)
    assert fresh.robot is other.robot
    assert len(fresh.times) == 1
    assert fresh.values["positions"].shape == (1, 2, 6)


def test_a_time_before_the_last_sample_begins_anew(state: State) -> None:
    history, states = driven(state, 30)
    assert history.is_due(states[0], ())
    assert len(sampled(history, states[0]).times) == 1


def test_a_signal_that_is_added_or_changes_its_curves_is_blank_before(state: State) -> None:
    history, states = driven(state, 20)
    last = replace(gate.add_plane([0.0, 0.0, 1.0, -0.9])(states[-1]), t=states[-1].t + 1)
    wider = history.with_sample(last, needed_signals(last, ("planes", "speed")))
    assert wider.values.keys() == {"planes", "speed"}
    assert wider.values["planes"].shape[2] == len(last.problem.planes.panes)
    assert np.isnan(wider.values["planes"][:-1]).all()
    assert np.isnan(wider.values["speed"][:-1]).all()
    assert np.isfinite(wider.values["planes"][-1, 0]).all()


def test_a_signal_that_is_new_is_sampled_at_once_and_no_time_twice(state: State) -> None:
    history, states = driven(state, 20)
    last = replace(states[-1], t=float(history.times[-1]))
    assert not history.is_due(last, needed_signals(last, SHOWN))
    signals = needed_signals(last, (*SHOWN, "speed"))
    assert history.is_due(last, signals)
    wider = history.with_sample(last, signals)
    np.testing.assert_array_equal(wider.times, history.times)
    assert np.isfinite(wider.values["speed"][-1, 0]).all()
    assert not wider.is_due(last, signals)


def test_two_arms_are_kept_apart(state: State) -> None:
    history, states = driven(gate.compare_with("transpose")(gate.choose_method("damped")(state)), 60)
    second = states[-1].compared_state
    assert second is not None
    first, other = history.values["positions"][-1]
    np.testing.assert_array_equal(other, signals_of(second)["positions"].read(second))
    assert not np.allclose(first, other)


@pytest.mark.parametrize("arms", [(), (untranslated("damped"), untranslated("transpose"))])
def test_the_file_read_again_has_the_values_of_the_states(state: State, arms: tuple) -> None:  # type: ignore[type-arg]
    state = gate.compare_with("transpose")(gate.choose_method("damped")(state)) if arms else state
    history, states = driven(state, 60)
    signals = needed_signals(states[-1], SHOWN)
    head, *rows = csv.reader(io.StringIO(history_csv(history, signals, 1.0, "pt_BR", arms)))
    assert head[0] == "t [s]"
    assert len(set(head)) == len(head) == len(rows[0])
    named = {float(row[0]): dict(zip(head, row, strict=True)) for row in rows}
    assert all(states[-1].t - t <= 1.0 for t in named)
    for state in states[-3:]:
        row = named[state.t]
        for k, pane in enumerate(state.problem.planes.panes):
            (name,) = (h for h in head if pane.title.pt_BR in h and "transpose" not in h)
            assert float(row[name]) == signals_of(state)["planes"].read(state)[k]
    assert {row[head.index(h)] for row in rows for h in head if h.startswith("Termos")} == {""}
