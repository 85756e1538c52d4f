"""Who comes to the lab, who goes, and what it costs while nobody asks anything."""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from tests.pages import Hand, Message
from tests.session.labs import after_ticks, eventually, running, state, window

from helicoide import gate, lesson
from helicoide.command import HoldPosition
from helicoide.geometry import rotation
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.lesson import StepWatch
from helicoide.session import arms, bay
from helicoide.session.display import Display
from helicoide.session.lab import Lab
from helicoide.session.seats import KEPT, LIVES_ON, Seats
from helicoide.session.workcell import Workcell
from helicoide.state import initial_state
from helicoide.view.pose import place_point
from helicoide.view.window import Window
from helicoide.view.window_view import View

SILENT = 30


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


def test_a_lab_at_rest_does_nothing(lab: Lab, hand: Hand) -> None:
    """No tick, no frame and no word: counted over a second, after all that was left to say has been said."""
    hand.do(hand.page.give("1 waist", 3.0))
    assert eventually(lambda: abs(state(lab).arm.q[0] - 0.05236) < 1e-3)
    assert eventually(lambda: lab.clock.idle)
    time.sleep(1.5)
    display = lab.shared.display
    assert display is not None

    def done() -> tuple[int, int, int]:
        return lab.shared.workcell.ticks, display.frames, hand.page.frames

    before = done()
    time.sleep(1.0)
    assert done() == before
    hand.do(hand.page.give("1 waist", 4.0))
    assert eventually(lambda: all(new > old for new, old in zip(done(), before, strict=True)))


def test_windows_that_never_answer_hold_nobody_up(lab: Lab) -> None:
    silent = [Hand(lab.server.get_port(), silent=True) for _ in range(SILENT)]
    assert eventually(lambda: len(lab.lines) == SILENT)
    hand = window(lab)
    assert len(lab.visitors) == 1, "it was furnished before any of those was given up"
    for one in (*silent, hand):
        one.close()
    assert eventually(lambda: not lab.lines and not lab.visitors)


def test_the_browsers_language_is_spoken_and_a_seat_found_again(lab: Lab) -> None:
    first = window(lab, languages=("pt-BR", "en"))
    assert eventually(lambda: "Reproduzir" in first.page.made)
    token = first.page.seat
    assert token in lab.seats.places
    first.close()
    again = window(lab, seat=token, languages=("en",))
    assert again.page.seat == token
    assert eventually(lambda: "Reproduzir" in again.page.made)
    again.close()


def test_a_choice_made_while_the_page_is_built_is_followed(lab: Lab, monkeypatch: pytest.MonkeyPatch) -> None:
    fill = Window._fill
    chosen: list[Window] = []

    async def filled_meanwhile(window: Window, view: View) -> None:
        await fill(window, view)
        if not chosen:
            chosen.append(window)
            visitor = lab.visitors[window.client.client_id]
            visitor.reseat(lambda seat: replace(seat, language="pt_BR", dark=True))

    monkeypatch.setattr(Window, "_fill", filled_meanwhile)
    hand = window(lab, languages=("en",))
    assert eventually(lambda: "Reproduzir" in hand.page.made)
    assert eventually(lambda: chosen[0].dark)
    hand.close()


def test_a_lesson_looks_only_at_its_own_arm(lab: Lab, hand: Hand) -> None:
    """While its arm is on its way another one still stands there, whose state its goals do not know."""
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: state(lab).robot.name == "planar2r")
    (visitor,) = lab.visitors.values()
    in_lesson = lesson.entered(visitor.place.seat, "drive_the_arm")
    found = lesson.load_lesson("drive_the_arm")
    for number in range(len(found.steps)):
        seat = lesson.turned_to(found, in_lesson, number)
        assert lesson.judged_step(found, state(lab), seat, StepWatch(), 0.0) == (seat, StepWatch())
    hand.do(hand.page.give("Lesson", found.title.en))
    assert eventually(lambda: state(lab).robot.name == "movemaster")
    assert eventually(lambda: visitor.place.seat.lesson == "drive_the_arm")
    visitor.seat_as(lesson.progressed(found.steps[0], visitor.place.seat))
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: visitor.place.seat.lesson is None)
    assert visitor.place.seat.progress["drive_the_arm"].done == {"joint"}, "what was done stays done"
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "movemaster")
    assert eventually(lambda: state(lab).robot.name == "movemaster")


