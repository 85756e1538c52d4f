"""The filtered inverse: a matrix Θ that follows the inverse of a changing Jacobian without a matrix inversion.

    Θ̇ = −Γ (Jᵀ S_r + S_ℓ Jᵀ),   S_r = J Θ − I,   S_ℓ = Θ J − I

One error is used, "right" or "left", or both, "composite", or each with its own factor of Γ, such as (2, 0.5) for
Γ_r = 2 Γ and Γ_ℓ = Γ/2. With both, the equilibrium solves the Sylvester equation JᵀJ Θ + Θ JJᵀ = 2 Jᵀ. If J has full
rank, Θ then converges to J† from any start. In this module J is (r, n), Θ is (n, r), and gain is γ or a positive
definite symmetric Γ (n, n), 1/s. Source: Vargas 2013, eqs. 4.18–4.38.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from helicoide.arrays import Array

Update = Literal["right", "left", "composite"]
Parts = tuple[float, float]
Step = Literal["exact", "sylvester", "euler"]

SIDES: dict[Update, Parts] = {"right": (1, 0), "left": (0, 1), "composite": (1, 1)}


def parts(update: Update | Parts) -> Parts:
    """The factors of the right and of the left error."""
    return SIDES[update] if isinstance(update, str) else update


def inversion_errors(J: Array, Theta: Array) -> tuple[Array, Array]:
    """How far Θ is from an inverse: S_r = J Θ − I (r, r) and S_ℓ = Θ J − I (n, n). Source: Vargas 2013, 4.18, 4.19."""
    n, r = Theta.shape
    return J @ Theta - np.eye(r), Theta @ J - np.eye(n)


def lyapunov(J: Array, Theta: Array) -> tuple[float, float]:
    """V_r = ½ tr(S_rᵀ S_r) and V_ℓ = ½ tr(S_ℓᵀ S_ℓ); their sum V_c never grows while J is constant.

    Source: Vargas 2013, eqs. 4.20, 4.25, 4.30.
    """
    S_r, S_l = inversion_errors(J, Theta)
    return float(np.sum(S_r * S_r)) / 2, float(np.sum(S_l * S_l)) / 2


def filter_slope(J: Array, Theta: Array, gain: Array | float, update: Update | Parts = "composite") -> Array:
    """Θ̇ = −Γ (Jᵀ S_r + S_ℓ Jᵀ), with one of the two terms or both. Source: Vargas 2013, eqs. 4.21, 4.26, 4.31."""
    right, left = parts(update)
    S_r, S_l = inversion_errors(J, Theta)
    return np.asarray(-np.dot(gain, right * J.T @ S_r + left * S_l @ J.T))


def step_limit(J: Array, gain: float, update: Update | Parts = "composite") -> float:
    """The largest dt for which Euler's rule is stable, s: 1/(γ σ₁²), twice that with one error alone."""
    fastest = float(sum(parts(update)) * gain * np.linalg.norm(J, 2) ** 2)
    return 2 / fastest if fastest > 0 else np.inf


def euler(J: Array, Theta: Array, gain: Array | float, dt: float, update: Update | Parts = "composite") -> Array:
    """Θ + Θ̇ dt, stable up to `step_limit`. Source: Vargas 2013, tab. 4.1."""
    return Theta + dt * filter_slope(J, Theta, gain, update)


def sylvester(J: Array, Theta: Array, gain: Array | float, dt: float, update: Update | Parts = "composite") -> Array:
    """Backward Euler, stable for every dt: X + dt Γ (JᵀJ X + X JJᵀ) = Θ + 2 dt Γ Jᵀ, solved for vec X.

    Source: Vargas 2013, eqs. 4.38, A.6, A.9: vec(A X B) = (Bᵀ ⊗ A) vec X.
    """
    n, r = Theta.shape
    right, left = parts(update)
    Gamma = dt * np.dot(gain, np.eye(n))
    system = np.eye(n * r) + np.kron(np.eye(r), right * Gamma @ J.T @ J) + np.kron(left * J @ J.T, Gamma)
    known = Theta + (right + left) * Gamma @ J.T
    return np.asarray(np.linalg.solve(system, known.ravel("F")).reshape((n, r), order="F"))


def exact_update(J: Array, Theta: Array, gain: Array | float, dt: float, update: Update | Parts = "composite") -> Array:
    """Θ after dt, s, for constant J, exact for every dt.

    With J = U Σ Vᵀ, Ψ = Vᵀ Θ U and Γ = γ I: ψᵢⱼ ← e^(−γ (σᵢ² + σⱼ²) dt) ψᵢⱼ, and then
    ψᵢᵢ ← ψᵢᵢ + (1 − e^(−2γσᵢ² dt))/σᵢ.

    Source: Vargas 2013, eqs. 4.44–4.54, solved.
    """
    if np.ndim(gain):
        return _exact_by_columns(J, Theta, np.asarray(gain), dt, update)
    right, left = parts(update)
    U, sigma, Vt = np.linalg.svd(J)
    (n, r), p, both = Theta.shape, len(sigma), right + left
    rows, columns, squares = np.zeros(n), np.zeros(r), gain * dt * sigma * sigma
    rows[:p] = columns[:p] = squares
    Psi = np.exp(-(right * rows[:, None] + left * columns)) * (Vt @ Theta @ U)
    d = Psi.reshape(-1)[: p * (r + 1) : r + 1]  # a view of the diagonal
    d += both * gain * dt * sigma * _mean_decay(both * squares)
    return np.asarray(Vt.T @ Psi @ U.T)


def _exact_by_columns(J: Array, Theta: Array, Gamma: Array, dt: float, update: Update | Parts) -> Array:
    """`exact_update` for a matrix gain Γ = L Lᵀ.

    With JJᵀ uⱼ = λⱼ uⱼ, each yⱼ = L⁻¹ Θ uⱼ has its own equation ẏⱼ = −Lᵀ(JᵀJ + λⱼ I)L yⱼ + 2 Lᵀ Jᵀ uⱼ.
    """
    right, left = parts(update)
    L = np.linalg.cholesky(Gamma)
    squares, U = np.linalg.eigh(J @ J.T)
    M = L.T @ (right * J.T @ J + left * squares[:, None, None] * np.eye(len(L))) @ L
    rates, W = np.linalg.eigh(M)
    turned = np.swapaxes(W, 1, 2)
    y = turned @ np.linalg.solve(L, Theta @ U).T[..., None]
    pull = turned @ ((right + left) * L.T @ J.T @ U).T[..., None]
    x = rates[..., None] * dt
    return np.asarray(L @ (W @ (np.exp(-x) * y + dt * _mean_decay(x) * pull))[..., 0].T @ U.T)


def _mean_decay(x: Array) -> Array:
    """(1 − e⁻ˣ)/x for x ≥ 0, and 1 at x = 0, where the smallest x is used: −expm1(−x) is exactly x there."""
    x = np.maximum(x, 1e-300)
    return np.asarray(-np.expm1(-x) / x)


STEPS = {"exact": exact_update, "sylvester": sylvester, "euler": euler}


def filter_step(
    J: Array, Theta: Array, gain: Array | float, dt: float, update: Update | Parts = "composite", step: Step = "exact"
) -> Array:
    """Θ after dt, s, by one of the rules in `STEPS`."""
    return STEPS[step](J, Theta, gain, dt, update)
