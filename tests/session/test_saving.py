"""Progress is loaded, saved and deleted in a thread, seldom; a store that fails is said once, and the lab goes on."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from tests.session.labs import eventually, running, window

from helicoide.lesson import load_lesson
from helicoide.seat import LessonProgress, Seat
from helicoide.session import saving
from helicoide.session.lab import Lab
from helicoide.session.saving import KEPT, NOT_KEPT, Saving
from helicoide.session.seats import Place, Seats
from helicoide.session.visitor import Visitor
from helicoide.session.workcell import FAILED
from helicoide.store.database import Store
from helicoide.store.merging import NO_PROGRESS, Progress
from helicoide.text import HelicoideError, Text
from helicoide.view.requests import ForgetProgress

TOKEN, LESSON = "abcdefghijklmnop", "drive_the_arm"
STEPS = tuple(step.id for step in load_lesson(LESSON).steps)
BROKEN = Text(en="The disk is full.", pt_BR="O disco está cheio.")
FOREVER = 1e6


def done(*steps: str) -> Progress:
    return {LESSON: LessonProgress(LESSON, len(steps), frozenset(steps))}


class Faulty(Store):
    """A store that fails as long as `fault` says so, and counts its calls."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.fault: Exception | None = None
        self.calls: list[str] = []
        self.threads = set[str]()

    def _count(self, call: str) -> None:
        self.calls.append(call)
        self.threads.add(threading.current_thread().name)
        if self.fault is not None:
            raise self.fault

    def load(self, token: str) -> Progress:
        self._count("load")
        return super().load(token)

    def save(self, token: str, progress: Progress, before: Progress = NO_PROGRESS) -> None:
        self._count("save")
        super().save(token, progress, before)

    def forget(self, token: str) -> None:
        self._count("forget")
        super().forget(token)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "progress.sqlite"


@pytest.fixture
def store(path: Path) -> Faulty:
    return Faulty(path)


@pytest.fixture
def said() -> list[Text]:
    return []


@pytest.fixture
def place() -> Place:
    return Place(Seat(TOKEN, "en"))


@pytest.fixture
def kept(store: Faulty, place: Place, said: list[Text]) -> Iterator[Saving]:
    kept = Saving(store, lambda: [place], said.append)
    yield kept
    kept.close()


def advance(place: Place, progress: Progress, kept: Saving) -> None:
    place.seat = replace(place.seat, progress=progress)
    kept.changed(place)


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(60):
        while not condition():
            await asyncio.sleep(0.005)


def run(work: Callable[[], Awaitable[None]]) -> None:
    async def all_of_it() -> None:
        await work()
        for task in asyncio.all_tasks() - {asyncio.current_task()}:
            task.cancel()

    asyncio.run(all_of_it())


def test_a_change_is_saved_at_once_and_further_ones_a_period_later(
    kept: Saving, store: Faulty, place: Place, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving, "PERIOD", FOREVER)

    async def work() -> None:
        advance(place, done(STEPS[0]), kept)
        await until(lambda: place.saved == done(STEPS[0]))
        for _ in range(20):
            advance(place, done(*STEPS[:2]), kept)
            await asyncio.sleep(0.001)

    run(work)
    assert store.calls == ["save"]
    assert Store(path).load(TOKEN) == done(STEPS[0])
    kept.close()
    assert Store(path).load(TOKEN) == done(*STEPS[:2]), "what waits is saved when the lab closes"


def test_the_last_of_many_changes_is_saved(
    kept: Saving, place: Place, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving, "PERIOD", 0.01)

    async def work() -> None:
        for count in range(len(STEPS) + 1):
            advance(place, done(*STEPS[:count]), kept)
            await asyncio.sleep(0.004)
        await until(lambda: place.saved == done(*STEPS))

    run(work)
    assert Store(path).load(TOKEN) == done(*STEPS)


def test_the_store_is_used_in_one_thread_that_is_not_that_of_the_event_loop(
    kept: Saving, store: Faulty, place: Place
) -> None:
    async def work() -> None:
        await kept.load(TOKEN)
        advance(place, done(STEPS[0]), kept)
        await until(lambda: place.saved == place.seat.progress)
        kept.forget(place, print)
        await until(lambda: "forget" in store.calls)

    run(work)
    assert len(store.threads) == 1
    assert threading.current_thread().name not in store.threads


def test_what_is_loaded_is_about_the_lessons_that_there_are(kept: Saving, store: Faulty) -> None:
    strange = {LESSON: LessonProgress(LESSON, 99, frozenset({STEPS[0], "gone"})), "gone": LessonProgress("gone")}
    Store.save(store, TOKEN, strange)

    async def work() -> None:
        assert await kept.load(TOKEN) == {LESSON: LessonProgress(LESSON, len(STEPS), frozenset(STEPS[:1]))}
        for word in (None, "", "x", TOKEN + "=", "é" * 16, "\ud800" * 16):
            assert await kept.load(word) == NO_PROGRESS

    run(work)
    assert store.calls == ["load"], "what is no token is not looked for"


