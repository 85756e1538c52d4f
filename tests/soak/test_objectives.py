"""Secondary objectives and closed loops with the steps and the lengths of the sources."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.cerbaro_runs import CIRCLE_RANGES, ELLIPSE_RANGES, circle, degrees, demonstration_3, ellipse, within

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
