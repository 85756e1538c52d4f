"""List the lessons: id, title, robot, steps, and what each builds on."""

from __future__ import annotations

import json as json_format
import logging
from pathlib import Path
from typing import Annotated, Literal

import tyro

from helicoide import content
from helicoide.commands import language
from helicoide.lesson import Lesson, all_lessons
from helicoide.text import Text

LINE = Text(en="{id}: {title}; robot {robot}; {n} steps", pt_BR="{id}: {title}; robô {robot}; {n} passos")
BUILDS = Text(en="   builds on {needs}", pt_BR="   parte de {needs}")


def run(
    what: Annotated[tyro.conf.Positional[Literal["list"]], tyro.conf.arg(help="list: all lessons")] = "list",
    lessons: Path | None = None,
    json: bool = False,
) -> None:
    """List the lessons in the order of the course: id, title, robot, number of steps, and what each builds on.

    Args:
        what: what to do.
        lessons: a folder with further lessons.
        json: print JSON.
    """
    logging.basicConfig(format="helicoide: %(message)s")  # names a lesson that cannot be read
    if lessons is not None:
        content.add_lessons(lessons)
    found = all_lessons()
    if json:
        print(json_format.dumps([lesson_json(lesson) for lesson in found], indent=1, ensure_ascii=False))
        return
    spoken = language()
    for lesson in found:
        print(LINE.format(id=lesson.id, title=lesson.title, robot=lesson.robot, n=len(lesson.steps))[spoken])
        if lesson.needs:
            print(BUILDS.format(needs=", ".join(lesson.needs))[spoken])


def lesson_json(lesson: Lesson) -> dict[str, object]:
    """A lesson as JSON."""
    return {
        "id": lesson.id,
        "title": {"en": lesson.title.en, "pt_BR": lesson.title.pt_BR},
        "robot": lesson.robot,
        "steps": [step.id for step in lesson.steps],
        "needs": list(lesson.needs),
        "sources": list(lesson.sources),
    }
