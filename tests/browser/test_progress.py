"""One's progress on the page: added from a file, taken home, deleted, and there again after the server was killed."""

from __future__ import annotations

import os
import signal
import socket
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.lab import until

from helicoide.lesson import load_lesson
from helicoide.seat import LessonProgress
from helicoide.store.progress_file import encode_progress

LESSON = "drive_the_arm"
STEPS = [step.id for step in load_lesson(LESSON).steps]
PROGRESS = {LESSON: LessonProgress(LESSON, len(STEPS), frozenset(STEPS), finished=True)}
APP = str(Path(__file__).parents[2] / "app")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A file of progress, as a person has it on their computer."""
    file = tmp_path / "mine.json"
    file.write_bytes(encode_progress(PROGRESS))
    return file


@contextmanager
def served(port: int, store: Path) -> Iterator[subprocess.Popen[str]]:
    """The lab in a process of its own, which is killed at the end."""
    command = [sys.executable, "-m", "helicoide", "--port", str(port), "--store", str(store)]
    environment = {**os.environ, "PYTHONPATH": APP}
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) as lab:
        try:
            assert lab.stdout is not None
            assert str(port) in lab.stdout.readline()
            yield lab
        finally:
            lab.send_signal(signal.SIGKILL)


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def stored(store: Path) -> int:
    """How many lessons are in a store, for all people."""
    with closing(sqlite3.connect(store)) as reader:
        return int(reader.execute("SELECT count(*) FROM lesson_progress").fetchone()[0])


def unfold(page: Page) -> None:
    page.get_by_role("tab", name="Lesson").click()
    page.get_by_text("My progress", exact=True).click()


def add(page: Page, file: Path) -> None:
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Add the progress of a file").click()
    chooser.value.set_files(file)


def counted(page: Page, begun: int, finished: int) -> None:
    expect(page.get_by_text(f"Lessons begun: {begun}; completed: {finished}.")).to_be_visible()


def test_progress_is_there_again_after_the_server_was_killed(browser: Browser, tmp_path: Path, file: Path) -> None:
    port, store = free_port(), tmp_path / "progress.sqlite"
    with served(port, store) as first, window(browser, port) as page:
        unfold(page)
        counted(page, 0, 0)
        expect(page.get_by_role("button", name="Save my progress as a file")).to_be_disabled()
        add(page, file)
        counted(page, 1, 1)
        until(page, lambda: stored(store) == 1)
        first.kill()
        first.wait()
        with served(port, store):
            page.reload()
            page.wait_for_function("() => window.drives")
            unfold(page)
            counted(page, 1, 1)
            page.get_by_role("button", name="Save my progress as a file").click()
            with page.expect_download() as download:
                page.locator("a[download]").click()
            assert Path(download.value.path()).read_bytes() == file.read_bytes()

            file.write_text("{}")
            add(page, file)
            expect(page.get_by_text("nothing of it was taken")).to_be_visible()
            counted(page, 1, 1)

            page.get_by_text("Delete my progress", exact=True).click()
            page.get_by_role("button", name="Delete for good").click()
            counted(page, 0, 0)
