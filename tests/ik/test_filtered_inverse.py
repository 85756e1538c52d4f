"""The update laws of the filtered inverse against their equations, and the checks of Vargas 2013 on Θ alone (§6.1)."""

from __future__ import annotations

from itertools import pairwise
from typing import get_args

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from helicoide.arrays import Array
from helicoide.ik import filtered_inverse, modal
from helicoide.ik.filtered_inverse import Parts, Step, Update
from helicoide.ik.scalar_filter import crossing_peak

SHAPES = [(3, 3), (2, 3), (3, 6), (6, 6), (3, 2), (6, 7)]
UPDATES: tuple[Update, ...] = get_args(Update)
UNEQUAL: Parts = (2.0, 0.5)
STEPS: tuple[Step, ...] = get_args(Step)


def drawn(shape: tuple[int, int], seed: int = 1) -> tuple[Array, Array]:
    """A random J and a random Θ for it."""
    rng = np.random.default_rng(seed)
    return rng.normal(size=shape), rng.normal(size=shape[::-1])


def of_rank_2(seed: int = 2) -> Array:
    """A random J (3, 3) with singular values 2, 1, 0."""
    U, V = (np.linalg.qr(np.random.default_rng(seed + i).normal(size=(3, 3)))[0] for i in (0, 1))
    return np.asarray(U @ np.diag([2.0, 1, 0]) @ V.T)


def symmetric(n: int, seed: int = 3) -> Array:
    """A positive definite Γ that is no multiple of I."""
    A = np.random.default_rng(seed).normal(size=(n, n))
    return np.asarray(A @ A.T + 0.5 * np.eye(n))


def integrated(J: Array, Theta: Array, gain: Array | float, dt: float, update: Update | Parts) -> Array:
    """Θ(dt) by an integrator that knows the slope only."""

    def slope(t: float, flat: Array) -> Array:
        return filtered_inverse.filter_slope(J, flat.reshape(Theta.shape), gain, update).ravel()

    run = solve_ivp(slope, (0, dt), Theta.ravel(), method="DOP853", rtol=1e-12, atol=1e-13)
    return np.asarray(run.y[:, -1].reshape(Theta.shape))


def off(J: Array, Theta: Array) -> float:
    """‖Θ − J†‖."""
    return float(np.linalg.norm(Theta - np.linalg.pinv(J)))


@pytest.mark.parametrize("shape", SHAPES)
def test_the_slope_goes_downhill(shape: tuple[int, int]) -> None:
    """With one error alone Θ̇ is −∂V/∂Θ exactly: central differences of V_r and V_ℓ."""
    J, Theta = drawn(shape)
    for side, update in enumerate(("right", "left")):
        gradient = np.zeros_like(Theta)
        for entry in np.ndindex(Theta.shape):
            way = np.zeros_like(Theta)
            way[entry] = 1e-6
            ahead, behind = (filtered_inverse.lyapunov(J, Theta + k * way)[side] for k in (1, -1))
            gradient[entry] = (ahead - behind) / 2e-6
        np.testing.assert_allclose(filtered_inverse.filter_slope(J, Theta, 1.0, update), -gradient, atol=1e-6)


@pytest.mark.parametrize("update", [*UPDATES, UNEQUAL])
@pytest.mark.parametrize("shape", SHAPES)
def test_the_exact_step_is_the_differential_equation(shape: tuple[int, int], update: Update | Parts) -> None:
    J, Theta = drawn(shape)
    for gain in (0.7, symmetric(shape[1])):
        found = filtered_inverse.exact_update(J, Theta, gain, 0.3, update)
        np.testing.assert_allclose(found, integrated(J, Theta, gain, 0.3, update), atol=2e-10)


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("shape", [(2, 3), (6, 7), (3, 2)])
def test_a_gain_and_its_multiple_of_one_are_the_same(shape: tuple[int, int], update: Update) -> None:
    J, Theta = drawn(shape)
    for step in STEPS:
        of_number, of_matrix = (
            filtered_inverse.filter_step(J, Theta, gain, 0.05, update, step) for gain in (3.0, 3.0 * np.eye(shape[1]))
        )
        np.testing.assert_allclose(of_number, of_matrix, atol=1e-12)


