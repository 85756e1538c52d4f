"""Work for processes of their own, in a module that is soon imported."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from helicoide.jobs.apart import Report


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
    report(0)
    pid = os.getpid()
    subprocess.Popen([sys.executable, "-c", f"import os, time; time.sleep(0.5); os.kill({pid}, 9)"])
    report(bytes(1 << 28))
    time.sleep(600)


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
