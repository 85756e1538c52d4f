"""A link that is opened asks and moves nothing; an own arm, or the shown one, goes there when it is told to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from tests.session.labs import eventually, running, state, window

from helicoide.session.lab import Lab
from helicoide.session.visitor import Visitor
from helicoide.view import requests

HERE = "v=1&robot=movemaster&q=0.3,0.5,-1.2,-0.2,0&camera=1,2,3,0,0,0&tab=algebra&end=1"
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
    "text", ["", HERE[:-7], HERE.replace("movemaster", "hal9000"), HERE.replace("0.3,", ""), "x" * 3000]
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
