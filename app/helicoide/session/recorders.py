"""The recorders of the lab: which arms are recorded, how many at once, and when a recording ends by itself."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable
from datetime import datetime

from helicoide.recorder.folder import new_path
from helicoide.recorder.recorder import Recorder
from helicoide.session.workcell import Workcell
from helicoide.text import Text

MOST_AT_ONCE = 4
WATCHED = 0.5  # s between two looks at the recorders
CLOSING = 10.0  # s to wait for the end of a file when the lab closes
BUSY = Text(
    en="{n} arms are being recorded already: wait until one of these recordings has ended.",
    pt_BR="{n} braços já estão sendo gravados: espere uma dessas gravações terminar.",
).format(n=MOST_AT_ONCE)


class Recorders:
    """Records workcells. Use it only on the event loop.

    workcells: those of the lab; ended: called after a recording has ended; write: has the rows of all windows
    written.
    """

    def __init__(
        self,
        workcells: Callable[[], Iterable[Workcell]],
        ended: Callable[[], object],
        write: Callable[[], object],
    ) -> None:
        self.workcells, self.ended, self.write = workcells, ended, write
        self._recorded: dict[Workcell, Recorder] = {}
        self._watching: asyncio.Task[None] | None = None

    def record(self, workcell: Workcell, on: bool, refuse: Callable[[Text], object]) -> None:
        """Record a workcell, or end its recording. refuse: takes the reason if too many are recorded."""
        if not on:
            if workcell.recorder is not None:
                workcell.recorder.end()
        elif workcell.recorder is None or not workcell.recorder.running:
            if len(self._recorded) >= MOST_AT_ONCE:
                refuse(BUSY)
                return
            state, taken = workcell.state, [recorder.path for recorder in self._recorded.values()]
            path = new_path(state.robot, datetime.now(), taken)
            workcell.recorder = self._recorded[workcell] = Recorder(path, state)
            if self._watching is None or self._watching.done():
                self._watching = asyncio.get_running_loop().create_task(self._watch())

    def is_recorded(self, name: str) -> bool:
        """Whether the file of that name is being written."""
        return any(recorder.running and recorder.path.name == name for recorder in self._recorded.values())

    def close(self) -> None:
        """End all recordings, and wait for their files. Call it from another thread than the event loop's."""
        for recorder in tuple(self._recorded.values()):
            recorder.end(CLOSING)

    async def _watch(self) -> None:
        """While arms are recorded, show how much is written; end the recordings of arms that are paused or gone."""
        while self._recorded:
            await asyncio.sleep(WATCHED)
            known = set(self.workcells())
            for workcell, recorder in tuple(self._recorded.items()):
                if not recorder.running:
                    del self._recorded[workcell]
                    self.ended()
                elif workcell.paused or workcell not in known:
                    recorder.end()
            self.write()
