"""A lesson as a whole: its steps with their texts, its values and pictures, and what it builds on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from helicoide.lesson.prose import Prose
from helicoide.lesson.step import Step
from helicoide.lesson.values import Value
from helicoide.seat import LessonProgress
from helicoide.text import Text, untranslated


@dataclass(frozen=True)
class Lesson:
    """A lesson about a robot, with its steps and their texts.

    robot: its name; prose: texts by step id; about: one sentence; needs: ids of the lessons that it builds on; own_arm:
    whether it brings an arm of one's own, so that the shared one stays as it is; values: what the placeholders of the
    prose stand for; pictures: the drawings that the prose names, as SVG, and other pictures, as data URLs.
    """

    id: str
    title: Text
    robot: str
    steps: tuple[Step, ...]
    prose: Mapping[str, Prose]
    about: Text = field(default=untranslated(""))
    needs: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    own_arm: bool = False
    values: Mapping[str, Value] = field(default_factory=dict)
    pictures: Mapping[str, str] = field(default_factory=dict)

    def open_step(self, progress: LessonProgress) -> Step | None:
        """The step at which a person is; None at the summary after the last step."""
        return self.steps[progress.step] if 0 <= progress.step < len(self.steps) else None
