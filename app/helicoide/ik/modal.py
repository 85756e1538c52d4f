"""The filtered inverse for each singular value: Θ in the singular vectors of J.

    J = U Σ Vᵀ,   Ψ = Vᵀ Θ U = D + R,   ḋᵢ = −2γσᵢ(σᵢdᵢ − 1),   ṙᵢⱼ = −γ(σᵢ² + σⱼ²) rᵢⱼ

With Γ_r = rγI and Γ_ℓ = ℓγI: ḋᵢ = −(r + ℓ)γσᵢ(σᵢdᵢ − 1) and ṙᵢⱼ = −γ(rσᵢ² + ℓσⱼ²) rᵢⱼ.
Source: Vargas 2013, eqs. 4.44–4.54.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.filtered_inverse import Parts, Update, parts
from helicoide.kinematics.manipulability import analyse_jacobian


@dataclass(frozen=True, eq=False)
class ModalDiagnosis:
    """Θ (n, r) in the singular vectors of J (r, n), p = min(n, r).

    sigma (p,); d (p,), which tends to 1/σᵢ; R (n, r), which tends to 0; rates (n, r), 1/s: the decay rates, 2γσᵢ² for
    dᵢ and γ(σᵢ² + σⱼ²) for rᵢⱼ if both errors have the factor 1, with σ = 0 beyond p; V_c; floor: the smallest possible
    V_c, (r − ρ)/2 + (n − ρ)/2 for rank ρ.
    """

    sigma: Array
    d: Array
    R: Array
    rates: Array
    V_c: float
    floor: float


def diagnosed(J: Array, Theta: Array, gain: float, update: Update | Parts = "composite") -> ModalDiagnosis:
    """The modal diagnosis of Θ. Args: J (r, n); Theta (n, r); gain: γ, 1/s; update: the errors used, or their factors.

    Source: Vargas 2013, §4.4.
    """
    right, left = parts(update)
    r, n = J.shape
    axes = analyse_jacobian(J)
    p = axes.sigma.size
    rows, columns = np.zeros(n), np.zeros(r)
    rows[:p] = columns[:p] = axes.sigma
    R = axes.V.T @ Theta @ axes.U
    d = R.diagonal().copy()
    np.fill_diagonal(R, 0.0)
    # ½‖S_r‖² + ½‖S_ℓ‖² in the singular vectors of J: the diagonal is in both, and beyond p each has −1 on the diagonal.
    off = np.sum((rows[:, None] ** 2 + columns**2) * R**2) / 2
    V_c = float(np.sum((axes.sigma * d - 1) ** 2) + off + (r - p) / 2 + (n - p) / 2)
    rates = gain * (right * rows[:, None] ** 2 + left * columns**2)
    return ModalDiagnosis(axes.sigma, d, R, rates, V_c, (r - axes.rank) / 2 + (n - axes.rank) / 2)
