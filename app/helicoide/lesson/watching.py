"""Watch a step: is its goal met, for as long as it must be, and which typical mistake is made."""

from __future__ import annotations

from dataclasses import dataclass, replace

from helicoide.lesson.lesson import Lesson
from helicoide.lesson.progress import progressed, revealed, with_mistake
from helicoide.lesson.step import Step
from helicoide.seat import LessonProgress, Seat
from helicoide.state import State

MISTAKEN_FOR = 1.0  # s that a mistake lasts before it is explained


@dataclass(frozen=True)
class StepWatch:
    """Since when a goal is met, and since when which mistake is made; s of a clock, None while it is not so."""

    met_since: float | None = None
    mistake: str | None = None
    mistake_since: float = 0.0

    @property
    def is_waiting(self) -> bool:
        """Whether time alone may change the seat."""
        return self.met_since is not None or self.mistake is not None


def judged_step(lesson: Lesson, state: State, seat: Seat, watch: StepWatch, now: float) -> tuple[Seat, StepWatch]:
    """The seat with its open step judged at a time, s, and the watch until the next time.

    Nothing is judged on another robot than that of the lesson. A mistake is not explained during a drag.
    """
    progress = seat.lesson_progress
    step = None if progress is None else lesson.open_step(progress)
    if progress is None or step is None or state.robot.name != lesson.robot:
        return seat, StepWatch()
    if step.id not in progress.done:
        is_met = is_goal_met(step, state, seat)
        since = None if not is_met else now if watch.met_since is None else watch.met_since
        watch = StepWatch(since, watch.mistake, watch.mistake_since)
        if since is not None and now - since >= step.held_for:
            seat, watch = progressed(step, seat), StepWatch()
    seat = revealed(lesson, state, seat)
    return _diagnosed(step, state, seat, watch, now)


def is_goal_met(step: Step, state: State, seat: Seat) -> bool:
    """Whether the goal of a step is met now and its lines are accepted; without both, whether it is answered."""
    progress = seat.lesson_progress or LessonProgress("")
    if step.line is not None and len(progress.lines.get(step.id, ())) < len(step.line.lines()):
        return False
    if step.goal is not None:
        return bool(step.goal(state, seat))
    return step.line is not None or (step.by_answer and step.id in progress.answers)


def mistake_made(step: Step, state: State, seat: Seat) -> str | None:
    """The id of the first diagnosis that applies; None without a mistake."""
    return next((diagnosis.id for diagnosis in step.diagnoses if diagnosis.when(state, seat)), None)


def _diagnosed(step: Step, state: State, seat: Seat, watch: StepWatch, now: float) -> tuple[Seat, StepWatch]:
    """The seat with the mistake explained that is made for long enough; without an explanation if none is made."""
    if state.request.drag is not None:
        return seat, StepWatch(watch.met_since)
    progress = seat.lesson_progress
    is_done = progress is not None and step.id in progress.done
    made = None if is_done else mistake_made(step, state, seat)
    since = watch.mistake_since if made == watch.mistake else now
    if made is None:
        seat = seat if seat.mistake is None else replace(seat, mistake=None)
    elif now - since >= MISTAKEN_FOR:
        seat = with_mistake(step, seat, made)
    return seat, StepWatch(watch.met_since, made, since)
