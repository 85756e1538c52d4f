"""Whether stored answers still have the form that the predictions of their lessons ask for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from helicoide.lesson import Lesson
from helicoide.lesson.predictions import Prediction, checked_answer
from helicoide.seat import PredictionAnswer
from helicoide.store.merging import Progress
from helicoide.text import HelicoideError


def bad_answers(progress: Progress, lessons: Iterable[Lesson]) -> frozenset[tuple[str, str]]:
    """Lesson and step of each answer to these lessons that is not of the form that is asked for."""
    return frozenset(
        (lesson.id, step.id)
        for lesson in lessons
        for step in lesson.steps
        if lesson.id in progress and (answer := progress[lesson.id].answers.get(step.id)) is not None
        if not _fits(step.prediction, answer, len(lesson.prose[step.id].options))
    )


def without_bad_answers(progress: Progress, lessons: Iterable[Lesson]) -> Progress:
    """The progress without answers to predictions that have changed since they were given."""
    bad = bad_answers(progress, lessons)
    return {
        name: replace(each, answers={step: answer for step, answer in each.answers.items() if (name, step) not in bad})
        for name, each in progress.items()
    }


def _fits(prediction: Prediction | None, answer: PredictionAnswer, options: int) -> bool:
    if prediction is None:
        return False
    try:
        checked_answer(prediction, answer.given, options)
    except HelicoideError:
        return False
    return True
