"""Reading a recording in a process of its own, with limits on memory and time, as its file may come from anywhere."""

from __future__ import annotations

import asyncio
import logging
import sys
from pathlib import Path

from helicoide.jobs.process import JobFailed, ProcessJob, Report, follow_job
from helicoide.recorder.reading import read_recording
from helicoide.recorder.recording import Recording
from helicoide.text import HelicoideError, Text

PATIENCE, MEMORY = 120.0, 4_000_000_000  # s; bytes
TOO_MUCH = Text(
    en="{name} cannot be read: it takes more than {s:.0f} s or {gb:.0f} GB of memory.",
    pt_BR="Não dá para ler {name}: isso leva mais de {s:.0f} s ou {gb:.0f} GB de memória.",
)
log = logging.getLogger("helicoide")


async def read_in_process(path: Path, title: str) -> Recording:
    """The recording in a file. Raises HelicoideError with what is wrong with it. A cancellation ends the process."""
    job = ProcessJob(recording_or_refusal, path, title)
    try:
        await asyncio.wait_for(follow_job(job, lambda _: None), PATIENCE)
    except (JobFailed, TimeoutError) as error:
        log.warning("%s could not be read: %s", title, error)
    finally:
        job.stop()
    if isinstance(job.result, Recording):
        return job.result
    refusal = TOO_MUCH.format(name=title, s=PATIENCE, gb=MEMORY / 1e9)
    raise HelicoideError(job.result if isinstance(job.result, Text) else refusal)


def recording_or_refusal(report: Report, path: Path, title: str) -> Recording | Text:
    """The recording in a file, or why it cannot be read; this is the function that runs in the process."""
    if sys.platform != "win32":  # which has no such limit
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))
    try:
        return read_recording(path, title)
    except HelicoideError as refusal:
        return refusal.text
