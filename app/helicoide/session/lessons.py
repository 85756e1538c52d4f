"""Lessons in front of an arm: each is judged on its own arm, and left when another one comes."""

from __future__ import annotations

import logging
from collections.abc import Collection
from dataclasses import replace

from helicoide import lesson
from helicoide.seat import Seat
from helicoide.state import State

log = logging.getLogger("helicoide")


def is_about(seat: Seat, robots: Collection[str]) -> bool:
    """Whether a seat is in no lesson, or in one about one of these robots."""
    return seat.lesson is None or lesson.load_lesson(seat.lesson).robot in robots


def seated_at(robots: Collection[str], seat: Seat) -> Seat:
    """The seat in front of another robot: nothing selected or done, and in a lesson only where that is about it.

    robots: the one that stands there, and the one that is on its way.
    """
    seat = replace(seat, done=frozenset()) if is_about(seat, robots) else lesson.entered(seat, None)
    return replace(seat, selected=None, picked_points=None)


def judged(seat: Seat, state: State) -> Seat:
    """The seat with its step done where the goal is met; a lesson whose goal fails is left."""
    if seat.lesson is None:
        return seat
    try:
        return lesson.progressed(lesson.load_lesson(seat.lesson), state, seat)
    except Exception:
        log.exception("the goal of lesson %s failed", seat.lesson)
        return lesson.entered(seat, None)