def test_a_store_that_fails_is_said_once_and_tried_again(
    kept: Saving, store: Faulty, place: Place, said: list[Text], path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(saving, "RETRY", 0.005)
    store.fault = HelicoideError(BROKEN)

    async def work() -> None:
        assert await kept.load(TOKEN) == NO_PROGRESS
        advance(place, done(STEPS[0]), kept)
        await until(lambda: store.calls.count("save") > 3)
        assert len(said) == 1
        assert said[0] == kept.note
        assert BROKEN.pt_BR in said[0].pt_BR
        store.fault = None
        await until(lambda: place.saved == done(STEPS[0]))
        assert kept.note == KEPT

    run(work)
    assert Store(path).load(TOKEN) == done(STEPS[0])


def test_a_bug_is_said_and_logged(
    kept: Saving, store: Faulty, said: list[Text], caplog: pytest.LogCaptureFixture
) -> None:
    store.fault = ZeroDivisionError("a bug")

    async def work() -> None:
        assert await kept.load(TOKEN) == NO_PROGRESS

    run(work)
    assert [FAILED.en in text.en for text in said] == [True]
    assert "a bug" in caplog.text


def test_deleted_progress_is_gone_here_and_there(kept: Saving, store: Faulty, place: Place, path: Path) -> None:
    async def work() -> None:
        advance(place, done(*STEPS[:2]), kept)
        place.seat = replace(place.seat, lesson=LESSON)
        kept.forget(place, print)
        assert place.seat.progress == NO_PROGRESS
        assert place.seat.lesson is None
        await until(lambda: "forget" in store.calls and place.saved == NO_PROGRESS)

    run(work)
    assert Store(path).load(TOKEN) == NO_PROGRESS


def test_progress_that_cannot_be_deleted_stays_and_that_is_said(kept: Saving, store: Faulty, place: Place) -> None:
    refusals: list[Text] = []

    async def work() -> None:
        advance(place, done(STEPS[0]), kept)
        await until(lambda: place.saved == done(STEPS[0]))
        store.fault = HelicoideError(BROKEN)
        kept.forget(place, refusals.append)
        await until(lambda: bool(refusals))

    run(work)
    assert BROKEN.en in refusals[0].en
    assert place.seat.progress == done(STEPS[0])


def test_without_a_store_nothing_is_kept_and_that_is_said(place: Place) -> None:
    kept = Saving(None, lambda: [place], print)

    async def work() -> None:
        assert await kept.load(TOKEN) == NO_PROGRESS
        advance(place, done(STEPS[0]), kept)
        assert kept.note == NOT_KEPT
        kept.forget(place, print)
        assert place.seat.progress == NO_PROGRESS

    run(work)
    kept.close()


def test_a_browser_keeps_its_token_when_the_lab_is_another_one() -> None:
    seats = Seats(None)
    place = seats.take(TOKEN, "en", progress=done(STEPS[0]))
    assert place.seat.token == TOKEN
    assert place.seat.progress == place.saved == done(STEPS[0])
    assert seats.take(TOKEN, "en", progress=NO_PROGRESS) is place
    for word in (None, "", "short", "é" * 16, TOKEN + TOKEN):
        assert len(seats.take(word, "en").seat.token) == len(TOKEN)


def visitor_of(lab: Lab, token: str) -> Visitor:
    return next(one for one in lab.visitors.values() if one.place.seat.token == token)


def test_progress_outlives_the_lab_and_deletion_too(path: Path) -> None:
    with running("planar2r", Store(path)) as lab:
        hand = window(lab)
        token = hand.page.seat
        assert token is not None
        visitor = visitor_of(lab, token)
        update = lambda seat: replace(seat, progress=done(STEPS[0]))  # noqa: E731
        lab.loop.call_soon_threadsafe(visitor.reseat, update)
        assert eventually(lambda: visitor.place.saved == done(STEPS[0]))
        hand.close()
    with running("planar2r", Store(path)) as lab:
        hands = [window(lab, seat=token) for _ in range(2)]
        assert [hand.page.seat for hand in hands] == [token, token]
        visitor = visitor_of(lab, token)
        assert visitor.place.seat.progress == done(STEPS[0])
        assert visitor.place.windows == 2
        assert lab.view(visitor.window).progress_note == KEPT
        visitor.window.link.made_at = float("inf")  # as if the page had just made it
        lab.loop.call_soon_threadsafe(visitor.window.act, ForgetProgress())
        assert eventually(lambda: not Store(path).load(token))
        assert not visitor.place.seat.progress
        for hand in hands:
            hand.close()


def test_a_lab_with_a_damaged_store_goes_on_without_it(path: Path) -> None:
    path.write_bytes(b"dear diary, " * 900)
    with running("planar2r", Store(path)) as lab:
        hand = window(lab, seat=TOKEN)
        assert eventually(lambda: any("damaged" in text for text in hand.page.told))
        visitor = visitor_of(lab, TOKEN)
        lab.loop.call_soon_threadsafe(visitor.reseat, lambda seat: replace(seat, progress=done(STEPS[0])))
        assert eventually(lambda: visitor.place.seat.progress == done(STEPS[0]))
        assert "damaged" in lab.view(visitor.window).progress_note.en
        assert sum("damaged" in text for text in hand.page.told) == 1
        hand.close()
    assert path.read_bytes() == b"dear diary, " * 900