def test_a_lesson_is_left_whose_arm_was_gone_before_it_was_drawn(lab: Lab, hand: Hand) -> None:
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    display, (visitor,) = put_up(lab), lab.visitors.values()
    assert eventually(lambda: display._drawn[0] is not None and display._drawn[0].name == "planar2r")
    asyncio.run_coroutine_threadsafe(display._putting_up.acquire(), lab.loop).result()
    hand.do(hand.page.give("Lesson", lesson.load_lesson("drive_the_arm").title.en))
    assert eventually(lambda: state(lab).robot.name == "movemaster")
    assert visitor.place.seat.lesson == "drive_the_arm"
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: state(lab).robot.name == "planar2r")
    lab.loop.call_soon_threadsafe(display._putting_up.release)
    assert eventually(lambda: visitor.place.seat.lesson is None)
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "movemaster")
    assert eventually(lambda: state(lab).robot.name == "movemaster")


def test_a_lesson_stays_that_was_chosen_while_another_arm_was_on_its_way(
    lab: Lab, hand: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = hand.page.made["Lesson"]
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: state(lab).robot.name == "planar2r" and hand.page.made["Lesson"] is not first)
    second = hand.page.made["Lesson"]
    (visitor,) = lab.visitors.values()
    coming, load = threading.Event(), arms._loaded

    def slowly(name: str, lengths: tuple[str, ...]) -> Robot:
        coming.wait(60)
        return load(name, lengths)

    monkeypatch.setattr(arms, "_loaded", slowly)
    hand.do(hand.page.give("Lesson", lesson.load_lesson("drive_the_arm").title.en))
    assert eventually(lambda: visitor.place.seat.lesson == "drive_the_arm")
    lab.loop.call_soon_threadsafe(visitor.meet)
    lab.loop.call_soon_threadsafe(coming.set)
    assert eventually(lambda: state(lab).robot.name == "movemaster" and hand.page.made["Lesson"] is not second)
    assert visitor.place.seat.lesson == "drive_the_arm"
    hand.do(hand.page.give("Lesson", "Explore freely"))
    assert eventually(lambda: visitor.place.seat.lesson is None)


def test_an_arm_of_ones_own_is_refused_in_words_when_there_are_too_many(
    lab: Lab, hand: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bay, "MOST_OWN", 0)
    heard: list[str] = []
    hand.page.heard = lambda message: heard.append(str(message))
    hand.do(hand.page.give("Use my own arm", True))
    assert eventually(lambda: any("All 0 separate arms" in message for message in heard))
    assert len(lab.bays.workcells) == 1


def test_a_window_that_fails_to_be_drawn_costs_nobody_else(
    lab: Lab, hand: Hand, caplog: pytest.LogCaptureFixture
) -> None:
    other = window(lab)
    broken = list(lab.visitors.values())[-1].window
    assert eventually(lambda: broken.layers is not None)
    assert broken.layers is not None
    broken.layers.layers["target"].update = lambda old, new: 1 / 0  # type: ignore[method-assign]
    before = hand.page.frames
    lab.shared.workcell.tell(gate.set_joint(0, 0.2))
    assert eventually(lambda: hand.page.frames > before + 5)
    failed = [record for record in caplog.records if "layer target" in record.getMessage()]
    assert len(failed) == 1
    other.close()


def put_up(lab: Lab) -> Display:
    """The display of the shared arm, which somebody sees."""
    assert eventually(lambda: lab.shared.display is not None and bool(lab.shared.display.windows))
    assert lab.shared.display is not None
    return lab.shared.display


def test_a_window_that_leaves_while_it_enters_is_not_drawn(
    lab: Lab, hand: Hand, caplog: pytest.LogCaptureFixture
) -> None:
    display, before = put_up(lab), len(lab.visitors)
    asyncio.run_coroutine_threadsafe(display._putting_up.acquire(), lab.loop).result()
    brief = Hand(lab.server.get_port())
    assert eventually(lambda: len(display._entering) == 1)
    brief.close()
    assert eventually(lambda: len(lab.visitors) == before)
    lab.loop.call_soon_threadsafe(display._putting_up.release)
    hand.do(hand.page.give("1 waist", 2.0))
    assert eventually(lambda: abs(state(lab).arm.q[0] - 0.0349) < 1e-3)
    frames = display.frames
    hand.do(hand.page.give("1 waist", 3.0))
    assert eventually(lambda: display.frames > frames)
    assert len(display.windows) == before
    assert caplog.records == []


def test_a_window_that_enters_while_another_arm_comes_is_furnished_for_it(lab: Lab, hand: Hand) -> None:
    display, before = put_up(lab), state(lab).robot
    asyncio.run_coroutine_threadsafe(display._putting_up.acquire(), lab.loop).result()
    late = Hand(lab.server.get_port())
    assert eventually(lambda: len(display._entering) == 1)
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: state(lab).robot is not before)
    lab.loop.call_soon_threadsafe(display._putting_up.release)
    assert eventually(lambda: {visitor.window.robot for visitor in lab.visitors.values()} == {state(lab).robot})
    late.close()
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, before.name)
    assert eventually(lambda: state(lab).robot.name == before.name)


