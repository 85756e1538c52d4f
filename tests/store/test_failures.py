"""A database that cannot be used is refused in both languages, and nothing of it is changed."""

from __future__ import annotations

import os
import sqlite3
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from sqlalchemy import event
from tests.mutated import FOREIGN
from tests.store.samples import OTHER, PROGRESS, TOKEN

from helicoide.seat import LessonProgress
from helicoide.store import database
from helicoide.store.database import Store
from helicoide.store.schema import VERSION, person_of
from helicoide.text import HelicoideError, Text


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A database with the progress of one person, its file alone."""
    path = tmp_path / "progress.sqlite"
    store = Store(path)
    store.save(TOKEN, PROGRESS)
    store.close()
    return path


def reason(work: Callable[[], object]) -> Text:
    with pytest.raises(HelicoideError) as refusal:
        work()
    said = refusal.value.text
    assert said.en != said.pt_BR
    assert not FOREIGN.search(said.en), said.en
    assert "sqlite3" not in said.en
    return said


def refused_by(path: Path | str) -> Text:
    """Why nothing can be loaded, saved or deleted; it is the same reason for all."""
    store = Store(path)
    works: list[Callable[[], object]] = [
        store.open,
        lambda: store.load(TOKEN),
        lambda: store.save(TOKEN, PROGRESS),
        lambda: store.forget(TOKEN),
    ]
    (said,) = {reason(work) for work in works}
    store.close()
    return said


@pytest.mark.parametrize("damage", ["text", "head", "short", "zeros"])
def test_a_damaged_file_is_refused_and_left_as_it_is(path: Path, damage: str) -> None:
    good = path.read_bytes()
    bad = {
        "text": b"dear diary, " * 900,
        "head": b"\0" * 16 + good[16:],
        "short": good[: len(good) // 2],
        "zeros": good[:100] + b"\0" * (len(good) - 100),
    }[damage]
    path.write_bytes(bad)
    assert "damaged" in refused_by(path).en
    assert path.read_bytes() == bad


@pytest.mark.parametrize(
    "damage",
    [
        "done = '[\"axis\"'",
        "done = '{}'",
        "done = '[1]'",
        "answers = '{\"axis\": 1}'",
        "step = 'two'",
        "step = 1.5",
        "lines = 'null'",
        "done = x'ff'",
    ],
)
def test_a_damaged_row_is_refused_and_others_are_not(path: Path, damage: str) -> None:
    store = Store(path)
    store.save(OTHER, PROGRESS)
    with sqlite3.connect(path) as writer:
        writer.execute(f"UPDATE lesson_progress SET {damage} WHERE person = (SELECT max(person) FROM lesson_progress)")
        before = writer.execute("SELECT * FROM lesson_progress").fetchall()
    damaged, whole = sorted((TOKEN, OTHER), key=person_of, reverse=True)
    assert "damaged" in reason(lambda: store.load(damaged)).en
    assert "damaged" in reason(lambda: store.save(damaged, {})).en
    assert store.load(whole) == PROGRESS
    assert writer.execute("SELECT * FROM lesson_progress").fetchall() == before
    writer.close()
    store.close()


def test_a_database_of_another_program_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "photos.sqlite"
    with sqlite3.connect(path) as other:
        other.execute("CREATE TABLE photos (name TEXT)")
    other.close()
    before = path.read_bytes()
    assert "another program" in refused_by(path).en
    assert path.read_bytes() == before


def test_a_database_of_a_newer_helicoide_is_refused(path: Path) -> None:
    with sqlite3.connect(path) as newer:
        newer.execute("UPDATE helicoide_schema SET version = ?", [VERSION + 1])
    newer.close()
    assert f"version {VERSION + 1}" in refused_by(path).en


def test_a_database_without_its_version_is_refused(path: Path) -> None:
    with sqlite3.connect(path) as broken:
        broken.execute("DELETE FROM helicoide_schema")
    broken.close()
    assert "another program" in refused_by(path).en


def test_a_locked_database_is_refused_and_used_again_afterwards(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(database, "PATIENCE", 0.05)
    other = sqlite3.connect(path, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    store = Store(path)
    assert "locked" in reason(lambda: store.load(TOKEN)).en
    other.execute("ROLLBACK")
    other.close()
    assert store.load(TOKEN) == PROGRESS
    store.close()


def test_a_full_disk_is_said_and_what_was_there_stays(path: Path) -> None:
    """SQLite gives the error of a full disk when a file reaches the size that it is allowed."""
    store = Store(path)
    event.listen(store._engine, "connect", lambda connection, _: connection.execute("PRAGMA max_page_count = 5"))
    large = {"screws": LessonProgress("screws", lines={"axis": ("a" * 100_000,)})}
    assert "full" in reason(lambda: store.save(OTHER, large)).en
    assert store.load(TOKEN) == PROGRESS
    assert not store.load(OTHER)
    store.close()


@pytest.mark.parametrize("place", ["missing", "folder", "file in a file"])
def test_a_file_that_cannot_be_made_is_refused(tmp_path: Path, place: str) -> None:
    (tmp_path / "file").write_text("")
    path = {
        "missing": Path("/proc/none/progress.sqlite"),
        "folder": tmp_path,
        "file in a file": tmp_path / "file" / "x",
    }
    refused_by(path[place])


def test_a_folder_that_can_only_be_read_is_refused() -> None:
    """The superuser may write anywhere, so that the test becomes somebody else for a moment."""
    with tempfile.TemporaryDirectory(prefix="helicoide") as folder:
        path, superuser = Path(folder) / "progress.sqlite", os.geteuid() == 0
        store = Store(path)
        store.save(TOKEN, PROGRESS)
        store.close()
        path.chmod(0o444)
        Path(folder).chmod(0o555)
        if superuser:
            os.seteuid(65534)
        try:
            refused_by(path)
            refused_by(Path(folder) / "new.sqlite")
        finally:
            if superuser:
                os.seteuid(0)
            Path(folder).chmod(0o755)


@pytest.mark.parametrize("url", ["nothing://there", "://", "postgres:secret@host://x", "sqlite+nothing:///x"])
def test_an_impossible_url_is_refused_at_once(url: str) -> None:
    reason(lambda: Store(url))


def test_a_password_is_not_shown() -> None:
    assert "secret" not in reason(lambda: Store("nothing://user:secret@host/name")).en
