"""The course: order by what builds on what, circles, and what is next."""

from __future__ import annotations

from helicoide import lesson
from helicoide.lesson import Lesson, LessonProgress
from helicoide.text import untranslated


def named(name: str, *needs: str) -> Lesson:
    return Lesson(name, untranslated(name), "movemaster", (), {}, needs=needs)


A, B, C, D = named("a"), named("b", "a"), named("c", "b", "nowhere"), named("d")


def test_a_lesson_comes_after_those_it_builds_on() -> None:
    assert [each.id for each in lesson.in_course_order([C, B, D, A])] == ["a", "d", "b", "c"]
    assert lesson.course_levels([C, B, D, A]) == {"a": 0, "b": 1, "c": 2, "d": 0}


def test_a_circle_is_found_and_does_no_harm() -> None:
    round_one, other = named("x", "y"), named("y", "x")
    assert set(lesson.circle_of_needs([round_one, other, A])) == {"x", "y"}
    assert lesson.circle_of_needs([A, B, C, D]) == ()
    assert len(lesson.in_course_order([round_one, other, A])) == 3


def test_next_is_what_is_not_finished_and_builds_on_what_is() -> None:
    order = lesson.in_course_order([A, B, C, D])
    assert [each.id for each in lesson.next_lessons(order, {})] == ["a", "d"]
    begun = {"a": LessonProgress("a", finished=True), "d": LessonProgress("d", step=2)}
    assert [each.id for each in lesson.next_lessons(order, begun)] == ["d", "b"]
