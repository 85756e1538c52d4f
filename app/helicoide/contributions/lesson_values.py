"""Faults of what a lesson computes: the values of its prose, and the right answers of its predictions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from helicoide.geometry.multivector import Multivector
from helicoide.lesson import Lesson, Step, placeholders, right_answer
from helicoide.lesson.predictions import checked_answer
from helicoide.lines import Accepted, LineExercise, check_line, line_faults
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import HelicoideError, Text

NO_VALUE = Text(
    en="the value {name} is no finite number, array or multivector",
    pt_BR="o valor {name} não é um número, uma matriz ou um multivetor finito",
)


NOT_ACCEPTED = Text(en="its own line {line} is not accepted", pt_BR="a própria linha {line} não é aceita")


def _line_faults(exercise: LineExercise) -> Iterator[Text]:
    """The faults of an exercise: each of its lines must be accepted as it is written there."""
    yield from line_faults(exercise)
    for line in exercise.lines():
        if not isinstance(check_line(line, line.expected), Accepted):
            yield NOT_ACCEPTED.format(line=line.expected)


def value_faults(lesson: Lesson, step: Step, state: State, seat: Seat) -> Iterator[Text]:
    """The faults of the values that the prose of a step names, and of its right answer, at one state."""
    prose = lesson.prose[step.id]
    texts = (prose.body, prose.question, *prose.options, prose.reveal, prose.task, prose.hint, *prose.hints.values())
    for name in sorted({name for text in texts for name in placeholders(text.en)}):
        read = lesson.values[name].read(state, seat)
        numbers = read.values if isinstance(read, Multivector) else read
        if not isinstance(numbers, float | int | np.number | np.ndarray) or not np.all(np.isfinite(numbers)):
            yield NO_VALUE.format(name=name)
    if step.line is not None:
        yield from _line_faults(step.line)
    if step.prediction is not None:
        try:
            checked_answer(step.prediction, right_answer(step.prediction, state, seat), len(prose.options))
        except HelicoideError as error:
            yield error.text
