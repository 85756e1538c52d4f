"""The eleven trajectories of Vargas 2013 beside their formulas as the source prints them."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
from tests.trajectory.test_paths import holds_twist

from helicoide.trajectory.vargas import VARGAS

Vectors = tuple[object, object]


def path_1(t: float) -> Vectors:
    return (2 + 0.5 * sin(0.4 * t), 0.5 * cos(0.2 * t), 0), (0.2 * cos(0.4 * t), -0.1 * sin(0.2 * t), 0)


def path_2(t: float) -> Vectors:
    return (2.5 + 0.5 * sin(0.2 * t), 0.5 * cos(0.2 * t), 0), (0.1 * cos(0.2 * t), -0.1 * sin(0.2 * t), 0)


def path_3(t: float) -> Vectors:
    return (2.26 - t / 11, 3.23 - t / 8, 0), (-1 / 11, -1 / 8, 0)


def path_4(t: float) -> Vectors:
    return (0, 4 - t / 8, 0), (0, -1 / 8, 0)


def path_5(t: float) -> Vectors:
    return (2 + 0.5 * sin(0.4 * t), 1, 0), (0.2 * cos(0.4 * t), 0, 0)


def path_6(t: float) -> Vectors:
    rates = (pi * cos(0.2 * pi * t), 0.75 * pi * cos(0.1 * pi * t), 0)
    return (5 * sin(0.2 * pi * t) + 45.86, 7.5 * sin(0.1 * pi * t), 0), rates


def path_7(t: float) -> Vectors:
    rates = (0, pi * cos(0.2 * pi * t), 0.75 * pi * cos(0.1 * pi * t))
    return (0, 5 * sin(0.2 * pi * t), 7.5 * sin(0.1 * pi * t) + 53.86), rates


def path_8(t: float) -> Vectors:
    rates = (pi * cos(0.2 * pi * t), 0.75 * pi * cos(0.1 * pi * t), 0)
    return (5 * sin(0.2 * pi * t) + 63.36, 7.5 * sin(0.1 * pi * t), 0), rates


def path_9(t: float) -> Vectors:
    y = 7.5 * (sin(0.1 * pi * t) + sin(0.15 * pi * t)) + 5
    z = 7.5 * (sin(0.1 * pi * t + 1.6) + sin(0.15 * pi * t + 1.6))
    y_rate = 7.5 * pi * (0.1 * cos(0.1 * pi * t) + 0.15 * cos(0.15 * pi * t))
    z_rate = 7.5 * pi * (0.1 * cos(0.1 * pi * t + 1.6) + 0.15 * cos(0.15 * pi * t + 1.6))
    return (60, y, z), (0, y_rate, z_rate)


def path_10(t: float) -> Vectors:
    return (14.6 * sin(0.2 * t) + 15.5, 7 * cos(0.2 * t), 20), (2.92 * cos(0.2 * t), -1.4 * sin(0.2 * t), 0)


def path_11(t: float) -> Vectors:
    return (14.6 * sin(0.2 * t) + 30.5, 7 * cos(0.2 * t), 20), (2.92 * cos(0.2 * t), -1.4 * sin(0.2 * t), 0)


PRINTED = [path_1, path_2, path_3, path_4, path_5, path_6, path_7, path_8, path_9, path_10, path_11]
METRES = [1.0] * 5 + [0.01] * 6
# Where each begins, in the unit of the source.
STARTS = [
    (2, 0.5, 0), (2.5, 0.5, 0), (2.26, 3.23, 0), (0, 4, 0), (2, 1, 0), (45.86, 0, 0), (0, 0, 53.86), (63.36, 0, 0),
    (60, 5, 15 * sin(1.6)), (15.5, 7, 20), (30.5, 7, 20),
]  # fmt: skip


@pytest.mark.parametrize("number", range(1, 12))
def test_they_are_the_printed_formulas(number: int) -> None:
    path, printed, metre = VARGAS[number], PRINTED[number - 1], METRES[number - 1]
    for t in np.linspace(0, path.duration, 41):
        x, v = printed(float(t))
        np.testing.assert_allclose(path.pose(t)[:3, 3], np.multiply(metre, x), rtol=0, atol=1e-14)
        np.testing.assert_allclose(path.twist(t), [*np.multiply(metre, v), 0, 0, 0], rtol=0, atol=1e-14)
    np.testing.assert_allclose(path.pose(0.0)[:3, 3], np.multiply(metre, STARTS[number - 1]), rtol=0, atol=1e-14)


@pytest.mark.parametrize("number", VARGAS)
def test_twists_and_closedness(number: int) -> None:
    path = VARGAS[number]
    for s in (0.1, 0.45, 0.8):
        holds_twist(path, s)
    assert path.is_closed == (number not in (3, 4))
    meets = np.allclose(path.pose(path.duration), path.pose(0.0), rtol=0, atol=1e-12)
    assert meets == path.is_closed


@pytest.mark.parametrize("number", [n for n in VARGAS if VARGAS[n].is_closed])
def test_the_period_is_the_shortest(number: int) -> None:
    path = VARGAS[number]
    for part in (2, 3, 4, 5):
        later = [path.point(t + path.duration / part) - path.point(t) for t in np.linspace(0, path.duration, 50)]
        assert np.abs(later).max() > 0.1 * path.unit


def test_where_they_leave_the_reach_and_pass_the_origin() -> None:
    """3 comes nearest to the origin at 25.50 s (0.072), 4 is there at 32 s; 8 leaves the reach of 67.30 cm, by 1.27.

    Recomputed from the formulas of the source.
    """
    times = np.linspace(0, 40, 40_001)
    far = np.array([np.linalg.norm(VARGAS[3].point(t)) for t in times])
    assert times[far.argmin()] == pytest.approx(25.50, abs=0.005)
    assert far.min() == pytest.approx(0.072, abs=5e-4)
    np.testing.assert_allclose(VARGAS[4].point(32.0), np.zeros(3), atol=1e-15)
    beyond = np.array([np.linalg.norm(VARGAS[8].point(t)) for t in np.linspace(0, 20, 20_001)]) - 0.6730
    assert beyond.max() == pytest.approx(0.0127, abs=5e-5)
    assert np.mean(beyond > 0) == pytest.approx(0.23, abs=0.005)


def test_the_tool_on_10_and_11() -> None:
    """Sims. 3 and 14: R_y(π/2) and R_y(π)."""
    np.testing.assert_allclose(VARGAS[10].pose(1.0)[:3, :3], [[0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    np.testing.assert_allclose(VARGAS[11].pose(1.0)[:3, :3], [[-1, 0, 0], [0, 1, 0], [0, 0, -1]])