@pytest.mark.parametrize("update", [*UPDATES, UNEQUAL])
def test_both_rules_of_euler_come_to_the_exact_step(update: Update | Parts) -> None:
    """Their error falls with dt², and the backward rule solves its Sylvester equation."""
    J, Theta = drawn((3, 4))
    for rule in (filtered_inverse.euler, filtered_inverse.sylvester):
        errors = [
            np.linalg.norm(rule(J, Theta, 0.5, h, update) - filtered_inverse.exact_update(J, Theta, 0.5, h, update))
            for h in (1e-3, 1e-4)
        ]
        assert errors[0] / errors[1] == pytest.approx(100, rel=0.03)
    X = filtered_inverse.sylvester(J, Theta, 0.5, 0.4, update)
    np.testing.assert_allclose(X, Theta + 0.4 * filtered_inverse.filter_slope(J, X, 0.5, update), atol=1e-12)


@pytest.mark.parametrize("shape", SHAPES)
def test_full_rank_comes_to_the_pseudoinverse(shape: tuple[int, int]) -> None:
    """From a random Θ(0), T = 20/(2σ²) or 20/σ² of the smallest σ: within e⁻²⁰ of the way, and V_c never grows."""
    for seed in range(5):
        J, Theta = drawn(shape, seed)
        sigma = np.linalg.svd(J, compute_uv=False)[-1]
        dt = 20 / sigma**2 / (2 if shape[0] == shape[1] else 1) / 100
        errors, way = [sum(filtered_inverse.lyapunov(J, Theta))], off(J, Theta)
        for _ in range(100):
            Theta = filtered_inverse.exact_update(J, Theta, 1.0, dt)
            errors.append(sum(filtered_inverse.lyapunov(J, Theta)))
        assert off(J, Theta) <= np.exp(-20) * way + 1e-11
        assert all(later <= earlier + 1e-12 for earlier, later in pairwise(errors))
        assert errors[-1] == pytest.approx(abs(shape[0] - shape[1]) / 2, abs=1e-12)


@pytest.mark.parametrize("shape", [(3, 6), (6, 6), (3, 2)])
@pytest.mark.parametrize("step", ["exact", "sylvester"])
def test_a_matrix_gain_comes_there_too(shape: tuple[int, int], step: Step) -> None:
    J, Theta = drawn(shape)
    U, sigma, Vt = np.linalg.svd(J, full_matrices=False)
    J = U * np.linspace(2, 0.5, sigma.size) @ Vt
    for _ in range(60):
        Theta = filtered_inverse.filter_step(J, Theta, symmetric(shape[1]), 1e3, "composite", step)
    assert off(J, Theta) < 1e-12


@pytest.mark.parametrize(("shape", "loser", "winner"), [((2, 3), "right", "left"), ((3, 2), "left", "right")])
def test_one_error_alone_is_not_enough(shape: tuple[int, int], loser: Update, winner: Update) -> None:
    """A redundant J keeps null-space motion with S_r alone, one with too many rows keeps a reaction with S_ℓ alone."""
    J, Theta = drawn(shape)
    ends = {update: filtered_inverse.exact_update(J, Theta, 1.0, 1e4, update) for update in UPDATES}
    assert off(J, ends[loser]) > 0.1
    assert off(J, ends[winner]) < 1e-11
    assert off(J, ends["composite"]) < 1e-11


def test_a_lost_rank_leaves_its_entries_where_they_began() -> None:
    """Observation 1: d₃ is frozen; S_r alone keeps the third row of Ψ(0), S_ℓ alone the third column."""
    J = of_rank_2()
    Theta = np.random.default_rng(4).normal(size=(3, 3))
    U, _, Vt = np.linalg.svd(J)
    Psi = Vt @ Theta @ U
    target = np.diag([0.5, 1, 0])
    kept: dict[Update, Array] = {name: target.copy() for name in UPDATES}
    kept["composite"][2, 2] = Psi[2, 2]
    kept["right"][2] = Psi[2]
    kept["left"][:, 2] = Psi[:, 2]
    for update in UPDATES:
        end = filtered_inverse.exact_update(J, Theta, 1.0, 1e3, update)
        np.testing.assert_allclose(Vt @ end @ U, kept[update], atol=1e-12)
    assert off(J, filtered_inverse.exact_update(J, np.zeros((3, 3)), 1.0, 1e3)) < 1e-12


