"""The array type of the package, and read-only arrays."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def frozen(values: ArrayLike) -> Array:
    """A read-only copy in float64."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array
