"""A step of a lesson, as an author writes it: what is asked, how it is checked, and what is shown meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from helicoide.lesson.predictions import Prediction
from helicoide.lines import LineExercise
from helicoide.seat import CameraPreset, Notation, Seat, SeatUpdate, Selection
from helicoide.state import State, Update

StepGoal = Callable[[State, Seat], bool]


@dataclass(frozen=True)
class AtSeat:
    """A change of the seat in a solution, such as the choice of what is shown; it does not affect the arm."""

    update: SeatUpdate


Solution = tuple[tuple[Update | AtSeat, float], ...]
"""Changes of the state or the seat, each with the time that follows it, s."""


@dataclass(frozen=True)
class Diagnosis:
    """A typical mistake, recognised on the state and the seat. Its hint is in the prose, under its id.

    wrong: changes that make the mistake. The tests verify that `when` is true after them, and the goal is not met.
    """

    id: str
    when: StepGoal
    wrong: Solution


@dataclass(frozen=True)
class Shown:
    """What a person is shown on entering a step. It is undone on leaving the step.

    layers, hidden: names of layers that are shown or hidden; camera: where the camera goes; tab: the tab that opens, by
    the name of its module; selection: the inspected object; coefficient: the blade of `CL031` that is explained; sheet:
    an example sheet of the console. None leaves things as they are.
    """

    layers: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()
    camera: CameraPreset | None = None
    tab: str | None = None
    selection: Selection | None = None
    coefficient: str | None = None
    notation: Notation | None = None
    sheet: str | None = None


@dataclass(frozen=True)
class Step:
    """One step of a lesson.

    setup: brings the scene to the start of the step; goal: whether the step is done; solution: reaches the goal;
    joints: indices, from 0, of the joints whose sliders the step shows; held_for: how long the goal must hold, s;
    prediction: asked before its answer is revealed; diagnoses: typical mistakes, the first that applies is explained;
    line: an exercise whose lines the reader types, all of which must be accepted;
    charts: names of signals; console, playground: whether the step contains a line of the console, or the quaternion
    playground; is_open: an open task, with many solutions or none.

    A step without a goal is done when its lines are accepted, else when its prediction is answered. If it is open or
    has neither, its reader says when it is done.
    """

    id: str
    setup: Update
    goal: StepGoal | None = None
    solution: Solution = ()
    joints: tuple[int, ...] = ()
    held_for: float = 0.0
    prediction: Prediction | None = None
    diagnoses: tuple[Diagnosis, ...] = ()
    shown: Shown = field(default=Shown())
    line: LineExercise | None = None
    charts: tuple[str, ...] = ()
    console: bool = False
    playground: bool = False
    is_open: bool = False

    @property
    def by_reader(self) -> bool:
        """Whether the reader says that the step is done."""
        return self.goal is None and self.line is None and (self.is_open or self.prediction is None)

    @property
    def by_answer(self) -> bool:
        """Whether the step is done when its prediction is answered."""
        return self.goal is None and self.line is None and not self.by_reader
