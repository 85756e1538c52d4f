"""Guided lessons: steps with a checked goal, joined with their prose by the step's id."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from helicoide import content
from helicoide.state import Seat, State, Update
from helicoide.text import LANGUAGES, HelicoideError, Language, Text

Goal = Callable[[State, Seat], bool]


@dataclass(frozen=True)
class Step:
    """One thing to do: `setup` brings the scene to its start, `goal` says when it is done.

    `solution` plays it: wishes, each with the seconds that the arm is then given; the tests hold it to the goal.
    """

    id: str
    setup: Update
    goal: Goal
    solution: tuple[tuple[Update, float], ...]


@dataclass(frozen=True)
class Prose:
    """The words of a step, Markdown, both languages."""

    title: Text
    body: Text
    hint: Text


@dataclass(frozen=True)
class Lesson:
    """A lesson with its steps and their words."""

    id: str
    title: Text
    steps: tuple[Step, ...]
    prose: Mapping[str, Prose]


_SECTION = re.compile(r"^## (?P<id>[a-z_]+): (?P<title>.+?)\n(?P<body>.*?)\n> (?P<hint>.+?)\n?$", re.S)


def _sections(path: Path) -> dict[str, re.Match[str]]:
    """The sections of a lesson's page by step id: `## id: title`, the body, and a last line `> hint`."""
    found = {}
    for section in re.split(r"(?m)^(?=## )", path.read_text(encoding="utf-8"))[1:]:
        match = _SECTION.match(section.strip() + "\n")
        if match is None:
            raise _broken(path, f"'## id: title', text, '> hint': {section.splitlines()[0]}")
        found[match["id"]] = match
    return found


def _broken(path: Path, reason: object) -> HelicoideError:
    return HelicoideError(
        Text(en="{path} is not a valid lesson: {reason}", pt_BR="{path} não é uma lição válida: {reason}").format(
            path=path, reason=reason
        )
    )


def load(name: str) -> Lesson:
    """A lesson by the name of its folder; raises HelicoideError when its files do not fit together."""
    folder = content.folder("lessons", name)
    spec = importlib.util.spec_from_file_location(f"helicoide_lessons.{name}", folder / "lesson.py")
    if spec is None or spec.loader is None:
        raise _broken(folder, "lesson.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    steps: tuple[Step, ...] = module.STEPS
    pages = {language: _sections(folder / f"{language}.md") for language in LANGUAGES}
    for language, page in pages.items():
        if list(page) != [step.id for step in steps]:
            raise _broken(folder / f"{language}.md", f"{list(page)} != {[step.id for step in steps]}")
    return Lesson(name, module.TITLE, steps, {step.id: _prose(pages, step.id) for step in steps})


def _prose(pages: Mapping[Language, Mapping[str, re.Match[str]]], step: str) -> Prose:
    def text(part: str) -> Text:
        return Text(en=pages["en"][step][part].strip(), pt_BR=pages["pt_BR"][step][part].strip())

    return Prose(text("title"), text("body"), text("hint"))


def progressed(lesson: Lesson, state: State, seat: Seat) -> Seat:
    """The seat with its current step marked as done when the goal is met."""
    step = lesson.steps[seat.step]
    if step.id in seat.done or not step.goal(state, seat):
        return seat
    return replace(seat, done=seat.done | {step.id})
