"""Two links in the complex plane, where a rotation by θ multiplies by e^(iθ), and the elbow between them: kernels."""

from __future__ import annotations

from cmath import phase
from math import atan2, sqrt

import numpy as np

from helicoide.ik.families.elbow import EDGE
from helicoide.kernels import kernel_into

# |l₁|, |l₂|, arg l₁ and arg(l₂/l₁), m and rad.
TwoLinks = tuple[float, float, float, float]


def two_links(l1: complex, l2: complex) -> TwoLinks:
    """The links as a `TwoLinks` for the kernels. Args: l₁, l₂, m."""
    return abs(l1), abs(l2), phase(l1), phase(l2 / l1)


@kernel_into
def elbows(z: complex, links: TwoLinks, slack: float) -> tuple[int, float, bool]:
    """The number of elbow postures for the end at z, m; the cosine of the bend; whether the links are folded to z = 0.

    cos = (|z|² − |l₁|² − |l₂|²) / 2|l₁||l₂|, exactly ±1 on the edges, and beyond them up to `slack` times the outer
    radius. The rules are those of `elbow.Annulus`.
    """
    l1, l2, _, _ = links
    r, inner, outer = sqrt(z.real * z.real + z.imag * z.imag), abs(l1 - l2), l1 + l2
    cosine, edge, beyond = (r * r - l1 * l1 - l2 * l2) / (2 * l1 * l2), EDGE * outer, max(r - outer, inner - r)
    if beyond > slack * outer:
        return 0, cosine, False
    if beyond > 0.0 or min(abs(r - outer), abs(r - inner)) <= edge:
        return 1, float(np.sign(cosine)), bool(r <= edge and inner <= edge)
    return 2, cosine, False


@kernel_into
def bent(z: complex, links: TwoLinks, cosine: float) -> tuple[float, float, float]:
    """θ₂ = μ ∓ ψ and θ₃ = ±γ − δ of z = l₁ e^(iθ₂) + l₂ e^(i(θ₂ + θ₃)), the upper sign for a bend θ₃ + δ > 0.

    δ = arg(l₂/l₁). Returns μ, ψ and γ, rad.
    """
    l1, l2, first, _ = links
    sine = sqrt(max(1.0 - cosine * cosine, 0.0))
    return atan2(z.imag, z.real) - first, atan2(l2 * sine, l1 + l2 * cosine), atan2(sine, cosine)
