"""Whatever is under way, the loop has short turns and Stop is heard: studies, maps, clouds, tours, another arm.

A busy machine may be late by the clock; what counts here is how much processor time the longest turn takes. The clock's
figures stand in `make bench ARGS=load` and in the long form of these tests.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

import numpy as np
import pytest
from tests.pages import Hand
from tests.session.labs import after_ticks, eventually, running, state, window
from tests.session.turns import Turns, counted

from helicoide import gate
from helicoide.command import HoldPosition
from helicoide.jobs import chunks
from helicoide.kinematics.workspace import MAP_KINDS
from helicoide.session import mapping
from helicoide.session.lab import Lab
from helicoide.view.panels.study import studies_by_source
from helicoide.view.workspace_rows import TITLES

LONGEST = 0.1
# Those that report most often; all of them run in the long form.
TALKATIVE = ("vargas_01", "vargas_02", "cerbaro_confined_line")


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture(scope="module")
def hand(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()


def under_way(lab: Lab, hand: Hand, over: Callable[[], bool]) -> Turns:
    """What the loop does until something is over, while somebody presses Stop again and again."""
    end = time.monotonic() + 600
    with counted(lab.loop) as turns:
        while True:
            hand.do(hand.page.stop())
            time.sleep(0.2)
            if over():
                break
            assert time.monotonic() < end
    return turns


def drawn(lab: Lab) -> str:
    """The name of the arm that is drawn."""
    robot = None if lab.shared.display is None else lab.shared.display._drawn[0]
    return "" if robot is None else robot.name


@pytest.mark.parametrize("name", TALKATIVE)
def test_a_study_holds_nothing_up(lab: Lab, hand: Hand, name: str) -> None:
    (visitor,) = lab.visitors.values()
    before = visitor.place.study_panel.last
    hand.do(hand.page.give("Study", dict(studies_by_source())[name].en))
    assert eventually(lambda: visitor.place.study_panel.study == name)

    def begun() -> bool:
        """The button can be pressed once the page has heard that there is a study."""
        hand.do(hand.page.press("Run"))
        return (
            eventually(lambda: visitor.place.study_panel.progress is not None, 1.0)
            or visitor.place.study_panel.last is not before
        )

    assert eventually(begun)
    turns = under_way(lab, hand, lambda: visitor.place.study_panel.last is not before)
    assert turns.longest < LONGEST, turns.what
    assert state(lab).request.command == HoldPosition(stopped=True)


@pytest.mark.parametrize("kind", MAP_KINDS)
def test_a_map_holds_nothing_up(lab: Lab, hand: Hand, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chunks, "cached_map", lambda plan: None)
    monkeypatch.setattr(mapping, "SAMPLES", {one: {2: 150_000, 3: 700_000} for one in MAP_KINDS})
    hand.do(hand.page.give("Map", TITLES[kind].en))
    assert eventually(lambda: kind in {place.seat.map_kind for place in lab.seats.places.values()})
    hand.do(hand.page.press("Compute map"))
    assert eventually(lambda: state(lab).workspace.progress is not None)
    turns = under_way(lab, hand, lambda: state(lab).workspace.progress is None)
    assert state(lab).workspace.map is not None
    assert turns.longest < LONGEST, turns.what


def test_another_arm_holds_nothing_up(lab: Lab, hand: Hand) -> None:
    for name in ("puma560", "movemaster"):
        lab.loop.call_soon_threadsafe(lab.shared.arms.change, name)
        turns = under_way(lab, hand, lambda name=name: drawn(lab) == state(lab).robot.name == name)  # type: ignore[misc]
        assert turns.longest < LONGEST, turns.what


def test_a_cloud_of_a_million_points_holds_nothing_up(lab: Lab, hand: Hand) -> None:
    rng = np.random.default_rng(0)
    points = np.column_stack([rng.uniform(0.2, 0.9, (1_000_000, 2)), rng.normal(0.8, 1e-3, 1_000_000)])
    content = points.astype("<f4").tobytes()
    header = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1000000\nHEIGHT 1\n"
    file = f"{header}VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1000000\nDATA binary\n".encode() + content
    lab.shared.workcell.tell(gate.clear_planes())
    lab.loop.call_soon_threadsafe(lab.shared.survey.read, "room.pcd", file, "+z")
    turns = under_way(lab, hand, lambda: "+z" in state(lab).clouds)
    assert turns.longest < LONGEST, turns.what
    lab.shared.workcell.tell(gate.restore_planes())


def test_a_stop_ends_a_tour_and_what_is_worked_out(lab: Lab, hand: Hand) -> None:
    for begin in ("Measure with the camera", "Time-optimal"):
        hand.do(hand.page.press(begin))
        hand.do(hand.page.stop())
        stopped = after_ticks(lab, 20)
        later = after_ticks(lab, 200)
        assert later.request.command == HoldPosition(stopped=True)
        assert (later.arm.q == stopped.arm.q).all()
    lab.shared.workcell.tell(gate.restore_planes())
