"""Cosine and sine for kernels by arithmetic alone, so that a loop over many angles compiles to vector instructions."""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel

# π/2 in three parts, the first two of 33 bits: j times them is exact for |j| < 2²⁰. Source: fdlibm, e_rem_pio2.c.
HALF_PI = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
# (sin r − r) / r³ and (cos r − 1 + r²/2) / r⁴ as polynomials of r². Source: fdlibm, k_sin.c and k_cos.c.
SINE = (
    -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
    2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10,
)  # fmt: skip
COSINE = (
    4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
    -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11,
)  # fmt: skip
# Adding and subtracting this number rounds to an integer: a float of this size has no fractional bits.
TO_WHOLE = 1.5 * 2.0**52


@kernel
def horner(z: float, a: tuple[float, ...]) -> float:
    """a₀ + a₁ z + … + a₅ z⁵."""
    return a[0] + z * (a[1] + z * (a[2] + z * (a[3] + z * (a[4] + z * a[5]))))


@kernel
def cosine_and_sine(x: float) -> tuple[float, float]:
    """cos x and sin x without a branch, from x = j π/2 + r, |r| ≤ π/4, and minimax polynomials of r.

    Args: x, rad, |x| ≤ 10⁶. The error is below 2½ units in the last place.
    Source: Cody and Waite 1980, ch. 8 (reduction); fdlibm, Sun Microsystems 1993 (polynomials and their order).
    """
    j = (x * (2 / np.pi) + TO_WHOLE) - TO_WHOLE
    r = ((x - j * HALF_PI[0]) - j * HALF_PI[1]) - j * HALF_PI[2]
    z = r * r
    s, near = r + r * z * horner(z, SINE), 1.0 - 0.5 * z
    c = near + (((1.0 - near) - 0.5 * z) + z * z * horner(z, COSINE))
    quadrant = j - 4.0 * ((0.25 * j + TO_WHOLE) - TO_WHOLE)  # from -2 to 2, and those two are the same
    odd = quadrant * quadrant == 1.0
    cosine, sine = s if odd else c, c if odd else s
    return (
        cosine if quadrant * (quadrant + 1.0) == 0.0 else -cosine,
        sine if quadrant * (quadrant - 1.0) == 0.0 else -sine,
    )
