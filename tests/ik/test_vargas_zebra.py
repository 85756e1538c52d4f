"""Sims. 10 to 13 of Vargas 2013: the position of the Zebra-ZERO through singularities and beyond its reach, cm.

Steps of 2 and 5 ms; the exact step of Θ keeps the numbers of 1 ms within a few per cent where they do not hang on the
step itself. tests/soak has all rows at 1 ms.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.ik.vargas import (
    ARM_SIMS,
    DAMPED,
    FOLDED,
    REACH,
    arm_sim,
    dips,
    effector,
    largest,
    manipulability,
    path_8,
    re_entry,
    rms,
    sizes,
    unreachable,
    zebra_arm,
)

from helicoide.kinematics.forward import link_poses, tool_by_dh
from helicoide.kinematics.library import load

MANIPULABILITY = "damped_by_manipulability"


def test_the_arm_with_three_joints() -> None:
    """p and w of the starts of Sims. 10 and 11b, and `effector` against the robot's file."""
    assert len(zebra_arm().robot.variables) == 3
    for q in np.random.default_rng(0).uniform(-2, 2, (5, 3)):
        p = tool_by_dh(load("zebra_zero"), np.append(q, [0, 0, 0]))[:3, 3]
        np.testing.assert_allclose(effector(q[None])[0], 100 * p, atol=1e-9)
        np.testing.assert_allclose(
            link_poses(zebra_arm().robot.chain, q)[-1] @ zebra_arm().robot.T_link_tool @ [0, 0, 0, 1], [*p, 1]
        )
    np.testing.assert_allclose(effector(FOLDED[None])[0], [39.36, 0, 27.94], atol=1e-9)
    starts = np.array([FOLDED, ARM_SIMS["11b"][1]])
    assert manipulability(starts) == pytest.approx([43_285, 306], abs=0.6)


def test_simulation_10_without_singularity() -> None:
    """δ = 0 throughout: damping is the pseudoinverse; the filtered inverse moves as they do, below 0.2 rad/s."""
    t, q, e, rates = arm_sim("10", MANIPULABILITY, DAMPED, 5e-3, 8)
    np.testing.assert_allclose(arm_sim("10", "pseudoinverse", {}, 5e-3, 8)[1], q, atol=1e-12)
    _, same, e_filtered, softer = arm_sim("10", "filtered", {"gain": 1.0}, 5e-3, 8)
    assert largest(softer[0]) == 0
    assert largest(rates) == pytest.approx(0.842, abs=6e-4)
    for run in (rates, softer):
        assert largest(run, t >= 5) == pytest.approx(0.133, abs=2e-3)
    assert np.abs(same - q)[t >= 5].max() < 2e-3
    assert max(largest(sizes(e), t >= 5), largest(sizes(e_filtered), t >= 5)) < 3e-3


@pytest.mark.parametrize(
    ("name", "options", "fastest", "error", "mean"),
    [
        ("filtered", {"gain": 1.0}, 0.134, 0.0246, 0.0046),
        ("filtered_modified", {"gain": 1.0}, 0.134, 0.0054, None),
        (MANIPULABILITY, DAMPED, 0.139, 0.260, 0.056),
        (MANIPULABILITY, {**DAMPED, "exponent": "2"}, 0.131, 0.189, 0.039),
    ],
)
def test_simulation_11_crosses_singularities(
    name: str, options: dict[str, Any], fastest: float, error: float, mean: float | None
) -> None:
    """Where the pseudoinverse passes 1e4 rad/s; the mean of the modified law hangs on the step of q."""
    t, _, e, rates = arm_sim("11", name, options, 5e-3, 20)
    later = t >= 5
    assert largest(rates, later) == pytest.approx(fastest, abs=6e-4)
    assert largest(sizes(e), later) == pytest.approx(error, rel=0.05)
    assert mean is None or rms(sizes(e[later])) == pytest.approx(mean, rel=0.05)


