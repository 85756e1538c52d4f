"""Finds robots, lessons and static files, shipped or in the user's folder, and the modules of a package's folder."""

from __future__ import annotations

import importlib
import pkgutil
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Literal

from platformdirs import user_data_path

from helicoide.text import HelicoideError, Text

Kind = Literal["robots", "lessons"]

_PACKAGE = Path(__file__).parent
_CHECKOUT = _PACKAGE.parent.parent
SHIPPED = _CHECKOUT if (_CHECKOUT / "pyproject.toml").is_file() else _PACKAGE
STATIC = SHIPPED / "static"
_MARKER: dict[Kind, str] = {"robots": "robot.toml", "lessons": "lesson.py"}


def user_folder() -> Path:
    """Where a user's own robots and lessons are looked for."""
    return user_data_path("helicoide")


def found(kind: Kind) -> dict[str, Path]:
    """Folders of one kind by name; the user's own come before the shipped ones of the same name."""
    roots = (SHIPPED / kind, user_folder() / kind)
    return {file.parent.name: file.parent for root in roots for file in sorted(root.glob(f"*/{_MARKER[kind]}"))}


def folder(kind: Kind, name: str) -> Path:
    """The folder of one robot or lesson; raises HelicoideError that lists the names there are."""
    known = found(kind)
    if name not in known:
        what = {"robots": Text(en="robot", pt_BR="robô"), "lessons": Text(en="lesson", pt_BR="lição")}[kind]
        raise HelicoideError(
            Text(
                en="There is no {what} named {name!r}; there is: {known}.",
                pt_BR="Não existe {what} de nome {name!r}; existe: {known}.",
            ).format(what=what, name=name, known=", ".join(sorted(known)))
        )
    return known[name]


@cache
def module_names(package: str) -> tuple[str, ...]:
    """The names of the modules in the folder of an imported package, sorted.

    Packages and modules whose names begin with "_" are left out.
    """
    modules = pkgutil.iter_modules(sys.modules[package].__path__)
    return tuple(sorted(m.name for m in modules if not m.ispkg and not m.name.startswith("_")))


def modules(package: str) -> dict[str, ModuleType]:
    """All modules in the folder of an imported package, by name."""
    return {name: importlib.import_module(f"{package}.{name}") for name in module_names(package)}


def module(package: str, name: str, names: Sequence[str], what: Text) -> ModuleType:
    """Import one of the named modules of a package; raises HelicoideError, which lists them. what: such as "method"."""
    if name not in names:
        raise HelicoideError(
            Text(
                en="There is no {what} {name!r}; there is: {known}.", pt_BR="Não há {what} {name!r}; há: {known}."
            ).format(what=what, name=name, known=", ".join(names))
        )
    return importlib.import_module(f"{package}.{name}")
