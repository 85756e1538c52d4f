"""A Python file that a person wrote: whether it can be used at all, and where it stopped."""

from __future__ import annotations

import importlib
import traceback
from pathlib import Path
from types import ModuleType

from helicoide import content
from helicoide.lesson import stopped
from helicoide.text import HelicoideError, Text

LACKS = Text(en="{file} lacks: {names}", pt_BR="{file} não tem: {names}")
IN_FILE = Text(en="{file}, {what}", pt_BR="{file}, {what}")
FAILED = Text(
    en="{file} gave something that the program stops at, with {kind}: {why}",
    pt_BR="{file} deu algo em que o programa para, com {kind}: {why}",
)


def unusable(package: ModuleType, name: str) -> Text | None:
    """Why a method or a study cannot be used at all; None where it can. package: holds NEEDS."""
    file = content.module_file(package.__path__, name)
    try:
        module = importlib.import_module(f"{package.__name__}.{name}")
    except (Exception, SystemExit) as error:  # whatever a person's own file raises is its fault, and is said so
        return raised(file, error)
    missing = [need for need in package.NEEDS if not hasattr(module, need)]
    return LACKS.format(file=file, names=", ".join(missing)) if missing else None


def raised(file: Path, error: BaseException) -> Text:
    """Where a person's file stopped, or how what it gave made the program stop."""
    if isinstance(error, HelicoideError):
        return error.text
    inside = any(frame.filename == str(file) for frame in traceback.extract_tb(error.__traceback__))
    if inside or isinstance(error, SyntaxError):
        return IN_FILE.format(file=file, what=stopped(file, error))
    return FAILED.format(file=file, kind=type(error).__name__, why=error)
