"""The course: which lesson builds on which, in what order they are listed, and which to take next."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from helicoide.lesson.lesson import Lesson
from helicoide.seat import LessonProgress


def in_course_order(lessons: Collection[Lesson]) -> tuple[Lesson, ...]:
    """The lessons by level, those of a level by title."""
    levels = course_levels(lessons)
    return tuple(sorted(lessons, key=lambda lesson: (levels[lesson.id], lesson.title.en)))


def course_levels(lessons: Collection[Lesson]) -> dict[str, int]:
    """The level of each lesson: 0 if it builds on none, else one more than the highest of those it builds on.

    A need that no lesson has does not count. The levels of lessons in a circle mean nothing, but are finite.
    """
    levels = {lesson.id: 0 for lesson in lessons}
    for _ in lessons:
        for lesson in lessons:
            levels[lesson.id] = max((levels[need] + 1 for need in lesson.needs if need in levels), default=0)
    return levels


def circle_of_needs(lessons: Collection[Lesson]) -> tuple[str, ...]:
    """The ids of lessons that build on one another in a circle, and of those that build on these; empty without any.

    In a circle each round of `course_levels` raises the levels, so that they become higher than any chain can be.
    """
    return tuple(name for name, level in course_levels(lessons).items() if level >= len(lessons))


def next_lessons(lessons: Sequence[Lesson], progress: Mapping[str, LessonProgress]) -> tuple[Lesson, ...]:
    """The lessons that are recommended: not finished, with all that they build on finished."""
    finished = {name for name, each in progress.items() if each.finished}
    known = {lesson.id for lesson in lessons}
    return tuple(lesson for lesson in lessons if lesson.id not in finished and set(lesson.needs) & known <= finished)
