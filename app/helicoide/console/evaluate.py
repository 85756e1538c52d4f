"""The value of an expression, by the operators of `geometry` and the functions of the console alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.console.errors import ExpressionError, similar
from helicoide.console.functions import all_functions
from helicoide.console.names import is_reserved, reserved_value
from helicoide.console.operators import binary, repetitions, unary
from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation, Reference, Span, operands_of
from helicoide.console.values import Value, finite_value
from helicoide.text import HelicoideError, Text

MOST_WORK = 1000  # a unit is a product of two multivectors, about 20 µs at most

TOO_MUCH = Text(
    en="the sheet computes too much: it may take {most} steps in all; shorten it",
    pt_BR="a folha calcula demais: ela pode ter {most} passos no total; encurte-a",
)
NO_NAME = Text(en="{name} has no value; {similar}", pt_BR="{name} não tem valor; {similar}")
NO_FUNCTION = Text(en="there is no function {name}; {similar}", pt_BR="não há função {name}; {similar}")
IS_A_FUNCTION = Text(en="{name} is a function: {signature}", pt_BR="{name} é uma função: {signature}")


@dataclass
class Budget:
    """The work that is left for a sheet."""

    left: int = MOST_WORK

    def spend(self, work: int) -> None:
        """Count some work. Raises HelicoideError if none is left."""
        self.left -= work
        if self.left < 0:
            raise HelicoideError(TOO_MUCH.format(most=MOST_WORK))


@dataclass(frozen=True)
class Scope:
    """What names stand for: `values` are those of the sheet so far, `scene` gives those of the scene."""

    values: Mapping[str, Value]
    scene: Mapping[str, Callable[[], Value]]
    budget: Budget

    def value_of(self, name: str) -> Value:
        """The value of a name. Raises HelicoideError, which lists similar names."""
        if name in self.values:
            return self.values[name]
        if name in self.scene:
            return self.scene[name]()
        if name in all_functions():
            raise HelicoideError(IS_A_FUNCTION.format(name=name, signature=all_functions()[name].signature))
        known = reserved_value(name) if is_reserved(name) else None
        if known is None:
            close = similar(name, {*self.values, *self.scene})
            raise HelicoideError(NO_NAME.format(name=name, similar=close if self.values or self.scene else _DEFINE))
        return known


_DEFINE = Text(en="define it in a line before, as in a = 1", pt_BR="defina-o em uma linha antes, como em a = 1")


def evaluate(part: Expression, scope: Scope) -> Value:
    """The value of an expression, all of its numbers finite. Raises ExpressionError at the part that fails."""
    return applied(part, tuple(evaluate(operand, scope) for operand in operands_of(part)), scope)


def applied(part: Expression, values: tuple[Value, ...], scope: Scope) -> Value:
    """The value of an expression whose operands have these values. Raises ExpressionError."""
    match part:
        case Literal(value, place):
            return _at(place, lambda: finite_value(value))
        case Reference(name, place):
            return _at(place, lambda: finite_value(scope.value_of(name)))
        case Operation(symbol, _, place):
            return _at(place, lambda: _operation(symbol, values, scope.budget))
        case FunctionCall(name, _, place):
            return _at(place, lambda: _call(name, values, scope.budget))


def _at(place: Span, compute: Callable[[], Value]) -> Value:
    """What `compute` returns; its HelicoideError gets the place."""
    try:
        with np.errstate(all="ignore"):
            return compute()
    except HelicoideError as error:
        raise ExpressionError(error.text, place.start, place.end) from None


def _operation(symbol: str, operands: tuple[Value, ...], budget: Budget) -> Value:
    budget.spend(repetitions(symbol, operands))
    return finite_value(unary(symbol, *operands) if len(operands) == 1 else binary(symbol, *operands))


def _call(name: str, arguments: tuple[Value, ...], budget: Budget) -> Value:
    function = all_functions().get(name)
    if function is None:
        close = similar(name, all_functions())
        raise HelicoideError(NO_FUNCTION.format(name=name, similar=close))
    budget.spend(function.work * max(1, len(arguments) - 1))
    return finite_value(function(arguments))
