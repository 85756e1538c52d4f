"""Secondary objectives and closed loops with the steps and the lengths of the sources."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.cerbaro_runs import CIRCLE_RANGES, ELLIPSE_RANGES, circle, degrees, demonstration_3, ellipse, within
from tests.ik.vargas_runs import barrier, in_a_slab, obstacle_at_the_links, obstacle_at_the_tool, two_arms

pytestmark = pytest.mark.soak

# Cerbaro 2022, §4.4.3–4.4.4: 60 s in steps of 1 ms; digest §3.6.


def test_the_circle_of_the_orca() -> None:
    run = circle(1e-3)
    within(run, CIRCLE_RANGES, 0.006)
    assert run.error.max() == pytest.approx(1.1e-6, rel=0.1)
    assert np.abs(run.q.sum(axis=1)).max() < 2e-15
    assert np.degrees(run.fastest.max()) == pytest.approx(3.91, abs=0.006)
    assert circle(1e-3, 0, 0).error[-1] == pytest.approx(0.009, rel=0.05)


def test_the_ellipse_of_the_movemaster() -> None:
    run = ellipse(1e-3)
    within(run, ELLIPSE_RANGES, 0.06)
    assert run.error.max() == pytest.approx(6e-7, rel=0.1)
    assert np.abs(run.q[:, 1:4].sum(axis=1) + np.pi / 3).max() == pytest.approx(1e-6, rel=0.2)
    assert np.degrees(run.fastest.max()) == pytest.approx(2.74, abs=0.006)


def test_the_ellipse_without_orientation() -> None:
    plain, pushed = (demonstration_3("movemaster", k0, 1e-3) for k0 in (0.0, 500.0))
    assert degrees(plain, 3) == pytest.approx((-130.8, -98.4), abs=0.06)
    assert degrees(plain, 4) == pytest.approx((12.4, 22.9), abs=0.06)
    assert degrees(pushed, 3) == pytest.approx((-129.9, -72.0), abs=0.06)
    assert degrees(pushed, 4) == pytest.approx((-60.4, 13.5), abs=0.06)
    assert pushed.error.max() == pytest.approx(0.007, abs=2e-4)
    assert np.degrees(pushed.fastest.max()) == pytest.approx(650, abs=5)


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
