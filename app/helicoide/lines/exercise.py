"""What an author writes for an exercise that checks a typed line: what is asked for, and from which names."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from helicoide.text import Text

LineKind = Literal["quaternion product", "motor", "chain", "incidence", "jacobian", "error"]
GivenKind = Literal[
    "number", "angle", "length", "point", "direction", "line", "plane", "rotation", "vector", "motor", "formula"
]

LINE_KINDS: dict[LineKind, Text] = {
    "quaternion product": Text(en="a product of quaternions", pt_BR="um produto de quatérnios"),
    "motor": Text(en="the motor of a screw", pt_BR="o motor de um helicoide"),
    "chain": Text(en="a chain of forward kinematics", pt_BR="uma cadeia da cinemática direta"),
    "incidence": Text(en="a join or a meet", pt_BR="um join ou um meet"),
    "jacobian": Text(en="a column of the Jacobian", pt_BR="uma coluna da jacobiana"),
    "error": Text(en="an error of orientation or pose", pt_BR="um erro de orientação ou de pose"),
}


@dataclass(frozen=True)
class GivenName:
    """A name that a line may use.

    kind: what it stands for, and so which random values it takes. A rotation is a unit quaternion, a vector a
    quaternion without a real part. formula: for the kind "formula", the expression of the names before it.
    """

    name: str
    kind: GivenKind
    title: Text
    formula: str = ""


@dataclass(frozen=True)
class LineExercise:
    """An exercise: the student types an expression that equals `expected` for all values of the names.

    expected: in the language of the console. steps: lines to type before it, each a name for its result and what is
    expected; the lines after it may use this name. sign_counts: whether −M is wrong where M is expected; it is the same
    motion, and a plane or line with its sides or direction swapped. without: functions that may not be used. title:
    what is asked for, where the title of the kind does not say it.
    """

    kind: LineKind
    names: tuple[GivenName, ...]
    expected: str
    steps: tuple[tuple[str, str], ...] = ()
    sign_counts: bool = True
    without: tuple[str, ...] = ()
    title: Text | None = None

    def lines(self) -> tuple[LineExercise, ...]:
        """The lines to type, one after the other, each an exercise without steps."""
        found, names = [], self.names
        for name, expected in self.steps:
            found.append(replace(self, names=names, expected=expected, steps=()))
            title = Text(en="{name}, of a line before", pt_BR="{name}, de uma linha anterior").format(name=name)
            names = (*names, GivenName(name, "formula", title, expected))
        return (*found, replace(self, names=names, steps=()))
