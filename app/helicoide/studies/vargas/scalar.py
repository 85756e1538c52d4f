"""The scalar filtered inverse in time: Sims. 8 and 9 of Vargas 2013, its worst case and its crossing of zero."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import scalar_filter

Law = Callable[[float, float], float]


def scalar_filter_steps(
    k: Callable[[float], float], theta: float, beta: float, dt: float, t_0: float, t_1: float
) -> Array:
    """θ at t₀, t₀ + dt, … t₁, (s + 1,), by exact steps with k taken at their midpoints."""
    found = [theta]
    for i in range(round((t_1 - t_0) / dt)):
        theta = scalar_filter.scalar_step(k(t_0 + (i + 0.5) * dt), theta, beta, dt)
        found.append(theta)
    return np.array(found)


def plain_law(k: float, theta: float) -> float:
    """u = θ ν."""
    return theta


@dataclass(frozen=True, eq=False)
class ScalarLoop:
    """A closed loop: t, k, θ, e = y_d − y and u, (s + 1,) each."""

    t: Array
    k: Array
    theta: Array
    e: Array
    u: Array

    @property
    def y(self) -> Array:
        """y = y_d − e."""
        return np.asarray(4 + np.cos(0.2 * pi * self.t) - self.e)


def sine_gain(t: float) -> float:
    """k of Sim. 9."""
    return sin(0.4 * pi * t)


def scalar_closed_loop(law: Law, beta: float, dt: float, seconds: float, rate: float = 10.0) -> ScalarLoop:
    """Sim. 9: ẏ = k u, u = law(k, θ) ν, ν = ẏ_d + λ e, y_d = 4 + cos 0.2πt, from y = 5, θ = 0, by Runge and Kutta.

    Args: rate: λ, 1/s.
    """

    def target(t: float, y: float) -> float:
        return -0.2 * pi * sin(0.2 * pi * t) + rate * (4 + cos(0.2 * pi * t) - y)

    def slope(t: float, y: float, theta: float) -> tuple[float, float]:
        k = sine_gain(t)
        return k * law(k, theta) * target(t, y), scalar_filter.scalar_slope(k, theta, beta)

    y, theta, steps, half = 5.0, 0.0, round(seconds / dt), dt / 2
    columns = []
    for i in range(steps + 1):
        t = i * dt
        k = sine_gain(t)
        columns.append((t, k, theta, 4 + cos(0.2 * pi * t) - y, law(k, theta) * target(t, y)))
        a, b = slope(t, y, theta)
        c, d = slope(t + half, y + half * a, theta + half * b)
        e, f = slope(t + half, y + half * c, theta + half * d)
        g, h = slope(t + dt, y + dt * e, theta + dt * f)
        y, theta = y + dt / 6 * (a + 2 * c + 2 * e + g), theta + dt / 6 * (b + 2 * d + 2 * f + h)
    return ScalarLoop(*np.array(columns).T)
