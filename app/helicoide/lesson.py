"""Guided lessons: steps whose goals are checked, and their texts, matched by the id of the step."""

from __future__ import annotations

import re
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

from helicoide import content
from helicoide.files import text_file
from helicoide.seat import Seat, SeatUpdate
from helicoide.state import State, Update
from helicoide.text import LANGUAGES, HelicoideError, Language, Text

StepGoal = Callable[[State, Seat], bool]
MOST_BYTES = 1_000_000


@dataclass(frozen=True)
class AtSeat:
    """A change of the seat in a solution, such as the choice of what is shown; it does not affect the arm."""

    update: SeatUpdate


@dataclass(frozen=True)
class Step:
    """One step of a lesson.

    setup: brings the scene to the start of the step; goal: whether the step is done; solution: changes of the state or
    the seat, each with the time that follows it, s; joints: indices, from 0, of the joints whose sliders the step
    shows. `helicoide check` and the tests verify that the solution reaches the goal.
    """

    id: str
    setup: Update
    goal: StepGoal
    solution: tuple[tuple[Update | AtSeat, float], ...]
    joints: tuple[int, ...] = ()


@dataclass(frozen=True)
class Prose:
    """The texts of a step, in Markdown and both languages."""

    title: Text
    body: Text
    hint: Text


@dataclass(frozen=True)
class Lesson:
    """A lesson about a robot, with its steps and their texts. robot: its name; prose: texts by step id."""

    id: str
    title: Text
    robot: str
    steps: tuple[Step, ...]
    prose: Mapping[str, Prose]


_SECTION = re.compile(
    r"^## (?P<id>[a-z][a-z0-9_]*): (?P<title>\S.*)\n\s*(?P<body>[^\s>](?:.|\n)*?)\n(?P<hint>(?:> *\S.*\n)+)$"
)
_NO_PYTHON = Text(en="it is no Python", pt_BR="isto não é Python")
_NO_PYTHON_AT = Text(en="line {line} is no Python", pt_BR="a linha {line} não é Python")
_IMPORT = Text(
    en="line {line} imports {name}, which cannot be loaded", pt_BR="a linha {line} importa {name}, que não carrega"
)
_REFUSED = Text(en="line {line}: {why}", pt_BR="linha {line}: {why}")
_STOPPED = Text(
    en="line {line} stops with {kind}; run the file with Python to see why",
    pt_BR="a linha {line} para com {kind}; execute o arquivo com o Python para ver por quê",
)
_FORM = Text(
    en="each step is '## id: title', its text and, at the end, its hint on lines that begin with '> '; not so: {got!r}",
    pt_BR="cada passo é '## id: título', o texto e, ao fim, a dica em linhas iniciadas por '> '; não é assim: {got!r}",
)
_STEPS = Text(
    en="it needs TITLE, a Text, and STEPS, a tuple of at least one Step",
    pt_BR="faltam TITLE, um Text, e STEPS, uma tupla com pelo menos um Step",
)
_ROBOT = Text(en="it needs ROBOT, one of: {robots}", pt_BR="falta ROBOT, um dentre: {robots}")
_ORDER = Text(
    en="lesson.py has the steps {steps}, this page has {page}",
    pt_BR="lesson.py tem os passos {steps}, esta página tem {page}",
)


@cache
def load_lesson(name: str) -> Lesson:
    """A lesson by the name of its folder. Raises HelicoideError if a file is invalid or if the files do not match."""
    folder = content.content_folder("lessons", name)
    title, robot, steps = _read_module(folder / "lesson.py", name)
    pages = {language: _read_page(folder / f"{language}.md", steps) for language in LANGUAGES}
    return Lesson(name, title, robot, steps, {step.id: _prose(pages, step.id) for step in steps})


def _broken(path: Path, reason: Text) -> HelicoideError:
    return HelicoideError(
        Text(
            en="{path} is not a valid lesson: {reason}. The lessons that come with Helicoide are examples.",
            pt_BR="{path} não é uma lição válida: {reason}. As lições que vêm com o Helicoide servem de exemplo.",
        ).format(path=path, reason=reason)
    )


def _read_module(path: Path, name: str) -> tuple[Text, str, tuple[Step, ...]]:
    """TITLE, ROBOT and STEPS of a lesson.py. Raises HelicoideError with the line if the file raises anything."""
    loader = SourceFileLoader(f"helicoide_lessons.{name}", str(path))
    module = ModuleType(loader.name)
    try:
        loader.exec_module(module)
    except (Exception, SystemExit) as error:
        raise _broken(path, stopped(path, error)) from error
    title, robot, steps = (getattr(module, name, None) for name in ("TITLE", "ROBOT", "STEPS"))
    if robot not in content.content_folders("robots"):
        raise _broken(path, _ROBOT.format(robots=", ".join(content.content_folders("robots"))))
    if not (isinstance(title, Text) and isinstance(steps, tuple) and steps and all(isinstance(s, Step) for s in steps)):
        raise _broken(path, _STEPS)
    return title, robot, steps


def stopped(path: Path, error: BaseException) -> Text:
    """The line of a user's Python file at which an error was raised, and the kind of error, in words."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    if not lines:
        line = error.lineno if isinstance(error, SyntaxError) else None
        return _NO_PYTHON if line is None else _NO_PYTHON_AT.format(line=line)
    if isinstance(error, ImportError):
        return _IMPORT.format(line=lines[-1], name=error.name)
    if isinstance(error, HelicoideError):
        return _REFUSED.format(line=lines[-1], why=error.text)
    return _STOPPED.format(line=lines[-1], kind=type(error).__name__)


def _read_page(path: Path, steps: tuple[Step, ...]) -> dict[str, re.Match[str]]:
    """The sections of one language's page by step id, in the order of the steps."""
    try:
        before, *sections = re.split(r"(?m)^(?=## )", text_file.read_text(path, MOST_BYTES))
    except HelicoideError as error:
        raise _broken(path, error.text) from error
    if before.strip():
        raise _broken(path, _FORM.format(got=before.strip().splitlines()[0]))
    found = [_section(path, section) for section in sections]
    ids = [step.id for step in steps]
    if [match["id"] for match in found] != ids or len(set(ids)) != len(ids):
        raise _broken(path, _ORDER.format(steps=", ".join(ids), page=", ".join(match["id"] for match in found)))
    return {match["id"]: match for match in found}


def _section(path: Path, section: str) -> re.Match[str]:
    match = _SECTION.match(section.strip() + "\n")
    if match is None:
        raise _broken(path, _FORM.format(got=section.splitlines()[0]))
    return match


def _prose(pages: Mapping[Language, Mapping[str, re.Match[str]]], step: str) -> Prose:
    def text(part: str) -> Text:
        return Text(en=pages["en"][step][part].strip(), pt_BR=pages["pt_BR"][step][part].strip())

    hint = text("hint")
    return Prose(text("title"), text("body"), Text(en=_unquoted(hint.en), pt_BR=_unquoted(hint.pt_BR)))


def _unquoted(hint: str) -> str:
    return re.sub(r"(?m)^> *", "", hint)


def entered(seat: Seat, name: str | None) -> Seat:
    """The seat at the first step of a lesson, or without a lesson for None."""
    return replace(seat, lesson=name, step=0, done=frozenset(), hint_open=False)


def progressed(lesson: Lesson, state: State, seat: Seat) -> Seat:
    """The seat with its current step marked as done if the arm is that of the lesson and the goal is met."""
    step = lesson.steps[seat.step]
    if state.robot.name != lesson.robot or step.id in seat.done or not step.goal(state, seat):
        return seat
    return replace(seat, done=seat.done | {step.id})
