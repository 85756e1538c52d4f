"""Exercises that check a typed line: an expression of the console that must equal the expected one for all values.

`exercise.py` is what an author writes, `check.py` what comes of a line. A wrong line is repaired by the smallest change
that makes it right (`repairs_of_*.py`); the repair tells which term was wrong and what the slip was (`slips.py`). If no
single change does, the line is compared term by term and factor by factor (`terms.py`).
"""

from helicoide.lines.check import Accepted, LineVerdict, Refused, WrongTerm, check_line, line_faults
from helicoide.lines.exercise import LINE_KINDS, GivenKind, GivenName, LineExercise, LineKind
from helicoide.lines.slips import SLIPS, SlipName

__all__ = [
    "LINE_KINDS",
    "SLIPS",
    "Accepted",
    "GivenKind",
    "GivenName",
    "LineExercise",
    "LineKind",
    "LineVerdict",
    "Refused",
    "SlipName",
    "WrongTerm",
    "check_line",
    "line_faults",
]
