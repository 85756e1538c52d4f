"""What a step shows once it is set up counts in the checks of its words and charts."""

from __future__ import annotations

from dataclasses import replace

from helicoide.contributions.lesson_names import name_faults
from helicoide.contributions.lesson_words import screen_words, step_words
from helicoide.kinematics.library import load_robot
from helicoide.lesson import load_lesson


def test_words_of_rows_that_a_step_sets_up() -> None:
    lesson, robot = load_lesson("priorities"), load_robot("zebra_zero")
    number = [step.id for step in lesson.steps].index("heavier")
    assert "Weight k₀ [1/s]" in step_words(lesson, number, robot, "en") - screen_words(robot, "en")


def test_charts_that_a_step_itself_provides() -> None:
    lesson, robot = load_lesson("remote_centre"), load_robot("dia10_rod")
    assert not [*name_faults(lesson, robot)]
    bare = replace(lesson, steps=tuple(replace(step, setup=lambda state: state) for step in lesson.steps))
    assert "entry distance" in "".join(fault.en for fault in name_faults(bare, robot))
