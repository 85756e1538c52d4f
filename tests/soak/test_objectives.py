"""Secondary objectives and closed loops with the steps and the lengths of the sources."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.vargas_runs import barrier, in_a_slab, obstacle_at_the_links, obstacle_at_the_tool, two_arms

pytestmark = pytest.mark.soak

# Vargas 2013, §4.7; digest §6.7, §6.8.


@pytest.mark.parametrize(
    ("half", "lowest", "highest", "error", "rms", "speed"),
    [
        (None, -1.623, -1.121, 2e-4, 1e-4, 0.097),
        (0.5, -1.290, -0.590, 5e-4, 2e-4, 0.144),
        (0.2, -1.156, -0.843, 0.055, 0.015, 0.474),
    ],
)
def test_simulation_15(
    half: float | None, lowest: float, highest: float, error: float, rms: float, speed: float
) -> None:
    run = barrier(half, 1e-3).since(3.0)
    assert (run.q[:, 1].min(), run.q[:, 1].max()) == pytest.approx((lowest, highest), abs=6e-4)
    assert run.error.max() == pytest.approx(error, abs=6e-5 if error < 1e-3 else 5e-4)
    assert np.sqrt(np.mean(run.error**2)) == pytest.approx(rms, abs=6e-5 if error < 1e-3 else 5e-4)
    assert run.fastest.max() == pytest.approx(speed, abs=6e-4)


@pytest.mark.parametrize(
    ("weight", "closest", "error"),
    [
        (0.1, 0.251, 0.0015),
        (0.5, 0.271, 0.022),
        (1, 0.294, 0.046),
        (2, 0.325, 0.077),
        (5, 0.367, 0.12),
        (10, 0.399, 0.152),
    ],
)
def test_simulation_16(weight: float, closest: float, error: float) -> None:
    assert obstacle_at_the_tool(weight, 1e-3) == pytest.approx((closest, error), abs=6e-4)


@pytest.mark.parametrize(
    ("mu", "per_link", "distance", "error"),
    [
        ((0.6, 1.15), 0, 0.084, 1e-4),
        ((0.6, 1.15), 8, 0.413, 0.0075),
        ((0.6, 1.15), 1, 0.084, 1e-4),
        ((0.85, 1.55), 0, 0.151, 1e-4),
        ((0.85, 1.55), 8, 0.437, 0.011),
        ((0.85, 1.55), 1, 0.337, 0.006),
        ((1.5, 1.75), 0, 0.002, 1e-4),
        ((1.5, 1.75), 8, 0.409, 0.025),
        ((1.5, 1.75), 1, 0.030, 0.017),
    ],
)
def test_an_obstacle_beside_the_links(mu: tuple[float, float], per_link: int, distance: float, error: float) -> None:
    """The errors without a term, and with one point per link, are ours."""
    assert obstacle_at_the_links(mu, per_link, 1e-3, 32) == pytest.approx((distance, error), abs=6e-4)


@pytest.mark.parametrize(
    ("weight", "distance", "error", "speed"),
    [(0.0, 0.001, 0.0, 0.11), (1.0, 0.011, 0.94, 2.6), (5.0, 0.133, 0.50, 1.0)],
)
def test_a_second_arm_in_motion(weight: float, distance: float, error: float, speed: float) -> None:
    """The digest does not say between which points it measures the distance, so that it is met to 2 mm or 0.011 only.

    With α = 5 it is that at 3 s, where the arms are still parting.
    """
    found, run = two_arms(weight, 2e-3, 32)
    assert found == pytest.approx(distance, abs=0.011 if weight == 1 else 2e-3)
    assert run.error.max() == pytest.approx(error, abs=5e-3)
    assert run.fastest.max() == pytest.approx(speed, abs=0.05)


@pytest.mark.parametrize(
    ("weight", "steepness", "widest", "at_start"),
    [(0.0, 10, 0.500, 0.5), (5.0, 10, 0.249, 0.249), (1.0, 10, 0.270, 0.270), (5.0, 3, 0.178, 0.198)],
)
def test_the_slab(weight: float, steepness: int, widest: float, at_start: float) -> None:
    y, run = in_a_slab(weight, steepness, 5e-4, 32)
    assert np.abs(y[run.t >= 3]).max() == pytest.approx(widest, abs=6e-4)
    assert np.abs(y).max() == pytest.approx(at_start, abs=6e-4)
    if weight == 5 and steepness == 10:
        assert run.since(3.0).fastest.max() == pytest.approx(0.111, abs=6e-4)
