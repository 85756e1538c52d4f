"""Ellipses and circles in any plane, with constant orientation of the tool."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.path import checked_duration

# Largest distance of a start from the plane of its circle, as a fraction of the radius.
IN_PLANE = 1e-9


@dataclass(frozen=True, eq=False)
class EllipsePath:
    """An ellipse in the xy plane of a frame, run through once: p = c + a cos φ x̂ + b sin φ ŷ, φ = 2π s / T.

    T_world_plane (4, 4), m: centre and axes of the ellipse; radii a, b, m; R_world_target (3, 3); duration T, s.
    """

    T_world_plane: Array
    radii: tuple[float, float]
    R_world_target: Array
    duration: float

    def __post_init__(self) -> None:
        checked_duration(self.duration)

    @property
    def is_closed(self) -> bool:
        """True: it ends where it begins."""
        return True

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        phase, (a, b) = 2 * pi * s / self.duration, self.radii
        T = np.eye(4)
        T[:3, :3] = self.R_world_target
        T[:3, 3] = (self.T_world_plane @ [a * cos(phase), b * sin(phase), 0.0, 1.0])[:3]
        return T

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes; ω = 0."""
        rate, (a, b) = 2 * pi / self.duration, self.radii
        phase = rate * s
        return np.append(rate * self.T_world_plane[:3, :2] @ [-a * sin(phase), b * cos(phase)], np.zeros(3))


def circle_path(
    centre: ArrayLike, normal: ArrayLike, start: ArrayLike, R_world_target: Array, duration: float
) -> EllipsePath:
    """The circle about an axis from a start point, in the right-hand sense.

    Args: centre, start (3,), m; normal (3,), any length; R_world_target (3, 3); duration, s. Raises HelicoideError
    unless the vector from the centre to the start is perpendicular to the normal and not zero.
    """
    n, arm = rotation.unit_vector(normal), np.asarray(start, dtype=float) - centre
    radius = float(np.linalg.norm(arm))
    if not radius > 0 or abs(n @ arm) > IN_PLANE * radius:
        raise HelicoideError(
            Text(
                en="A circle needs a start away from its centre, in the plane perpendicular to its normal; this one "
                "is {radius:g} m from the centre and {out:g} m out of the plane.",
                pt_BR="Um círculo precisa de um início fora do centro, no plano perpendicular à normal; este está a "
                "{radius:g} m do centro e a {out:g} m do plano.",
            ).format(radius=radius, out=abs(n @ arm))
        )
    T = np.eye(4)
    T[:3, 0], T[:3, 2], T[:3, 3] = arm / radius, n, centre
    T[:3, 1] = np.cross(T[:3, 2], T[:3, 0])
    return EllipsePath(frozen(T), (radius, radius), R_world_target, duration)
