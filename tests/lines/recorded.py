"""The recorded wrong lines."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

FILE = Path(__file__).with_name("wrong_lines.toml")


@dataclass(frozen=True)
class WrongLine:
    """A wrong line of an exercise, with its slip and the characters that are wrong."""

    exercise: str
    text: str
    slip: str
    term: str


def wrong_lines() -> list[WrongLine]:
    exercises = tomllib.loads(FILE.read_text("utf-8"))
    return [WrongLine(name, *line) for name, exercise in exercises.items() for line in exercise["lines"]]