def test_a_display_that_somebody_is_about_to_enter_stays_when_the_last_one_leaves(lab: Lab) -> None:
    first = window(lab)
    display = put_up(lab)
    asyncio.run_coroutine_threadsafe(display._putting_up.acquire(), lab.loop).result()
    second = Hand(lab.server.get_port())
    assert eventually(lambda: len(display._entering) == 1)
    first.close()
    assert eventually(lambda: not display.windows)
    lab.loop.call_soon_threadsafe(display._putting_up.release)
    assert eventually(lambda: len(display.windows) == 1 and second.page.may_drive.is_set())
    frames = second.page.frames
    second.do(second.page.give("1 waist", 5.0))
    assert eventually(lambda: second.page.frames > frames + 5)
    second.close()
    assert eventually(lambda: not lab.visitors)


def test_a_window_that_leaves_while_others_are_furnished_for_another_arm_costs_nobody(
    lab: Lab, hand: Hand, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    leaves, stays = window(lab), window(lab)
    display, before = put_up(lab), state(lab).robot
    assert eventually(lambda: len(display.windows) == 3)
    first, goes, last = display.windows
    goes_on = asyncio.Event()

    async def slow(view: View) -> None:
        await goes_on.wait()
        await Window.fill(first, view)

    monkeypatch.setattr(first, "fill", slow)
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, "planar2r")
    assert eventually(lambda: display._drawn[0] is not before)
    leaves.close()
    assert eventually(lambda: goes not in display.windows)
    lab.loop.call_soon_threadsafe(goes_on.set)
    assert eventually(lambda: first.robot is last.robot is state(lab).robot is not before)
    stays.close()
    assert caplog.records == []
    lab.loop.call_soon_threadsafe(lab.shared.arms.change, before.name)
    assert eventually(lambda: first.robot.name == before.name)


def test_what_takes_longer_than_a_tick_is_no_part_of_one(lab: Lab, hand: Hand) -> None:
    """A target that is let go out of reach is searched for elsewhere, and then settles on what the arm can do."""
    hand.do(hand.page.gizmo("DragStart"))
    hand.do(hand.page.gizmo("Update", wxyz=(0.0, 1.0, 0.0, 0.0), position=(1.2, 0.0, 0.4)))
    hand.do(hand.page.gizmo("DragEnd"))
    assert eventually(lambda: state(lab).request.searched)
    assert state(lab).request.command.T_world_target[0, 3] < 1.0  # type: ignore[union-attr]
    lab.shared.workcell.tell(gate.get_ready())
    assert eventually(lambda: state(lab).request.command == HoldPosition())
    after_ticks(lab)


def test_a_drag_ends_where_the_page_let_go(lab: Lab, hand: Hand) -> None:
    """Even if a frame of a state in which it had not begun was drawn meanwhile. The page is told the pose again."""
    told: list[float] = []

    def heard(message: Message) -> None:
        if message["type"] == "SetPositionMessage" and message["name"] == "/target":
            told.append(message["position"][2])

    (visitor,) = lab.visitors.values()
    assert eventually(lambda: visitor.window.layers is not None)
    gizmo = visitor.window.layers.layers["target"].gizmo  # type: ignore[union-attr, attr-defined]
    T = state(lab).T_world_tool
    before, after = T[:3, 3], T[:3, 3] - [0.0, 0.0, 0.02]
    hand.do(hand.page.gizmo("DragStart"))
    wxyz = tuple(rotation.from_matrix(T[:3, :3]).tolist())
    hand.do(hand.page.gizmo("Update", wxyz=wxyz, position=tuple(after.tolist())))
    assert eventually(lambda: np.allclose(gizmo.position, after))
    lab.loop.call_soon_threadsafe(place_point, gizmo, before)
    assert eventually(lambda: np.allclose(gizmo.position, before))
    hand.page.heard = heard
    hand.do(hand.page.gizmo("DragEnd"))
    assert eventually(lambda: state(lab).request.drag is None and not state(lab).arm.moving)
    assert state(lab).request.command.T_world_target[2, 3] == pytest.approx(after[2], abs=1e-6)  # type: ignore[union-attr]
    assert eventually(lambda: bool(told) and told[-1] == pytest.approx(after[2], abs=1e-6))


def test_seats_that_nobody_uses_are_forgotten_and_their_arms_rest() -> None:
    seats = Seats(None)
    cell = Workcell(initial_state(load_robot("movemaster")), lambda: None, ThreadPoolExecutor(1))
    used, left = seats.take(None, "en"), seats.take(None, "pt_BR")
    used.own = left.own = cell
    seats.leave(left)
    seats.tidy(left.left + LIVES_ON - 1)
    assert not cell.paused
    seats.tidy(left.left + LIVES_ON + 1)
    assert cell.paused
    assert seats.take(left.seat.token, "en") is left
    seats.leave(left)
    seats.tidy(left.left + KEPT + 1)
    assert list(seats.places.values()) == [used]
