"""The cubic spline: through its samples, twice differentiable, and the one that scipy finds for the same end slopes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from helicoide.arrays import Array
from helicoide.text import HelicoideError
from helicoide.trajectory.spline import JointSpline


def random(knots: int, seed: int, joints: int = 3) -> JointSpline:
    rng = np.random.default_rng(seed)
    s = np.append(0.0, np.cumsum(rng.uniform(0.2, 1.0, knots - 1)))
    return JointSpline(s, rng.normal(size=(knots, joints)))


@pytest.mark.parametrize("knots", [2, 3, 4, 5, 17])
def test_it_goes_through_its_samples_exactly(knots: int) -> None:
    path = random(knots, knots)
    np.testing.assert_array_equal(path.q(path.knots), path.samples)
    assert path.duration == path.knots[-1]
    assert not path.is_closed


@pytest.mark.parametrize("knots", [2, 3, 4, 9])
def test_it_is_the_spline_of_its_end_slopes(knots: int) -> None:
    path = random(knots, 100 + knots)
    first, last = path.rates(0.0), path.rates(path.duration)
    other = CubicSpline(path.knots, path.samples, bc_type=((1, first), (1, last)))
    s = np.linspace(0, path.duration, 101)
    np.testing.assert_allclose(path.q(s), other(s), atol=1e-12)
    np.testing.assert_allclose(path.rates(s), other(s, 1), atol=1e-11)
    np.testing.assert_allclose(path.accelerations(s), other(s, 2), atol=1e-10)


def test_two_derivatives_are_continuous() -> None:
    path, inside = random(8, 3), 1e-9
    for s in path.knots[1:-1]:
        for function in (path.q, path.rates, path.accelerations):
            np.testing.assert_allclose(function(s - inside), function(s + inside), atol=1e-6)


def cubic(s: Array) -> Array:
    return np.stack([1 + s - 2 * s**2 + 0.5 * s**3, s**3], axis=-1)


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_polynomial_up_to_a_cubic_is_met_everywhere(degree: int) -> None:
    """From as many samples as it needs."""
    knots = np.array([0.0, 0.4, 1.5, 1.9, 3.0])[: degree + 1]
    powers = np.arange(degree + 1)
    coefficients = np.array([0.3, -1.0, 0.7, 0.2])[: degree + 1]
    path = JointSpline(knots, np.sum(coefficients * knots[:, None] ** powers, axis=1)[:, None])
    s = np.linspace(0, knots[-1], 50)
    np.testing.assert_allclose(path.q(s)[:, 0], np.sum(coefficients * s[:, None] ** powers, axis=1), atol=1e-13)


def test_it_comes_nearer_with_the_fourth_power_of_the_step() -> None:
    def missed(samples: int) -> float:
        knots, s = np.linspace(0, 3, samples), np.linspace(0, 3, 999)
        return float(np.abs(JointSpline(knots, np.sin(knots)[:, None]).q(s)[:, 0] - np.sin(s)).max())

    assert missed(41) < missed(21) / 12
    assert missed(101) < 1e-7


def test_it_closes_where_its_samples_do() -> None:
    path = JointSpline(np.array([0.0, 1.0, 2.0]), np.array([[0.5], [1.0], [0.5]]))
    assert path.is_closed


@pytest.mark.parametrize(
    ("knots", "samples"),
    [
        ([0.0], [[1.0]]),
        ([0.0, 1.0], [[1.0]]),
        ([0.0, 0.0], [[1.0], [2.0]]),
        ([0.5, 1.0], [[1.0], [2.0]]),
        ([0.0, np.inf], [[1.0], [2.0]]),
        ([0.0, 1.0], [[1.0], [np.nan]]),
        ([0.0, 1.0], [1.0, 2.0]),
    ],
)
def test_samples_that_are_no_path_are_refused(knots: list[float], samples: list[list[float]]) -> None:
    with pytest.raises(HelicoideError, match="two or more times that rise from 0"):
        JointSpline(np.array(knots), np.array(samples))
