"""Where a Python file of a contributor raised, in words."""

from __future__ import annotations

import traceback
from pathlib import Path

from helicoide.text import HelicoideError, Text

NO_PYTHON = Text(en="it is no Python", pt_BR="isto não é Python")
NO_PYTHON_AT = Text(en="line {line} is no Python", pt_BR="a linha {line} não é Python")
IMPORT = Text(
    en="line {line} imports {name}, which cannot be loaded", pt_BR="a linha {line} importa {name}, que não carrega"
)
REFUSED = Text(en="line {line}: {why}", pt_BR="linha {line}: {why}")
STOPPED = Text(
    en="line {line} stops with {kind}; run the file with Python to see why",
    pt_BR="a linha {line} para com {kind}; execute o arquivo com o Python para ver por quê",
)


def stopped(path: Path, error: BaseException) -> Text:
    """The line of a user's Python file at which an error was raised, and the kind of error, in words."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    if not lines:
        line = error.lineno if isinstance(error, SyntaxError) else None
        return NO_PYTHON if line is None else NO_PYTHON_AT.format(line=line)
    if isinstance(error, ImportError):
        return IMPORT.format(line=lines[-1], name=error.name)
    if isinstance(error, HelicoideError):
        return REFUSED.format(line=lines[-1], why=error.text)
    return STOPPED.format(line=lines[-1], kind=type(error).__name__)


def raised_in(path: Path, error: BaseException) -> Path:
    """The file at which an error was raised, if it lies beside a user's Python file, else this file."""
    raised = [frame.filename for frame in traceback.extract_tb(error.__traceback__)]
    if isinstance(error, SyntaxError) and error.filename is not None:
        raised.append(error.filename)
    return next((file for file in map(Path, reversed(raised)) if file.parent == path.parent), path)
