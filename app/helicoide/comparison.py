"""How two methods move their arms to the same target: the last seconds, and the largest values of all."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array, frozen

SPAN, SPACING = 10.0, 0.05  # s, of what is kept


class Effort(NamedTuple):
    """Of one arm at one tick: ‖q̇‖ that its method asks for and that the arm has, rad/s; distance to the target, m."""

    requested: float
    speed: float
    error: float


@dataclass(frozen=True, eq=False)
class Trace:
    """Efforts of both arms while one of them moves.

    seconds: time in which they moved; times (k,), s, of those that are kept; efforts (k, 2, 3): of the first arm and
    the second, as in `Effort`; largest (2, 3): of all ticks.
    """

    seconds: float = 0.0
    times: Array = field(default_factory=lambda: frozen(np.empty(0)))
    efforts: Array = field(default_factory=lambda: frozen(np.empty((0, 2, 3))))
    largest: Array = field(default_factory=lambda: frozen(np.zeros((2, 3))))

    def with_tick(self, first: Effort, second: Effort, dt: float) -> Trace:
        """The trace one tick later."""
        both = np.array([first, second])
        largest = frozen(np.maximum(self.largest, both))
        after = replace(self, seconds=self.seconds + dt, largest=largest)
        if len(self.times) > 0 and after.seconds - self.times[-1] < SPACING:
            return after
        kept = self.times > after.seconds - SPAN
        return replace(
            after,
            times=frozen(np.append(self.times[kept], after.seconds)),
            efforts=frozen(np.concatenate([self.efforts[kept], both[None]])),
        )
