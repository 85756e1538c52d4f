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
from helicoide.ik.clik import ControlLaw, closed_loop
from helicoide.ik.limit_gains import GrowingObjective, LimitGainMemory
from helicoide.ik.secondary import push
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import LoopRun, collected
from helicoide.studies.study import Progress
from helicoide.trajectory import Ellipse

DT, DT_SHORT, TURN = 1e-3, 1e-2, 60.0
CIRCLE = Ellipse(centre=(0.36, 0.18, 0), radii=(0.1, 0.1, 0), pitch=0, roll=0, period=TURN)
ELLIPSE = Ellipse(centre=(0.52, 0, 0.2), radii=(0.08, 0.08, 0.05), pitch=-np.pi / 3, roll=0, period=TURN)
DAMPING = 0.1

Velocity = Callable[[float], Array]


def gain_in_degrees(k0: float, joints: int) -> float:
    """k₀, 1/s, converted to radians if eq. 14 is read in degrees, with the factor 6 that it prints for any arm."""
    return k0 * 2 * joints / 6 * radians(1) ** 2


def ignore_progress(share: float) -> None:
    """Ignore progress."""


def closed_path_points(path: Ellipse) -> Array:
    """Points of a whole path, (k, 3), m."""
    return np.array([path.point(t) for t in np.linspace(0, path.period, 181)])


def zero_feedforward(t: float) -> Array:
    """Zero feedforward velocity, (3,), m/s."""
    return np.zeros(3)


def eq_32(t: float) -> Array:
    """The velocity that Cerbaro 2022, eq. 32, prints for every path, (3,), m/s; read in the unit of the path, mm."""
    return setups.MM * pi / 4 * np.array([sin(pi * t), cos(pi * t), cos(pi * t)])


def run_circle(
    dt: float, position_gain: float, heading_gain: float, progress: Progress = ignore_progress, seconds: float = TURN
) -> LoopRun:
    """The ORCA follows its circle with fixed heading. position_gain, heading_gain: Λ Δt of position and of heading."""
    orca = setups.orca()
    aiming = setups.heading_task(orca, setups.point_along(CIRCLE))
    q = setups.solved_posture(orca, aiming, orca.robot.poses["home"])
    gains = np.array([position_gain, position_gain, position_gain, heading_gain]) / dt
    law = ControlLaw(setups.damped_inverse(0.0), gains, dt)
    return collected(closed_loop(orca, law, aiming, q), seconds, progress)


def run_ellipse(
    dt: float,
    position_gain: float,
    orientation_gain: float,
    progress: Progress = ignore_progress,
    seconds: float = TURN,
    velocity: Velocity = ELLIPSE.velocity,
) -> LoopRun:
    """The Movemaster follows its ellipse with fixed pitch and roll.

    position_gain, orientation_gain: as in `circle`; velocity: feedforward ẋ_d of the control law, m/s.
    """
    movemaster = setups.movemaster()
    aiming = setups.pitch_and_roll_task(movemaster, setups.point_along(ELLIPSE, velocity), ELLIPSE.pitch)
    q = setups.solved_posture(movemaster, aiming, movemaster.robot.poses["home"])
    gains = np.array([position_gain] * 3 + [orientation_gain] * 2) / dt
    law = ControlLaw(setups.damped_inverse(DAMPING), gains, dt)
    return collected(closed_loop(movemaster, law, aiming, q), seconds, progress)


def run_free_circle(
    k0: float, dt: float, progress: Progress = ignore_progress, seconds: float = TURN, limits: float = 1.0
) -> LoopRun:
    """The ORCA follows its circle with free heading and limit gain k₀, 1/s. limits: scale of the assumed limits."""
    orca = setups.orca(limits)
    q = setups.solved_posture(orca, setups.heading_task(orca, setups.point_along(CIRCLE)), orca.robot.poses["home"])
    pushed = push(orca, setups.limit_distance(), k0)
    aiming = setups.position_task(orca, setups.point_along(CIRCLE))
    law = ControlLaw(setups.damped_inverse(0.0), 0.8 / dt, dt)
    return collected(closed_loop(orca, law, aiming, q, pushed), seconds, progress)


def start_of_ellipse(pitch_deg: float = -60.0) -> Array:
    """The posture at (440, 0, 200) mm by its pitch; −60° is the source's, with J3 at −129.94°, outside its limits."""
    movemaster = setups.movemaster()
    point = setups.fixed_point(*ELLIPSE.point(0.0))
    aiming = setups.pitch_and_roll_task(movemaster, point, np.radians(pitch_deg))
    return setups.solved_posture(movemaster, aiming, movemaster.robot.poses["ready"])


def start_inside(degrees: float) -> Array:
    """The posture at (440, 0, 200) mm with J3 `degrees` inside its lower limit, and no roll."""
    movemaster = setups.movemaster()
    sums, wanted = np.eye(5)[[2, 4]], np.array([movemaster.limits.lower[2] + np.radians(degrees), 0.0])
    aiming = setups.joint_sum_task(movemaster, setups.fixed_point(*ELLIPSE.point(0.0)), sums, wanted)
    return setups.solved_posture(movemaster, aiming, movemaster.robot.poses["ready"])


class LimitGain(NamedTuple):
    """The gain k₀, 1/s, of the objective that keeps joints away from their limits.

    growth: by Algorithm 1, the factor of a joint's gain each time the joint is clipped; None without that algorithm.
    """

    k0: float
    growth: float | None = None


def run_free_ellipse(
    q: Array,
    gain: LimitGain,
    dt: float,
    progress: Progress = ignore_progress,
    seconds: float = TURN,
    velocity: Velocity = ELLIPSE.velocity,
) -> LoopRun:
    """The Movemaster follows its ellipse from q (5,), rad, with free orientation; velocity as in `ellipse`."""
    movemaster, chosen = setups.movemaster(), setups.limit_distance()
    aiming = setups.position_task(movemaster, setups.point_along(ELLIPSE, velocity))
    law = ControlLaw(setups.damped_inverse(DAMPING), 1.8 / dt, dt)
    if gain.growth is None:
        pushed = push(movemaster, chosen, gain.k0)
        return collected(closed_loop(movemaster, law, aiming, q, pushed), seconds, progress)
    objective, memory = GrowingObjective(chosen, gain.growth), LimitGainMemory(np.full(5, gain.k0))
    moments = limit_gains.loop_with_limit_gains(movemaster, law, objective, aiming, q, memory)
    return collected(moments, seconds, progress)
