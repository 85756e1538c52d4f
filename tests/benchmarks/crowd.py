"""Many pages in a process of their own, which is told what to do by lines, so that none of it is measured.

`python -m tests.benchmarks.crowd PORT`: the lines are the methods of `Crowd` with their numbers, such as `join 10 3`;
each is answered by one of JSON.
"""

from __future__ import annotations

import asyncio
import json
import sys
from collections.abc import Awaitable, Callable
from contextlib import AsyncExitStack
from time import perf_counter

from tests.pages import Page, opened

from helicoide.readout import matrices
from helicoide.readout.signals import joints
from helicoide.view import layers, panels

ALGEBRA = 2  # the number of its tab


class Crowd:
    """The pages, and what may be asked of them."""

    def __init__(self, port: int) -> None:
        self.port = port
        self.stack = AsyncExitStack()
        self.pages: list[Page] = []

    async def join(self, count: int, seconds: float = 0.0) -> float:
        """Open so many pages; how long it took until each had its words, s."""
        began = perf_counter()
        joining = [self._open(number * seconds / count) for number in range(count)]
        self.pages += await asyncio.gather(*joining)
        return perf_counter() - began

    async def watch(self, count: int) -> None:
        """Open so many pages of a bare viser, which only watch."""
        for _ in range(count):
            self.pages.append(await self.stack.enter_async_context(opened(self.port, silent=True)))

    async def _open(self, delay: float) -> Page:
        await asyncio.sleep(delay)
        page = await self.stack.enter_async_context(opened(self.port))
        while not page.notice or not page.may_drive.is_set():
            await asyncio.sleep(0.02)
        return page

    async def private(self) -> None:
        """An arm of one's own for everybody, with its planes, and its multivectors lit up."""
        for page in self.pages:
            await page.give("Use my own arm", True)
        await asyncio.sleep(3.0)
        for page in self.pages:
            await page.tell(tab=ALGEBRA)
            await page.give("Highlight", "end-effector motor")

    async def show_all(self) -> None:
        """All layers, a line of the console, four charts and a matrix in every page; the pages spread over the tabs."""
        for number, page in enumerate(self.pages):
            for layer in layers.optional():
                await page.give(layer.TITLE.en, True)
            await page.give("Expression", "p = M_tool >> point(0, 0, 0.1)")
            await page.press("Enter line")
            await page.give("Highlight", "end-effector motor")
            await page.give("Signals", joints.TITLE.en)
            await page.give("Matrix", matrices.TITLES["J"].en)
            await page.tell(tab=number % len(panels.all_panels()))

    async def play(self, everybody: int = 0) -> None:
        """Play on the shared arm, or on everybody's."""
        for page in self.pages if everybody else self.pages[:1]:
            await page.stop()
        await asyncio.sleep(0.5)
        for page in self.pages if everybody else self.pages[:1]:
            await page.press("Play")

    async def stop(self, times: int) -> list[float]:
        """How long each of so many stops took to be heard, s; the arm plays on after each."""
        took = []
        for number in range(times):
            page = self.pages[number % len(self.pages)]
            took.append(await page.stop())
            await asyncio.sleep(0.2)
            await page.press("Play")
            await asyncio.sleep(0.1)
        return took

    async def drag(self, times: int) -> list[float]:
        """How long after a drag of the target a message showed it to the page of the hand, s."""
        page, took = self.pages[0], []
        await page.gizmo("DragStart")
        for number in range(times):
            shown = asyncio.get_running_loop().create_future()
            place = (0.5, 0.02 * (number % 5), 0.3 + 0.001 * number)
            page.shown = lambda when, point, shown=shown: None if shown.done() else shown.set_result(when)
            began = perf_counter()
            await page.gizmo("Update", wxyz=(0.0, 1.0, 0.0, 0.0), position=place)
            took.append(await asyncio.wait_for(shown, 10.0) - began)
            await asyncio.sleep(0.05)
        await page.gizmo("DragEnd")
        return took

    async def count(self) -> list[int]:
        """How many changes of the scene or of words each page has had."""
        return [page.frames for page in self.pages]

    async def leave(self) -> None:
        """Close every page."""
        await self.stack.aclose()
        self.pages = []


async def _listen() -> None:
    crowd = Crowd(int(sys.argv[1]))
    lines = asyncio.StreamReader()
    await asyncio.get_running_loop().connect_read_pipe(lambda: asyncio.StreamReaderProtocol(lines), sys.stdin)
    while line := (await lines.readline()).decode().split():
        act: Callable[..., Awaitable[object]] = getattr(crowd, line[0])
        print(json.dumps(await act(*map(int, line[1:]))), flush=True)


if __name__ == "__main__":
    asyncio.run(_listen())
