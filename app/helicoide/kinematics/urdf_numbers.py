"""Lists of numbers in a URDF: separated by spaces, or by commas as some programs write them."""

from __future__ import annotations

import math
from collections.abc import Sequence

MOST = 1e9


def parse_numbers(words: str | None, count: int, most: float = MOST) -> list[float]:
    """The numbers in a text; empty unless there are `count` of absolute value at most `most`."""
    try:
        values = [float(word) for word in (words or "").replace(",", " ").split()]
    except ValueError:
        return []
    return values if len(values) == count and all(abs(value) <= most for value in values) else []


def format_numbers(values: Sequence[float]) -> str:
    """The numbers as text, from which `parse_numbers` reads them back exactly."""
    return " ".join(repr(0.0 if value == 0 or math.isnan(value) else float(value)) for value in values)
