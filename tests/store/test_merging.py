"""What two have made of one progress is united: nothing of either is lost, and what one takes back is taken back."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from tests.store.samples import PROGRESS, STEPS, progresses

from helicoide.seat import LessonProgress, PredictionAnswer
from helicoide.store.known import known_progress
from helicoide.store.merging import NO_PROGRESS, Progress, merge_progress

SCREWS = PROGRESS["screws"]


def of(lesson: LessonProgress) -> Progress:
    return {lesson.lesson: lesson}


@given(progresses(), progresses())
def test_without_others_the_result_is_what_is_now(before: Progress, now: Progress) -> None:
    assert merge_progress(before, before, now) == now


@given(progresses(), progresses())
def test_who_changed_nothing_changes_nothing(stored: Progress, before: Progress) -> None:
    assert merge_progress(stored, before, before) == {**before, **stored}


@given(progresses(), progresses())
def test_nothing_of_two_is_lost_that_began_with_nothing(one: Progress, two: Progress) -> None:
    both = merge_progress(one, NO_PROGRESS, two)
    for progress in (one, two):
        for name, lesson in progress.items():
            assert lesson.done <= both[name].done
            assert lesson.skipped <= both[name].done | both[name].skipped
            assert lesson.answers.keys() <= both[name].answers.keys()
            assert lesson.step <= both[name].step
            assert lesson.mistakes <= both[name].mistakes
            assert lesson.finished <= both[name].finished
            assert not both[name].done & both[name].skipped
    for name in one:
        assert {**both[name].answers, **one[name].answers} == both[name].answers, "an answer is recorded once"


@given(progresses(), progresses(), progresses())
def test_saving_twice_is_saving_once(stored: Progress, before: Progress, now: Progress) -> None:
    """As when the answer of the first one was lost."""
    once = merge_progress(stored, before, now)
    assert merge_progress(once, before, now) == once


@given(progresses(), progresses(), progresses())
def test_the_order_of_two_does_not_matter_for_what_is_done(before: Progress, one: Progress, two: Progress) -> None:
    there = merge_progress(merge_progress(before, before, one), before, two)
    here = merge_progress(merge_progress(before, before, two), before, one)
    for name in one.keys() & two.keys():
        if before.get(name) not in (one[name], two[name]):
            assert (there[name].done, there[name].step) == (here[name].done, here[name].step)


def test_two_windows_unite() -> None:
    one = replace(SCREWS, step=3, done=SCREWS.done | {"moves"})
    two = replace(SCREWS, done=SCREWS.done | {"pitch"}, skipped=frozenset())
    both = merge_progress(of(one), of(SCREWS), of(two))["screws"]
    assert both == replace(SCREWS, step=3, done=frozenset({"axis", "moves", "pitch"}), skipped=frozenset())


def test_begun_again_is_begun_again_also_while_another_window_goes_on() -> None:
    afterwards = replace(SCREWS, done=SCREWS.done | {"moves"})
    both = merge_progress(of(afterwards), of(SCREWS), of(LessonProgress("screws")))["screws"]
    assert both.done == {"moves"}
    assert not both.answers
    assert not both.lines


def test_an_answer_that_is_revealed_stays_revealed() -> None:
    revealed = replace(SCREWS, answers={**SCREWS.answers, "moves": PredictionAnswer((0.25,), True)})
    elsewhere = replace(SCREWS, step=3)
    assert merge_progress(of(elsewhere), of(SCREWS), of(revealed))["screws"].answers == revealed.answers


@given(progresses())
def test_progress_in_lessons_that_have_changed_fits_them(progress: Progress) -> None:
    fewer = {"screws": STEPS["screws"][1:3]}
    known = known_progress(progress, fewer)
    assert known.keys() == progress.keys() & fewer.keys()
    for lesson in known.values():
        assert 0 <= lesson.step <= 2
        assert lesson.done | lesson.skipped | lesson.answers.keys() | lesson.lines.keys() <= set(fewer["screws"])
    assert {**progress, **merge_progress(progress, known, known)} == progress, "what is not known here stays stored"


@given(progresses())
def test_progress_in_the_lessons_that_there_are_is_the_same(progress: Progress) -> None:
    assert known_progress(progress, STEPS) == progress
