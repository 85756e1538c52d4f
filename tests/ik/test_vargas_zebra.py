"""The Zebra-ZERO of Vargas 2013 with three joints, and how long a step of Sim. 11 may be."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.kinematics.forward import link_poses, tool_by_dh
from helicoide.kinematics.library import load_robot
from helicoide.studies.vargas.arms import FOLDED, NEARLY_UPRIGHT, zebra_arm
from helicoide.studies.vargas.paths import path_7, path_points
from helicoide.studies.vargas.position_arm import run_on_zebra
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, method_settings


def effector(q: Array) -> Array:
    """Where the effector is while the last three joints are at 0, cm: App. B in closed form. Args: q (k, 3)."""
    q1, q2, q3 = q.T
    r = 27.94 * np.cos(q2) - 39.36 * np.sin(q2 + q3)
    return np.stack([r * np.cos(q1), r * np.sin(q1), 27.94 * np.sin(q2) + 39.36 * np.cos(q2 + q3)], axis=1)


def manipulability(q: Array) -> Array:
    """w of the position, cm³, by central differences of `effector`. Args: q (k, 3)."""
    columns = [(effector(q + way) - effector(q - way)) / 2e-5 for way in 1e-5 * np.eye(3)]
    return np.abs(np.linalg.det(np.stack(columns, axis=-1)))


def crossing(dt: float, seconds: float, **options: object) -> MethodRun:
    """Sim. 11 by the filtered inverse, γ = 1."""
    ways = {"filtered": method_settings("filtered", gain=1.0, **options)}
    return run_on_zebra(path_7, FOLDED, ways, dt, seconds, lambda share: None)["filtered"]


def test_the_arm_with_three_joints() -> None:
    """p and w of the starts of Sims. 10 and 11b, and `effector` against the robot's file."""
    assert len(zebra_arm().robot.variables) == 3
    for q in np.random.default_rng(0).uniform(-2, 2, (5, 3)):
        p = tool_by_dh(load_robot("zebra_zero"), np.append(q, [0, 0, 0]))[:3, 3]
        np.testing.assert_allclose(effector(q[None])[0], 100 * p, atol=1e-9)
        np.testing.assert_allclose(
            link_poses(zebra_arm().robot.chain, q)[-1] @ zebra_arm().robot.T_link_tool @ [0, 0, 0, 1], [*p, 1]
        )
    np.testing.assert_allclose(effector(FOLDED[None])[0], [39.36, 0, 27.94], atol=1e-9)
    assert manipulability(np.array([FOLDED, NEARLY_UPRIGHT])) == pytest.approx([43_285, 306], abs=0.6)


def test_a_run_knows_where_the_effector_is() -> None:
    """p = p_d − e, and w of J, against the closed form."""
    run = crossing(1e-2, 1.0)
    np.testing.assert_allclose(path_points(path_7, run.t) - run.e, effector(run.q), atol=1e-9)
    np.testing.assert_allclose(run.w, manipulability(run.q), rtol=1e-5, atol=1e-2)


@pytest.mark.parametrize("step", ["exact", "sylvester"])
def test_a_loop_of_50_hz_is_enough(step: str) -> None:
    """Sim. 11 at 20 ms: the error is 0.0205 cm there; explicit Euler would need 0.193 ms."""
    run = crossing(2e-2, 20, step=step)
    assert largest_absolute(run.joint_velocities, run.t >= 5) == pytest.approx(0.134, abs=1e-3)
    assert largest_absolute(run.error_norm, run.t >= 5) == pytest.approx(0.0205, rel=0.03 if step == "exact" else 0.2)


@pytest.mark.parametrize(("step", "works"), [(1.9e-4, True), (1e-3, False)])
def test_explicit_euler_in_simulation_11(step: float, works: bool) -> None:
    """Its limit is 0.193 ms: 0.19 ms works as the exact step does, at 1 ms Θ runs away."""
    rates = crossing(step, 0.5, step="euler").joint_velocities
    assert np.isfinite(rates).all()
    assert (largest_absolute(rates) < 3) == works
    assert (largest_absolute(rates) > 1e3) != works
