"""Check the lines that people type for an exercise, one after another in a thread: a check may take 0.2 s."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from helicoide import lesson
from helicoide.lines import Accepted, check_line
from helicoide.session.visitor import Visitor
from helicoide.view.open_step import OpenStep, open_step
from helicoide.view.window_view import LineCheck

log = logging.getLogger("helicoide")


class LineChecking:
    """Checks lines. Use it only on the event loop. news: has the rows of all windows written."""

    def __init__(self, news: Callable[[], object]) -> None:
        self.news = news
        self._thread = ThreadPoolExecutor(1, "helicoide lines")
        self._tasks: set[asyncio.Task[None]] = set()

    def begin(self, visitor: Visitor, text: str) -> None:
        """Check a line for the open step of a visitor, whatever else happens in the meantime."""
        opened = open_step(visitor.place.seat)
        if opened is not None and opened.step.line is not None:
            task = asyncio.get_running_loop().create_task(self._check(visitor, opened, text))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

    async def _check(self, visitor: Visitor, opened: OpenStep, text: str) -> None:
        assert opened.step.line is not None
        lines, number = opened.step.line.lines(), len(opened.accepted_lines)
        if number >= len(lines):
            return
        loop = asyncio.get_running_loop()
        try:
            verdict = await loop.run_in_executor(self._thread, check_line, lines[number], text)
        except Exception:
            log.exception("a line of step %s of lesson %s could not be checked", opened.step.id, opened.lesson.id)
            return
        now = open_step(visitor.place.seat)
        if now is None or now.step is not opened.step or len(now.accepted_lines) != number:
            return
        if isinstance(verdict, Accepted):
            visitor.seat_as(lesson.with_accepted_line(opened.lesson, visitor.place.seat, text.strip()))
        visitor.place.line_check = LineCheck((opened.lesson.id, opened.step.id), text, verdict)
        if visitor.bay.display is not None:
            visitor.bay.display.redraw()
        self.news()
