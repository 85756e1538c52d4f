"""Progress in the lessons that there are: lessons may have been changed or removed since it was stored."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from helicoide.seat import LessonProgress
from helicoide.store.merging import Progress


def known_progress(progress: Progress, steps: Mapping[str, Sequence[str]]) -> Progress:
    """The part of the progress that is about existing lessons and steps. steps: the ids of the steps by lesson."""
    return {name: _known(lesson, steps[name]) for name, lesson in progress.items() if name in steps}


def _known(lesson: LessonProgress, steps: Sequence[str]) -> LessonProgress:
    return replace(
        lesson,
        step=min(max(lesson.step, 0), len(steps)),
        done=lesson.done & frozenset(steps),
        skipped=lesson.skipped & frozenset(steps),
        answers={step: answer for step, answer in lesson.answers.items() if step in steps},
        lines={step: lines for step, lines in lesson.lines.items() if step in steps},
        mistakes=frozenset((step, mistake) for step, mistake in lesson.mistakes if step in steps),
    )
