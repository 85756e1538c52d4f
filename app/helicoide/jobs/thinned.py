"""Progress that is told no oftener than people can see: a study may report two thousand times a second."""

from __future__ import annotations

import time
from collections.abc import Callable
from math import inf
from typing import Any

STEP = 0.01
OFTEN = 0.2

Tell = Callable[[Any], None]


def thinned(tell: Tell, clock: Callable[[], float] = time.monotonic) -> Tell:
    """Tell only those shares that moved by STEP since the last one told, or come OFTEN s after it; the end, 1, always.

    Shares are floats; what is none, such as a count or a word, is told as it is. clock: the time, s.
    """
    last, when = -inf, -inf

    def told(what: Any) -> None:
        nonlocal last, when
        if isinstance(what, float):
            now = clock()
            if abs(what - last) < STEP and now - when < OFTEN and not what >= 1 > last:
                return
            last, when = what, now
        tell(what)

    return told
