"""The database gives back what was saved, to the person who saved it, and keeps no trace of what was deleted."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from sqlalchemy import create_engine, inspect
from tests.store.samples import OTHER, PROGRESS, TOKEN, progresses

from helicoide.seat import LessonProgress
from helicoide.store.database import Store
from helicoide.store.merging import NO_PROGRESS, Progress
from helicoide.store.schema import METADATA, VERSION, person_of

SCREWS = PROGRESS["screws"]
VERSION_1 = """
CREATE TABLE helicoide_schema (version INTEGER NOT NULL);
INSERT INTO helicoide_schema VALUES (1);
CREATE TABLE lesson_progress (
    person VARCHAR(64) NOT NULL, lesson VARCHAR(100) NOT NULL, step INTEGER NOT NULL, done JSON NOT NULL,
    PRIMARY KEY (person, lesson)
);
"""


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "folder" / "progress.sqlite"


@pytest.fixture
def store(path: Path) -> Iterator[Store]:
    store = Store(path)
    yield store
    store.close()


def bytes_in(folder: Path) -> bytes:
    return b"".join(file.read_bytes() for file in folder.iterdir())


def test_what_was_saved_is_loaded_also_by_the_next_lab(store: Store, path: Path) -> None:
    assert store.load(TOKEN) == NO_PROGRESS
    store.save(TOKEN, PROGRESS)
    assert store.load(TOKEN) == PROGRESS
    store.close()
    assert Store(str(path)).load(TOKEN) == PROGRESS
    assert Store(f"sqlite:///{path}").load(TOKEN) == PROGRESS


def test_everyone_has_their_own(store: Store) -> None:
    store.save(TOKEN, PROGRESS)
    store.save(OTHER, {"motors": LessonProgress("motors")})
    assert store.load(OTHER) == {"motors": LessonProgress("motors")}
    store.forget(OTHER)
    assert store.load(TOKEN) == PROGRESS


@settings(max_examples=50)
@given(progresses(), progresses())
def test_any_progress_comes_back(tmp_path_factory: pytest.TempPathFactory, first: Progress, then: Progress) -> None:
    store = Store(tmp_path_factory.getbasetemp() / "any.sqlite")
    store.save(TOKEN, first, store.load(TOKEN))
    assert store.load(TOKEN) == first
    store.save(TOKEN, then, first)
    assert store.load(TOKEN) == then
    store.close()


def test_the_token_is_not_in_the_file(store: Store, path: Path) -> None:
    store.save(TOKEN, PROGRESS)
    found = bytes_in(path.parent)
    assert person_of(TOKEN).encode() in found
    assert TOKEN.encode() not in found


def test_two_windows_of_two_labs_unite(path: Path) -> None:
    one, two = Store(path), Store(path)
    before = {"screws": SCREWS}
    one.save(TOKEN, before)
    here = {"screws": replace(SCREWS, done=SCREWS.done | {"moves"}, step=3)}
    there = {"screws": replace(SCREWS, done=SCREWS.done | {"open"}), "motors": PROGRESS["motors"]}
    one.save(TOKEN, here, before)
    two.save(TOKEN, there, before)
    assert one.load(TOKEN) == {
        "screws": replace(SCREWS, done=frozenset({"axis", "moves", "open"}), step=3),
        "motors": PROGRESS["motors"],
    }
    one.close()
    two.close()


def test_many_who_save_at_once_lose_nothing(path: Path) -> None:
    """Four labs on one file, each of which adds steps of its own to the lesson of one person."""
    Store(path).open()

    def add(lab: int) -> None:
        store, before, now = Store(path), NO_PROGRESS, LessonProgress("screws")
        for step in range(10):
            now = replace(now, done=now.done | {f"{lab} {step}"}, step=step)
            store.save(TOKEN, {"screws": now}, before)
            before = {"screws": now}
        store.close()

    with ThreadPoolExecutor(4) as labs:
        list(labs.map(add, range(4)))
    found = Store(path).load(TOKEN)["screws"]
    assert found.done == {f"{lab} {step}" for lab in range(4) for step in range(10)}
    assert found.step == 9


def test_what_is_deleted_leaves_no_trace(store: Store, path: Path) -> None:
    """Many people, whose rows have grown and moved between pages, and one of them who leaves."""
    people = [f"person-{k:09d}" for k in range(40)]
    progress: Progress = {}
    for step in range(12):
        lines = {f"step{k}": ("secret" * k,) for k in range(step)}
        progress = {name: LessonProgress(name, step, lines=lines) for name in ("screws", "motors")}
        for person in people:
            store.save(person, progress)
        store.save(TOKEN, {"diary": LessonProgress("diary", step, frozenset({f"unique{k}" for k in range(step)}))})
    with sqlite3.connect(path) as reader:  # its checkpoint comes when another connection is open, too
        assert reader.execute("SELECT count(*) FROM lesson_progress").fetchone() == (81,)
    reader.close()
    store.forget(TOKEN)
    for trace in (person_of(TOKEN), "diary", "unique"):
        assert trace.encode() not in bytes_in(path.parent), trace
    assert store.load(people[0]) == progress


def test_a_database_of_version_1_is_upgraded_and_nothing_of_it_is_lost(path: Path) -> None:
    path.parent.mkdir()
    with sqlite3.connect(path) as old:
        old.executescript(VERSION_1)
        old.execute("INSERT INTO lesson_progress VALUES (?, 'screws', 2, '[\"axis\", \"pitch\"]')", [person_of(TOKEN)])
    old.close()
    store, begun = Store(path), {"screws": LessonProgress("screws", 2, frozenset({"axis", "pitch"}))}
    assert store.load(TOKEN) == begun
    store.save(TOKEN, PROGRESS, begun)
    assert store.load(TOKEN) == PROGRESS
    store.close()
    with sqlite3.connect(path) as new:
        assert new.execute("SELECT version FROM helicoide_schema").fetchall() == [(VERSION,)]
    new.close()


def test_an_upgraded_database_has_the_tables_of_a_new_one(tmp_path: Path) -> None:
    with sqlite3.connect(tmp_path / "old.sqlite") as old:
        old.executescript(VERSION_1)
    old.close()
    for name in ("old.sqlite", "new.sqlite"):
        store = Store(tmp_path / name)
        store.open()
        store.close()
    tables = []
    for name in ("old.sqlite", "new.sqlite"):
        engine = create_engine(f"sqlite:///{tmp_path / name}")
        found = inspect(engine)
        tables.append(
            {
                table: [(c["name"], str(c["type"]), c["nullable"], c["primary_key"]) for c in found.get_columns(table)]
                for table in found.get_table_names()
            }
        )
        engine.dispose()
    assert tables[0] == tables[1]
    assert tables[0].keys() == METADATA.tables.keys()


def test_an_upgrade_that_fails_changes_nothing(path: Path) -> None:
    """A column of the new version is there already, so that the last of the steps fails."""
    path.parent.mkdir()
    with sqlite3.connect(path) as old:
        old.executescript(VERSION_1 + "ALTER TABLE lesson_progress ADD COLUMN finished BOOLEAN;")
    old.close()
    before = sqlite3.connect(path).execute("SELECT sql FROM sqlite_master").fetchall()
    with pytest.raises(Exception, match="cannot be used"):
        Store(path).open()
    assert sqlite3.connect(path).execute("SELECT sql FROM sqlite_master").fetchall() == before
