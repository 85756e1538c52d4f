"""Lines of the console evaluated for tests, and lines made at random, hostile ones among them."""

from __future__ import annotations

import random
from collections.abc import Sequence

import numpy as np

from helicoide.arrays import Array
from helicoide.console import LineResult, Value, all_functions, sheet_results
from helicoide.geometry.multivector import Multivector
from helicoide.sheet import Sheet, SheetLine
from helicoide.state import State


def results(*lines: str, state: State | None = None) -> tuple[LineResult, ...]:
    return sheet_results(Sheet(tuple(SheetLine(line) for line in lines)), state)


def value(*lines: str, state: State | None = None) -> Value:
    """The value of the last line; the others must have one, too."""
    found = results(*lines, state=state)
    for result in found:
        assert result.error is None, result.error.text.en
    assert found[-1].value is not None
    return found[-1].value


def numbers(*lines: str, state: State | None = None) -> Array:
    """The coefficients of the last line's value; a number is an array of one."""
    last = value(*lines, state=state)
    return last.values if isinstance(last, Multivector) else np.array([last])


def written(coefficients: Array, names: Sequence[str]) -> str:
    """A multivector as an expression, with every digit."""
    return " + ".join(f"({number!r})*{name}" for number, name in zip(coefficients.tolist(), names, strict=True))


HOSTILE = (
    "__import__", "().__class__", "a.__dict__", "__builtins__", "lambda: 0", "eval(1)", "exec", "open", "x[0]", "{x}",
    "'text'", '"text"', "`ls`", "e.__init__", "os.system", "import os", "print(1)", "True", "None", "nan", "inf",
    "NaN", "1e+308", "1e+308*1e+308", "9**9**9**9", "(2)**32**32", "e12**32", "e12**33", "e12**-32", "2**-1074",
    "0**-1", "(-1)**0.5", "1/0", "0*e1/e", "1/e", "sqrt(-1)", "log(0)", "exp(1e+9)", "exp(exp(exp(9)))", "sin(1e+300)",
    "point(1e+300,0,0)", "point(1e-320,0,0)", "ｅ12", "е1", "ⅇ", "π", "𝟏", "１", "a‮b", "\u200b", "\x00", "\n", "\\",
    "%s", "{0}", "{0.__class__}", "<script>", "a=b=c", "=1", "pi=3", "e1=2", "join=1", "a==1", "a<b", "a>b", "a@b",
    "a if b else c", "for x in y", "a;b", "a:=1", "1_000", "0x10", "1j", "1e5", "..", "...", "**", "((((", "))))",
)  # fmt: skip
ATOMS = ("0", "1", "2.5", "1e-9", "1e+200", "-3", "pi", "e1", "e", "e12", "e1e2e3", "e0123", "e321", "i", "k", "a",
         "theta", "M_tool", "L1", "L9", "q_tool", "elbow", "ceiling", "target", "point(1,2,3)", "plane(0,0,1,2)",
         "translator(1,2,3)", "modern(e1)", "direction(1,0,0)", "rotor(0,0,1,1)")  # fmt: skip
OPERATORS = ("+", "-", "*", "/", "^", "|", "&", ">>", "**")


def expression(source: random.Random, depth: int) -> str:
    """An expression that the grammar mostly reads, of operators and functions at random."""
    if depth == 0 or source.random() < 0.15:
        return source.choice(HOSTILE if source.random() < 0.08 else ATOMS)
    form = source.random()
    inner = [expression(source, depth - 1) for _ in range(source.randint(0, 4))] or ["1"]
    if form < 0.4:
        function = source.choice([*all_functions().values()])
        fits = inner if source.random() < 0.2 else (inner * 12)[: len(function.parameters)]
        return f"{function.name}({', '.join(fits)})"
    if form < 0.9:
        return f"({inner[0]}) {source.choice(OPERATORS)} {inner[-1]}"
    return f"{source.choice('-~')}{inner[0]}"


def fuzzed(source: random.Random) -> str:
    """A line: mostly an expression, sometimes a definition, deeply nested, damaged, or noise."""
    form, line = source.random(), expression(source, source.randint(1, 4))
    if form < 0.1:
        return f"{source.choice(['a', 'b', 'theta', 'pi', 'L1', 'join', 'e1'])} = {line}"
    if form < 0.15:
        return source.choice(["(", "-", "~", "sin(", "1+(", "2**", "e1*"]) * source.randint(1, 399) + line
    if form < 0.3:
        place = source.randint(0, len(line))
        return line[:place] + source.choice([*HOSTILE, "", " "]) + line[place + source.randint(0, 3) :]
    if form < 0.33:
        return "".join(chr(source.choice([source.randint(1, 126), source.randint(127, 0x2FFF)])) for _ in range(40))
    return line
