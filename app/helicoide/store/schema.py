"""The tables of the database, and the steps from each version of them to the next.

A person is the hash of the token that their browser keeps: who reads the database cannot take their place at the lab.
A change of the tables needs a new `VERSION` and a function at the end of `UPGRADES`.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable

from sqlalchemy import JSON, Boolean, Column, Connection, Integer, MetaData, String, Table, false, inspect, select, text

from helicoide.text import HelicoideError, Text

VERSION = 2
METADATA = MetaData()
SCHEMA = Table("helicoide_schema", METADATA, Column("version", Integer, nullable=False))
PROGRESS = Table(
    "lesson_progress",
    METADATA,
    Column("person", String(64), primary_key=True),
    Column("lesson", String(100), primary_key=True),
    Column("step", Integer, nullable=False),
    Column("done", JSON, nullable=False),
    Column("skipped", JSON, nullable=False, server_default=text("'[]'")),
    Column("answers", JSON, nullable=False, server_default=text("'{}'")),
    Column("lines", JSON, nullable=False, server_default=text("'{}'")),
    Column("mistakes", JSON, nullable=False, server_default=text("'[]'")),
    Column("finished", Boolean, nullable=False, server_default=false()),
)
OTHER_PROGRAM = Text(
    en="it belongs to another program",
    pt_BR="ele é de outro programa",
)
NEWER = Text(
    en="a newer Helicoide has written it (version {found}; this one reads versions 1 to {known})",
    pt_BR="um Helicoide mais novo o escreveu (versão {found}; este lê as versões 1 a {known})",
)


def person_of(token: str) -> str:
    """The person to whom a token belongs, as the database names them."""
    return hashlib.sha256(token.encode()).hexdigest()


def prepare_tables(connection: Connection) -> None:
    """Make the tables in an empty database, or upgrade them. Raises HelicoideError if they are not ours or newer."""
    tables = inspect(connection).get_table_names()
    if not tables:
        METADATA.create_all(connection)
        connection.execute(SCHEMA.insert().values(version=VERSION))
        return
    version = connection.scalar(select(SCHEMA.c.version)) if {SCHEMA.name, PROGRESS.name} <= set(tables) else None
    if not isinstance(version, int) or version < 1:
        raise HelicoideError(OTHER_PROGRAM)
    if version > VERSION:
        raise HelicoideError(NEWER.format(found=version, known=VERSION))
    if version < VERSION:
        for upgrade in UPGRADES[version - 1 :]:
            upgrade(connection)
        connection.execute(SCHEMA.update().values(version=VERSION))


def _to_version_2(connection: Connection) -> None:
    """Version 1 had the current step and the steps that were done."""
    for column in (
        "skipped JSON DEFAULT '[]'",
        "answers JSON DEFAULT '{}'",
        "lines JSON DEFAULT '{}'",
        "mistakes JSON DEFAULT '[]'",
        "finished BOOLEAN DEFAULT FALSE",
    ):
        connection.exec_driver_sql(f"ALTER TABLE lesson_progress ADD COLUMN {column} NOT NULL")


UPGRADES: tuple[Callable[[Connection], None], ...] = (_to_version_2,)
