"""Demonstrations 2 and 3 of Cerbaro 2022, §4.4.3–4.4.4: one turn round a closed path in 60 s, in steps of 1 ms.

Where a run has steps ten times as long, with the same Λ Δt, errors of Euler's rule grow a hundredfold.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, radians, sin
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import limit_gains
from helicoide.ik.clik import followed
from helicoide.ik.limit_gains import Memory
from helicoide.ik.secondary import push
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, ran
from helicoide.studies.study import Progress
from helicoide.trajectory import Ellipse

DT, DT_SHORT, TURN = 1e-3, 1e-2, 60.0
CIRCLE = Ellipse(centre=(0.36, 0.18, 0), radii=(0.1, 0.1, 0), pitch=0, roll=0, period=TURN)
ELLIPSE = Ellipse(centre=(0.52, 0, 0.2), radii=(0.08, 0.08, 0.05), pitch=-np.pi / 3, roll=0, period=TURN)
DAMPING = 0.1

Velocity = Callable[[float], Array]


def in_degrees(k0: float, joints: int) -> float:
    """k₀, 1/s, converted to radians if eq. 14 is read in degrees, with the factor 6 that it prints for any arm."""
    return k0 * 2 * joints / 6 * radians(1) ** 2


def nothing(share: float) -> None:
    """Ignore progress."""


def round_once(path: Ellipse) -> Array:
    """Points of a whole path, (k, 3), m."""
    return np.array([path.point(t) for t in np.linspace(0, path.period, 181)])


def unfed(t: float) -> Array:
    """Zero feedforward velocity, (3,), m/s."""
    return np.zeros(3)


def eq_32(t: float) -> Array:
    """The velocity that Cerbaro 2022, eq. 32, prints for every path, (3,), m/s; read in the unit of the path, mm."""
    return arms.MM * pi / 4 * np.array([sin(pi * t), cos(pi * t), cos(pi * t)])


def circle(dt: float, place: float, turn: float, progress: Progress = nothing, seconds: float = TURN) -> Run:
    """The ORCA follows its circle with fixed heading. place, turn: Λ Δt of position and of heading."""
    orca = arms.orca()
    aiming = arms.with_heading(orca, arms.along(CIRCLE))
    q = arms.start_at(orca, aiming, orca.robot.poses["home"])
    gains = np.array([place, place, place, turn]) / dt
    return ran(followed(orca, *arms.inverse(0.0), aiming, gains, q, dt), seconds, progress)


def ellipse(
    dt: float,
    place: float,
    turn: float,
    progress: Progress = nothing,
    seconds: float = TURN,
    velocity: Velocity = ELLIPSE.velocity,
) -> Run:
    """The Movemaster follows its ellipse with fixed pitch and roll.

    place, turn: as in `circle`; velocity: feedforward ẋ_d of the control law, m/s.
    """
    movemaster = arms.movemaster()
    aiming = arms.with_pitch_and_roll(movemaster, arms.along(ELLIPSE, velocity), ELLIPSE.pitch)
    q = arms.start_at(movemaster, aiming, movemaster.robot.poses["home"])
    gains = np.array([place] * 3 + [turn] * 2) / dt
    return ran(followed(movemaster, *arms.inverse(DAMPING), aiming, gains, q, dt), seconds, progress)


def free_circle(k0: float, dt: float, progress: Progress = nothing, seconds: float = TURN, limits: float = 1.0) -> Run:
    """The ORCA follows its circle with free heading and limit gain k₀, 1/s. limits: scale of the assumed limits."""
    orca = arms.orca(limits)
    q = arms.start_at(orca, arms.with_heading(orca, arms.along(CIRCLE)), orca.robot.poses["home"])
    pushed = push(orca, arms.limit_distance(), k0)
    aiming = arms.position(orca, arms.along(CIRCLE))
    return ran(followed(orca, *arms.inverse(0.0), aiming, 0.8 / dt, q, dt, pushed), seconds, progress)


def start_of_ellipse(pitch_deg: float = -60.0) -> Array:
    """The posture at (440, 0, 200) mm by its pitch; −60° is the source's, with J3 at −129.94°, outside its limits."""
    movemaster = arms.movemaster()
    point = arms.standing(*ELLIPSE.point(0.0))
    aiming = arms.with_pitch_and_roll(movemaster, point, np.radians(pitch_deg))
    return arms.start_at(movemaster, aiming, movemaster.robot.poses["ready"])


def start_inside(degrees: float) -> Array:
    """The posture at (440, 0, 200) mm with J3 `degrees` inside its lower limit, and no roll."""
    movemaster = arms.movemaster()
    sums, wanted = np.eye(5)[[2, 4]], np.array([movemaster.limits.lower[2] + np.radians(degrees), 0.0])
    aiming = arms.with_sums(movemaster, arms.standing(*ELLIPSE.point(0.0)), sums, wanted)
    return arms.start_at(movemaster, aiming, movemaster.robot.poses["ready"])


class LimitGain(NamedTuple):
    """The gain k₀, 1/s, of the objective that keeps joints away from their limits.

    growth: by Algorithm 1, the factor of a joint's gain each time the joint is clipped; None without that algorithm.
    """

    k0: float
    growth: float | None = None


def free_ellipse(
    q: Array,
    gain: LimitGain,
    dt: float,
    progress: Progress = nothing,
    seconds: float = TURN,
    velocity: Velocity = ELLIPSE.velocity,
) -> Run:
    """The Movemaster follows its ellipse from q (5,), rad, with free orientation; velocity as in `ellipse`."""
    movemaster, chosen = arms.movemaster(), arms.limit_distance()
    aiming, feedback = arms.position(movemaster, arms.along(ELLIPSE, velocity)), 1.8 / dt
    method, options = arms.inverse(DAMPING)
    if gain.growth is None:
        pushed = push(movemaster, chosen, gain.k0)
        return ran(followed(movemaster, method, options, aiming, feedback, q, dt, pushed), seconds, progress)
    memory, growth = Memory(np.full(5, gain.k0)), gain.growth
    moments = limit_gains.followed(movemaster, method, options, aiming, feedback, chosen, memory, q, dt, growth=growth)
    return ran(moments, seconds, progress)
