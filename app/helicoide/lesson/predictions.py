"""Predictions: what a reader is asked before it is revealed, and whether the answer is right."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.lesson.values import in_unit
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import HelicoideError, Text

Reveal = Literal["now", "done"]
"""When the right answer is revealed: at once, or when the step is done."""
LARGEST = 1e9
NO_ANSWER = Text(en="The answer has to be {what}.", pt_BR="A resposta precisa ser {what}.")
A_NUMBER = Text(en="a number, such as 12.5", pt_BR="um número, como 12,5")
A_POINT = Text(en="a point: three numbers", pt_BR="um ponto: três números")
AN_OPTION = Text(en="one of the {n} options", pt_BR="uma das {n} opções")
AN_ORDER = Text(en="all {n} options in an order", pt_BR="todas as {n} opções, em uma ordem")


@dataclass(frozen=True)
class Choice:
    """One of several options, which are in the prose. right: the number of the right one, from 0."""

    right: int
    reveal: Reveal = "now"


@dataclass(frozen=True)
class Estimate:
    """A number. value: the right one, in SI units or rad; within: the tolerance, in the unit that is shown."""

    value: Callable[[State, Seat], float]
    unit: str
    within: float
    reveal: Reveal = "now"


@dataclass(frozen=True)
class Order:
    """An order of the options, which are in the prose. right: their numbers, from 0, in the right order."""

    right: tuple[int, ...]
    reveal: Reveal = "now"


@dataclass(frozen=True)
class Mark:
    """A point of the scene, marked by dragging a marker. point: the right one, (3,) m, world frame; within: m."""

    point: Callable[[State, Seat], Array]
    within: float = 0.03
    reveal: Reveal = "done"


Prediction = Choice | Estimate | Order | Mark


def right_answer(prediction: Prediction, state: State, seat: Seat) -> tuple[float, ...]:
    """The right answer, in the form of `PredictionAnswer.given`."""
    match prediction:
        case Choice(right):
            return (float(right),)
        case Estimate(value, unit):
            return (in_unit(float(value(state, seat)), unit),)
        case Order(right):
            return tuple(map(float, right))
        case Mark(point):
            return tuple(map(float, point(state, seat)))


def is_right(prediction: Prediction, given: Sequence[float], state: State, seat: Seat) -> bool:
    """Whether an answer is right, for estimates and points within their tolerance."""
    right = right_answer(prediction, state, seat)
    match prediction:
        case Choice() | Order():
            return tuple(given) == right
        case Estimate() | Mark():
            return bool(np.linalg.norm(np.subtract(given, right)) <= prediction.within)


def checked_answer(prediction: Prediction, given: Sequence[float], options: int) -> tuple[float, ...]:
    """An answer as it is recorded. Raises HelicoideError unless it has the form that the prediction asks for.

    options: how many the prose has.
    """
    numbers = tuple(map(float, given))
    finite = all(math.isfinite(number) and abs(number) <= LARGEST for number in numbers)
    match prediction:
        case Choice():
            is_valid, what = len(numbers) == 1 and numbers[0] in range(options), AN_OPTION
        case Order():
            is_valid, what = sorted(numbers) == list(range(options)), AN_ORDER
        case Estimate():
            is_valid, what = len(numbers) == 1 and finite, A_NUMBER
        case Mark():
            is_valid, what = len(numbers) == 3 and finite, A_POINT
    if not is_valid:
        raise HelicoideError(NO_ANSWER.format(what=what.format(n=options)))
    return numbers
