"""The paths of Cerbaro 2022: the family of eq. 31, the three of its experiments, and the two of its demonstrations."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, pi, radians, sin

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.trajectory.loop import EllipsePath


@dataclass(frozen=True)
class Ellipse:
    """The ellipses of Cerbaro 2022, eq. 31, run through once in `period` seconds.

    Args: centre and radii, m; pitch, rad: angle of the tool above the horizontal; roll, rad: angle about the tool axis.
    The yaw is the direction from the waist to the point, the only one possible for an arm with five joints.
    """

    centre: tuple[float, float, float]
    radii: tuple[float, float, float]
    pitch: float
    roll: float
    period: float = 30.0

    @property
    def duration(self) -> float:
        """Duration of the ellipse, s."""
        return self.period

    @property
    def is_closed(self) -> bool:
        """True: it ends where it begins."""
        return True

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

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes: ω = (x ẏ − y ẋ)/(x² + y²) about z.

        On the waist axis, where the yaw is undefined, ω is 0.
        """
        (x, y, _), v = self.point(s), self.velocity(s)
        from_axis = x * x + y * y
        turning = (x * v[1] - y * v[0]) / from_axis if from_axis > 0 else 0.0
        return np.array([*v, 0.0, 0.0, turning])


# The experiments (Cerbaro 2022, §6.1): eqs. 33 to 35. Eq. 34 prints 500 mm for the 50 mm that its ends A and B need;
# the text calls the circle of eq. 35 parallel to yz, but the equation makes it parallel to xy.
EQ_33 = Ellipse(centre=(0.52, 0.0, 0.23), radii=(0.06, 0.28, 0.14), pitch=-pi / 3, roll=0.0)
EQ_34 = Ellipse(centre=(0.55, 0.0, 0.23), radii=(0.0, 0.25, 0.05), pitch=0.0, roll=pi / 2)
EQ_35 = Ellipse(centre=(0.48, 0.1, 0.2), radii=(0.22, 0.22, 0.0), pitch=radians(-70), roll=radians(30))

# The demonstrations (§4.4.3 and §4.4.4), in the direction of eq. 31; the source does not state theirs.
# The ORCA keeps its φ = 0.
MOVEMASTER_ELLIPSE = Ellipse(centre=(0.52, 0.0, 0.2), radii=(0.08, 0.08, 0.05), pitch=-pi / 3, roll=0.0, period=60.0)
ORCA_CIRCLE = EllipsePath(
    T_world_plane=frozen([[-1.0, 0.0, 0.0, 0.36], [0.0, 1.0, 0.0, 0.18], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]),
    radii=(0.1, 0.1),
    R_world_target=frozen(np.eye(3)),
    duration=60.0,
)
