"""Errors of contributed Python files: whether a file can be used, and where it raised."""

from __future__ import annotations

import importlib
import traceback
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType

from helicoide import content
from helicoide.lesson import stopped
from helicoide.text import HelicoideError, Text

LACKS = Text(en="{file} lacks: {names}", pt_BR="{file} não tem: {names}")
IN_FILE = Text(en="{file}, {what}", pt_BR="{file}, {what}")
FAILED = Text(
    en="{file}: the program stops with {kind} at what it gave ({place})",
    pt_BR="{file}: o programa para com {kind} naquilo que ele deu ({place})",
)


def unusable(package: ModuleType, name: str) -> Text | None:
    """Why a method or a study cannot be used; None if it can. package: defines NEEDS."""
    file = content.module_file(package.__path__, name)
    try:
        module = importlib.import_module(f"{package.__name__}.{name}")
    except (Exception, SystemExit) as error:  # any error of a contributed file is a fault
        return where_raised(file, error)
    missing = [need for need in package.NEEDS if not hasattr(module, need)]
    return LACKS.format(file=file, names=", ".join(missing)) if missing else None


def collected_faults(file: Path, found: Iterable[Text]) -> tuple[Text, ...]:
    """The faults that are found. If the contributed file raises, its error is the last fault."""
    said = list[Text]()
    try:
        for fault in found:
            said.append(fault)
    except Exception as error:  # any error of a contributed file is a fault
        said.append(where_raised(file, error))
    return tuple(said)


def where_raised(file: Path, error: BaseException) -> Text:
    """Where a contributed file raised, or which error its result caused in the program."""
    if isinstance(error, HelicoideError):
        return error.text
    frames = traceback.extract_tb(error.__traceback__)
    if isinstance(error, SyntaxError) or any(frame.filename == str(file) for frame in frames):
        return IN_FILE.format(file=file, what=stopped(file, error))
    place = f"{Path(frames[-1].filename).name}:{frames[-1].lineno}" if frames else "-"
    return FAILED.format(file=file, kind=type(error).__name__, place=place)
