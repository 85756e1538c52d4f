"""Charts in the session: sampled while chosen, apart for two arms, anew for another arm, and free when not shown."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np
import pytest
from tests.pages import Hand
from tests.session.labs import after_ticks, eventually, running, state, window

from helicoide import gate
from helicoide.kinematics.library import load_robot
from helicoide.readout.signal import Signal
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY, SignalHistory
from helicoide.seat import Seat
from helicoide.session.lab import Lab
from helicoide.session.seats import Place
from helicoide.session.visitor import Visitor
from helicoide.state import initial_state
from helicoide.view.signal_rows import with_group, with_signal


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture
def hand(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()
    assert eventually(lambda: not lab.visitors)


def visitor_of(lab: Lab, hand: Hand) -> Visitor:
    key = hand.page.window.result()
    visitor = next(one for one in lab.visitors.values() if one.window.link.key == key)
    assert eventually(lambda: visitor.settled)  # which begins a new history
    return visitor


def move(lab: Lab, visitor: Visitor, along: float) -> None:
    T = visitor.bay.workcell.state.T_world_tool
    visitor.bay.workcell.tell(gate.set_target(T[:3, 3] + np.array([0.0, along, 0.0]), [1.0, 0.0, 0.0, 0.0]))


def choose(lab: Lab, visitor: Visitor, group: str) -> None:
    lab.loop.call_soon_threadsafe(visitor.reseat, lambda seat: with_group(seat, group))
    assert eventually(lambda: any(visitor.place.seat.charts.shown) == bool(group))


def test_nothing_is_read_while_no_chart_is_chosen_or_charts_are_paused(lab: Lab, hand: Hand) -> None:
    visitor = visitor_of(lab, hand)
    with patch.object(Signal, "read", side_effect=AssertionError("a signal was read")) as read:
        move(lab, visitor, 0.02)
        after_ticks(lab)
        assert visitor.history is NO_SIGNAL_HISTORY
        assert read.call_count == 0
    choose(lab, visitor, "joints")
    move(lab, visitor, -0.02)
    assert eventually(lambda: len(visitor.history.times) > 3)
    lab.loop.call_soon_threadsafe(visitor.reseat, paused)
    assert eventually(lambda: visitor.place.seat.charts.paused)
    history = visitor.history
    with patch.object(SignalHistory, "with_sample", side_effect=AssertionError("a sample was taken")) as sample:
        move(lab, visitor, 0.02)
        after_ticks(lab)
        assert sample.call_count == 0
    assert visitor.history is history


def paused(seat: Seat) -> Seat:
    return replace(seat, charts=replace(seat.charts, paused=True))


def test_paused_charts_of_another_arm_are_dropped() -> None:
    planar, puma = (initial_state(load_robot(name)) for name in ("planar3r", "puma560"))
    cell = SimpleNamespace(state=planar)
    place = Place(with_group(Seat("a", "en"), "joints"))
    visitor = Visitor(SimpleNamespace(), place, SimpleNamespace(workcell=cell))  # type: ignore[arg-type]
    visitor.sample()
    place.seat, kept = paused(place.seat), visitor.history
    visitor.sample()
    assert visitor.history is kept is not NO_SIGNAL_HISTORY
    cell.state = puma
    visitor.sample()
    assert visitor.history is NO_SIGNAL_HISTORY


def test_two_arms_are_kept_apart_and_an_arm_begins_anew(lab: Lab, hand: Hand) -> None:
    visitor = visitor_of(lab, hand)
    choose(lab, visitor, "joints")
    move(lab, visitor, 0.02)
    assert eventually(lambda: len(visitor.history.times) > 3)
    shared = visitor.history
    hand.do(hand.page.give("Use my own arm", True))
    assert eventually(lambda: visitor.settled and visitor.bay is not lab.shared)
    assert len(visitor.history.times) <= 1 or visitor.history.times[0] > shared.times[-1]
    move(lab, visitor, 0.02)
    assert eventually(lambda: len(visitor.history.times) > 3)
    own = visitor.history.values["positions"][-1, 0]
    assert not np.allclose(own, shared.values["positions"][-1, 0])
    lab.loop.call_soon_threadsafe(visitor.bay.arms.change, "puma560")
    assert eventually(lambda: visitor.bay.workcell.state.robot.name == "puma560")
    move(lab, visitor, 0.02)
    assert eventually(lambda: visitor.history.robot is visitor.bay.workcell.state.robot)
    assert eventually(lambda: visitor.history.values["positions"].shape[2] == 6)
    assert state(lab).robot.name == "movemaster"


def test_a_signal_that_raises_stops_neither_the_arm_nor_the_page(
    lab: Lab, hand: Hand, caplog: pytest.LogCaptureFixture
) -> None:
    visitor = visitor_of(lab, hand)
    with patch.object(Signal, "read", side_effect=ValueError("broken")):
        lab.loop.call_soon_threadsafe(visitor.reseat, lambda seat: with_signal(seat, "speed"))
        assert eventually(lambda: "speed" in visitor.place.seat.charts.shown)
        move(lab, visitor, 0.02)
        before = state(lab).t
        assert eventually(lambda: state(lab).t > before + 0.2)
    assert "could not be read" in caplog.text
    move(lab, visitor, -0.02)
    assert eventually(lambda: len(visitor.history.times) > 3)
