"""Why a database cannot be used, in both languages; its own messages are for programmers."""

from __future__ import annotations

import sqlite3

from sqlalchemy.exc import DBAPIError, SQLAlchemyError

from helicoide.text import Text

DAMAGED = Text(en="it is damaged or no database", pt_BR="ele está danificado ou não é um banco de dados")
_LOCKED = Text(en="another program has locked it", pt_BR="outro programa o bloqueou")
_WHY = {
    sqlite3.SQLITE_FULL: Text(en="the disk is full", pt_BR="o disco está cheio"),
    sqlite3.SQLITE_BUSY: _LOCKED,
    sqlite3.SQLITE_LOCKED: _LOCKED,
    sqlite3.SQLITE_READONLY: Text(en="it can only be read", pt_BR="ele é só de leitura"),
    sqlite3.SQLITE_CANTOPEN: Text(
        en="the file cannot be opened or made there; its folder or the permissions do not allow it",
        pt_BR="não dá para abrir nem criar o arquivo ali; a pasta ou as permissões não deixam",
    ),
    sqlite3.SQLITE_IOERR: Text(en="the disk does not read or write it", pt_BR="o disco não consegue ler ou escrever"),
    sqlite3.SQLITE_CORRUPT: DAMAGED,
    sqlite3.SQLITE_NOTADB: DAMAGED,
}
_REFUSED = Text(
    en="the database refuses it; the terminal says why", pt_BR="o banco de dados não deixa; o terminal diz por quê"
)
PRIMARY = 0xFF  # SQLite adds details to its codes in higher bits


def database_reason(error: SQLAlchemyError | sqlite3.Error) -> Text:
    """The reason of an error of a database as part of a sentence."""
    cause = error.orig if isinstance(error, DBAPIError) else error
    return _WHY.get(getattr(cause, "sqlite_errorcode", 0) & PRIMARY, _REFUSED)
