"""The step of a lesson that a view shows, with its texts and what its reader has done."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.lesson import Lesson, Prose, Step, load_lesson
from helicoide.seat import CameraPreset, LessonProgress, PredictionAnswer, Seat
from helicoide.view.window_view import View


@dataclass(frozen=True)
class OpenStep:
    """A step, its number from 0, its texts, and its reader's progress in the lesson."""

    lesson: Lesson
    number: int
    step: Step
    prose: Prose
    progress: LessonProgress

    @property
    def is_done(self) -> bool:
        """Whether the step is done."""
        return self.step.id in self.progress.done

    @property
    def answer(self) -> PredictionAnswer | None:
        """The answer to the prediction of the step; None before it is given."""
        return self.progress.answers.get(self.step.id)

    @property
    def accepted_lines(self) -> tuple[str, ...]:
        """The lines of its exercise that are accepted so far."""
        return self.progress.lines.get(self.step.id, ())


def lesson_of(seat: Seat) -> Lesson | None:
    """The open lesson of a seat."""
    return None if seat.lesson is None else load_lesson(seat.lesson)


def open_step(seat: Seat) -> OpenStep | None:
    """The open step of a seat; None without a lesson, and at the summary after its last step."""
    lesson, progress = lesson_of(seat), seat.lesson_progress
    step = None if lesson is None or progress is None else lesson.open_step(progress)
    if lesson is None or progress is None or step is None:
        return None
    return OpenStep(lesson, progress.step, step, lesson.prose[step.id], progress)


def step_camera(view: View) -> CameraPreset | None:
    """Where the open step puts the camera, if its arm is shown; None if it leaves the camera where it is."""
    opened = open_step(view.seat)
    return None if opened is None or opened.lesson.robot != view.state.robot.name else opened.step.shown.camera
