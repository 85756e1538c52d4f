"""A link that is opened asks and moves nothing; an own arm, or the shown one, goes there when it is told to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from tests.session.labs import eventually, running, state, window

from helicoide import gate
from helicoide.session.lab import Lab
from helicoide.session.visitor import SHEET_OPENED, SHEET_REPLACED, Visitor
from helicoide.sheet import NameSlider, Sheet, SheetLine, packed_sheet
from helicoide.text import Text
from helicoide.view import requests
from helicoide.view.share import encode_link

HERE = "v=1&robot=movemaster&q=0.3,0.5,-1.2,-0.2,0&camera=1,2,3,0,0,0&tab=algebra&end=1"
SHEET = Sheet((SheetLine("e1"), SheetLine("a + 1")), (("a", NameSlider(0.5, 0.0, 1.0)),))
OWN = Sheet((SheetLine("L1"),))
ELSEWHERE = "v=1&robot=planar2r&q=0.3,0.5&camera=1,2,3,0,0,0&tab=robot&end=1"


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture
def visitor(lab: Lab) -> Iterator[Visitor]:
    hand = window(lab)
    assert eventually(lambda: lab.clock.idle)
    try:
        yield list(lab.visitors.values())[-1]
    finally:
        hand.close()
        assert eventually(lambda: not lab.visitors)


def open_link(lab: Lab, visitor: Visitor, text: str) -> None:
    lab.loop.call_soon_threadsafe(visitor.open_link, text)


def act(lab: Lab, visitor: Visitor, request: requests.PageRequest) -> None:
    visitor.window.link.made_at = float("inf")  # as if the page had just made it
    lab.loop.call_soon_threadsafe(visitor.window.act, request)


def test_an_opened_link_moves_the_camera_and_no_arm(lab: Lab, visitor: Visitor) -> None:
    before = state(lab)
    open_link(lab, visitor, HERE)
    assert eventually(lambda: visitor.place.seat.linked is not None)
    np.testing.assert_allclose(visitor.window.client.camera.position, [1, 2, 3])
    assert state(lab).arm.q is before.arm.q
    assert state(lab).request.command is before.request.command
    act(lab, visitor, requests.CloseLink())
    assert eventually(lambda: visitor.place.seat.linked is None)
    assert state(lab).arm.q is before.arm.q


@pytest.mark.parametrize(
    "text",
    [
        "",
        HERE[:-7],
        HERE.replace("movemaster", "hal9000"),
        HERE.replace("0.3,", ""),
        "x" * 3000,
        encode_link(SHEET)[:-3],
        HERE.replace("&end", "&sheet=eJx&end"),
        HERE.replace("0.3,", "").replace("&end", f"&sheet={packed_sheet(SHEET)}&end"),
    ],
)
def test_a_link_that_cannot_be_read_is_said_and_changes_nothing(lab: Lab, visitor: Visitor, text: str) -> None:
    said: list[object] = []
    visitor.window.tell = said.append  # type: ignore[method-assign]
    seat = visitor.place.seat
    open_link(lab, visitor, text)
    assert eventually(lambda: len(said) == 1)
    assert visitor.place.seat is seat


def test_the_posture_of_a_link_is_executed_on_a_press(lab: Lab, visitor: Visitor) -> None:
    open_link(lab, visitor, HERE)
    assert eventually(lambda: visitor.place.seat.linked is not None)
    act(lab, visitor, requests.TakeLink(own=False))
    assert eventually(lambda: visitor.place.seat.linked is None)
    assert eventually(lambda: bool(np.allclose(state(lab).arm.q, [0.3, 0.5, -1.2, -0.2, 0], atol=1e-3)))


def test_a_posture_outside_the_limits_is_refused(lab: Lab, visitor: Visitor) -> None:
    before = state(lab)
    lab.shared.workcell.tell(lambda state: replace(state, notice=None))
    open_link(lab, visitor, HERE.replace("0.3,", "99,"))
    assert eventually(lambda: visitor.place.seat.linked is not None)
    act(lab, visitor, requests.TakeLink(own=False))
    assert eventually(lambda: visitor.place.seat.linked is None)
    assert eventually(lambda: state(lab).notice is not None)
    assert state(lab).arm.q is before.arm.q


def test_a_link_about_another_robot_loads_nothing_into_the_shared_arm(lab: Lab, visitor: Visitor) -> None:
    """As when another window has loaded a robot after the page offered to go to the posture."""
    open_link(lab, visitor, ELSEWHERE)
    assert eventually(lambda: visitor.place.seat.linked is not None)
    wanted = lab.shared.arms.wanted
    act(lab, visitor, requests.TakeLink(own=False))
    act(lab, visitor, requests.ForSeat(lambda seat: replace(seat, dark=True)))
    assert eventually(lambda: visitor.place.seat.dark)
    assert lab.shared.arms.wanted == wanted
    assert visitor.place.seat.linked is not None


def test_another_arm_is_shown_on_an_own_one(lab: Lab, visitor: Visitor) -> None:
    before = state(lab)
    open_link(lab, visitor, ELSEWHERE)
    assert eventually(lambda: visitor.place.seat.linked is not None)
    act(lab, visitor, requests.TakeLink(own=True))
    assert eventually(lambda: visitor.place.own is not None)
    own = visitor.place.own
    assert own is not None
    assert eventually(lambda: own.state.robot.name == "planar2r")
    assert eventually(lambda: bool(np.allclose(own.state.arm.q, [0.3, 0.5], atol=1e-3)))
    assert eventually(lambda: visitor.place.seat.linked is None)
    assert state(lab).robot is before.robot
    assert state(lab).arm.q is before.arm.q


def test_a_link_about_the_present_posture_asks_nothing_and_ends_an_older_one(lab: Lab, visitor: Visitor) -> None:
    open_link(lab, visitor, ELSEWHERE)
    assert eventually(lambda: visitor.place.seat.linked is not None)
    visitor.window.client.camera.position = (3.0, 3.0, 3.0)
    q = ",".join(f"{value:.6g}" for value in state(lab).arm.q)
    open_link(lab, visitor, HERE.replace("0.3,0.5,-1.2,-0.2,0", q))
    assert eventually(lambda: bool(np.allclose(visitor.window.client.camera.position, [1, 2, 3])))
    assert visitor.place.seat.linked is None


def test_a_sheet_replaces_that_of_the_seat_and_undo_brings_it_back(lab: Lab, visitor: Visitor) -> None:
    said: list[Text] = []
    visitor.window.tell = said.append  # type: ignore[method-assign]
    act(lab, visitor, requests.ForSeat(lambda seat: replace(seat, sheet=OWN)))
    assert eventually(lambda: visitor.place.seat.sheet == OWN)
    act(lab, visitor, requests.OpenLink(f" http://127.0.0.1:8080/?x=1#{encode_link(SHEET)}\n"))
    assert eventually(lambda: visitor.place.seat.sheet == SHEET)
    assert eventually(lambda: said == [SHEET_REPLACED])
    change = visitor.view(True).sheet_undo
    assert change is not None
    assert change.other == OWN
    act(lab, visitor, requests.Undo())
    assert eventually(lambda: visitor.place.seat.sheet == OWN)
    act(lab, visitor, requests.Redo())
    assert eventually(lambda: visitor.place.seat.sheet == SHEET)
    assert [str(text["en"]) for text in said[1:]] == ["Undone: sheet changed.", "Redone: sheet changed."]


def test_a_view_brings_its_sheet_and_one_without_keeps_the_own_one(lab: Lab, visitor: Visitor) -> None:
    said: list[Text] = []
    visitor.window.tell = said.append  # type: ignore[method-assign]
    open_link(lab, visitor, HERE.replace("&end", f"&sheet={packed_sheet(SHEET)}&end"))
    assert eventually(lambda: visitor.place.seat.sheet == SHEET)
    assert eventually(lambda: said == [SHEET_OPENED])
    open_link(lab, visitor, ELSEWHERE)
    assert eventually(lambda: (linked := visitor.place.seat.linked) is not None and linked.robot == "planar2r")
    assert visitor.place.seat.sheet == SHEET


def test_undo_takes_the_newest_change_of_sheet_and_scene(lab: Lab, visitor: Visitor) -> None:
    """The sheet, a plane, the sheet again: they are undone from the newest one, and redone in their order."""
    zones = state(lab).problem.zones
    depth = len(state(lab).history.undo)
    sheets = [Sheet((SheetLine(text),)) for text in ("1", "2")]

    def enter(sheet: Sheet) -> None:
        act(lab, visitor, requests.ForSeat(lambda seat: replace(seat, sheet=sheet)))
        assert eventually(lambda: visitor.place.seat.sheet == sheet)

    enter(sheets[0])
    act(lab, visitor, requests.ForArm(gate.set_zones(zones.critical, zones.warning + 0.02)))
    assert eventually(lambda: len(state(lab).history.undo) == depth + 1)
    enter(sheets[1])
    wider = state(lab).problem.zones
    act(lab, visitor, requests.Undo())
    assert eventually(lambda: visitor.place.seat.sheet == sheets[0])
    assert state(lab).problem.zones == wider
    act(lab, visitor, requests.Undo())
    assert eventually(lambda: state(lab).problem.zones == zones)
    assert visitor.place.seat.sheet == sheets[0]
    act(lab, visitor, requests.Undo())
    assert eventually(lambda: visitor.place.seat.sheet == Sheet())
    for done in (
        lambda: visitor.place.seat.sheet == sheets[0],
        lambda: state(lab).problem.zones == wider,
        lambda: visitor.place.seat.sheet == sheets[1],
    ):
        act(lab, visitor, requests.Redo())
        assert eventually(done)


def test_a_slider_that_is_held_is_one_change(lab: Lab, visitor: Visitor) -> None:
    def move(value: float) -> None:
        slider = NameSlider(value, 0.0, 1.0)
        act(lab, visitor, requests.ForSeat(lambda seat: replace(seat, sheet=seat.sheet.with_slider("a", slider))))
        assert eventually(lambda: visitor.place.seat.sheet.slider("a") == slider)

    for value in (0.1, 0.2, 0.3):
        move(value)
    assert len(visitor.place.seat.sheet_history.undo) == 1
    lab.loop.call_soon_threadsafe(visitor.finish_change)
    assert eventually(lambda: not visitor.place.seat.sheet_history.unfinished)
    move(0.9)
    assert len(visitor.place.seat.sheet_history.undo) == 2
    act(lab, visitor, requests.Undo())
    assert eventually(lambda: visitor.place.seat.sheet.slider("a").value == 0.3)
