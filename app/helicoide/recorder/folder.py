"""The recordings in the user's folder: new names, what is there, and what is deleted."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass
from datetime import datetime
from functools import lru_cache
from pathlib import Path

from mcap.reader import make_reader

from helicoide import content
from helicoide.files.os_errors import os_error_reason
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

MOST_LISTED = 200
NO_RECORDING = Text(
    en="There is no recording {name!r}; there is: {known}.", pt_BR="Não há gravação {name!r}; há: {known}."
)
UNDELETED = Text(en="{name} cannot be deleted: {reason}.", pt_BR="Não dá para apagar {name}: {reason}.")


@dataclass(frozen=True)
class RecordingFile:
    """A recording in the folder. size: bytes; seconds: its length, None while it is written or if its end is lost."""

    name: str
    date: datetime
    size: int
    seconds: float | None


def recordings_folder() -> Path:
    """The folder of the recordings, which may not exist yet."""
    return content.user_folder() / "recordings"


def new_path(robot: Robot, now: datetime, taken: Collection[Path] = ()) -> Path:
    """A file that does not exist yet, named by the time and the robot. taken: files that are about to be made."""
    name = re.sub(r"[^\w-]+", "_", robot.name)[:60]
    stem, number = f"{now:%Y-%m-%d_%H-%M-%S}_{name}", 1
    path = recordings_folder() / f"{stem}.mcap"
    while path in taken or path.exists():
        number += 1
        path = recordings_folder() / f"{stem}_{number}.mcap"
    return path


def list_recordings() -> tuple[RecordingFile, ...]:
    """The recordings, the newest first, at most `MOST_LISTED`."""
    found = []
    for path in recordings_folder().glob("*.mcap"):
        try:
            stat = path.stat()
            seconds = _length(path, stat.st_size, stat.st_mtime_ns)
        except OSError:  # it was deleted meanwhile, or is not readable
            continue
        found.append(RecordingFile(path.name, datetime.fromtimestamp(stat.st_mtime), stat.st_size, seconds))
    return tuple(sorted(found, key=lambda file: (file.date, file.name), reverse=True)[:MOST_LISTED])


@lru_cache(maxsize=2 * MOST_LISTED)
def _length(path: Path, size: int, changed: int) -> float | None:
    """The length of a recording of that size, last changed at a time, ns: by the index at its end, if it has one."""
    with path.open("rb") as file:
        try:
            summary = make_reader(file).get_summary()
        except OSError:
            raise
        except Exception:  # the end is lost, or is anything
            return None
    if summary is None or summary.statistics is None:
        return None
    return (summary.statistics.message_end_time - summary.statistics.message_start_time) / 1e9


def recording_path(name: str) -> Path:
    """The file of a recording. Raises HelicoideError, which lists the recordings, for any other name."""
    known = {path.name: path for path in recordings_folder().glob("*.mcap")}
    if name not in known:
        raise HelicoideError(NO_RECORDING.format(name=name, known=", ".join(sorted(known)) or "–"))
    return known[name]


def delete_recording(name: str) -> None:
    """Delete a recording. Raises HelicoideError if there is none of that name, or why it cannot be deleted."""
    try:
        recording_path(name).unlink()
    except OSError as error:
        raise HelicoideError(UNDELETED.format(name=name, reason=os_error_reason(error))) from error
