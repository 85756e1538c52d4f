"""A step is done when its goal has held, and a mistake is explained when it lasts, never during a drag."""

from __future__ import annotations

from dataclasses import replace

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.lesson import Lesson, StepWatch
from helicoide.lesson.watching import MISTAKEN_FOR
from helicoide.seat import Seat
from helicoide.state import Drag, State, initial_state


def done(seat: Seat) -> frozenset[str]:
    assert seat.lesson_progress is not None
    return seat.lesson_progress.done


def test_a_met_goal_stays_done(tour: Lesson, seat: Seat, start: State) -> None:
    same, watch = lesson.judged_step(tour, start, seat, StepWatch(), 0.0)
    assert same is seat
    seat, watch = lesson.judged_step(tour, replace(start, t=1.0), seat, watch, 0.1)
    assert done(seat) == {"choice"}
    again, _ = lesson.judged_step(tour, start, seat, watch, 0.2)
    assert again is seat


def test_a_goal_has_to_hold(tour: Lesson, seat: Seat, start: State) -> None:
    seat, late = lesson.turned_to(tour, seat, 1), replace(start, t=1.0)
    seat, watch = lesson.judged_step(tour, late, seat, StepWatch(), 10.0)
    assert watch.is_waiting
    seat, watch = lesson.judged_step(tour, late, seat, watch, 11.9)
    seat, watch = lesson.judged_step(tour, start, seat, watch, 12.1)
    seat, watch = lesson.judged_step(tour, late, seat, watch, 12.2)
    seat, watch = lesson.judged_step(tour, late, seat, watch, 14.1)
    assert done(seat) == set()
    seat, watch = lesson.judged_step(tour, late, seat, watch, 14.2)
    assert done(seat) == {"estimate"}
    assert not watch.is_waiting


def test_a_step_without_a_goal_is_done_by_its_answer_or_its_reader(tour: Lesson, seat: Seat, start: State) -> None:
    order = lesson.turned_to(tour, seat, 2)
    assert lesson.judged_step(tour, start, order, StepWatch(), 0.0)[0] is order
    order, _ = lesson.judged_step(tour, start, lesson.answered(tour, order, (0.0, 1.0, 2.0)), StepWatch(), 0.0)
    assert done(order) == {"order"}
    own = lesson.turned_to(tour, seat, 5)
    assert lesson.judged_step(tour, start, own, StepWatch(), 0.0)[0] is own
    assert tour.steps[5].by_reader


def test_a_mistake_that_lasts_is_explained_and_kept_for_the_summary(tour: Lesson, seat: Seat, start: State) -> None:
    seat, late = lesson.turned_to(tour, seat, 4), replace(start, t=2.0)
    seat, watch = lesson.judged_step(tour, late, seat, StepWatch(), 0.0)
    assert (seat.mistake, watch.is_waiting) == (None, True)
    seat, watch = lesson.judged_step(tour, late, seat, watch, MISTAKEN_FOR)
    assert seat.mistake == "slip"
    seat, watch = lesson.judged_step(tour, start, seat, watch, 2.0)
    assert seat.mistake is None
    assert seat.lesson_progress is not None
    assert seat.lesson_progress.mistakes == {("mistake", "slip")}


def test_nothing_is_explained_during_a_drag_or_once_it_is_done(tour: Lesson, seat: Seat, start: State) -> None:
    seat, late = lesson.turned_to(tour, seat, 4), replace(start, t=2.0)
    dragged = replace(late, request=replace(late.request, drag=Drag("hand", "target")))
    watch = StepWatch()
    for second in range(4):
        seat, watch = lesson.judged_step(tour, dragged, seat, watch, second)
    assert seat.mistake is None
    for second in range(4, 8):
        seat, watch = lesson.judged_step(tour, replace(start, t=9.0), seat, watch, second)
    assert (done(seat), seat.mistake) == ({"mistake"}, None)


def test_another_robot_is_not_judged(tour: Lesson, seat: Seat) -> None:
    other = replace(initial_state(load_robot("planar2r")), t=5.0)
    assert lesson.judged_step(tour, other, seat, StepWatch(1.0), 9.0) == (seat, StepWatch())
