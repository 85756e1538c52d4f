"""One progress out of two: of two windows or two labs of one person, or of a file and what is there already."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TypeVar

from helicoide.seat import LessonProgress

Value = TypeVar("Value")
Progress = Mapping[str, LessonProgress]
"""The progress of a person in each lesson that they have begun, by its id."""
NO_PROGRESS: Progress = MappingProxyType({})


def merge_progress(stored: Progress, before: Progress, now: Progress) -> Progress:
    """The stored progress after somebody's changes: `before` is what they began with, `now` what they made of it.

    What was stored meanwhile by others stays. Where nothing was, the result is `now`, so that one can also go back or
    begin again. With an empty `before` nothing is lost of either.
    """
    left = before.keys() - now.keys()
    lessons = {name: lesson for name, lesson in stored.items() if name not in left}
    for name, mine in now.items():
        other, base = stored.get(name), before.get(name)
        if other is None or other == base:
            lessons[name] = mine
        elif mine != base:
            lessons[name] = _united(other, base or LessonProgress(name), mine)
    return lessons


def _united(other: LessonProgress, base: LessonProgress, mine: LessonProgress) -> LessonProgress:
    """The progress in a lesson that two have changed: all that is done, and the later step."""
    done = _united_set(other.done, base.done, mine.done)
    skipped = _united_set(other.skipped, base.skipped, mine.skipped)
    return LessonProgress(
        mine.lesson,
        max(other.step, mine.step),
        done,
        skipped - done,
        _united_table(other.answers, base.answers, mine.answers),
        _united_table(other.lines, base.lines, mine.lines),
        _united_set(other.mistakes, base.mistakes, mine.mistakes),
        other.finished or mine.finished,
    )


def _united_set(other: frozenset[Value], base: frozenset[Value], mine: frozenset[Value]) -> frozenset[Value]:
    """What one of them added is there; what one of them removed is not."""
    return (other - (base - mine)) | (mine - base)


def _united_table(
    other: Mapping[str, Value], base: Mapping[str, Value], mine: Mapping[str, Value]
) -> Mapping[str, Value]:
    """All entries of both. Of one that both have changed, the other's stays: it was stored first."""
    kept = {key: value for key, value in other.items() if key in mine or key not in base}
    changed = {key: value for key, value in mine.items() if key not in other or other[key] == base.get(key)}
    return kept | changed
