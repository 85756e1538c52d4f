"""The functions of the console: each described once, where it is computed, by `@console_function`.

An example is a pair of expressions with the same value: the first shows the function, the second what it gives.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from helicoide import content
from helicoide.console.parameters import Parameter
from helicoide.console.values import Value
from helicoide.text import HelicoideError, Text

Compute = Callable[..., Value]
MARK = "console_function"

COUNT = Text(
    en="{name} takes {wanted} arguments, not {given}: {signature}",
    pt_BR="{name} recebe {wanted} argumentos, não {given}: {signature}",
)
ARGUMENT = Text(en="argument {n} of {signature}: {what}", pt_BR="argumento {n} de {signature}: {what}")


@dataclass(frozen=True)
class Example:
    """An expression, and a simpler one of the same value."""

    expression: str
    equals: str


@dataclass(frozen=True)
class ConsoleFunction:
    """A function of the console.

    signature: its name and arguments, with … if the last may be repeated; parameters: one for each argument; least: how
    many must be given; work: how long it takes, in products of two multivectors.
    """

    signature: str
    about: Text
    example: Example
    parameters: tuple[Parameter, ...]
    compute: Compute
    least: int
    work: int

    @property
    def name(self) -> str:
        """The name by which it is called."""
        return self.signature.partition("(")[0]

    @property
    def most(self) -> int:
        """How many arguments it takes at most."""
        return 12 if "…" in self.signature else len(self.parameters)

    def __call__(self, arguments: tuple[Value, ...]) -> Value:
        """Its value. Raises HelicoideError for a wrong number or kind of arguments."""
        given = len(arguments)
        if not self.least <= given <= self.most:
            wanted = str(self.least) if self.least == self.most else f"{self.least}–{self.most}"
            raise HelicoideError(COUNT.format(name=self.name, wanted=wanted, given=given, signature=self.signature))
        return self.compute(*(self._taken(n, argument) for n, argument in enumerate(arguments)))

    def _taken(self, n: int, argument: Value) -> Any:
        take = self.parameters[min(n, len(self.parameters) - 1)]
        try:
            return take(argument)
        except HelicoideError as error:
            what = ARGUMENT.format(n=n + 1, signature=self.signature, what=error.text)
            raise HelicoideError(what) from None


def console_function(
    signature: str, parameters: tuple[Parameter, ...], about: Text, example: Example, least: int = 0, work: int = 1
) -> Callable[[Compute], Compute]:
    """Describes the function below it. least: 0 if all arguments must be given."""

    def described(compute: Compute) -> Compute:
        entry = ConsoleFunction(signature, about, example, parameters, compute, least or len(parameters), work)
        setattr(compute, MARK, entry)
        return compute

    return described


@cache
def all_functions() -> dict[str, ConsoleFunction]:
    """All functions by name, sorted."""
    entries = [
        getattr(thing, MARK)
        for module in content.modules(__name__).values()
        for thing in vars(module).values()
        if hasattr(thing, MARK)
    ]
    return {entry.name: entry for entry in sorted(entries, key=lambda entry: entry.name)}
