"""Read lessons: `lesson.py` and the pages of a folder, which have to match. What is wrong is said in words.

The folder is a package, so that a long `lesson.py` can import from other files in it: `from .values import VALUES`.
"""

from __future__ import annotations

import importlib
import logging
import sys
from base64 import b64encode
from collections.abc import Mapping
from functools import cache
from importlib.machinery import SourceFileLoader
from itertools import count
from pathlib import Path
from types import ModuleType

from helicoide import content
from helicoide.files import text_file
from helicoide.files.os_errors import os_error_reason
from helicoide.lesson.course import in_course_order
from helicoide.lesson.lesson import Lesson
from helicoide.lesson.matching import merged_prose, mismatch
from helicoide.lesson.module_errors import raised_in, stopped
from helicoide.lesson.prose import PICTURE, Section, read_sections
from helicoide.lesson.step import Step
from helicoide.lesson.values import Value
from helicoide.text import LANGUAGES, HelicoideError, Language, Text, untranslated

READINGS = count()
MOST_BYTES, LARGEST_PICTURE = 1_000_000, 400_000
KINDS = {".svg": "", ".png": "image/png", ".jpg": "image/jpeg", ".webp": "image/webp"}
_STEPS = Text(
    en="it needs TITLE, a Text, and STEPS, a tuple of at least one Step",
    pt_BR="faltam TITLE, um Text, e STEPS, uma tupla com pelo menos um Step",
)
_TWICE = Text(en="two of its steps have one id: {steps}", pt_BR="dois dos passos têm o mesmo id: {steps}")
_ROBOT = Text(en="it needs ROBOT, one of: {robots}", pt_BR="falta ROBOT, um dentre: {robots}")
_OPTIONAL = Text(
    en="{name} is of another type: ABOUT is a Text, NEEDS and SOURCES are tuples of words, OWN_ARM is True or False, "
    "VALUES has a Value for each name",
    pt_BR="{name} é de outro tipo: ABOUT é um Text, NEEDS e SOURCES são tuplas de palavras, OWN_ARM é True ou False, "
    "VALUES tem um Value para cada nome",
)
_PICTURE = Text(
    en="the picture {name} has to be a file of the lesson's folder, with at most {most} kB, of one of these kinds: "
    "{kinds}",
    pt_BR="a figura {name} precisa ser um arquivo da pasta da lição, com no máximo {most} kB, de um destes tipos: "
    "{kinds}",
).format(most=LARGEST_PICTURE // 1000, kinds=", ".join(KINDS), name="{name}")
log = logging.getLogger("helicoide")


@cache
def load_lesson(name: str) -> Lesson:
    """A lesson by the name of its folder, read once. Raises HelicoideError as `read_lesson`."""
    return read_lesson(name)


def read_lesson(name: str) -> Lesson:
    """A lesson by the name of its folder. Raises HelicoideError if a file is invalid or if the files do not match."""
    folder = content.content_folder("lessons", name)
    found = _read_module(folder / "lesson.py", name)
    pages = {language: _read_page(folder / f"{language}.md", found) for language in LANGUAGES}
    path, fault = folder, mismatch(found, pages)
    if fault is not None:
        path = folder / f"{fault.language}.md"
        raise _broken(path, fault.text)
    prose = {step.id: merged_prose(pages["en"][step.id], pages["pt_BR"][step.id]) for step in found.steps}
    pictures = {name: _picture(folder, name) for name in _picture_names(pages)}
    return Lesson(**{**vars(found), "prose": prose, "pictures": pictures})


def all_lessons() -> tuple[Lesson, ...]:
    """Every lesson whose files can be read, in the order of the course. Others are named in the log."""
    return in_course_order([lesson for name in content.content_folders("lessons") if (lesson := _readable(name))])


def _readable(name: str) -> Lesson | None:
    try:
        return load_lesson(name)
    except HelicoideError as error:
        log.warning("%s", error)
        return None


def _broken(path: Path, reason: Text) -> HelicoideError:
    return HelicoideError(
        Text(
            en="{path} is not a valid lesson: {reason}. The lessons that come with Helicoide are examples.",
            pt_BR="{path} não é uma lição válida: {reason}. As lições que vêm com o Helicoide servem de exemplo.",
        ).format(path=path, reason=reason)
    )


def _read_module(path: Path, name: str) -> Lesson:
    """A lesson.py, without prose. Raises HelicoideError with the line if the file raises anything."""
    package = f"helicoide_lessons.{name}_{next(READINGS)}"  # a name of its own, since files may have changed
    loader = SourceFileLoader(package, str(path))
    module = sys.modules[package] = ModuleType(package)
    module.__package__, module.__path__ = package, [str(path.parent)]
    importlib.invalidate_caches()
    try:
        loader.exec_module(module)
    except (Exception, SystemExit) as error:
        file = raised_in(path, error)
        raise _broken(file, stopped(file, error)) from error
    finally:
        for imported in [one for one in list(sys.modules) if one == package or one.startswith(f"{package}.")]:
            del sys.modules[imported]
    title, robot, steps = (getattr(module, name, None) for name in ("TITLE", "ROBOT", "STEPS"))
    if robot not in content.content_folders("robots"):
        raise _broken(path, _ROBOT.format(robots=", ".join(content.content_folders("robots"))))
    if not (isinstance(title, Text) and isinstance(steps, tuple) and steps and all(isinstance(s, Step) for s in steps)):
        raise _broken(path, _STEPS)
    if len({step.id for step in steps}) < len(steps):
        raise _broken(path, _TWICE.format(steps=", ".join(step.id for step in steps)))
    return _with_options(Lesson(name, title, robot, steps, {}), module, path)


def _with_options(lesson: Lesson, module: ModuleType, path: Path) -> Lesson:
    """The lesson with what its lesson.py may leave out."""
    about = getattr(module, "ABOUT", untranslated(""))
    needs, sources = getattr(module, "NEEDS", ()), getattr(module, "SOURCES", ())
    own_arm, values = getattr(module, "OWN_ARM", False), getattr(module, "VALUES", {})
    valid = {
        "ABOUT": isinstance(about, Text),
        "NEEDS": isinstance(needs, tuple) and all(isinstance(need, str) for need in needs),
        "SOURCES": isinstance(sources, tuple) and all(isinstance(source, str) for source in sources),
        "OWN_ARM": isinstance(own_arm, bool),
        "VALUES": isinstance(values, Mapping) and all(isinstance(value, Value) for value in values.values()),
    }
    if invalid := [name for name, is_valid in valid.items() if not is_valid]:
        raise _broken(path, _OPTIONAL.format(name=invalid[0]))
    more = {"about": about, "needs": needs, "sources": sources, "own_arm": own_arm, "values": values}
    return Lesson(**{**vars(lesson), **more})


def _read_page(path: Path, lesson: Lesson) -> dict[str, Section]:
    """The sections of one language's page by step id."""
    diagnoses = {step.id: [one.id for one in step.diagnoses] for step in lesson.steps}
    try:
        return read_sections(text_file.read_text(path, MOST_BYTES), diagnoses)
    except HelicoideError as error:
        raise _broken(path, error.text) from error


def _picture_names(pages: Mapping[Language, Mapping[str, Section]]) -> list[str]:
    sections = (section for page in pages.values() for section in page.values())
    return sorted({name for section in sections for name in PICTURE.findall(section.whole)})


def _picture(folder: Path, name: str) -> str:
    """A picture of the lesson's folder: the SVG itself, or a data URL."""
    file = folder / name
    kind = KINDS.get(file.suffix)
    if kind is None or file.parent != folder:
        raise _broken(folder, _PICTURE.format(name=name))
    try:
        picture = file.read_bytes()
    except OSError as error:
        raise _broken(file, os_error_reason(error)) from error
    if len(picture) > LARGEST_PICTURE:
        raise _broken(folder, _PICTURE.format(name=name))
    return f"data:{kind};base64,{b64encode(picture).decode()}" if kind else picture.decode("utf-8", "replace")
