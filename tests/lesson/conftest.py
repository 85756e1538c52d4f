"""A small lesson without files, and a seat in it."""

from __future__ import annotations

import pytest

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.lesson import Choice, Diagnosis, Estimate, Lesson, Mark, Order, Prose, Step
from helicoide.seat import Seat
from helicoide.state import State, initial_state
from helicoide.text import untranslated

OPTIONS = tuple(map(untranslated, ("a", "b", "c")))


def is_late(state: State, seat: Seat) -> bool:
    """Whether the time of the state is 1 s or later."""
    return state.t >= 1.0


def is_very_late(state: State, seat: Seat) -> bool:
    """Whether the time of the state is 9 s or later."""
    return state.t >= 9.0


def prose(title: str) -> Prose:
    """The texts of a step with three options and the hint of a mistake."""
    said = untranslated(title)
    return Prose(said, said, said, question=said, options=OPTIONS, reveal=said, hints={"slip": said})


STEPS = (
    Step("choice", lambda state: state, is_late, prediction=Choice(1)),
    Step("estimate", lambda state: state, is_late, held_for=2.0, prediction=Estimate(lambda state, _: 0.5, "mm", 5.0)),
    Step("order", lambda state: state, prediction=Order((2, 0, 1))),
    Step("mark", lambda state: state, is_late, prediction=Mark(lambda state, _: state.T_world_tool[:3, 3], 0.03)),
    Step("mistake", lambda state: state, is_very_late, diagnoses=(Diagnosis("slip", is_late, ()),)),
    Step("open", lambda state: state, is_open=True),
)


@pytest.fixture
def tour() -> Lesson:
    return Lesson("tour", untranslated("Tour"), "movemaster", STEPS, {step.id: prose(step.id) for step in STEPS})


@pytest.fixture
def seat(tour: Lesson) -> Seat:
    return lesson.entered(Seat(token="", language="en"), tour.id)


@pytest.fixture
def start() -> State:
    return initial_state(load_robot("movemaster"))
