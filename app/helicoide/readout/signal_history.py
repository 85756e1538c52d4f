"""The last minute of the signals that a window charts: a sample about twenty times a second, bounded in length."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.readout.signal import Signal
from helicoide.state import State

LONGEST, SPACING = 60.0, 0.05  # s, of what is kept
# Two samples that are further apart than this, s, are not joined by a line.
GAP = 0.5


@dataclass(frozen=True, eq=False)
class SignalHistory:
    """Samples of signals of one arm, and of the compared arm if there is one.

    robot: None before the first sample; times (k,), s, of `State.t`; values: by the name of the signal, (k, 2, c): of
    the first arm and of the second, in the unit of the signal, NaN where undefined.
    """

    robot: Robot | None = None
    times: Array = field(default_factory=lambda: frozen(np.empty(0)))
    values: Mapping[str, Array] = field(default_factory=lambda: MappingProxyType({}))

    def of(self, signal: Signal) -> Array | None:
        """The samples of a signal, (k, 2, c); None if there are none, or of other curves, such as of fewer planes."""
        values = self.values.get(signal.name)
        return None if values is None or values.shape[2] != len(signal.curves) else values

    def is_due(self, state: State, signals: Sequence[Signal]) -> bool:
        """Whether to sample a state: it is of another arm, late enough after the last sample, or a signal is new."""
        if self.robot is not state.robot or any(self.of(signal) is None for signal in signals):
            return True
        if not len(self.times):
            return True
        return not 0 <= state.t - self.times[-1] < SPACING - 1e-9

    def with_sample(self, state: State, signals: Sequence[Signal]) -> SignalHistory:
        """The history with a sample, and without what is older than `LONGEST`.

        Signals that are not among the given ones are dropped; new ones are NaN before. A sample of the same time is
        replaced. Another arm, or a time before the last sample, begins a new history.
        """
        if self.robot is not state.robot or (len(self.times) > 0 and state.t < self.times[-1]):
            return SignalHistory(state.robot).with_sample(state, signals)
        kept = (self.times > state.t - LONGEST) & (self.times < state.t)
        values = {signal.name: self._extended(signal, state, kept) for signal in signals}
        return SignalHistory(state.robot, frozen(np.append(self.times[kept], state.t)), MappingProxyType(values))

    def _extended(self, signal: Signal, state: State, kept: NDArray[np.bool_]) -> Array:
        """The kept samples of a signal and one more, (k, 2, c)."""
        second, curves = state.compared_state, len(signal.curves)
        both = np.full((1, 2, curves), np.nan)
        both[0, 0] = signal.read(state)
        if second is not None:
            both[0, 1] = signal.read(second)
        before = self.of(signal)
        if before is None:
            before = np.full((len(kept), 2, curves), np.nan)
        return frozen(np.concatenate([before[kept], both]))

    def since(self, seconds: float) -> slice:
        """The samples of the last seconds."""
        return slice(int(np.searchsorted(self.times, self.times[-1] - seconds)) if len(self.times) else 0, None)


NO_SIGNAL_HISTORY = SignalHistory()
