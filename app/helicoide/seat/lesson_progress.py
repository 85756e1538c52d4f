"""How far a person has come in a lesson."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType


@dataclass(frozen=True)
class PredictionAnswer:
    """What a person answered to a prediction. It is never changed.

    given: the number of the chosen option; the estimate, in its unit; the options in their order; or a point (3,), m,
    world frame. right: whether it is right; None until that is revealed.
    """

    given: tuple[float, ...]
    right: bool | None = None


@dataclass(frozen=True)
class LessonProgress:
    """How far a person has come in a lesson.

    step: the number of the open step, from 0; the number of steps, if the summary is open; done, skipped: ids of steps;
    answers: to the predictions, by step; lines: the accepted lines of exercises, by step; mistakes: those that were
    recognised, as (step, diagnosis); finished: whether the summary has been reached.
    """

    lesson: str
    step: int = 0
    done: frozenset[str] = frozenset()
    skipped: frozenset[str] = frozenset()
    answers: Mapping[str, PredictionAnswer] = field(default_factory=lambda: MappingProxyType({}))
    lines: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: MappingProxyType({}))
    mistakes: frozenset[tuple[str, str]] = frozenset()
    finished: bool = False
