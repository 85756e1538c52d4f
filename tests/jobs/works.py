"""Work for processes of their own, in a module that is soon imported."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from multiprocessing.connection import Connection
from pathlib import Path

from helicoide.jobs.process import Report

HEAD = 16  # bytes: what goes before a message says no more than how long it is


def counts(report: Report, upto: int) -> int:
    for k in range(upto):
        report(k)
    return 10 * upto


def fails(report: Report) -> None:
    report(0)
    raise ValueError("no such thing")


def waits(report: Report, file: str) -> None:
    report(0)
    time.sleep(600)
    Path(file).write_text("too late")


def returns_nothing(report: Report) -> None:
    report(0)


def breaks_off(report: Report) -> None:
    """Killed in the middle of what it says."""

    def half(connection: Connection, message: bytes) -> None:
        whole = len(message) <= HEAD
        os.write(connection.fileno(), message if whole else message[: len(message) // 2])
        if not whole:
            os.kill(os.getpid(), signal.SIGKILL)

    report(0)
    Connection._send = half  # type: ignore[attr-defined]
    report(bytes(1 << 16))


def has_a_child_of_its_own(report: Report) -> None:
    """It outlives this process, and holds what it inherits."""
    other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"], close_fds=False)
    report(other.pid)
    os.kill(os.getpid(), signal.SIGKILL)


def is_killed(report: Report, file: str, times: int) -> None:
    """So many times; each time leaves a letter in the file."""
    with Path(file).open("a") as lives:
        lives.write("x")
    report(1)
    if len(Path(file).read_text()) <= times:
        os.kill(os.getpid(), signal.SIGKILL)
    report(2)


def dies(report: Report, *_: object) -> None:
    report(0.25)
    os.kill(os.getpid(), signal.SIGKILL)
