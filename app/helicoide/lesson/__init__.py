"""Guided lessons: steps whose goals are checked, predictions, and their texts, matched by the id of the step.

`step`, `predictions` and `values` are what an author writes, `prose` the form of the pages; `reading` reads both.
`progress` changes what a person has done, `watching` judges it, `shown` shows what a step needs, `course` orders all.
"""

from helicoide.lesson.course import circle_of_needs, course_levels, in_course_order, next_lessons
from helicoide.lesson.lesson import Lesson
from helicoide.lesson.module_errors import stopped
from helicoide.lesson.predictions import Choice, Estimate, Mark, Order, Prediction, is_right, right_answer
from helicoide.lesson.progress import (
    answered,
    entered,
    progressed,
    restarted,
    revealed,
    skipped,
    turned_to,
    with_accepted_line,
)
from helicoide.lesson.prose import Prose, paragraphs, placeholders
from helicoide.lesson.reading import all_lessons, load_lesson, read_lesson
from helicoide.lesson.shown import with_step_shown, without_step_shown
from helicoide.lesson.step import AtSeat, Diagnosis, Shown, Solution, Step, StepGoal
from helicoide.lesson.values import Value, fixed, in_unit, measured_text
from helicoide.lesson.watching import StepWatch, is_goal_met, judged_step, mistake_made
from helicoide.seat import LessonProgress, PredictionAnswer

__all__ = [
    "AtSeat",
    "Choice",
    "Diagnosis",
    "Estimate",
    "Lesson",
    "LessonProgress",
    "Mark",
    "Order",
    "Prediction",
    "PredictionAnswer",
    "Prose",
    "Shown",
    "Solution",
    "Step",
    "StepGoal",
    "StepWatch",
    "Value",
    "all_lessons",
    "answered",
    "circle_of_needs",
    "course_levels",
    "entered",
    "fixed",
    "in_course_order",
    "in_unit",
    "is_goal_met",
    "is_right",
    "judged_step",
    "load_lesson",
    "measured_text",
    "mistake_made",
    "next_lessons",
    "paragraphs",
    "placeholders",
    "progressed",
    "read_lesson",
    "restarted",
    "revealed",
    "right_answer",
    "skipped",
    "stopped",
    "turned_to",
    "with_accepted_line",
    "with_step_shown",
    "without_step_shown",
]
