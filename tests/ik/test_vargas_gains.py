"""Sim. 14 of Vargas 2013: what the gains weigh, against a direct search for the least weighted errors."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.optimize import minimize

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.clik import quaternion_vector_error
from helicoide.kinematics.forward import tool_by_screws
from helicoide.studies.vargas.arms import zebra
from helicoide.studies.vargas.paths import path_11
from helicoide.studies.vargas.runs import rotation_about, row_norms
from helicoide.studies.vargas_14 import HALF, weighted_run


def test_the_error_of_orientation_is_that_of_the_quaternions() -> None:
    """The vector part of Q_d * Q_e⁻¹ along the shorter turn, from matrices; also for no turn and next to none."""
    rng = np.random.default_rng(1)
    for size in (0.0, 1e-12, 1e-6, 0.1, 1.0, 3.0, 3.14):
        axis = rng.normal(size=3)
        R_tool = rotation.exponential(rng.normal(size=3))
        R_target = rotation.exponential(size * axis / np.linalg.norm(axis)) @ R_tool
        expected = rotation.quaternion_error(rotation.from_matrix(R_target), rotation.from_matrix(R_tool))
        np.testing.assert_allclose(quaternion_vector_error(R_target, R_tool), expected, rtol=0, atol=1e-12)


def best(of_position: float, of_turn: float, q: Array) -> tuple[float, float]:
    """(‖e_p‖, dm, and ‖Δε‖) of the least ½ e_pᵀΛ_p e_p + 2 λ_o (1 − Δη) at `HALF`, found from near q."""
    robot, R_target = zebra().robot, rotation_about(1, pi)

    def errors(q: Array) -> tuple[Array, Array]:
        T = tool_by_screws(robot, q)
        quaternion = rotation.from_matrix(R_target @ T[:3, :3].T)
        return np.divide(path_11(HALF)[0], 10) - 10 * T[:3, 3], quaternion

    def cost(q: Array) -> float:
        e, quaternion = errors(q)
        return float(of_position * e @ e / 2 + 2 * of_turn * (1 - quaternion[0]))

    rng = np.random.default_rng(0)
    found = [minimize(cost, q + rng.normal(size=6) * 0.05, options={"gtol": 1e-7}) for _ in range(3)]
    e, quaternion = errors(min(found, key=lambda one: one.fun).x)
    return float(np.linalg.norm(e)), float(np.linalg.norm(quaternion[1:]))


@pytest.mark.parametrize(("of_position", "of_turn"), [(100, 10), (10, 10), (10, 100)])
def test_out_of_reach_the_weighted_errors_are_least(of_position: float, of_turn: float) -> None:
    run = weighted_run((of_position, of_position, of_position, of_turn), 25.0, 4e-3, HALF)
    now = row_norms(run.e[-1:, :3])[0], row_norms(run.e[-1:, 3:])[0]
    assert now == pytest.approx(best(of_position, of_turn, run.q[-1]), abs=1e-3)


def test_only_the_ratio_of_the_gains_counts() -> None:
    ends = [weighted_run((gain, gain, gain, gain), 25.0, 4e-3, HALF).e[-1] for gain in (10, 100)]
    np.testing.assert_allclose(*ends, atol=2e-3)
