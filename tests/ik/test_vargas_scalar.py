"""The scalar filtered inverse against its equation, by an integrator that knows the slope only (Vargas 2013, ch. 4)."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helicoide.arrays import Array
from helicoide.ik import scalar_filter
from helicoide.studies.vargas.scalar import scalar_closed_loop, scalar_filter_steps
from helicoide.studies.vargas_08 import CASES
from helicoide.studies.vargas_09 import LAWS


def integrated(slope: Callable[[float, Array], list[float]], y: list[float], times: Array) -> Array:
    """Solutions y (…, k) at the given times."""
    run = solve_ivp(slope, (times[0], times[-1]), y, "LSODA", times, rtol=1e-10, atol=1e-12)
    return np.asarray(run.y)


@pytest.mark.parametrize("k", [2.0, 0.5, -1.3, 1e-7, 0.0])
def test_the_exact_step_is_the_differential_equation(k: float) -> None:
    ends = integrated(lambda t, y: [scalar_filter.scalar_slope(k, y[0], 5)], [1.0], np.array([0, 0.4]))[0]
    assert scalar_filter.scalar_step(k, 1.0, 5, 0.4) == pytest.approx(ends[-1], rel=1e-8)


@pytest.mark.parametrize("name", CASES)
def test_simulation_8_is_the_differential_equation(name: str) -> None:
    """Steps of 1 ms with k in their middle."""
    k = CASES[name]
    times = np.linspace(0, 10, 101)
    theta = integrated(lambda t, y: [scalar_filter.scalar_slope(k(t), y[0], 5)], [1.0], times)[0]
    np.testing.assert_allclose(scalar_filter_steps(k, 1.0, 5, 1e-3, 0.0, 10.0)[::100], theta, rtol=1e-6)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("beta", [10, 1000])
def test_simulation_9_is_the_differential_equation(beta: float, law: str) -> None:
    """Steps of Runge and Kutta, 0.5 ms."""

    def k(t: float) -> float:
        return sin(0.4 * pi * t)

    def rate(t: float, y: float) -> float:
        return -0.2 * pi * sin(0.2 * pi * t) + 10 * (4 + cos(0.2 * pi * t) - y)

    def slope(t: float, y: Array) -> list[float]:
        return [k(t) * LAWS[law](k(t), y[1]) * rate(t, y[0]), scalar_filter.scalar_slope(k(t), y[1], beta)]

    times = np.linspace(0, 20, 401)
    y, theta = integrated(slope, [5.0, 0.0], times)
    loop = scalar_closed_loop(LAWS[law], beta, 5e-4, 20.0)
    np.testing.assert_allclose(loop.theta[::100], theta, atol=1e-6)
    np.testing.assert_allclose(loop.e[::100], 4 + np.cos(0.2 * pi * times) - y, atol=1e-6)
    u = [LAWS[law](k(t), a) * rate(t, b) for t, a, b in zip(times, theta, y, strict=True)]
    np.testing.assert_allclose(loop.u[::100], u, atol=1e-5)


def test_the_worst_case_solves_its_equation() -> None:
    """β = 5, c = 0.25, k₀ = 1: S² = c at each time, and θ as the law of the filter has it."""
    times = np.array([0.0, 10, 100, 1000])
    found = [scalar_filter.worst_case(t, 1.0, 5, 0.25) for t in times]
    assert [k * theta - 1 for k, theta in found] == pytest.approx([-0.5] * 4)

    def slope(t: float, y: Array) -> list[float]:
        return [scalar_filter.scalar_slope(scalar_filter.worst_case(t, 1.0, 5, 0.25)[0], y[0], 5)]

    np.testing.assert_allclose(integrated(slope, [0.5], times)[0], [theta for _, theta in found], rtol=1e-6)


@pytest.mark.parametrize(("beta", "speed"), [(2.0, 0.5), (100.0, 1.0)])
def test_crossing_zero(beta: float, speed: float) -> None:
    """From a converged θ: the peak of the formula at k = 0; vargas_scalar has its numbers."""
    times = np.linspace(-40, 40, 40_001) / ((beta / speed) ** (1 / 3) * speed)
    theta = integrated(
        lambda t, y: [scalar_filter.scalar_slope(-speed * t, y[0], beta)], [-1 / (speed * times[0])], times
    )[0]
    assert theta[times.size // 2] == pytest.approx(scalar_filter.crossing_peak(beta, speed), rel=1e-5)
    assert theta.max() == pytest.approx(scalar_filter.crossing_peak(beta, speed), rel=1e-5)


def test_feed_forward_forbids_the_crossing() -> None:
    """With −θ² k̇ added, β = 100, θ runs away while k → 0 (and would be 1/k exactly if it began there)."""

    def slope(t: float, y: Array) -> list[float]:
        return [scalar_filter.scalar_slope(1 - t, y[0], 100) + y[0] ** 2]

    times = np.array([0.0, 0.9, 0.99, 0.999])
    np.testing.assert_allclose(integrated(slope, [1.0], times)[0], [1, 10, 100, 1000], rtol=1e-5)
    assert integrated(lambda t, y: [scalar_filter.scalar_slope(1 - t, y[0], 100)], [1.0], times)[0].max() < 7
