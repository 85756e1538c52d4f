"""Changes of a person's progress: pure functions of the seat. The open lesson is `seat.lesson`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from types import MappingProxyType

from helicoide.lesson.lesson import Lesson
from helicoide.lesson.predictions import checked_answer, is_right
from helicoide.lesson.step import Step
from helicoide.seat import LessonProgress, PredictionAnswer, Seat
from helicoide.state import State


def entered(seat: Seat, name: str | None) -> Seat:
    """The seat in a lesson, where the person left it or at its first step; without a lesson for None."""
    seat = _at_another_step(replace(seat, lesson=name))
    if name is None or name in seat.progress:
        return seat
    return with_lesson_progress(seat, LessonProgress(name))


def restarted(seat: Seat) -> Seat:
    """The seat at the first step of the open lesson, with all progress in it cleared."""
    if seat.lesson is None:
        return seat
    return with_lesson_progress(_at_another_step(seat), LessonProgress(seat.lesson))


def turned_to(lesson: Lesson, seat: Seat, step: int) -> Seat:
    """The seat at a step of the open lesson, by its number; the number after the last step is the summary."""
    step, now = min(max(step, 0), len(lesson.steps)), seat.lesson_progress
    if now is None or step == now.step:
        return seat
    is_last = step == len(lesson.steps)
    return with_lesson_progress(_at_another_step(seat), replace(now, step=step, finished=now.finished or is_last))


def skipped(lesson: Lesson, seat: Seat) -> Seat:
    """The seat at the next step, with the current one marked as skipped unless it is done."""
    now = seat.lesson_progress
    if now is None or (step := lesson.open_step(now)) is None:
        return seat
    if step.id not in now.done:
        seat = with_lesson_progress(seat, replace(now, skipped=now.skipped | {step.id}))
    return turned_to(lesson, seat, now.step + 1)


def answered(lesson: Lesson, seat: Seat, given: Sequence[float]) -> Seat:
    """The seat with an answer to the prediction of the current step. The first answer is never changed.

    Raises HelicoideError if the answer is not of the form that is asked.
    """
    now = seat.lesson_progress
    step = None if now is None else lesson.open_step(now)
    if now is None or step is None or step.prediction is None or step.id in now.answers:
        return seat
    answer = PredictionAnswer(checked_answer(step.prediction, given, len(lesson.prose[step.id].options)))
    return with_lesson_progress(seat, replace(now, answers=MappingProxyType({**now.answers, step.id: answer})))


def revealed(lesson: Lesson, state: State, seat: Seat) -> Seat:
    """The seat with the answer of the current step judged, if it is time to reveal what is right."""
    now = seat.lesson_progress
    step = None if now is None else lesson.open_step(now)
    if now is None or step is None or step.prediction is None:
        return seat
    answer = now.answers.get(step.id)
    is_time = step.prediction.reveal == "now" or step.by_answer or step.id in now.done
    if answer is None or answer.right is not None or not is_time:
        return seat
    judged = replace(answer, right=is_right(step.prediction, answer.given, state, seat))
    return with_lesson_progress(seat, replace(now, answers=MappingProxyType({**now.answers, step.id: judged})))


def progressed(step: Step, seat: Seat) -> Seat:
    """The seat with a step of the open lesson marked as done, and no longer as skipped."""
    now = seat.lesson_progress
    if now is None or step.id in now.done:
        return seat
    return with_lesson_progress(seat, replace(now, done=now.done | {step.id}, skipped=now.skipped - {step.id}))


def with_accepted_line(lesson: Lesson, seat: Seat, text: str) -> Seat:
    """The seat with one more accepted line of the exercise of the current step."""
    now = seat.lesson_progress
    step = None if now is None else lesson.open_step(now)
    if now is None or step is None or step.line is None:
        return seat
    accepted = now.lines.get(step.id, ())
    if len(accepted) >= len(step.line.lines()):
        return seat
    return with_lesson_progress(seat, replace(now, lines=MappingProxyType({**now.lines, step.id: (*accepted, text)})))


def with_mistake(step: Step, seat: Seat, diagnosis: str) -> Seat:
    """The seat with the hint of a mistake shown. The mistake is kept for the summary."""
    now = seat.lesson_progress
    if now is None or seat.mistake == diagnosis:
        return seat
    return with_lesson_progress(
        replace(seat, mistake=diagnosis), replace(now, mistakes=now.mistakes | {(step.id, diagnosis)})
    )


def with_lesson_progress(seat: Seat, progress: LessonProgress) -> Seat:
    """The seat with other progress in one lesson."""
    return replace(seat, progress=MappingProxyType({**seat.progress, progress.lesson: progress}))


def _at_another_step(seat: Seat) -> Seat:
    """The seat without what belongs to the step that it leaves."""
    return replace(seat, hint_open=False, mistake=None, draft=None)
