"""Lessons and the current robot: a lesson is judged on its own robot, and left when another robot is loaded."""

from __future__ import annotations

import logging
from collections.abc import Collection
from dataclasses import replace

from helicoide import lesson
from helicoide.lesson import StepWatch
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.view.open_step import open_step

log = logging.getLogger("helicoide")


def is_about(seat: Seat, robots: Collection[str]) -> bool:
    """Whether a seat has no lesson, or a lesson about one of these robots."""
    return seat.lesson is None or lesson.load_lesson(seat.lesson).robot in robots


def without_lesson(seat: Seat) -> Seat:
    """The seat without a lesson, and without what its step has shown."""
    opened = open_step(seat)
    return lesson.entered(seat if opened is None else lesson.without_step_shown(seat, opened.step), None)


def seated_at(robots: Collection[str], seat: Seat) -> Seat:
    """The seat for another robot: without selection, and without a lesson about a third robot.

    robots: names of the current robot and of the one that is being loaded.
    """
    return replace((seat if is_about(seat, robots) else without_lesson(seat)).inspecting(None), picked_points=None)


def judged(seat: Seat, state: State, watch: StepWatch, now: float) -> tuple[Seat, StepWatch]:
    """The seat with its step judged at a time, s of a clock. A lesson whose goal or diagnosis raises is left."""
    if seat.lesson is None:
        return seat, StepWatch()
    try:
        return lesson.judged_step(lesson.load_lesson(seat.lesson), state, seat, watch, now)
    except Exception:
        log.exception("the step of lesson %s could not be judged", seat.lesson)
        return without_lesson(seat), StepWatch()
