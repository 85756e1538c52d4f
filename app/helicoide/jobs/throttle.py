"""Progress reported no more often than people can see: a study may report two thousand times a second."""

from __future__ import annotations

import time
from collections.abc import Callable
from math import inf
from typing import Any

MIN_STEP = 0.01
MAX_PERIOD = 0.2

Tell = Callable[[Any], None]


def throttled(tell: Tell, clock: Callable[[], float] = time.monotonic) -> Tell:
    """Report a fraction only if it changed by `STEP`, or `MAX_PERIOD` s passed, since the last report; 1 is always
    reported.

    Reports that are not floats, such as a count or a word, always pass. clock: returns the time, s.
    """
    last, when = -inf, -inf

    def reported(what: Any) -> None:
        nonlocal last, when
        if isinstance(what, float):
            now = clock()
            if abs(what - last) < MIN_STEP and now - when < MAX_PERIOD and not what >= 1 > last:
                return
            last, when = what, now
        tell(what)

    return reported
