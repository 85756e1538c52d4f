"""Checks of robots, lessons, methods and studies, one module for each kind.

`faults(name)` of each module returns the faults as texts. `helicoide check` and the tests use the same functions.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Iterable
from importlib import import_module
from typing import Literal, get_args

from helicoide import content
from helicoide import studies as all_studies
from helicoide.ik import methods as all_methods
from helicoide.text import HelicoideError, Text

Kind = Literal["robot", "lesson", "method", "study"]
KINDS: tuple[Kind, ...] = get_args(Kind)
TITLES: dict[Kind, Text] = {
    "robot": Text(en="robot", pt_BR="robô"),
    "lesson": Text(en="lesson", pt_BR="lição"),
    "method": Text(en="method", pt_BR="método"),
    "study": Text(en="study", pt_BR="estudo"),
}
_FILES: dict[Kind, str] = {"robot": "robots", "lesson": "lessons", "method": "methods", "study": "studies"}
UNKNOWN = Text(
    en="There is no robot, lesson, method or study named {name!r}; there is: {known}.",
    pt_BR="Não há robô, lição, método ou estudo de nome {name!r}; há: {known}.",
)


def contribution_names(kind: Kind) -> tuple[str, ...]:
    """The names of all of a kind, including those that cannot be used."""
    match kind:
        case "robot":
            return tuple(sorted(content.content_folders("robots")))
        case "lesson":
            return tuple(sorted(content.content_folders("lessons")))
        case "method":
            return _modules(all_methods.names(), all_methods.__path__)
        case "study":
            return _modules(all_studies.study_names(), all_studies.__path__)


def _modules(usable: Iterable[str], path: Iterable[str]) -> tuple[str, ...]:
    _, *own = path
    return tuple(sorted({*usable, *(module.name for module in pkgutil.iter_modules(own) if module.name[0] != "_")}))


def faults(kind: Kind, name: str) -> tuple[Text, ...]:
    """The faults of one of them."""
    said: tuple[Text, ...] = import_module(f"{__name__}.{_FILES[kind]}").faults(name)
    return said


def named(name: str | None) -> list[tuple[Kind, str]]:
    """Kind and name of all with that name; None: of all. Raises HelicoideError, with all names, if there is none."""
    every = [(kind, each) for kind in KINDS for each in contribution_names(kind)]
    chosen = [(kind, each) for kind, each in every if name in (None, each)]
    if not chosen:
        raise HelicoideError(UNKNOWN.format(name=name, known=", ".join(each for _, each in every)))
    return chosen
