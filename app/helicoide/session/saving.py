"""Progress in the store: loaded when a person comes, saved when it changes, deleted when they ask for it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

from helicoide import lesson
from helicoide.session.seats import Place, is_token
from helicoide.session.workcell import FAILED
from helicoide.store.answer_check import without_bad_answers
from helicoide.store.database import Store
from helicoide.store.known import known_progress
from helicoide.store.merging import NO_PROGRESS, Progress, merge_progress
from helicoide.text import HelicoideError, Text
from helicoide.view.progress_rows import steps_of

# s between two saves of one person, and to the next try after one that failed
PERIOD, RETRY = 1.0, 20.0
KEPT = Text(
    en="This lab keeps your progress for this browser.",
    pt_BR="Este laboratório guarda seu progresso para este navegador.",
)
NOT_KEPT = Text(
    en="This lab does not keep your progress: save it as a file before you leave.",
    pt_BR="Este laboratório não guarda seu progresso: salve-o como arquivo antes de sair.",
)
GOES_ON = Text(
    en="{why} The lab goes on without it: save your progress as a file.",
    pt_BR="{why} O laboratório segue sem isso: salve seu progresso como um arquivo.",
)
NOT_DELETED = Text(en="Your progress was not deleted. {why}", pt_BR="Seu progresso não foi apagado. {why}")
log = logging.getLogger("helicoide")
Result = TypeVar("Result")


class Saving:
    """Loads and saves the progress of places, one after another in a thread. Use it only on the event loop.

    store: None if progress is not kept; places: those of all users; tell: shows a text in every window; failure: why
    the store could not be used the last time, else None.
    """

    def __init__(
        self, store: Store | None, places: Callable[[], Iterable[Place]], tell: Callable[[Text], object]
    ) -> None:
        self.store, self.places, self.tell = store, places, tell
        self.failure: Text | None = None
        self._thread = ThreadPoolExecutor(1, "helicoide store")
        self._tasks: set[asyncio.Task[None]] = set()
        self._saved: set[Place] = set()  # those with a task that saves their changes
        self._closed = False

    @property
    def note(self) -> Text:
        """Whether progress is kept, for the page."""
        return self.failure or (NOT_KEPT if self.store is None else KEPT)

    async def load(self, token: str | None) -> Progress:
        """The progress of the person with that token in the lessons there are; empty if it cannot be loaded."""
        if self.store is None or token is None or not is_token(token):
            return NO_PROGRESS
        try:
            return await self._in_thread(partial(_loaded, self.store, token))
        except HelicoideError:
            return NO_PROGRESS

    def changed(self, place: Place) -> None:
        """Save the progress of a place if it has changed: at once, or a second after the last time."""
        if self.store is not None and place.seat.progress != place.saved and place not in self._saved:
            self._saved.add(place)
            self._begin(self._save(place, self.store))

    def forget(self, place: Place, refuse: Callable[[Text], object]) -> None:
        """Delete the progress of a place, here and in the store. refuse: takes the reason if it stays."""
        progress = place.seat.progress
        place.seat = replace(lesson.entered(place.seat, None), progress=NO_PROGRESS)
        if self.store is not None:
            self._begin(self._forget(place, self.store, progress, refuse))

    def close(self) -> None:
        """Save what is not saved yet, and close the store, once. Call it from another thread than the event loop's."""
        was_closed, self._closed = self._closed, True
        if self.store is not None and not was_closed:
            for place in tuple(self.places()):
                if place.seat.progress != place.saved:
                    self._thread.submit(self.store.save, place.seat.token, place.seat.progress, place.saved)
            self._thread.submit(self.store.close)
        self._thread.shutdown()

    def _begin(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _save(self, place: Place, store: Store) -> None:
        try:
            while (progress := place.seat.progress) != place.saved and not self._closed:
                try:
                    await self._in_thread(partial(store.save, place.seat.token, progress, place.saved))
                    place.saved = progress
                    await asyncio.sleep(PERIOD)
                except HelicoideError:
                    await asyncio.sleep(RETRY)
        finally:
            self._saved.discard(place)

    async def _forget(self, place: Place, store: Store, progress: Progress, refuse: Callable[[Text], object]) -> None:
        try:
            await self._in_thread(partial(store.forget, place.seat.token))
            place.saved = NO_PROGRESS
        except HelicoideError as refusal:
            place.seat = replace(place.seat, progress=merge_progress(progress, NO_PROGRESS, place.seat.progress))
            refuse(NOT_DELETED.format(why=refusal.text))

    async def _in_thread(self, work: Callable[[], Result]) -> Result:
        """The result of work with the store. Raises HelicoideError; that it begins to fail is shown in every window."""
        try:
            result = await asyncio.get_running_loop().run_in_executor(self._thread, work)
        except HelicoideError as refusal:
            self._fail(refusal.text)
            raise
        except Exception as error:
            log.exception("the store failed")
            self._fail(FAILED)
            raise HelicoideError(FAILED) from error
        self.failure = None
        return result

    def _fail(self, why: Text) -> None:
        failed_before, self.failure = self.failure, GOES_ON.format(why=why)
        if failed_before is None:
            log.warning("%s: %s", "no store" if self.store is None else self.store.name, why.en)
            self.tell(self.failure)


def _loaded(store: Store, token: str) -> Progress:
    lessons = lesson.all_lessons()
    return without_bad_answers(known_progress(store.load(token), steps_of(lessons)), lessons)
