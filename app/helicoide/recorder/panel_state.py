"""The recordings of a seat: which are there, which one is open, and the time at which it is looked at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from helicoide.recorder.folder import RecordingFile
from helicoide.recorder.read_back import ReadBack
from helicoide.recorder.recording import Recording
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class RecordingPanelState:
    """What a seat looks at. files: the recordings in the folder; chosen: the name of the open one, empty for none.

    reading: whether it is being read; recording: what it contains; shown: the same on the arm, None if it is of another
    arm; instant: the time on its time line, s; plays: whether that time runs; refusal: why it is not shown.
    """

    files: tuple[RecordingFile, ...] = ()
    chosen: str = ""
    reading: bool = False
    recording: Recording | None = None
    shown: ReadBack | None = None
    instant: float = 0.0
    plays: bool = False
    refusal: Text | None = None


RecordingPanelUpdate = Callable[[RecordingPanelState], RecordingPanelState]
NO_RECORDINGS = RecordingPanelState()


def with_chosen(name: str) -> RecordingPanelUpdate:
    """Choose another recording, which is read from then on; an empty name closes the open one."""
    return lambda panel: RecordingPanelState(panel.files, name, reading=bool(name))


def with_recording(recording: Recording, shown: ReadBack | None, refusal: Text | None = None) -> RecordingPanelUpdate:
    """Show what was read."""
    return lambda panel: replace(
        panel, reading=False, recording=recording, shown=shown, refusal=refusal, plays=panel.plays and shown is not None
    )


def with_refusal(why: Text) -> RecordingPanelUpdate:
    """Say why a recording is not shown."""
    return lambda panel: replace(panel, reading=False, plays=False, refusal=why)


def with_instant(instant: float) -> RecordingPanelUpdate:
    """Go to a time of the open recording, s, within its length."""

    def update(panel: RecordingPanelState) -> RecordingPanelState:
        if panel.shown is None or instant != instant:
            return panel
        return replace(panel, instant=min(max(float(instant), 0.0), panel.shown.recording.duration), plays=False)

    return update


def with_play(panel: RecordingPanelState) -> RecordingPanelState:
    """Start or stop the time; from the end it begins again."""
    if panel.shown is None:
        return panel
    at_end = panel.instant >= panel.shown.recording.duration
    return replace(panel, plays=not panel.plays, instant=0.0 if at_end and not panel.plays else panel.instant)


def with_elapsed(seconds: float) -> RecordingPanelUpdate:
    """Let the time run on; it stops at the end of the recording."""

    def update(panel: RecordingPanelState) -> RecordingPanelState:
        if panel.shown is None or not panel.plays:
            return panel
        end = panel.shown.recording.duration
        instant = min(panel.instant + seconds, end)
        return replace(panel, instant=instant, plays=instant < end)

    return update
