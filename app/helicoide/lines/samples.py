"""Random values of the given names, the same in every run, away from special values such as 0 and right angles."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.console import Value
from helicoide.console.evaluate import Budget, Scope, evaluate
from helicoide.console.grammar import parse_line
from helicoide.console.syntax import Expression
from helicoide.console.values import multivector_value, quaternion_value
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.lines.exercise import GivenKind, GivenName
from helicoide.text import HelicoideError, Text

COUNT, SEED = 8, 2022
NO_EXPRESSION = Text(
    en="“{text}” is no expression: write its right side alone", pt_BR="“{text}” não é uma expressão: escreva só o valor"
)


@lru_cache(maxsize=256)
def samples(names: tuple[GivenName, ...]) -> tuple[dict[str, Value], ...]:
    """`COUNT` times a value for each name. Raises HelicoideError for a formula that has none."""
    return tuple(_sample(names, np.random.default_rng([SEED, n])) for n in range(COUNT))


def _sample(names: tuple[GivenName, ...], random: np.random.Generator) -> dict[str, Value]:
    known: dict[str, Value] = {}
    for given in names:
        if given.kind == "formula":
            known[given.name] = evaluate(expression_of(given.formula), Scope(known, {}, Budget()))
        else:
            known[given.name] = _DRAWN[given.kind](random)
    return known


def expression_of(text: str) -> Expression:
    """The parts of an expression. Raises HelicoideError, also for a comment or a definition."""
    line = parse_line(text)
    if line is None or line.target is not None:
        raise HelicoideError(NO_EXPRESSION.format(text=text))
    return line.expression


def _number(random: np.random.Generator) -> float:
    return float(random.uniform(0.4, 2.5) * random.choice([-1, 1]))


def _angle(random: np.random.Generator) -> float:
    """Between two multiples of π/4, and at least 0.1 rad from both."""
    eighth = random.integers(-3, 3) * math.pi / 4
    return float(eighth + random.uniform(0.1, math.pi / 4 - 0.1))


def _length(random: np.random.Generator) -> float:
    return float(random.uniform(0.15, 0.95))


def _unit(random: np.random.Generator, size: int = 3) -> Array:
    vector = random.uniform(0.3, 1.0, size) * random.choice([-1, 1], size)
    return np.asarray(vector / np.linalg.norm(vector))


def _place(random: np.random.Generator) -> Array:
    return np.asarray(random.uniform(0.15, 0.95, 3) * random.choice([-1, 1], 3))


def _point(random: np.random.Generator) -> Value:
    return multivector_value(rigid.point(_place(random)))


def _direction(random: np.random.Generator) -> Value:
    return multivector_value(rigid.null_part(rigid.point(_unit(random))))


def _line(random: np.random.Generator) -> Value:
    return multivector_value(rigid.line(_unit(random), _place(random)))


def _plane(random: np.random.Generator) -> Value:
    return multivector_value(rigid.plane(_unit(random), _length(random)))


def _rotation(random: np.random.Generator) -> Value:
    return quaternion_value(_unit(random, 4))


def _vector(random: np.random.Generator) -> Value:
    return quaternion_value(np.array([0.0, *_place(random)]))


def _motor(random: np.random.Generator) -> Value:
    turn = rigid.rotor(_unit(random), _angle(random))
    return multivector_value(CL031.product(rigid.translator(_place(random)), turn))


_DRAWN: dict[GivenKind, Callable[[np.random.Generator], Value]] = {
    "number": _number,
    "angle": _angle,
    "length": _length,
    "point": _point,
    "direction": _direction,
    "line": _line,
    "plane": _plane,
    "rotation": _rotation,
    "vector": _vector,
    "motor": _motor,
}
