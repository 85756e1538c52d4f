"""One arm and its scene: the state, the inbox of updates, and the tick."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import replace
from functools import partial
from threading import Lock

from helicoide import gate
from helicoide.advance import advance
from helicoide.command import FollowPath
from helicoide.foresight import at_rest, foreseen, leads_elsewhere, search_posture, wants_search
from helicoide.recorder.recorder import Recorder
from helicoide.state import State, Update
from helicoide.text import Text

TICK = 0.01
# ticks between two computations of the goal, if the goal is drawn and if it is not
SEEN, UNSEEN = 3, 20
FAILED = Text(
    en="Internal error; see the terminal.",
    pt_BR="Erro interno; veja o terminal.",
)
log = logging.getLogger("helicoide")


class Workcell:
    """An arm that is advanced tick by tick. Only the clock's thread replaces its state.

    wake: wakes that thread; searcher: runs posture searches; connected: whether a real arm follows, which the Stop of
    every window then stops; recorder: the last recording of the arm, running or ended, None before the first one.
    """

    def __init__(self, state: State, wake: Callable[[], None], searcher: Executor) -> None:
        self.state, self.wake, self.searcher = state, wake, searcher
        self.connected = False
        self.recorder: Recorder | None = None
        self.paused = False
        self.resting = False
        self.ticks = 0
        self._inbox: deque[tuple[Update, bool]] = deque()
        self._lock = Lock()
        self._foreseen: State | None = None
        self._foreseen_at = -UNSEEN
        self._searching = False

    def ask(self, update: Update) -> None:
        """Queue a request of a user. A stop discards it if it is not applied yet."""
        self._post(update, is_request=True)

    def tell(self, update: Update) -> None:
        """Queue the result of a job. A stop leaves it in the inbox."""
        self._post(update, is_request=False)

    def stop(self, closing: bool = False) -> None:
        """Discard all queued requests, and stop the arm before the next tick.

        closing: whether the same keystroke also closes something on the page.
        """
        with self._lock:
            results = [entry for entry in self._inbox if not entry[1]]
            self._inbox = deque([(gate.stop(closing), False), *results])
        self._rise()

    def pause(self, paused: bool) -> None:
        """Pause the arm, or resume it."""
        self.paused = paused
        self._rise()

    def _post(self, update: Update, is_request: bool) -> None:
        with self._lock:
            self._inbox.append((update, is_request))
        self._rise()

    def _rise(self) -> None:
        self.resting = False
        self.wake()

    def drain(self) -> None:
        """Apply all queued updates. Like `tick` and `foresee`, only in the clock's thread."""
        while (update := self._next()) is not None:
            self.resting = False
            self.state = self._tried(partial(_applied, update), lambda state: state)

    def _next(self) -> Update | None:
        with self._lock:
            return self._inbox.popleft()[0] if self._inbox else None

    def tick(self) -> None:
        """Advance the arm by `TICK` seconds."""
        before = self.state
        self.state = self._tried(lambda state: advance(state, TICK), otherwise=gate.stop())
        self.ticks += 1
        if self.recorder is not None:
            self.recorder.take(self.state)
        if wants_search(self.state) and not self._searching:
            self._searching = True
            self.searcher.submit(self._search, self.state)
        self.resting = at_rest(before, self.state)

    def foresee(self) -> None:
        """Compute the goal if it may have changed; less often while a path plays, since its goal is not drawn."""
        plays = isinstance(self.state.request.command, FollowPath) and self.state.request.command.playing
        if self.ticks - self._foreseen_at < (UNSEEN if plays else SEEN):
            return
        if leads_elsewhere(self._foreseen, self.state):
            self._foreseen_at = self.ticks
            self._foreseen = self.state = self._tried(
                foreseen, lambda state: replace(state, request=replace(state.request, goal=None))
            )

    def _search(self, state: State) -> None:
        """Search for another posture, in a thread of the searcher."""
        try:
            found = search_posture(state)
        except Exception:
            log.exception("a search failed")
            found = _searched_in_vain
        self._searching = False
        self.tell(found)

    def _tried(self, update: Update, otherwise: Update) -> State:
        """The state after an update; if that raises, after `otherwise` with a notice, and the error is logged."""
        try:
            return update(self.state)
        except Exception:
            log.exception("an update failed and was skipped")
            return replace(otherwise(self.state), notice=FAILED)


def _applied(update: Update, state: State) -> State:
    """The state after an update, which can be undone."""
    return gate.recorded(state, update(state))


def _searched_in_vain(state: State) -> State:
    return replace(state, request=replace(state.request, searched=True))
