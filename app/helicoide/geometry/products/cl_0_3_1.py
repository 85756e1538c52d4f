"""The products of Cl(0,3,1), written out by `python -m tests.geometry.write_products`."""

from __future__ import annotations

import numpy as np

from helicoide.geometry.signature import Array
from helicoide.kernels import kernel, kernel_into

CONJUGATE = (1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0, 1.0)


# fmt: off
@kernel_into
def product(a: Array, b: Array, out: Array) -> None:
    """Write a b into out, each (16,), the blades in the order of `Cl(0,3,1)`: (a b)ₖ = Σ ± aᵢ bⱼ."""
    if a.size != 16 or b.size != 16 or out.size != 16:
        raise ValueError("each multivector needs as many coefficients as the algebra has blades")
    a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15 = (
        a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8], a[9], a[10], a[11], a[12], a[13], a[14], a[15]
    )
    b0, b1, b2, b3, b4, b5, b6, b7, b8, b9, b10, b11, b12, b13, b14, b15 = (
        b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8], b[9], b[10], b[11], b[12], b[13], b[14], b[15]
    )
    out[0] = a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3 - a5 * b5 - a6 * b6 - a7 * b7 + a11 * b11
    out[1] = a1 * b0 + a0 * b1 - a5 * b2 - a6 * b3 + a2 * b5 + a3 * b6 - a11 * b7 - a7 * b11
    out[2] = a2 * b0 + a5 * b1 + a0 * b2 - a7 * b3 - a1 * b5 + a11 * b6 + a3 * b7 + a6 * b11
    out[3] = a3 * b0 + a6 * b1 + a7 * b2 + a0 * b3 - a11 * b5 - a1 * b6 - a2 * b7 - a5 * b11
    out[4] = (
        a4 * b0 + a8 * b1 + a9 * b2 + a10 * b3 + a0 * b4 - a12 * b5 - a13 * b6 - a14 * b7 - a1 * b8 - a2 * b9 - a3 * b10
        - a15 * b11 - a5 * b12 - a6 * b13 - a7 * b14 + a11 * b15
    )
    out[5] = a5 * b0 - a2 * b1 + a1 * b2 - a11 * b3 + a0 * b5 - a7 * b6 + a6 * b7 - a3 * b11
    out[6] = a6 * b0 - a3 * b1 + a11 * b2 + a1 * b3 + a7 * b5 + a0 * b6 - a5 * b7 + a2 * b11
    out[7] = a7 * b0 - a11 * b1 - a3 * b2 + a2 * b3 - a6 * b5 + a5 * b6 + a0 * b7 - a1 * b11
    out[8] = (
        a8 * b0 - a4 * b1 + a12 * b2 + a13 * b3 + a1 * b4 + a9 * b5 + a10 * b6 - a15 * b7 + a0 * b8 - a5 * b9 - a6 * b10
        + a14 * b11 + a2 * b12 + a3 * b13 - a11 * b14 - a7 * b15
    )
    out[9] = (
        a9 * b0 - a12 * b1 - a4 * b2 + a14 * b3 + a2 * b4 - a8 * b5 + a15 * b6 + a10 * b7 + a5 * b8 + a0 * b9 - a7 * b10
        - a13 * b11 - a1 * b12 + a11 * b13 + a3 * b14 + a6 * b15
    )
    out[10] = (
        a10 * b0 - a13 * b1 - a14 * b2 - a4 * b3 + a3 * b4 - a15 * b5 - a8 * b6 - a9 * b7 + a6 * b8 + a7 * b9 + a0 * b10
        + a12 * b11 - a11 * b12 - a1 * b13 - a2 * b14 - a5 * b15
    )
    out[11] = a11 * b0 + a7 * b1 - a6 * b2 + a5 * b3 + a3 * b5 - a2 * b6 + a1 * b7 + a0 * b11
    out[12] = (
        a12 * b0 + a9 * b1 - a8 * b2 + a15 * b3 + a5 * b4 + a4 * b5 - a14 * b6 + a13 * b7 - a2 * b8 + a1 * b9 -
        a11 * b10 + a10 * b11 + a0 * b12 - a7 * b13 + a6 * b14 - a3 * b15
    )
    out[13] = (
        a13 * b0 + a10 * b1 - a15 * b2 - a8 * b3 + a6 * b4 + a14 * b5 + a4 * b6 - a12 * b7 - a3 * b8 + a11 * b9 +
        a1 * b10 - a9 * b11 + a7 * b12 + a0 * b13 - a5 * b14 + a2 * b15
    )
    out[14] = (
        a14 * b0 + a15 * b1 + a10 * b2 - a9 * b3 + a7 * b4 - a13 * b5 + a12 * b6 + a4 * b7 - a11 * b8 - a3 * b9 +
        a2 * b10 + a8 * b11 - a6 * b12 + a5 * b13 + a0 * b14 - a1 * b15
    )
    out[15] = (
        a15 * b0 - a14 * b1 + a13 * b2 - a12 * b3 + a11 * b4 + a10 * b5 - a9 * b6 + a8 * b7 + a7 * b8 - a6 * b9 +
        a5 * b10 - a4 * b11 + a3 * b12 - a2 * b13 + a1 * b14 + a0 * b15
    )


@kernel
def sandwich(a: Array, b: Array, out: Array) -> None:
    """Write a b a* into out, each (16,), with the Clifford conjugate a*."""
    half, turned = np.empty(16), np.empty(16)
    product(a, b, half)
    for k in range(16):
        turned[k] = CONJUGATE[k] * a[k]
    product(half, turned, out)
