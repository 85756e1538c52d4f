"""The rotations of the quaternion playground."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from helicoide.arrays import Array
from helicoide.geometry import rotation

SMALLEST_AXIS = 1e-9  # length below which three numbers give no direction
LARGEST_ANGLE = 4 * math.pi


def is_finite_number(value: object) -> bool:
    """Whether a value, as a page may send it, is a finite number."""
    return isinstance(value, int | float) and math.isfinite(value)


@dataclass(frozen=True)
class AxisAngle:
    """A rotation by an angle, rad, about an axis (not zero)."""

    axis: tuple[float, float, float]
    angle: float

    def about(self, axis: tuple[float, float, float]) -> AxisAngle:
        """The same angle about another axis, scaled to length one; unchanged if the numbers give no direction."""
        if not all(map(is_finite_number, axis)) or (length := math.hypot(*axis)) < SMALLEST_AXIS:
            return self
        x, y, z = (value / length for value in axis)
        return replace(self, axis=(x, y, z)) if math.isfinite(length) else self

    def turned_by(self, angle: float) -> AxisAngle:
        """Another angle, rad, about the same axis; unchanged unless it is a number of at most two turns."""
        return replace(self, angle=float(angle)) if is_finite_number(angle) and abs(angle) < LARGEST_ANGLE else self


@dataclass(frozen=True)
class Playground:
    """Two rotations to compare and compose. t: fraction of the way from the first to the second, 0 to 1.

    opposite: whether the first one is written −q, which is the same rotation.
    """

    first: AxisAngle = AxisAngle((0.0, 0.0, 1.0), 1.5)
    second: AxisAngle = AxisAngle((1.0, 0.0, 0.0), 2.0)
    t: float = 0.5
    opposite: bool = False

    @property
    def quaternions(self) -> tuple[Array, Array]:
        """The quaternions of the two rotations, wxyz (4,), the first with the chosen sign."""
        p, q = (rotation.from_axis_angle(one.axis, one.angle) for one in (self.first, self.second))
        return -p if self.opposite else p, q

    def at(self, t: float) -> Playground:
        """The same rotations at another fraction of the way, 0 to 1; unchanged unless it is one."""
        return replace(self, t=float(t)) if is_finite_number(t) and 0 <= t <= 1 else self