def test_rates_of_decay() -> None:
    """K = diag(2, 0.5), γ = 3, t = 0.3, Θ(0) = ones."""
    found = filtered_inverse.exact_update(np.diag([2, 0.5]), np.ones((2, 2)), 3.0, 0.3)
    np.testing.assert_allclose(found, [[0.50037, 0.02182], [0.02182, 1.36237]], atol=5e-6)


@pytest.mark.parametrize("update", [*UPDATES, UNEQUAL])
def test_the_limit_of_euler(update: Update | Parts) -> None:
    """99 % of the longest step converges, 101 % diverges."""
    J, Theta = drawn((3, 3))
    limit = filtered_inverse.step_limit(J, 2.0, update)
    if update == "composite":
        assert limit == pytest.approx(1 / (2.0 * np.linalg.svd(J, compute_uv=False)[0] ** 2))
    ends = {}
    for part in (0.99, 1.01):
        X = Theta
        for _ in range(3000):
            X = filtered_inverse.euler(J, X, 2.0, part * limit, update)
        ends[part] = np.linalg.norm(X - np.linalg.pinv(J))
    assert ends[0.99] < 1e-2
    assert ends[1.01] > 1e6
    assert filtered_inverse.step_limit(np.zeros((2, 2)), 1.0) == np.inf


@pytest.mark.parametrize(("gain", "peak", "law"), [(10, 2.60, 2.55), (100, 5.51, 5.49), (1000, 11.84, 11.83)])
def test_crossing_a_singularity_is_bounded(gain: float, peak: float, law: float) -> None:
    """K(t) = U diag(1, 0.5, cos t) Vᵀ, 1 ≤ t ≤ 2π, at 1 ms, from Θ = 0: the pseudoinverse passes 4.9e3."""
    U, V = (np.linalg.qr(np.random.default_rng(i).normal(size=(3, 3)))[0] for i in (5, 6))
    Theta, sizes = np.zeros((3, 3)), []
    for t in np.arange(1, 2 * np.pi, 1e-3):
        Theta = filtered_inverse.exact_update(U @ np.diag([1, 0.5, np.cos(t)]) @ V.T, Theta, gain, 1e-3)
        sizes.append(np.linalg.norm(Theta, 2))
    assert max(sizes) == pytest.approx(peak, abs=0.006)
    assert crossing_peak(2 * gain, 1.0) == pytest.approx(law, abs=0.006)


@pytest.mark.parametrize("update", ["composite", UNEQUAL])
@pytest.mark.parametrize("shape", SHAPES)
def test_the_modal_diagnosis(shape: tuple[int, int], update: Update | Parts) -> None:
    """d → 1/σ and r → 0 at the rates that it gives, and its V_c is that of the errors."""
    J, Theta = drawn(shape)
    before = modal.diagnosed(J, Theta, 0.7, update)
    after = modal.diagnosed(J, filtered_inverse.exact_update(J, Theta, 0.7, 0.2, update), 0.7, update)
    decay = np.exp(-0.2 * before.rates)
    aim = 1 / before.sigma
    np.testing.assert_allclose(after.R, before.R * decay, atol=1e-12)
    np.testing.assert_allclose(after.d - aim, (before.d - aim) * decay.diagonal(), atol=1e-12)
    np.testing.assert_allclose(before.rates.diagonal(), sum(filtered_inverse.parts(update)) * 0.7 * before.sigma**2)
    assert before.V_c == pytest.approx(sum(filtered_inverse.lyapunov(J, Theta)))
    assert before.floor == abs(shape[0] - shape[1]) / 2


def test_the_floor_of_the_inversion_error() -> None:
    """(m − r)/2 + (n − r)/2: 0.5 for 2×3, 1.5 for 3×6, 1 for 3×3 of rank 2."""
    for J, floor in ((drawn((2, 3))[0], 0.5), (drawn((3, 6))[0], 1.5), (of_rank_2(), 1.0)):
        at_rest = modal.diagnosed(J, np.linalg.pinv(J), 1.0)
        assert at_rest.floor == floor
        assert at_rest.V_c == pytest.approx(floor)
