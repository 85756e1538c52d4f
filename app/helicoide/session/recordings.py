"""The recordings that each place looks at: listed, opened, played as a ghost, downloaded and deleted."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine, Iterable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from helicoide.files.os_errors import os_error_reason
from helicoide.recorder import panel_state
from helicoide.recorder.folder import delete_recording, list_recordings, recording_path
from helicoide.recorder.panel_state import RecordingPanelUpdate
from helicoide.recorder.read_back import read_back
from helicoide.recorder.recording import Recording
from helicoide.recorder.table import encode_recording
from helicoide.session.recording_job import read_in_process
from helicoide.session.seats import Place
from helicoide.session.workcell import FAILED
from helicoide.state import State
from helicoide.text import HelicoideError, Text

STEP = 0.05  # s between two steps of a time that runs
IN_USE = Text(
    en="{name} is still being recorded: stop the recording first.",
    pt_BR="{name} ainda está sendo gravado: pare a gravação antes.",
)
UNREADABLE = Text(en="{name} cannot be read: {reason}.", pt_BR="Não dá para ler {name}: {reason}.")
log = logging.getLogger("helicoide")
Save = Callable[[str, bytes], object]


class Recordings:
    """Opens recordings for places. Use it only on the event loop.

    places: those of all users; state_of: the state of the arm that a place shows; redraw: draws the windows of a place
    again; is_recorded: whether a file is being written.
    """

    def __init__(
        self,
        places: Callable[[], Iterable[Place]],
        state_of: Callable[[Place], State],
        redraw: Callable[[Place], object],
        is_recorded: Callable[[str], bool],
    ) -> None:
        self.places, self.state_of, self.redraw, self.is_recorded = places, state_of, redraw, is_recorded
        self._opening: dict[Place, asyncio.Task[None]] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def list(self) -> None:
        """Show every place which recordings are in the folder."""
        self._begin(self._list())

    def meet(self, place: Place) -> None:
        """Compare the open recording of a place with the arm that it shows now."""
        panel = place.recordings
        if panel.recording is not None and not (panel.shown and panel.shown.fits(self.state_of(place).robot)):
            self._begin(self._show(place, panel.recording))

    def change(self, place: Place, update: RecordingPanelUpdate) -> None:
        """Change what a place sees of its recording; its time may begin to run."""
        played = place.recordings.plays
        self._put(place, update)
        if place.recordings.plays and not played:
            self._begin(self._play(place))

    def open(self, place: Place, name: str, content: bytes | None) -> None:
        """Open a recording of the folder, or a file with this content; an empty name closes the open one."""
        self.forget(place)
        self._put(place, panel_state.with_chosen(name))
        if name:
            self._opening[place] = self._begin(self._open(place, name, content))

    def forget(self, place: Place) -> None:
        """End the reading of a place whose last window has closed, and stop its time."""
        if (task := self._opening.pop(place, None)) is not None:
            task.cancel()
        place.recordings = replace(place.recordings, plays=False)

    def delete(self, name: str, refuse: Callable[[Text], object]) -> None:
        """Delete a recording of the folder, which closes it where it is open. refuse: takes the reason if it stays."""
        self._begin(self._guarded(self._delete(name), refuse))

    def save(self, place: Place, kind: str, send: Save, refuse: Callable[[Text], object]) -> None:
        """Send the open recording of a place as a file of a kind. refuse: takes the reason if that fails."""
        self._begin(self._guarded(self._save(place, kind, send), refuse))

    def _begin(self, work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return task

    def _put(self, place: Place, update: RecordingPanelUpdate) -> None:
        before = place.recordings
        place.recordings = update(before)
        if place.recordings is not before:
            self.redraw(place)

    async def _guarded(self, work: Coroutine[Any, Any, None], refuse: Callable[[Text], object]) -> None:
        try:
            await work
        except HelicoideError as refusal:
            refuse(refusal.text)
        except Exception:
            log.exception("a request about a recording failed")
            refuse(FAILED)

    async def _list(self) -> None:
        files = await asyncio.to_thread(list_recordings)
        for place in tuple(self.places()):
            if place.recordings.files != files:
                self._put(place, lambda panel: replace(panel, files=files))

    async def _open(self, place: Place, name: str, content: bytes | None) -> None:
        def refuse(why: Text) -> None:
            self._put(place, panel_state.with_refusal(why))

        async def read() -> None:
            await self._show(place, await _read(name, content))

        await self._guarded(read(), refuse)

    async def _show(self, place: Place, recording: Recording) -> None:
        """Show a recording on the arm of a place, or why it is of another arm."""
        shown, refusal = None, None
        try:
            shown = await asyncio.to_thread(read_back, recording, self.state_of(place))
        except HelicoideError as error:
            refusal = error.text
        if place.recordings.chosen == recording.title:  # otherwise another one has been chosen meanwhile
            self._put(place, panel_state.with_recording(recording, shown, refusal))

    async def _play(self, place: Place) -> None:
        clock = asyncio.get_running_loop().time
        before = clock()
        while place.recordings.plays:
            await asyncio.sleep(STEP)
            now = clock()
            self._put(place, panel_state.with_elapsed(now - before))
            before = now

    async def _delete(self, name: str) -> None:
        if self.is_recorded(name):
            raise HelicoideError(IN_USE.format(name=name))
        await asyncio.to_thread(delete_recording, name)
        for place in tuple(self.places()):
            if place.recordings.chosen == name:
                self.open(place, "", None)
        await self._list()

    async def _save(self, place: Place, kind: str, send: Save) -> None:
        panel = place.recordings
        if kind == "csv" and panel.recording is not None:
            send(f"{Path(panel.chosen).stem}.csv", await asyncio.to_thread(encode_recording, panel.recording))
        elif kind == "mcap":
            send(panel.chosen, await asyncio.to_thread(_bytes_of, panel.chosen))


async def _read(name: str, content: bytes | None) -> Recording:
    """The recording of that name in the folder, or in a file with this content."""
    if content is None:
        return await read_in_process(await asyncio.to_thread(recording_path, name), name)
    folder = await asyncio.to_thread(TemporaryDirectory, prefix="helicoide")
    try:
        path = Path(folder.name) / f"upload{Path(name).suffix.lower()}"
        await asyncio.to_thread(path.write_bytes, content)
        return await read_in_process(path, name)
    except OSError as error:
        raise HelicoideError(UNREADABLE.format(name=name, reason=os_error_reason(error))) from error
    finally:
        with suppress(OSError):
            folder.cleanup()


def _bytes_of(name: str) -> bytes:
    try:
        return recording_path(name).read_bytes()
    except OSError as error:
        raise HelicoideError(UNREADABLE.format(name=name, reason=os_error_reason(error))) from error
