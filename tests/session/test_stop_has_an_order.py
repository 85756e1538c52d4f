"""What was sent before a stop does nothing after it, from whichever window; what is stale does nothing at all."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from operator import attrgetter

import pytest
from tests.pages import Hand
from tests.session.labs import SLOW, after_ticks, eventually, running, state, window

from helicoide.command import HoldPosition
from helicoide.session.lab import Lab
from helicoide.state import State, initial_state
from helicoide.view.window import LATE

BUSY = 0.3
HERE = {"wxyz": (0.0, 1.0, 0.0, 0.0), "position": (0.5, 0.1, 0.3)}
Ask = Callable[[Hand], None]


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture
def one(lab: Lab) -> Iterator[Hand]:
    lab.shared.workcell.tell(lambda state: initial_state(state.robot))
    assert eventually(lambda: state(lab).request.command == HoldPosition() and not state(lab).arm.moving)
    hand = window(lab)
    yield hand
    hand.close()


@pytest.fixture
def other(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()


def busy(lab: Lab) -> None:
    """The event loop is held up; what comes meanwhile waits."""
    lab.loop.call_soon_threadsafe(time.sleep, BUSY)
    time.sleep(0.05)


def give(label: str, value: object) -> Ask:
    return lambda hand: hand.do(hand.page.give(label, value))


def drag(hand: Hand) -> None:
    hand.do(hand.page.gizmo("DragStart"))
    hand.do(hand.page.gizmo("Update", **HERE))


def drag_of_a_plane(hand: Hand) -> None:
    hand.do(hand.page.gizmo("DragStart", "/handles/plane 0"))
    hand.do(hand.page.gizmo("Update", "/handles/plane 0", wxyz=(0.0, 1.0, 0.0, 0.0), position=(0.5, 0.0, 0.7)))


ASKED: dict[str, Ask] = {
    "slider": give("1 waist", 40.0),
    "play": give("Play", True),
    "target": give("x y z [mm]", (500.0, 100.0, 300.0)),
    "posture": give("Go to pose", "arm stretched"),
    "gripper": give("Gripper [%]", 80.0),
    "drag": drag,
    "plane": drag_of_a_plane,
    "time-optimal": give("Time-optimal", True),
    "another arm": give("Arm", "SCARA"),
}


def unmoved(lab: Lab, before: State) -> bool:
    """Whether the arm has been stopped, and neither it nor its planes have changed since."""
    after = after_ticks(lab)
    return bool(
        after.request.command == HoldPosition(stopped=True)
        and (after.arm.q == before.arm.q).all()
        and after.problem is before.problem
        and after.request.gripper == before.request.gripper
    )


@pytest.mark.parametrize("asked", ASKED)
def test_what_is_fresh_counts(lab: Lab, one: Hand, asked: str) -> None:
    before = state(lab)
    ASKED[asked](one)
    parts = ("request.command", "request.gripper", "problem", "robot")
    assert eventually(lambda: any(attrgetter(part)(state(lab)) is not attrgetter(part)(before) for part in parts))
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, before.robot.name)
    assert eventually(lambda: state(lab).robot is before.robot)


@pytest.mark.parametrize("asked", ASKED)
def test_what_a_window_sent_before_its_stop_does_nothing(lab: Lab, one: Hand, asked: str) -> None:
    """Stop overtakes the rest on a channel of its own: both wait while the loop is busy. What comes in before it counts
    before it; what comes in after it, not at all.
    """
    busy(lab)
    ASKED[asked](one)
    one.do(one.page.stop())
    assert eventually(lambda: state(lab).request.command == HoldPosition(stopped=True))
    assert unmoved(lab, state(lab))


@pytest.mark.parametrize("asked", ASKED)
def test_what_another_window_sent_before_it_knew_does_nothing(lab: Lab, one: Hand, other: Hand, asked: str) -> None:
    other.page.passes = False
    one.do(one.page.stop())
    before = state(lab)
    assert eventually(lambda: state(lab).request.command == HoldPosition(stopped=True))
    ASKED[asked](other)
    assert unmoved(lab, before)


def test_a_drag_that_was_under_way_stays_dead_until_it_begins_anew(lab: Lab, one: Hand, other: Hand) -> None:
    drag(other)
    assert eventually(lambda: state(lab).request.drag is not None)
    one.do(one.page.stop())
    assert eventually(lambda: state(lab).request.command == HoldPosition(stopped=True))
    before = state(lab)
    other.do(other.page.gizmo("Update", wxyz=HERE["wxyz"], position=(0.4, -0.1, 0.3)))
    other.do(other.page.gizmo("DragEnd"))
    assert unmoved(lab, before)
    drag(other)
    assert eventually(lambda: state(lab).request.drag is not None)
    assert eventually(lambda: state(lab).arm.moving)


def test_what_was_made_after_the_stop_was_known_counts(lab: Lab, one: Hand, other: Hand) -> None:
    one.do(one.page.stop())
    for hand in (one, other):
        before = state(lab).request.command
        give("1 waist", 5.0 if hand is one else 6.0)(hand)
        assert eventually(lambda before=before: state(lab).request.command is not before)  # type: ignore[misc]


@pytest.mark.parametrize("asked", ASKED)
def test_what_is_too_old_does_nothing_and_is_told(lab: Lab, one: Hand, asked: str) -> None:
    before, one.page.old = state(lab), 1000 * SLOW + 100.0
    for _ in range(3):
        ASKED[asked](one)
    assert eventually(lambda: bool(one.page.told))
    after = after_ticks(lab)
    assert one.page.told == [LATE["en"]]  # once, not for each message
    assert after.request.command is before.request.command
    assert after.problem is before.problem
    assert after.robot is before.robot


def test_the_time_of_day_of_a_page_does_not_matter(lab: Lab) -> None:
    hand = Hand(lab.server.get_port(), ahead=86_400.0)
    assert eventually(hand.page.may_drive.is_set)
    give("1 waist", 7.0)(hand)
    assert eventually(lambda: abs(state(lab).arm.q[0] - 0.1222) < 1e-3)
    hand.close()


@pytest.mark.parametrize("asked", ASKED)
def test_a_page_without_its_own_channel_drives_nothing(lab: Lab, one: Hand, asked: str) -> None:
    before = state(lab)
    one.do(one.page.hang_up())
    assert eventually(lambda: not any(visitor.window.link.channels for visitor in lab.visitors.values()))
    ASKED[asked](one)
    after = after_ticks(lab)
    assert after.request.command is before.request.command
    assert after.problem is before.problem
    assert after.robot is before.robot


def test_a_drag_ends_when_the_channel_does(lab: Lab, one: Hand) -> None:
    drag(one)
    assert eventually(lambda: state(lab).request.drag is not None)
    one.do(one.page.hang_up())
    assert eventually(lambda: state(lab).request.drag is None)


def test_a_stop_reaches_every_arm_that_a_real_one_follows(lab: Lab, one: Hand, other: Hand) -> None:
    give("Use my own arm", True)(other)
    assert eventually(lambda: {visitor.bay is lab.shared for visitor in lab.visitors.values()} == {True, False})
    give("Play", True)(one)
    assert eventually(lambda: state(lab).arm.moving)
    other.do(other.page.stop())
    after_ticks(lab)
    assert state(lab).request.command != HoldPosition(stopped=True), "an arm of one's own is stopped alone"
    lab.shared.workcell.connected = True
    other.do(other.page.stop())
    assert eventually(lambda: state(lab).request.command == HoldPosition(stopped=True))
    assert eventually(lambda: one.page.notice.get("everywhere") is True)
    lab.shared.workcell.connected = False
