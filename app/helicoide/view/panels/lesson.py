"""The tab of the lessons: the choice of one, and the course map while none is open. The lesson itself is docked."""

from __future__ import annotations

from functools import partial

from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.lesson import all_lessons, entered
from helicoide.text import Text
from helicoide.view.course_map import course_map
from helicoide.view.progress_rows import progress_rows
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Dropdown, HtmlRow, Row

TITLE = Text(en="Lesson", pt_BR="Lição")
ORDER = 0
ICON = Icon.SCHOOL

FREE = Text(en="Explore freely", pt_BR="Exploração livre")


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    lessons = all_lessons()
    return [
        Dropdown(
            TITLE,
            [("", FREE), *((lesson.id, lesson.title) for lesson in lessons)],
            lambda view: view.seat.lesson or "",
            lambda name: ForSeat(partial(entered, name=name or None)),
        ),
        HtmlRow(partial(course_map, lessons)),
        progress_rows(all_lessons),
    ]


def first_lesson() -> ForSeat:
    """The request that begins the first lesson, or leaves the seat as it is if there is none."""
    first = next(iter(all_lessons()), None)
    return ForSeat(lambda seat: seat if first is None else entered(seat, first.id))
