"""The lab ends when it is asked to, at any moment, and leaves no process behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil
import pytest

APP = Path(__file__).parents[2] / "app"
SERVE = ["-m", "helicoide", "--port", "0", "--store", "none"]
GUARD = 20.0
# A thread that nobody can interrupt, as one that compiles: with Python's own end the program would wait for it.
BUSY = """
import time
from helicoide.commands import serve
from helicoide.session import preparing

preparing.exercise = lambda: time.sleep(600)
serve.run(port=0, store="none")
"""
STUDY = """
import time
from helicoide.commands import serve
from helicoide.session import preparing, studies
from helicoide.session.lab import Lab
from helicoide.session.seats import Place
from helicoide.seat import Seat
from helicoide.studies import panel_state, study_names

opened, place = Lab.open, Place(Seat("", "en"))

def opened_with_a_study(session, *address):
    port = opened(session, *address)
    for update in (panel_state.with_study(study_names()[0]), panel_state.with_run_started):
        session.loop.call_soon_threadsafe(session.studies.change, place, update)
    return port

def lasting(report, *_):
    while True:
        report(0.5)
        time.sleep(0.1)

if __name__ == "__main__":
    Lab.open, studies.study = opened_with_a_study, lasting
    preparing.exercise = lambda: None
    serve.run(port=0, store="none")
"""


@contextmanager
def lab(arguments: list[str], cache: Path | None = None) -> Iterator[subprocess.Popen[str]]:
    """The lab in a process group of its own, as a terminal starts it."""
    environment = {**os.environ, "PYTHONPATH": str(APP), **({"NUMBA_CACHE_DIR": str(cache)} if cache else {})}
    command = [sys.executable, *arguments]
    with subprocess.Popen(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def ended(process: subprocess.Popen[str], number: int = signal.SIGTERM) -> int:
    """End it by a signal, to all of its group for Ctrl+C; its exit code. None of its processes may remain."""
    children = psutil.Process(process.pid).children(recursive=True)
    begun = time.monotonic()
    (os.killpg if number == signal.SIGINT else os.kill)(process.pid, number)
    code = process.wait(GUARD)
    print(f"ended after {time.monotonic() - begun:.2f} s, with {len(children)} other processes")
    _, alive = psutil.wait_procs(children, GUARD)
    assert alive == []
    return code


def until(process: subprocess.Popen[str], happened: Callable[[], object]) -> None:
    latest = time.monotonic() + 300
    while not happened():
        assert process.poll() is None
        assert time.monotonic() < latest
        time.sleep(0.02)


def workers(process: subprocess.Popen[str]) -> list[psutil.Process]:
    """The processes that it has work done in."""
    children = psutil.Process(process.pid).children(recursive=True)
    return [child for child in children if "spawn_main" in " ".join(child.cmdline())]


@pytest.mark.parametrize("seconds", [0.1, 0.7, 1.5, 3.0, 6.0])
def test_it_ends_at_any_moment_of_its_first_start(tmp_path: Path, seconds: float) -> None:
    with lab(SERVE, tmp_path) as process:
        time.sleep(seconds)
        assert ended(process) in (0, -signal.SIGTERM)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_it_ends_while_kernels_are_compiled(tmp_path: Path, number: int) -> None:
    with lab(SERVE, tmp_path) as process:
        until(process, lambda: any(tmp_path.rglob("*.kernel")))
        assert len(workers(process)) == 1
        assert ended(process, number) == 0
        assert process.stderr is not None
        assert process.stderr.read() == ""
    assert not any(tmp_path.rglob("*guarded.guarded_tick-*")), "it was not waited for the last kernels"


@pytest.mark.parametrize("code", [BUSY, STUDY], ids=["a thread that is busy", "a study"])
def test_it_ends_whatever_it_does(tmp_path: Path, code: str) -> None:
    script = tmp_path / "lab.py"
    script.write_text(code)
    with lab([str(script)]) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("Helicoide: ")
        if code is STUDY:
            until(process, lambda: workers(process))
        time.sleep(0.5)
        assert ended(process) == 0


def test_it_ends_as_soon_as_it_is_there() -> None:
    with lab(SERVE) as process:
        assert process.stdout is not None
        process.stdout.readline()
        assert ended(process) == 0
        assert process.stderr is not None
        assert process.stderr.read() == ""


def test_a_store_that_cannot_be_used_is_said_and_the_lab_goes_on(tmp_path: Path) -> None:
    path = tmp_path / "progress.sqlite"
    path.write_bytes(b"dear diary, " * 900)
    with lab([*SERVE[:-1], str(path), "--lang", "pt_BR"]) as process:
        assert process.stdout is not None
        assert any(f"{path}: Não dá para usar o banco de dados do progresso" in line for line in process.stdout)
        assert process.poll() is None
        assert ended(process) == 0


def test_a_store_is_made_at_the_start_in_a_folder_that_is_made_too(tmp_path: Path) -> None:
    path = tmp_path / "class" / "progress.sqlite"
    with lab([*SERVE[:-1], f"sqlite:///{path}"]) as process:
        until(process, path.exists)
        assert ended(process) == 0


def test_an_impossible_store_is_refused(tmp_path: Path) -> None:
    with lab([*SERVE[:-1], "nothing://user:secret@host/name"]) as process:
        _, said = process.communicate(timeout=GUARD)
        assert process.returncode == 2
        assert "nothing://user:***@host/name" in said
        assert "secret" not in said
