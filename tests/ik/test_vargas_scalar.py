"""The scalar filtered inverse against its equation, Sims. 8 and 9 of Vargas 2013, the worst case and the crossing."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, exp, pi, sin

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helicoide.ik import scalar_filter
from helicoide.kinematics.chain import Array


def integrated(slope: Callable[[float, Array], list[float]], y: list[float], times: Array) -> Array:
    """Solutions y (…, k) at the given times."""
    run = solve_ivp(slope, (times[0], times[-1]), y, "LSODA", times, rtol=1e-10, atol=1e-12)
    return np.asarray(run.y)


@pytest.mark.parametrize("k", [2.0, 0.5, -1.3, 1e-7, 0.0])
def test_the_exact_step_is_the_differential_equation(k: float) -> None:
    ends = integrated(lambda t, y: [scalar_filter.slope(k, y[0], 5)], [1.0], np.array([0, 0.4]))[0]
    assert scalar_filter.stepped(k, 1.0, 5, 0.4) == pytest.approx(ends[-1], rel=1e-8)


@pytest.mark.parametrize(
    ("k", "ends"),
    [
        (lambda t: 2.0, (0.5, 0.5, 0.5)),
        (lambda t: 0.5, (1.7135, 1.9981, 2.000)),
        (lambda t: 0.0, (1, 1, 1)),
        (lambda t: 2 * exp(-0.5 * t), (0.7771, 2.7376, 3.8321)),
    ],
)
def test_simulation_8(k: Callable[[float], float], ends: tuple[float, ...]) -> None:
    """θ at 1, 5, 10 s, from 1 with β = 5; by the integrator and by steps of 1 ms with k in their middle."""
    times = np.array([0.0, 1, 5, 10])
    theta = integrated(lambda t, y: [scalar_filter.slope(k(t), y[0], 5)], [1.0], times)[0]
    assert theta[1:] == pytest.approx(ends, abs=6e-5)
    at, stepped = 1.0, []
    for i in range(10_000):
        at = scalar_filter.stepped(k((i + 0.5) * 1e-3), at, 5, 1e-3)
        stepped += [at] if i + 1 in (1000, 5000, 10_000) else []
    assert stepped == pytest.approx(ends, abs=6e-5)


def test_time_constants_and_the_limit_of_a_fading_k() -> None:
    """τ = 1/(βk²) is 0.05 and 0.8 s; with k = 2 e^(−t/2) θ ends at 3.963."""
    for k, tau in ((2.0, 0.05), (0.5, 0.8)):
        assert (scalar_filter.stepped(k, 0.0, 5, tau) - 1 / k) * -k == pytest.approx(exp(-1))
    last = integrated(lambda t, y: [scalar_filter.slope(2 * exp(-0.5 * t), y[0], 5)], [1.0], np.array([0.0, 60]))
    assert last[0, -1] == pytest.approx(3.963, abs=6e-4)


@pytest.mark.parametrize(
    ("beta", "theta_max", "filtered", "modified"),
    [
        (10, 1.951, (1.363, 0.349, 8.96), (0.368, 0.123, 2.36)),
        (100, 4.069, (0.379, 0.077, 7.67), (0.222, 0.052, 4.44)),
        (1000, 8.715, (0.150, 0.024, 9.95), (0.120, 0.021, 7.43)),
    ],
)
def test_simulation_9(beta: float, theta_max: float, filtered: tuple[float, ...], modified: tuple[float, ...]) -> None:
    """k = sin 0.4πt, y_d = 4 + cos 0.2πt, λ = 10, 1 ≤ t ≤ 20 s: max and rms of e, max of u, for both laws."""

    def k(t: float) -> float:
        return sin(0.4 * pi * t)

    def rate(t: float, y: float) -> float:
        return -0.2 * pi * sin(0.2 * pi * t) + 10 * (4 + cos(0.2 * pi * t) - y)

    for law, expected in ((lambda k, theta: theta, filtered), (scalar_filter.modified, modified)):

        def slope(t: float, y: Array, law: Callable[[float, float], float] = law) -> list[float]:
            return [k(t) * law(k(t), y[1]) * rate(t, y[0]), scalar_filter.slope(k(t), y[1], beta)]

        times = np.append(0, np.linspace(1, 20, 19_001))
        y, theta = integrated(slope, [5.0, 0.0], times)[:, 1:]
        e = 4 + np.cos(0.2 * pi * times[1:]) - y
        u = np.array([law(k(t), a) * rate(t, b) for t, a, b in zip(times[1:], theta, y, strict=True)])
        assert np.abs(theta).max() == pytest.approx(theta_max, abs=6e-4)
        assert (np.abs(e).max(), np.sqrt(np.mean(e**2))) == pytest.approx(expected[:2], abs=6e-4)
        assert np.abs(u).max() == pytest.approx(expected[2], abs=6e-3)


def test_the_worst_case() -> None:
    """β = 5, c = 0.25, k₀ = 1: S = −0.5 throughout, θ(10, 100, 1000) = 5.025, 15.82, 50.00."""
    times = np.array([0.0, 10, 100, 1000])
    found = [scalar_filter.worst_case(t, 1.0, 5, 0.25) for t in times]
    assert [k * theta - 1 for k, theta in found] == pytest.approx([-0.5] * 4)
    assert [theta for _, theta in found][1:] == pytest.approx([5.025, 15.82, 50.00], abs=6e-3)

    def slope(t: float, y: Array) -> list[float]:
        return [scalar_filter.slope(scalar_filter.worst_case(t, 1.0, 5, 0.25)[0], y[0], 5)]

    np.testing.assert_allclose(integrated(slope, [0.5], times)[0], [theta for _, theta in found], rtol=1e-6)


@pytest.mark.parametrize(("beta", "speed"), [(2.0, 0.5), (100.0, 1.0)])
def test_crossing_zero(beta: float, speed: float) -> None:
    """From a converged θ: peak 0.9389 (β/k̇)^⅓ at k = 0, S in [−1.427, 0.077], |θ_M| ≤ 0.5124 (β/k̇)^⅓."""
    size = (beta / speed) ** (1 / 3)
    times = np.linspace(-40, 40, 40_001) / (size * speed)
    k = -speed * times  # k/|k̇| counts in lengths of (β/k̇)^(−1/3)
    theta = integrated(lambda t, y: [scalar_filter.slope(-speed * t, y[0], beta)], [1 / k[0]], times)[0]
    assert theta[k.size // 2] == pytest.approx(scalar_filter.crossing_peak(beta, speed), rel=1e-5)
    assert theta.max() / size == pytest.approx(0.9389, abs=1e-4)
    assert np.abs(scalar_filter.modified(k, theta)).max() / size == pytest.approx(0.5124, abs=1e-4)
    S = k * theta - 1
    assert (S.min(), S.max()) == (pytest.approx(-1.427, abs=1e-3), pytest.approx(0.077, abs=1e-3))


def test_feed_forward_forbids_the_crossing() -> None:
    """With −θ² k̇ added, β = 100, θ runs away while k → 0 (and would be 1/k exactly if it began there)."""

    def slope(t: float, y: Array) -> list[float]:
        return [scalar_filter.slope(1 - t, y[0], 100) + y[0] ** 2]

    times = np.array([0.0, 0.9, 0.99, 0.999])
    np.testing.assert_allclose(integrated(slope, [1.0], times)[0], [1, 10, 100, 1000], rtol=1e-5)
    assert integrated(lambda t, y: [scalar_filter.slope(1 - t, y[0], 100)], [1.0], times)[0].max() < 7
