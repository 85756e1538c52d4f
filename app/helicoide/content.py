"""Finds robots, lessons and static files, shipped or in the user's folder, and the modules of a package.

The user's folder may contain robots/, lessons/, methods/ and studies/; the lab adds recordings/ and the progress in
lessons.
"""

from __future__ import annotations

import importlib
import logging
import pkgutil
import sys
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Literal

from platformdirs import user_data_path

from helicoide.text import HelicoideError, Text, untranslated

ContentKind = Literal["robots", "lessons"]

log = logging.getLogger("helicoide")

_PACKAGE = Path(__file__).parent
_CHECKOUT = _PACKAGE.parent.parent
IN_CHECKOUT = (_CHECKOUT / "pyproject.toml").is_file()
SHIPPED = _CHECKOUT if IN_CHECKOUT else _PACKAGE
STATIC = SHIPPED / "static"
_MARKER_FILE: dict[ContentKind, str] = {"robots": "robot.toml", "lessons": "lesson.py"}
_LESSON_FOLDERS = list[Path]()  # named by the user, besides the user's own folder
NO_LESSONS = Text(
    en="{folder} contains no lesson: name a folder that has a folder for each lesson, with its lesson.py.{instead}",
    pt_BR="{folder} não contém lição: indique uma pasta que tenha uma pasta por lição, com o lesson.py.{instead}",
)
INSTEAD = Text(en=" Here that is {folder}.", pt_BR=" Aqui, essa pasta é {folder}.")


def user_folder() -> Path:
    """The folder of the user's own robots, lessons, methods and studies."""
    return user_data_path("helicoide")


def content_folders(kind: ContentKind) -> dict[str, Path]:
    """Folders of one kind by name; a user's folder replaces a shipped one of the same name."""
    roots = (SHIPPED / kind, user_folder() / kind, *(_LESSON_FOLDERS if kind == "lessons" else ()))
    return {file.parent.name: file.parent for root in roots for file in sorted(root.glob(f"*/{_MARKER_FILE[kind]}"))}


def add_lessons(folder: Path) -> None:
    """Find the lessons of a further folder too. Raises HelicoideError if there are none in it."""
    folder = folder.expanduser().resolve()
    marker = _MARKER_FILE["lessons"]
    if not any(folder.glob(f"*/{marker}")):
        instead = INSTEAD.format(folder=folder.parent) if (folder / marker).is_file() else untranslated("")
        raise HelicoideError(NO_LESSONS.format(folder=folder, instead=instead))
    _LESSON_FOLDERS.append(folder)


def content_folder(kind: ContentKind, name: str) -> Path:
    """The folder of one robot or lesson. Raises HelicoideError, which lists the known names."""
    known = content_folders(kind)
    if name not in known:
        what = {"robots": Text(en="robot", pt_BR="robô"), "lessons": Text(en="lesson", pt_BR="lição")}[kind]
        raise HelicoideError(
            Text(
                en="There is no {what} named {name!r}; there is: {known}.",
                pt_BR="Não existe {what} de nome {name!r}; existe: {known}.",
            ).format(what=what, name=name, known=", ".join(sorted(known)))
        )
    return known[name]


def module_names(package: str, needs: Sequence[str] = ()) -> tuple[str, ...]:
    """The sorted names of the modules of an imported package; shipped ones that begin with "_" are left out.

    A package that accepts modules of the user has the user's folder in its `__path__` after its own. A user's module
    that cannot be imported, or lacks a name of `needs`, is left out with a warning in the log. A broken shipped module
    raises when it is imported.
    """
    shipped, *own = sys.modules[package].__path__
    names = _names_in(shipped)
    more = (module.name for module in pkgutil.iter_modules(own) if not module.ispkg)
    return tuple(sorted({*names, *(name for name in more if name not in names and _usable(package, name, needs))}))


@cache
def _names_in(folder: str) -> frozenset[str]:
    modules = pkgutil.iter_modules([folder])
    return frozenset(m.name for m in modules if not m.ispkg and not m.name.startswith("_"))


def module_file(path: Iterable[str], name: str) -> Path:
    """The file of a module in the folders of a package's path; the place in the first folder if no folder has it."""
    files = [Path(folder) / f"{name}.py" for folder in path]
    return next((file for file in files if file.is_file()), files[0])


def _usable(package: str, name: str, needs: Sequence[str]) -> bool:
    try:
        module = importlib.import_module(f"{package}.{name}")
    except (Exception, SystemExit) as error:  # a user's file may raise anything
        log.warning("%s.%s is left out, %r: see helicoide check %s", package, name, error, name)
        return False
    if missing := [need for need in needs if not hasattr(module, need)]:
        log.warning("%s.%s is left out, it lacks %s: see helicoide check %s", package, name, ", ".join(missing), name)
    return not missing


def modules(package: str) -> dict[str, ModuleType]:
    """All modules of an imported package, by name."""
    return {name: importlib.import_module(f"{package}.{name}") for name in module_names(package)}


def module(package: str, name: str, names: Sequence[str], what: Text) -> ModuleType:
    """Import a module of a package. Raises HelicoideError, which lists `names`, if it is not one of them.

    what: the kind of module in the message, such as "method".
    """
    if name not in names:
        raise HelicoideError(
            Text(
                en="There is no {what} {name!r}; there is: {known}.", pt_BR="Não há {what} {name!r}; há: {known}."
            ).format(what=what, name=name, known=", ".join(names))
        )
    return importlib.import_module(f"{package}.{name}")
