"""Two links in the complex plane, where a turn by θ multiplies by e^(iθ), and the elbow between them: kernels."""

from __future__ import annotations

from math import atan2, sqrt

import numpy as np

from helicoide.ik.families.elbow import EDGE
from helicoide.kernels import kernel


@kernel
def angle_of(z: complex) -> float:
    """arg z, rad."""
    return atan2(z.imag, z.real)


@kernel
def elbows(z: complex, l1: complex, l2: complex, slack: float) -> tuple[int, float, bool]:
    """How many elbows bring the links to z, m: 0, 1 or 2; the cosine of the bend; whether equal links are folded there.

    cos = (|z|² − |l₁|² − |l₂|²) / 2|l₁||l₂|, exactly ±1 on the edges and, by `slack` of the reach, beyond them.
    The rules are those of `elbow.Annulus`.
    """
    r, inner, outer = abs(z), abs(abs(l1) - abs(l2)), abs(l1) + abs(l2)
    cosine, edge = (r * r - abs(l1) ** 2 - abs(l2) ** 2) / (2 * abs(l1) * abs(l2)), EDGE * outer
    if max(r - outer, inner - r) > slack * outer:
        return 0, cosine, False
    if min(abs(r - outer), abs(r - inner)) <= edge or max(r - outer, inner - r) > 0.0:
        return 1, float(np.sign(cosine)), bool(r <= edge and inner <= edge)
    return 2, cosine, False


@kernel
def bent(z: complex, l1: complex, l2: complex, cosine: float, bend: float) -> tuple[float, float]:
    """θ₂ and θ₃ of z = l₁ e^(iθ₂) + l₂ e^(i(θ₂ + θ₃)), rad, for a sign of the bend θ₃ + arg(l₂/l₁)."""
    sine = bend * sqrt(max(1.0 - cosine * cosine, 0.0))
    theta2 = angle_of(z) - atan2(abs(l2) * sine, abs(l1) + abs(l2) * cosine) - angle_of(l1)
    return theta2, atan2(sine, cosine) - angle_of(l2 / l1)
