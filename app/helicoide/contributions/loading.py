"""A Python file that a person wrote: whether it can be used at all, and where it stopped."""

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
    """Why a method or a study cannot be used at all; None where it can. package: holds NEEDS."""
    file = content.module_file(package.__path__, name)
    try:
        module = importlib.import_module(f"{package.__name__}.{name}")
    except (Exception, SystemExit) as error:  # whatever a person's own file raises is its fault, and is said so
        return raised(file, error)
    missing = [need for need in package.NEEDS if not hasattr(module, need)]
    return LACKS.format(file=file, names=", ".join(missing)) if missing else None


def gathered(file: Path, found: Iterable[Text]) -> tuple[Text, ...]:
    """The faults that are found; where a person's file raises meanwhile, those before it, and that it does."""
    said = list[Text]()
    try:
        for fault in found:
            said.append(fault)
    except Exception as error:  # whatever a person's own file raises is its fault, and is said so
        said.append(raised(file, error))
    return tuple(said)


def raised(file: Path, error: BaseException) -> Text:
    """Where a person's file stopped, or how what it gave made the program stop."""
    if isinstance(error, HelicoideError):
        return error.text
    frames = traceback.extract_tb(error.__traceback__)
    if isinstance(error, SyntaxError) or any(frame.filename == str(file) for frame in frames):
        return IN_FILE.format(file=file, what=stopped(file, error))
    place = f"{Path(frames[-1].filename).name}:{frames[-1].lineno}" if frames else "-"
    return FAILED.format(file=file, kind=type(error).__name__, place=place)
