"""One arm and its scene: its state, the inbox of what is asked of it, and its tick."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import replace
from threading import Lock

from helicoide import gate
from helicoide.advance import advance
from helicoide.command import FollowPath
from helicoide.foresight import foreseen, leads_elsewhere, rests, search, wants_search
from helicoide.state import State, Update
from helicoide.text import Text

TICK = 0.01
# ticks from one look at where the command leads to the next, where that is drawn and where it is not
SEEN, UNSEEN = 3, 20
FAILED = Text(
    en="Something went wrong inside; see the terminal.",
    pt_BR="Algo deu errado por dentro; veja o terminal.",
)
log = logging.getLogger("helicoide")


class Workcell:
    """An arm that lives from tick to tick. Its state is replaced by the clock's thread alone.

    wake: what wakes that thread; searcher: where searches run meanwhile; connected: whether a real arm follows, so that
    every window's Stop is for it, too.
    """

    def __init__(self, state: State, wake: Callable[[], None], searcher: Executor) -> None:
        self.state, self.wake, self.searcher = state, wake, searcher
        self.connected = False
        self.paused = False
        self.resting = False
        self.ticks = 0
        self._inbox: deque[tuple[Update, bool]] = deque()
        self._lock = Lock()
        self._foreseen: State | None = None
        self._foreseen_at = -UNSEEN
        self._searching = False

    def ask(self, update: Update) -> None:
        """What a person wishes: a stop that comes before it is done leaves it undone."""
        self._post(update, asked=True)

    def tell(self, update: Update) -> None:
        """What came of a piece of work: a stop leaves it in the inbox."""
        self._post(update, asked=False)

    def stop(self, closing: bool = False) -> None:
        """Nothing that was asked before is done any more; from the next tick on nothing moves.

        closing: whether the same key closes something on the page.
        """
        with self._lock:
            told = [entry for entry in self._inbox if not entry[1]]
            self._inbox = deque([(gate.stop(closing), False), *told])
        self._rise()

    def pause(self, paused: bool) -> None:
        """Let no time pass, or let it pass again."""
        self.paused = paused
        self._rise()

    def _post(self, update: Update, asked: bool) -> None:
        with self._lock:
            self._inbox.append((update, asked))
        self._rise()

    def _rise(self) -> None:
        self.resting = False
        self.wake()

    def drain(self) -> None:
        """Do all that was asked. Here and below: only in the clock's thread."""
        while (update := self._next()) is not None:
            self.resting = False
            self.state = self._tried(update, lambda state: state)

    def _next(self) -> Update | None:
        with self._lock:
            return self._inbox.popleft()[0] if self._inbox else None

    def tick(self) -> None:
        """One hundredth of a second of the arm."""
        before = self.state
        self.state = self._tried(lambda state: advance(state, TICK), otherwise=gate.stop())
        self.ticks += 1
        if wants_search(self.state) and not self._searching:
            self._searching = True
            self.searcher.submit(self._search, self.state)
        self.resting = rests(before, self.state)

    def foresee(self) -> None:
        """Work out where the command leads, where that may have changed; of a path that plays, only words tell."""
        plays = isinstance(self.state.request.command, FollowPath) and self.state.request.command.playing
        if self.ticks - self._foreseen_at < (UNSEEN if plays else SEEN):
            return
        if leads_elsewhere(self._foreseen, self.state):
            self._foreseen_at = self.ticks
            self._foreseen = self.state = self._tried(
                foreseen, lambda state: replace(state, request=replace(state.request, goal=None))
            )

    def _search(self, state: State) -> None:
        """Look for another posture; in a thread of the searcher."""
        try:
            found = search(state)
        except Exception:
            log.exception("a search failed")
            found = _searched_in_vain
        self._searching = False
        self.tell(found)

    def _tried(self, update: Update, otherwise: Update) -> State:
        """What an update makes of the state; when it fails, another one and a notice, with the reason in the log."""
        try:
            return update(self.state)
        except Exception:
            log.exception("an update failed and was skipped")
            return replace(otherwise(self.state), notice=FAILED)


def _searched_in_vain(state: State) -> State:
    return replace(state, request=replace(state.request, searched=True))
