"""The wrench on the tool that one seat looks at."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.gate.check import finite
from helicoide.seat import Seat, SeatUpdate
from helicoide.text import HelicoideError

LARGEST_WRENCH = 1000.0  # N, and N·m


def set_force(force: ArrayLike) -> SeatUpdate:
    """Set the force (3,), N, world frame, clipped. Values that are no numbers are ignored."""
    return _changed(slice(0, 3), force)


def set_moment(moment: ArrayLike) -> SeatUpdate:
    """Set the moment (3,) about the origin of the tool, N·m, world frame, clipped, as for `set_force`."""
    return _changed(slice(3, 6), moment)


def _changed(part: slice, values: ArrayLike) -> SeatUpdate:
    def change(seat: Seat) -> Seat:
        try:
            given = np.clip(finite(values, (3,)), -LARGEST_WRENCH, LARGEST_WRENCH).tolist()
        except HelicoideError:
            return seat
        wrench = list(seat.wrench)
        wrench[part] = given
        return replace(seat, wrench=tuple(wrench))

    return change
