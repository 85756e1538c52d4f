"""The progress in one lesson as it is written down: in a row of the database, and in a file."""

from __future__ import annotations

from typing import Any

import msgspec

from helicoide.files.toml import table_to_struct
from helicoide.seat import LessonProgress, PredictionAnswer


class AnswerRecord(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """An answer to a prediction."""

    given: tuple[int | float, ...]
    right: bool | None


class LessonRecord(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The progress in one lesson, without the id of the lesson."""

    step: int
    finished: bool
    done: tuple[str, ...]
    skipped: tuple[str, ...]
    answers: dict[str, AnswerRecord]
    lines: dict[str, tuple[str, ...]]
    mistakes: tuple[tuple[str, str], ...]


def lesson_to_record(progress: LessonProgress) -> dict[str, Any]:
    """The progress in a lesson as numbers, words, lists and tables, always in the same order."""
    return {
        "step": progress.step,
        "finished": progress.finished,
        "done": sorted(progress.done),
        "skipped": sorted(progress.skipped),
        "answers": {
            step: {"given": list(answer.given), "right": answer.right}
            for step, answer in sorted(progress.answers.items())
        },
        "lines": {step: list(lines) for step, lines in sorted(progress.lines.items())},
        "mistakes": sorted(map(list, progress.mistakes)),
    }


def record_to_lesson(lesson: str, record: LessonRecord) -> LessonProgress:
    """The progress in a lesson that was written down."""
    return LessonProgress(
        lesson,
        record.step,
        frozenset(record.done),
        frozenset(record.skipped),
        {step: PredictionAnswer(answer.given, answer.right) for step, answer in record.answers.items()},
        record.lines,
        frozenset(record.mistakes),
        record.finished,
    )


def read_lesson_record(lesson: str, found: object) -> LessonProgress:
    """The progress in a lesson from what a database gives. Raises HelicoideError if something is missing or added."""
    return record_to_lesson(lesson, table_to_struct(found, LessonRecord))
