"""A point cloud."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.units import METRES, Unit
from helicoide.text import Text

# Farther points, m, are dropped: they cannot be readings of a room, and squares of huge numbers overflow.
FARTHEST = 1000.0


@dataclass(frozen=True, eq=False)
class PointCloud:
    """A point cloud: points (k, 3), m; dropped: number of points without coordinates, such as pixels without a depth.

    notes: sentences on how the points were read from a file, such as the assumed unit.
    """

    points: Array
    dropped: int = 0
    notes: tuple[Text, ...] = ()

    @property
    def description(self) -> Text:
        """A sentence with the number of points, their extent, and the number of dropped points."""
        size = np.ptp(self.points, axis=0) if len(self.points) else np.zeros(3)
        return Text(
            en="{k} points within {x:.2f} × {y:.2f} × {z:.2f} m; {dropped} without coordinates were left out.",
            pt_BR="{k} pontos em {x:.2f} × {y:.2f} × {z:.2f} m; {dropped} sem coordenadas ficaram de fora.",
        ).format(k=len(self.points), x=size[0], y=size[1], z=size[2], dropped=self.dropped)


def cloud_from_rows(coordinates: Array, unit: Unit = "m", notes: tuple[Text, ...] = ()) -> PointCloud:
    """The cloud of rows x, y, z (k, 3); rows not finite, or farther than `FARTHEST`, are dropped and counted."""
    with np.errstate(invalid="ignore"):
        points = np.ascontiguousarray(coordinates, dtype=np.float64) * METRES[unit]
        kept = np.asarray((np.abs(points) <= FARTHEST).all(axis=1))
    points = points[kept]
    points.flags.writeable = False
    return PointCloud(points, int(len(kept) - len(points)), notes)
