"""The database that keeps progress: an SQLite file, or another database by its URL."""

from __future__ import annotations

import logging
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, create_engine, event, select
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, SQLAlchemyError

from helicoide.files.os_errors import os_error_reason
from helicoide.store.failures import DAMAGED, database_reason
from helicoide.store.merging import NO_PROGRESS, Progress, merge_progress
from helicoide.store.records import lesson_to_record, read_lesson_record
from helicoide.store.schema import PROGRESS, person_of, prepare_tables
from helicoide.text import HelicoideError, Text

PATIENCE = 1.0  # s to wait for another program that writes into the same file
# With a write-ahead log, what was saved is there after a kill. The setting stays in the file, so it is made once, when
# it is known that the file is ours.
LOG = "PRAGMA journal_mode = WAL"
PRAGMAS = ("PRAGMA synchronous = NORMAL", "PRAGMA secure_delete = ON")  # which overwrites what is deleted
UNUSABLE = Text(
    en="The database of the progress cannot be used: {reason}.",
    pt_BR="Não dá para usar o banco de dados do progresso: {reason}.",
)
IMPOSSIBLE = Text(
    en="Progress cannot be kept in {place}: {reason}.", pt_BR="Não dá para guardar o progresso em {place}: {reason}."
)
NO_URL = Text(
    en="it is not the URL of a database, such as sqlite:////folder/file or postgresql://user@host/name",
    pt_BR="isto não é a URL de um banco de dados, como sqlite:////pasta/arquivo ou postgresql://usuario@host/nome",
)
NO_DRIVER = Text(
    en="the Python package that connects to {kind} is not installed",
    pt_BR="falta instalar o pacote de Python que conecta a {kind}",
)
log = logging.getLogger("helicoide")


class Store:
    """Keeps the progress of each person, by the token of their browser, of which it keeps a hash alone.

    place: the path of an SQLite file, which is made when it is first needed, or the URL of a database; name: the same
    without a password. Every method may raise HelicoideError, which says why the database cannot be used; nothing is
    changed then. Methods may be called from any thread, and take up to a second if another program uses the database:
    not on the event loop.
    """

    def __init__(self, place: Path | str) -> None:
        url = _url(place)
        file = url.database if url.get_backend_name() == "sqlite" else None
        self.name = file or url.render_as_string(hide_password=True)
        self._folder = None if file is None else Path(file).parent
        self._engine = _engine(url, self.name)
        self._ready = False

    def open(self) -> None:
        """Make the tables, or upgrade them, if this is not done yet."""
        with self._transaction():
            pass

    def load(self, token: str) -> Progress:
        """The progress of a person; empty if there is none."""
        with self._transaction() as connection:
            return self._read(connection, person_of(token))

    def save(self, token: str, progress: Progress, before: Progress = NO_PROGRESS) -> None:
        """Store the changes of a person: `before` is what they had loaded or saved last. What others saved is kept."""
        person = person_of(token)
        with self._transaction() as connection:
            stored = self._read(connection, person)
            result = merge_progress(stored, before, progress)
            changed = [name for name in stored.keys() | result.keys() if stored.get(name) != result.get(name)]
            rows = [{"lesson": name, **lesson_to_record(result[name])} for name in changed if name in result]
            connection.execute(PROGRESS.delete().where(PROGRESS.c.person == person, PROGRESS.c.lesson.in_(changed)))
            if rows:
                connection.execute(PROGRESS.insert().values(person=person), rows)

    def forget(self, token: str) -> None:
        """Delete all that is stored about a person; an SQLite file then contains no trace of it."""
        with self._transaction() as connection:
            connection.execute(PROGRESS.delete().where(PROGRESS.c.person == person_of(token)))
        with self._in_words():
            self._outside_transactions("PRAGMA wal_checkpoint(TRUNCATE)")

    def close(self) -> None:
        """Close the file or the connection. A later call opens it again."""
        self._engine.dispose()

    def _read(self, connection: Connection, person: str) -> Progress:
        columns = [column for column in PROGRESS.c if column is not PROGRESS.c.person]
        try:
            rows = connection.execute(select(*columns).where(PROGRESS.c.person == person)).mappings()
            found = [{str(key): value for key, value in row.items()} for row in rows]
            return {(name := row.pop("lesson")): read_lesson_record(name, row) for row in found}
        except (ValueError, HelicoideError) as error:
            raise HelicoideError(DAMAGED) from error

    @contextmanager
    def _transaction(self) -> Iterator[Connection]:
        """A transaction on a database whose tables are there."""
        with self._in_words():
            if not self._ready:
                self._prepare()
            with self._engine.begin() as connection:
                yield connection

    def _prepare(self) -> None:
        if self._folder is not None:
            self._folder.mkdir(parents=True, exist_ok=True)
        with self._engine.begin() as connection:
            prepare_tables(connection)
        self._outside_transactions(LOG)
        self._ready = True

    def _outside_transactions(self, statement: str) -> None:
        """Execute a statement of SQLite, if the database is a file of it."""
        if self._folder is not None:
            with closing(self._engine.raw_connection()) as connection:
                connection.cursor().execute(statement)

    @contextmanager
    def _in_words(self) -> Iterator[None]:
        """Raise what goes wrong as HelicoideError; what the database itself says goes to the log."""
        try:
            yield
        except HelicoideError as refusal:
            raise HelicoideError(UNUSABLE.format(reason=refusal.text)) from refusal
        except OSError as error:
            raise HelicoideError(UNUSABLE.format(reason=os_error_reason(error))) from error
        except (SQLAlchemyError, sqlite3.Error) as error:
            log.warning("%s: %s", self.name, error)
            raise HelicoideError(UNUSABLE.format(reason=database_reason(error))) from error


def _url(place: Path | str) -> URL:
    """The URL of a database, which may be given as the path of an SQLite file."""
    if isinstance(place, Path) or "://" not in place:
        return URL.create("sqlite", database=str(place))
    try:
        return make_url(place)
    except (ArgumentError, ValueError) as error:
        raise HelicoideError(IMPOSSIBLE.format(place=place, reason=NO_URL)) from error


def _engine(url: URL, name: str) -> Engine:
    kind = url.get_backend_name()
    wait = {"timeout": PATIENCE} if kind == "sqlite" else {}
    try:
        engine = create_engine(url, connect_args=wait, hide_parameters=True)
    except (ArgumentError, ImportError) as error:
        raise HelicoideError(IMPOSSIBLE.format(place=name, reason=NO_DRIVER.format(kind=kind))) from error
    if kind == "sqlite":
        event.listen(engine, "connect", _set_up)
        event.listen(engine, "begin", _begin)
    return engine


def _set_up(connection: sqlite3.Connection, _: object) -> None:
    """Set up a new connection to an SQLite file. Transactions are begun by `_begin`, not by Python."""
    connection.isolation_level = None
    for pragma in PRAGMAS:
        connection.execute(pragma)


def _begin(connection: Connection) -> None:
    """Begin as a writer: a reader that becomes one could find that another program was faster."""
    connection.exec_driver_sql("BEGIN IMMEDIATE")
