"""Points that a depth camera saw."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.units import METRES, Unit
from helicoide.text import Text

# Farther points, m, are no readings of a room; of the largest numbers even squares would be infinite.
FARTHEST = 1000.0


@dataclass(frozen=True, eq=False)
class PointCloud:
    """points (k, 3), m; dropped: how many more there were without coordinates, such as pixels that saw nothing.

    notes: sentences about how the points came out of a file, such as the unit that was assumed.
    """

    points: Array
    dropped: int = 0
    notes: tuple[Text, ...] = ()

    @property
    def description(self) -> Text:
        """How many points there are, over which room, and how many were left out."""
        size = np.ptp(self.points, axis=0) if len(self.points) else np.zeros(3)
        return Text(
            en="{k} points within {x:.2f} × {y:.2f} × {z:.2f} m; {dropped} without coordinates were left out.",
            pt_BR="{k} pontos em {x:.2f} × {y:.2f} × {z:.2f} m; {dropped} sem coordenadas ficaram de fora.",
        ).format(k=len(self.points), x=size[0], y=size[1], z=size[2], dropped=self.dropped)


def cloud_from_rows(coordinates: Array, unit: Unit = "m", notes: tuple[Text, ...] = ()) -> PointCloud:
    """The cloud of rows x, y, z (k, 3); rows that are not finite, or beyond `FARTHEST`, are dropped and counted."""
    with np.errstate(invalid="ignore"):
        points = np.ascontiguousarray(coordinates, dtype=np.float64) * METRES[unit]
        kept = np.asarray((np.abs(points) <= FARTHEST).all(axis=1))
    points = points[kept]
    points.flags.writeable = False
    return PointCloud(points, int(len(kept) - len(points)), notes)
