"""What a person does in a lesson: answers, steps, skips, leaves, begins again; nothing is done twice or undone."""

from __future__ import annotations

from dataclasses import replace

import pytest

from helicoide import lesson
from helicoide.lesson import Lesson, LessonProgress, StepWatch
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import HelicoideError


def now(seat: Seat) -> LessonProgress:
    assert seat.lesson_progress is not None
    return seat.lesson_progress


def test_a_lesson_is_taken_up_where_it_was_left(tour: Lesson, seat: Seat) -> None:
    seat = lesson.turned_to(tour, seat, 2)
    outside = lesson.entered(seat, None)
    assert outside.lesson_progress is None
    assert now(lesson.entered(outside, tour.id)).step == 2
    assert now(lesson.restarted(seat)) == LessonProgress(tour.id)


def test_a_skipped_step_is_marked_until_it_is_done(tour: Lesson, seat: Seat) -> None:
    seat = lesson.skipped(tour, seat)
    assert (now(seat).step, now(seat).skipped, now(seat).done) == (1, {"choice"}, set())
    seat = lesson.progressed(tour.steps[0], lesson.turned_to(tour, seat, 0))
    assert (now(seat).skipped, now(seat).done) == (set(), {"choice"})
    assert now(lesson.skipped(tour, seat)).skipped == set()


def test_the_last_step_leads_to_the_summary(tour: Lesson, seat: Seat) -> None:
    seat = lesson.turned_to(tour, seat, 99)
    assert (now(seat).step, now(seat).finished) == (len(tour.steps), True)
    assert tour.open_step(now(seat)) is None
    assert lesson.skipped(tour, seat) is seat
    assert now(lesson.turned_to(tour, seat, -3)).step == 0
    assert now(lesson.turned_to(tour, seat, 1)).finished


def test_what_belongs_to_a_step_stays_there(tour: Lesson, seat: Seat) -> None:
    seat = replace(seat, hint_open=True, mistake="slip", draft=(1.0,))
    for after in (lesson.turned_to(tour, seat, 1), lesson.entered(seat, None), lesson.restarted(seat)):
        assert (after.hint_open, after.mistake, after.draft) == (False, None, None)


def test_an_answer_is_recorded_once(tour: Lesson, seat: Seat, start: State) -> None:
    seat = lesson.answered(tour, seat, (0.0,))
    assert lesson.answered(tour, seat, (1.0,)) is seat
    assert now(seat).answers["choice"].right is None
    seat = lesson.revealed(tour, start, seat)
    assert now(seat).answers["choice"].right is False
    assert lesson.revealed(tour, start, seat) is seat


@pytest.mark.parametrize(
    ("step", "given"),
    [
        (0, (3.0,)),
        (0, (-1.0,)),
        (0, (0.5,)),
        (0, ()),
        (1, (float("nan"),)),
        (1, (1e300,)),
        (2, (0.0, 1.0)),
        (2, (0.0, 1.0, 1.0)),
        (3, (0.0, 0.0)),
        (3, (0.0, 0.0, float("inf"))),
    ],
)
def test_an_answer_of_another_form_is_refused(tour: Lesson, seat: Seat, step: int, given: tuple[float, ...]) -> None:
    with pytest.raises(HelicoideError, match="The answer has to be"):
        lesson.answered(tour, lesson.turned_to(tour, seat, step), given)


@pytest.mark.parametrize(
    ("step", "given", "right"),
    [
        (0, (1.0,), True),
        (1, (504.0,), True),
        (1, (506.0,), False),
        (2, (2.0, 0.0, 1.0), True),
        (2, (0.0, 1.0, 2.0), False),
    ],
)
def test_a_prediction_is_judged(
    tour: Lesson, seat: Seat, start: State, step: int, given: tuple[float, ...], right: bool
) -> None:
    seat = lesson.answered(tour, lesson.turned_to(tour, seat, step), given)
    assert now(lesson.revealed(tour, start, seat)).answers[tour.steps[step].id].right is right


def test_what_is_right_may_wait_for_the_goal(tour: Lesson, seat: Seat, start: State) -> None:
    place = tuple(start.T_world_tool[:3, 3] + [0.0, 0.0, 0.02])
    seat = lesson.answered(tour, lesson.turned_to(tour, seat, 3), place)
    assert lesson.revealed(tour, start, seat) is seat
    done, _ = lesson.judged_step(tour, replace(start, t=2.0), seat, StepWatch(), 0.0)
    assert now(done).done == {"mark"}
    assert now(done).answers["mark"].right is True


def test_a_seat_without_a_lesson_changes_nothing(tour: Lesson, start: State) -> None:
    seat = Seat(token="", language="en")
    assert lesson.skipped(tour, seat) is seat
    assert lesson.answered(tour, seat, (0.0,)) is seat
    assert lesson.revealed(tour, start, seat) is seat
    assert lesson.progressed(tour.steps[0], seat) is seat
    assert lesson.restarted(seat) is seat
