"""The filtered inverse of one number: θ follows 1/k, and k may cross zero.

    θ̇ = −β S k,   S = k θ − 1,   u = θ ν   or, with the sign of k, u = θ² k ν

Source: Vargas 2013, §4.1, §4.2, eqs. 4.1–4.15, 4.64.
"""

from __future__ import annotations

from math import exp, expm1, gamma, sqrt

CROSSING = gamma(2 / 3) / 3 ** (1 / 3)


def scalar_slope(k: float, theta: float, beta: float) -> float:
    """θ̇ = −β k (k θ − 1): a low-pass filter of 1/k with the time constant 1/(β k²). Source: Vargas 2013, 4.6, 4.10."""
    return -beta * k * (k * theta - 1)


def scalar_step(k: float, theta: float, beta: float, dt: float) -> float:
    """θ after dt, s, for constant k: 1/k + (θ − 1/k) e^(−β k² dt), and θ at k = 0. Source: Vargas 2013, 4.10."""
    x = beta * k * k * dt
    gained = -expm1(-x) / x if x > 1e-12 else 1.0
    return theta * exp(-x) + beta * k * dt * gained


def modified(k: float, theta: float) -> float:
    """θ_M = θ² k, which has the sign of k. Source: Vargas 2013, eq. 4.64."""
    return theta * theta * k


def worst_case(t: float, k_0: float, beta: float, c: float) -> tuple[float, float]:
    """The k that decreases so that S² = c stays constant, k = k₀/√(2 a k₀² t + 1), and its θ = (1 − √c)/k.

    θ grows as √t; a = β √c/(1 − √c), 0 < c < 1. Returns k, θ at t, s. Source: Vargas 2013, eqs. 4.11–4.15.
    """
    a = beta * sqrt(c) / (1 - sqrt(c))
    k = k_0 / sqrt(2 * a * k_0 * k_0 * t + 1)
    return k, (1 - sqrt(c)) / k


def crossing_peak(beta: float, speed: float) -> float:
    """θ at k = 0 when k crosses zero at a constant speed and θ starts at 1/k: θ = 3^(−1/3) Γ(2/3) (β/|k̇|)^(1/3).

    For a matrix Θ, β = 2γ gives the bound of ‖Θ‖ when a singular value crosses zero.
    Derived from θ̇ = −β k (k θ − 1) with k = k̇ t.
    """
    return float(CROSSING * (beta / abs(speed)) ** (1 / 3))
