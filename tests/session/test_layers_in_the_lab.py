"""Layers that need more than a redraw when the arm has moved: lists that are computed for them, ghosts that move."""

from __future__ import annotations

import time
from collections.abc import Iterator

import pytest
from tests.pages import Hand
from tests.session.labs import eventually, running, state, window

from helicoide import gate
from helicoide.session.lab import Lab


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture(scope="module")
def hand(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()


def show(lab: Lab, name: str, on: bool) -> None:
    """Show or hide a layer in every window."""
    for visitor in tuple(lab.visitors.values()):
        lab.loop.call_soon_threadsafe(visitor.reseat, lambda seat: seat.with_layer(name, on))


def frames_in(lab: Lab, seconds: float) -> int:
    display = lab.shared.display
    assert display is not None
    before = display.frames
    time.sleep(seconds)
    return display.frames - before


def rests(lab: Lab) -> bool:
    return lab.shared.workcell.resting and frames_in(lab, 0.3) == 0


def test_the_list_of_postures_is_computed_for_its_layer_and_again_for_another_target(lab: Lab, hand: Hand) -> None:
    assert eventually(lambda: lab.shared.workcell.resting)
    assert state(lab).postures.listing is None
    show(lab, "postures", True)
    assert eventually(lambda: state(lab).postures.listing is not None)
    first = state(lab).postures.listing
    lab.shared.workcell.ask(gate.set_joint(0, float(state(lab).arm.q[0]) + 0.2))
    assert eventually(lambda: state(lab).postures.listing is not first)
    assert eventually(lambda: lab.shared.workcell.resting)
    second = state(lab).postures.listing
    time.sleep(0.5)
    assert state(lab).postures.listing is second, "once for each target"
    show(lab, "postures", False)


def test_a_ghost_moves_while_the_arm_rests_and_only_while_it_is_shown(lab: Lab, hand: Hand) -> None:
    show(lab, "null", True)
    assert eventually(lambda: rests(lab)), "with its orientation kept, the arm has no null space"
    lab.shared.workcell.ask(gate.keep_orientation(False))
    assert eventually(lambda: lab.shared.workcell.resting and frames_in(lab, 0.5) >= 3)
    assert frames_in(lab, 1.0) <= 30, "one frame at a time, about twenty a second"
    show(lab, "null", False)
    assert eventually(lambda: rests(lab))
