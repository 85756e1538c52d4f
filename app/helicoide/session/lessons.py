"""Lessons and the current robot: a lesson is checked on its own robot, and left when another robot is loaded."""

from __future__ import annotations

import logging
from collections.abc import Collection
from dataclasses import replace

from helicoide import lesson
from helicoide.seat import Seat
from helicoide.state import State

log = logging.getLogger("helicoide")


def is_about(seat: Seat, robots: Collection[str]) -> bool:
    """Whether a seat has no lesson, or a lesson about one of these robots."""
    return seat.lesson is None or lesson.load_lesson(seat.lesson).robot in robots


def seated_at(robots: Collection[str], seat: Seat) -> Seat:
    """The seat for another robot: without selection and progress, and without a lesson about a third robot.

    robots: names of the current robot and of the one that is being loaded.
    """
    seat = replace(seat, done=frozenset()) if is_about(seat, robots) else lesson.entered(seat, None)
    return replace(seat.inspecting(None), picked_points=None)


def judged(seat: Seat, state: State) -> Seat:
    """The seat with its step marked as done if the goal is met. A lesson whose goal raises is left."""
    if seat.lesson is None:
        return seat
    try:
        return lesson.progressed(lesson.load_lesson(seat.lesson), state, seat)
    except Exception:
        log.exception("the goal of lesson %s failed", seat.lesson)
        return lesson.entered(seat, None)