@pytest.mark.parametrize("step", ["exact", "sylvester"])
def test_a_loop_of_50_hz_is_enough(step: str) -> None:
    """Sim. 11 at 20 ms: the error is 0.0205 cm there; explicit Euler would need 0.193 ms."""
    t, _, e, rates = arm_sim("11", "filtered", {"gain": 1.0, "step": step}, 2e-2, 20)
    assert largest(rates, t >= 5) == pytest.approx(0.134, abs=1e-3)
    assert largest(sizes(e), t >= 5) == pytest.approx(0.0205, rel=0.03 if step == "exact" else 0.2)


@pytest.mark.parametrize(("step", "works"), [(1.9e-4, True), (1e-3, False)])
def test_explicit_euler_in_simulation_11(step: float, works: bool) -> None:
    """Its limit is 0.193 ms: 0.19 ms works as the exact step does, at 1 ms Θ runs away."""
    _, _, _, rates = arm_sim("11", "filtered", {"gain": 1.0, "step": "euler"}, step, 0.5)
    assert np.isfinite(rates).all()
    assert (largest(rates) < 3) == works
    assert (largest(rates) > 1e3) != works


def test_simulation_11b_starts_ill_conditioned() -> None:
    """The filtered inverse tracks from the first seconds on; damping stays on and misses by more than 1 cm."""
    for name in ("filtered", "filtered_modified"):
        t, _, e, rates = arm_sim("11b", name, {"gain": 1.0}, 5e-3, 20)
        assert largest(sizes(e), t >= 5) < 3e-3
        assert largest(rates, t >= 5) == pytest.approx(0.134, abs=6e-4)
    t, q, e, _ = arm_sim("11b", MANIPULABILITY, DAMPED, 5e-3, 20)
    assert manipulability(q).max() < DAMPED["threshold"]
    assert np.mean(sizes(e) > 1) > 0.5
    assert largest(sizes(e), t >= 5) == pytest.approx(5.07, abs=6e-3)


@pytest.mark.parametrize(
    ("gain", "dip", "hertz", "fastest", "error"), [(1.0, 0.135, 1.3, 1.07, None), (25.0, 0.024, 6.6, 2.21, 0.320)]
)
def test_simulation_12_oscillates_out_of_reach(
    gain: float, dip: float, hertz: float, fastest: float, error: float | None
) -> None:
    """Larger γ: smaller and faster; the elbow passes the stretched arm twice in a period."""
    t, q, e, rates = arm_sim("12", "filtered", {"gain": gain}, 2e-3, 15)
    times, depths = dips(t, q)
    assert depths[0] == pytest.approx(dip, rel=0.15)
    assert 0.5 / np.diff(times[:4]).mean() == pytest.approx(hertz, rel=0.1)
    assert largest(rates, t >= 5) == pytest.approx(fastest, rel=0.02)
    assert error is None or largest(sizes(e), (t >= 5) & ~unreachable(t)) == pytest.approx(error, rel=0.02)


def test_simulation_13_rests_out_of_reach_and_comes_back() -> None:
    """Modified law, γ = 25: no dip, 0.013 cm off the radial projection, back within 0.02 cm; damping takes a detour."""
    t, q, e, _ = arm_sim("12", "filtered_modified", {"gain": 25.0}, 2e-3, 15)
    outside = (t > 11.6) & (t < 13.6)
    wished = np.array([path_8(now)[0] for now in t[outside]])
    assert largest(sizes(effector(q[outside]) - REACH * wished / sizes(wished)[:, None])) <= 0.0135
    assert not dips(t, q)[0].size
    assert max(re_entry(t, e)) < 0.02
    t, _, e, _ = arm_sim("12", MANIPULABILITY, DAMPED, 2e-3, 15)
    assert re_entry(t, e)[:2] == pytest.approx((0.57, 1.21), abs=6e-3)
    assert largest(sizes(e), unreachable(t) & (t >= 11)) >= 1.27
