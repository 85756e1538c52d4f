"""The grid of a workspace map: equal squares in a plane, or equal cubes in space."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.kernels import kernel

Counts = NDArray[np.int64]
Mask = NDArray[np.bool_]


class Cells(NamedTuple):
    """A `WorkspaceGrid` for the kernels; shape (d,) as an array."""

    origin: Array
    axes: Array
    size: float
    shape: Counts


@dataclass(frozen=True, eq=False)
class WorkspaceGrid:
    """A grid of cells with d = 2 axes for a planar arm, else 3.

    origin (3,), m: the corner of the first cell, base frame; axes (d, 3): orthonormal; size: edge of a cell, m; shape
    (d,): number of cells along each axis.
    """

    origin: Array
    axes: Array
    size: float
    shape: tuple[int, ...]

    @property
    def packed(self) -> Cells:
        """The grid for the kernels."""
        return Cells(self.origin, self.axes, self.size, np.array(self.shape, dtype=np.int64))

    @property
    def count(self) -> int:
        """Number of cells."""
        return prod(self.shape)

    @cached_property
    def centres(self) -> Array:
        """The middle of every cell, (count, 3), m, base frame, in the order of the counts."""
        steps = np.indices(self.shape).reshape(len(self.shape), -1).T + 0.5
        return np.asarray(self.origin + self.size * steps @ self.axes)

    def measure(self, reached: Mask) -> float:
        """Area, m², or volume, m³, of the reached cells (count,).

        All reached cells together contain the workspace; those with only reached neighbours lie inside it. To first
        order the border is halfway between the two, so the mean of both is taken.
        """
        outer = np.pad(reached.reshape(self.shape), 1)
        inner = outer.copy()
        for axis in range(inner.ndim):
            inner &= np.roll(inner, 1, axis) & np.roll(inner, -1, axis)
        return 0.5 * float(outer.sum() + inner.sum()) * self.size ** len(self.shape)


@kernel
def cell_index(point: Array, cells: Cells) -> int:
    """The number of the cell that holds a point (3,), m; −1 outside the grid."""
    origin, axes, size, shape = cells
    number = 0
    for k in range(shape.shape[0]):
        along = 0.0
        for a in range(3):
            along += (point[a] - origin[a]) * axes[k, a]
        step = int(np.floor(along / size))
        if step < 0 or step >= shape[k]:
            return -1
        number = number * shape[k] + step
    return number
