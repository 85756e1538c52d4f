"""The file with which a person takes their progress home or to another lab: JSON, read as a whole or refused."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping, Sequence

import msgspec

from helicoide.files import text_file
from helicoide.files.json_text import parse_json
from helicoide.files.toml import table_to_struct
from helicoide.store.merging import Progress
from helicoide.store.records import LessonRecord, lesson_to_record, record_to_lesson
from helicoide.text import HelicoideError, Text

FORMAT = "helicoide progress 1"
NAME, MOST_BYTES, LONGEST_LINE = "helicoide-progress.json", 500_000, 1000
NO_PROGRESS_FILE = Text(
    en="This is not a file of progress that can be read, and nothing of it was taken: {reason}.",
    pt_BR="Este não é um arquivo de progresso que se possa ler, e nada dele foi usado: {reason}.",
)
NO_FORMAT = Text(
    en="it needs a table with format, {format!r}, and lessons",
    pt_BR="é preciso uma tabela com format, {format!r}, e lessons",
)
NO_LESSON = Text(
    en="this lab has no lesson {lesson!r}; it has: {known}",
    pt_BR="este laboratório não tem a lição {lesson!r}; tem: {known}",
)
NO_STEP = Text(
    en="the lesson {lesson} has no step {step!r}; it has: {known}",
    pt_BR="a lição {lesson} não tem o passo {step!r}; tem: {known}",
)
NO_INDEX = Text(
    en="step of {lesson} must be 0 to {last}, not {step}", pt_BR="step de {lesson} deve ser de 0 a {last}, não {step}"
)
TWICE = Text(
    en="the step {step} of {lesson} appears twice in done and skipped",
    pt_BR="o passo {step} de {lesson} aparece duas vezes em done e skipped",
)
BAD_LINE = Text(
    en="a line or a mistake in the step {step} of {lesson} is empty, too long, or cannot be shown",
    pt_BR="uma linha ou um engano no passo {step} de {lesson} está em branco, é longo demais ou não dá para mostrar",
)


class ProgressFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file: the progress in lessons by their ids."""

    format: str
    lessons: dict[str, LessonRecord]


def encode_progress(progress: Progress) -> bytes:
    """The file of a person's progress. It does not say whose it is."""
    lessons = {name: lesson_to_record(lesson) for name, lesson in sorted(progress.items())}
    return (json.dumps({"format": FORMAT, "lessons": lessons}, ensure_ascii=False, indent=1) + "\n").encode()


def decode_progress(content: bytes, steps: Mapping[str, Sequence[str]]) -> Progress:
    """The progress in a file. steps: the ids of the steps of each lesson there is, by the id of the lesson.

    Raises HelicoideError, which says what is wrong and what would be valid, if any part of the file is.
    """
    try:
        table = parse_json(text_file.decode_utf8(content, MOST_BYTES))
        if not isinstance(table, dict) or table.get("format") != FORMAT:
            raise HelicoideError(NO_FORMAT.format(format=FORMAT))
        lessons = table_to_struct(table, ProgressFile).lessons
        for lesson, record in lessons.items():
            if lesson not in steps:
                raise HelicoideError(NO_LESSON.format(lesson=lesson, known=", ".join(steps)))
            for fault in _faults(lesson, record, steps[lesson]):
                raise HelicoideError(fault)
    except HelicoideError as error:
        raise HelicoideError(NO_PROGRESS_FILE.format(reason=error.text)) from error
    return {lesson: record_to_lesson(lesson, record) for lesson, record in lessons.items()}


def _faults(lesson: str, record: LessonRecord, steps: Collection[str]) -> Iterator[Text]:
    """What cannot be true of a lesson with these steps."""
    if not 0 <= record.step <= len(steps):  # the last number is that of the summary
        yield NO_INDEX.format(lesson=lesson, last=len(steps), step=record.step)
    mistaken = (step for step, _ in record.mistakes)
    for step in (*record.done, *record.skipped, *record.answers, *record.lines, *mistaken):
        if step not in steps:
            yield NO_STEP.format(lesson=lesson, step=step, known=", ".join(steps))
    marks = [*record.done, *record.skipped]
    for step in marks:
        if marks.count(step) > 1:
            yield TWICE.format(lesson=lesson, step=step)
    for step, lines in record.lines.items():
        if not all(map(_can_be_shown, lines)):
            yield BAD_LINE.format(lesson=lesson, step=step)
    for step, mistake in record.mistakes:
        if not _can_be_shown(mistake):
            yield BAD_LINE.format(lesson=lesson, step=step)


def _can_be_shown(line: str) -> bool:
    return 0 < len(line) <= LONGEST_LINE and line.isprintable()
