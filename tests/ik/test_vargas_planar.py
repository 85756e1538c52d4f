"""Sims. 1, 2 and 4 to 7 of Vargas 2013: the planar arm, at coarser steps than in tests/soak where the numbers allow."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from tests.ik.vargas import (
    DAMPED_PLANAR,
    FEEDBACK,
    IN_PLANE,
    WITH_ANGLE,
    largest,
    left_at,
    path_1,
    planar,
    planar_sim,
    record,
    sizes,
    tracking,
    turned,
)

MANIPULABILITY = "damped_by_manipulability"


def first_sim(name: str, with_angle: bool, gain: float, options: dict[str, Any], seconds: float) -> Any:
    """Sim. 1, position and angle π/2, or 2, position alone."""
    arm = planar()
    R, rows = (turned(2, pi / 2), WITH_ANGLE) if with_angle else (None, IN_PLANE)
    aiming = tracking(arm, path_1, rows, R, 1.0, "rotation vector")
    return record(arm, name, options, aiming, gain, [pi / 6] * 3, 1e-3, seconds)


@pytest.mark.parametrize(("name", "with_angle"), [("inverse", True), ("pseudoinverse", False)])
@pytest.mark.parametrize(
    ("gain", "slope", "after_1", "after_3"), [(1.0, -1.001, 0.874, 0.118), (2.0, -2.002, 0.321, 0.0059)]
)
def test_the_error_decays_with_its_gain(
    name: str, with_angle: bool, gain: float, slope: float, after_1: float, after_3: float
) -> None:
    """Sims. 1 and 2: ln‖e‖ falls with the slope −λ."""
    t, _, e, rates = first_sim(name, with_angle, gain, {}, 3)
    size, between = sizes(e), (t > 0.5) & (t < 3)
    assert np.polyfit(t[between], np.log(size[between]), 1)[0] == pytest.approx(slope, abs=6e-4)
    assert size[[1000, 3000]] == pytest.approx([after_1, after_3], rel=0.01)
    if gain == 2:
        assert largest(rates) == pytest.approx(9.42 if with_angle else 2.86, abs=0.006)


@pytest.mark.parametrize(("with_angle", "fastest"), [(True, 1.61), (False, 1.69)])
def test_the_filtered_inverse_starts_softly(with_angle: bool, fastest: float) -> None:
    _, _, _, rates = first_sim("filtered", with_angle, 2.0, {"gain": 5.0}, 3)
    assert largest(rates) == pytest.approx(fastest, abs=0.006)


def test_simulation_4_needs_no_damping() -> None:
    """Trajectory 2: δ = 0 throughout, so that damping by manipulability is the pseudoinverse; all are alike."""
    runs = {
        name: planar_sim(4, name, options, 1e-2, 40)
        for name, options in {
            "pseudoinverse": {},
            MANIPULABILITY: DAMPED_PLANAR,
            "filtered": {"gain": 5.0},
            "filtered_modified": {"gain": 5.0},
        }.items()
    }
    np.testing.assert_allclose(runs[MANIPULABILITY][1], runs["pseudoinverse"][1], atol=1e-12)
    for t, _, e, rates in runs.values():
        assert largest(rates, t >= 5) == pytest.approx(0.0469, abs=3e-4)
        assert largest(sizes(e), t >= 5) < 2e-3


@pytest.mark.parametrize(
    ("name", "options", "fastest", "error"),
    [
        (MANIPULABILITY, DAMPED_PLANAR, 0.93, 0.187),
        ("filtered", {"gain": 5.0}, 1.19, 0.310),
        ("filtered_modified", {"gain": 5.0}, 1.73, 0.443),
    ],
)
def test_simulation_5_passes_near_the_origin(name: str, options: dict[str, Any], fastest: float, error: float) -> None:
    t, _, e, rates = planar_sim(5, name, options, 5e-3, 30)
    assert largest(rates, t >= 5) == pytest.approx(fastest, rel=0.02)
    assert largest(sizes(e), t >= 5) == pytest.approx(error, rel=0.02)


@pytest.mark.parametrize(
    ("name", "options", "when"),
    [("feedback", FEEDBACK, 0.66), ("filtered", {"gain": 5.0, "start": "ones"}, 0.65)],
)
def test_simulation_6_leaves_a_singular_start(name: str, options: dict[str, Any], when: float) -> None:
    """Only a coupling of the rows, or a Θ that knows the lost direction, moves the stretched arm."""
    t, q, _, _ = planar_sim(6, name, options, 1e-3, 1)
    assert left_at(q, t) == pytest.approx(when, abs=0.006)


@pytest.mark.parametrize(
    ("name", "options", "seconds"),
    [
        ("filtered_modified", {"gain": 5.0}, 40),
        ("filtered_modified", {"gain": 5.0, "start": "ones"}, 20),
        ("filtered", {"gain": 5.0}, 2),
        ("feedback", {**FEEDBACK, "coupling": 0.0}, 1),
        (MANIPULABILITY, DAMPED_PLANAR, 2),
    ],
)
def test_simulation_6_or_stays(name: str, options: dict[str, Any], seconds: float) -> None:
    """The modified law never leaves, whatever Θ(0), since Jᵀν = 0; the others later, and by rounding alone."""
    t, q, _, _ = planar_sim(6, name, options, 1e-2, seconds)
    assert left_at(q, t) == np.inf


@pytest.mark.parametrize(
    ("name", "options", "fastest", "error"),
    [
        (MANIPULABILITY, DAMPED_PLANAR, 0.795, 0.184),
        ("filtered", {"gain": 5.0}, 1.37, 0.530),
        ("filtered", {"gain": 50.0}, 1.38, 0.162),
    ],
)
def test_simulation_7_passes_through_the_origin(
    name: str, options: dict[str, Any], fastest: float, error: float
) -> None:
    """The pseudoinverse is at hundreds of rad/s here; a larger γ leaves a smaller error at the same speed."""
    t, _, e, rates = planar_sim(7, name, options, 5e-3, 40)
    assert largest(rates, t >= 5) == pytest.approx(fastest, rel=0.02)
    assert largest(sizes(e), t >= 5) == pytest.approx(error, rel=0.02)
