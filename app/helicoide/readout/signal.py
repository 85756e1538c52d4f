"""A signal: a quantity of a State that changes with time, for charts; and the bands in which it should not be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.state import State
from helicoide.text import Text

Level = Literal["warning", "critical"]
Bands = Callable[[State], "tuple[Band, ...]"]
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


@dataclass(frozen=True)
class Band:
    """Values from lower to upper, in the unit of the signal, one of them possibly infinite. level: how serious."""

    title: Text
    lower: float
    upper: float
    level: Level = "critical"


def no_bands(state: State) -> tuple[Band, ...]:
    """The bands of a signal without bands."""
    return ()


@dataclass(frozen=True, eq=False)
class Signal:
    """A quantity with one or several curves, such as the value of each joint.

    name: its key; symbol: as written on an axis; curves: the names of the curves, (c,); values: from a state to (c,),
    NaN where the state does not define the quantity; positive: whether all values are at least 0, so that a logarithmic
    axis can show them.
    """

    name: str
    title: Text
    symbol: str
    unit: str
    curves: tuple[Text, ...]
    values: Callable[[State], Array]
    bands: Bands = no_bands
    positive: bool = False

    def read(self, state: State) -> Array:
        """The values of a state, (c,); NaN, too, where they are infinite or a decomposition fails."""
        try:
            values = np.asarray(self.values(state), dtype=np.float64).reshape(len(self.curves))
        except np.linalg.LinAlgError:
            return np.full(len(self.curves), np.nan)
        return np.where(np.isfinite(values), values, np.nan)


@dataclass(frozen=True)
class PhasePlane:
    """Two signals, one over the other, curve by curve. across, up: their names; inverse: draw up = 1/across too."""

    name: str
    title: Text
    across: str
    up: str
    inverse: bool = False


def subscript(symbol: str, number: int) -> str:
    """A symbol with a number as its subscript, such as σ₁."""
    return symbol + str(number).translate(SUBSCRIPTS)


def scalar(value: float) -> Array:
    """The array of a signal with one curve, (1,)."""
    return np.array([value])
