"""Time-optimal scaling of a joint path, for a given time law, within the limits of speed and acceleration.

    |q'ᵢ| ṡ ≤ vᵢ,   |q'ᵢ s̈ + q''ᵢ ṡ²| ≤ aᵢ,   s = L σ(t/T):   ṡ goes with 1/T, s̈ with 1/T²

So the shortest T for a law σ follows from the velocities and accelerations of the joints at T = 1 s.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.path import SmoothJointPath
from helicoide.trajectory.timing import ConstantSpeed, MinimumJerk, TimedJoints, TimeScaling, TrapezoidalVelocity

TimingShape = Literal["trapezoid", "minimum jerk", "constant speed"]
# The duration is longer than the shortest one by this fraction.
MARGIN = 1e-3
# A shorter duration, s, counts as no motion.
AT_REST = 1e-9
# Shortest ramp of a trapezoid, as a share of its duration, even without limits of acceleration.
SHORTEST_RAMP = 0.01
# Samples of a path, at least in all and between two knots; candidates for a ramp in one search.
_INSTANTS, _BETWEEN, _TRIED = 2000, 8, 60
_SHARES = np.linspace(0, 1, 401)


def limit_ratio(path: SmoothJointPath, speed: Array, acceleration: Array) -> float:
    """The factor by which the duration must be multiplied to just meet all limits; 1 if one is just met already.

    max over i and s of |q̇ᵢ| / vᵢ and √(|q̈ᵢ| / aᵢ), on a fine grid between the knots. Args: limits of speed, rad/s or
    m/s, and acceleration, rad/s² or m/s², (n,).
    """
    knots = path.knots
    count = max(_BETWEEN, -(-_INSTANTS // (len(knots) - 1)))
    # just inside the ends: at a knot the acceleration may jump, and only one of its two values would be sampled
    shares = np.linspace(1e-9, 1 - 1e-9, count)
    s = (knots[:-1, None] + np.diff(knots)[:, None] * shares).ravel()
    too_fast = np.abs(path.rates(s)) / speed
    too_sharp = np.abs(path.accelerations(s)) / acceleration
    return float(max(too_fast.max(), np.sqrt(too_sharp.max())))


def time_optimal_timing(path: SmoothJointPath, shape: TimingShape, speed: Array, acceleration: Array) -> TimedJoints:
    """The path with the shortest duration that keeps all limits under this time law, plus `MARGIN`.

    Args: speed, rad/s or m/s, and acceleration, rad/s² or m/s², (n,), positive; an acceleration may be infinite.
    Raises HelicoideError if nothing moves, and for constant speed if a joint with limited acceleration would have to
    start or stop in a jump.
    """
    law = _law(path, shape, speed, acceleration)
    needed = limit_ratio(TimedJoints(path, law, 1.0), speed, acceleration)
    if not needed > AT_REST:
        raise HelicoideError(
            Text(
                en="No joint moves on this path, so it has no shortest duration.",
                pt_BR="Nenhuma junta se move nesta trajetória, portanto ela não tem tempo mínimo.",
            )
        )
    return TimedJoints(path, law, (1 + MARGIN) * needed)


def _law(path: SmoothJointPath, shape: TimingShape, speed: Array, acceleration: Array) -> TimeScaling:
    match shape:
        case "trapezoid":
            return TrapezoidalVelocity(_best_ramp(path, speed, acceleration))
        case "minimum jerk":
            return MinimumJerk()
        case "constant speed":
            _refuse_jumps(path, acceleration)
            return ConstantSpeed()


def _refuse_jumps(path: SmoothJointPath, acceleration: Array) -> None:
    jumps = (path.rates(np.array([0.0, path.duration])) != 0).any(axis=0)
    if (jumps & np.isfinite(acceleration)).any():
        raise HelicoideError(
            Text(
                en="Constant speed starts with a velocity step, which the acceleration limits of these joints do not "
                "allow: {joints}. Use a trapezoidal velocity or minimum jerk.",
                pt_BR="A velocidade constante começa com um degrau de velocidade, que os limites de aceleração destas "
                "juntas não permitem: {joints}. Use o perfil trapezoidal ou o jerk mínimo.",
            ).format(joints=", ".join(str(i + 1) for i in np.flatnonzero(jumps & np.isfinite(acceleration))))
        )


def _best_ramp(path: SmoothJointPath, speed: Array, acceleration: Array) -> float:
    """The ramp β of the trapezoid of shortest duration, by a coarse and then a fine search."""
    shares = np.union1d(_SHARES, path.knots / path.duration)
    along = shares * path.duration
    first = path.duration * np.abs(path.rates(along) / speed).max(axis=1)
    rates, bends = path.rates(along) * path.duration, path.accelerations(along) * path.duration**2

    def needed(ramp: float) -> float:
        k, even = 1 / (ramp * (1 - ramp)), 1 / (1 - ramp)
        up, down = np.sqrt(2 * k * shares), np.sqrt(2 * k * (1 - shares))
        rate = np.minimum(np.minimum(up, down), even)
        change = k * (1.0 * (up < even) - 1.0 * (down < even))
        sharp = np.abs(rates * change[:, None] + bends * rate[:, None] ** 2) / acceleration
        return float(max((first * rate).max(), np.sqrt(sharp.max())))

    low, high = SHORTEST_RAMP, 0.5
    for _ in range(2):
        tried = np.geomspace(low, high, _TRIED)
        best = int(np.argmin([needed(ramp) for ramp in tried]))
        low, high = tried[max(best - 1, 0)], tried[min(best + 1, _TRIED - 1)]
    return float(min(tried[best], 0.5))
