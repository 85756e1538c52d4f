"""Sims. 3 and 14 of Vargas 2013: six joints past a shoulder singularity, and priorities by gains; short forms."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize
from tests.ik.vargas import largest, path_11, sizes, turned, weighted_sim, wrist_sim, zebra

from helicoide.geometry import rotation
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import tool_by_screws

HALF = 7.854  # s: where trajectory 11 is farthest


@pytest.mark.parametrize(
    ("name", "options", "arm", "wrist"),
    [
        ("filtered", {"gain": 1.0}, 3.46, 3.14),
        ("filtered_modified", {"gain": 1.0}, 3.77, 3.08),
    ],
)
def test_the_passage_at_speed(name: str, options: dict[str, Any], arm: float, wrist: float) -> None:
    """Sim. 3 at 2.5 times its speed, the singularity at 9.43 s, where the inverse turns the wrist at 35 rad/s."""
    t, _, _, rates = wrist_sim(name, options, 2e-3, 11, 2.5)
    assert largest(rates[:, :3], t > 3) == pytest.approx(arm, rel=0.02)
    assert largest(rates[:, 3:], t > 3) == pytest.approx(wrist, rel=0.03)


def test_the_inverse_races_at_the_passage() -> None:
    t, _, _, rates = wrist_sim("inverse", {}, 2e-3, 11, 2.5)
    assert largest(rates[:, 3:], t > 3) > 25
    assert largest(rates[:, :3], t > 3) == pytest.approx(3.89, rel=0.02)


def test_the_passage_is_left_behind() -> None:
    """Sim. 3, modified law, γ = 10: below 1.5 rad/s, 0.05 cm, and nothing of it is left at the end."""
    t, _, e, rates = wrist_sim("filtered_modified", {"gain": 10.0}, 5e-3, 29.5)
    assert largest(rates[:, :3], t > 3) == pytest.approx(1.49, rel=0.02)
    assert largest(rates[:, 3:], t > 3) == pytest.approx(1.42, rel=0.02)
    assert largest(sizes(e[:, :3]), t > 3) < 0.05
    assert largest(sizes(e), t > 29) < 1e-3


def best(of_position: float, of_turn: float, q: Array) -> tuple[float, float]:
    """(‖e_p‖, dm, and ‖Δε‖) of the least ½ e_pᵀΛ_p e_p + 2 λ_o (1 − Δη) at `HALF`, found from near q."""
    robot, R_target = zebra(0.1).robot, turned(1, pi)

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


@pytest.mark.parametrize(
    ("of_position", "of_turn", "at_half"),
    [
        (100, 10, (0.0151, 0.2402)),
        (10, 10, (0.1310, 0.2044)),
        (10, 100, (0.5246, 0.0734)),
    ],
)
def test_gains_set_priorities(of_position: float, of_turn: float, at_half: tuple[float, float]) -> None:
    """Out of reach the arm rests where the weighted errors are least, and the larger gain wins."""
    _, q, e, _ = weighted_sim([of_position] * 3 + [of_turn] * 3, 4e-3, HALF)
    now = sizes(e[-1:, :3])[0], sizes(e[-1:, 3:])[0]
    assert now == pytest.approx(at_half, abs=6e-4)
    assert now == pytest.approx(best(of_position, of_turn, q[-1]), abs=1e-3)


@pytest.mark.parametrize(
    ("axes", "x", "z"), [((100, 10, 10), 0.66, 5.06), ((10, 10, 100), 5.40, 0.53), ((10, 10, 10), 3.99, 3.40)]
)
def test_gains_favour_an_axis(axes: tuple[int, int, int], x: float, z: float) -> None:
    """e_p at 7.85 s, cm, with λ_o = 100."""
    _, _, e, _ = weighted_sim([*axes, 100, 100, 100], 4e-3, HALF)
    assert 10 * np.abs(e[-1, [0, 2]]) == pytest.approx([x, z], abs=0.02)


def test_only_the_ratio_of_the_gains_counts() -> None:
    ends = [weighted_sim([gain] * 6, 4e-3, HALF)[2][-1] for gain in (10, 100)]
    np.testing.assert_allclose(*ends, atol=2e-3)
