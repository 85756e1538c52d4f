"""Paths that the target can follow, as functions of a path parameter in seconds."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, pi, sin

import numpy as np

from helicoide.kinematics.chain import Array


@dataclass(frozen=True)
class Ellipse:
    """The family of Cerbaro 2022, eq. 31: one closed turn in `period` seconds.

    Args: centre and radii, m; pitch, rad: angle of the tool above the horizontal; roll, rad: turn about the tool axis.
    The heading is that of the point seen from the waist, the only one that an arm with five joints can hold.
    """

    centre: tuple[float, float, float]
    radii: tuple[float, float, float]
    pitch: float
    roll: float
    period: float = 30.0

    def point(self, s: float) -> Array:
        """p = c + (−rx cos φ, ry sin φ, rz sin φ), φ = 2π s / T. Returns (3,), m."""
        phase = 2 * pi * s / self.period
        return np.asarray(self.centre) + np.asarray(self.radii) * (-cos(phase), sin(phase), sin(phase))

    def velocity(self, s: float) -> Array:
        """The derivative of `point`, (3,), m/s (the source's eq. 32 prints another expression)."""
        phase, rate = 2 * pi * s / self.period, 2 * pi / self.period
        return rate * np.asarray(self.radii) * (sin(phase), cos(phase), cos(phase))

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m: R = Rz(heading) Ry(−pitch) Rx(roll)."""
        x, y, z = self.point(s)
        ch, sh = cos(atan2(y, x)), sin(atan2(y, x))
        cp, sp = cos(-self.pitch), sin(-self.pitch)
        cr, sr = cos(self.roll), sin(self.roll)
        pose = np.eye(4)
        pose[:3, :3] = (
            np.array([[ch, -sh, 0], [sh, ch, 0], [0, 0, 1]])
            @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
            @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
        )
        pose[:3, 3] = x, y, z
        return pose


EQ_33 = Ellipse(centre=(0.52, 0.0, 0.23), radii=(0.06, 0.28, 0.14), pitch=-pi / 3, roll=0.0)
