"""The geometric product of Cl(0,2,0), written out; made by `python -m tests.geometry.write_products`."""

from __future__ import annotations

from helicoide.geometry.signature import Array
from helicoide.kernels import kernel


# fmt: off
@kernel
def product(a: Array, b: Array, out: Array) -> None:
    """Write a b into out, each (4,), the blades in the order of `Cl(0,2,0)`: (a b)ₖ = Σ ± aᵢ bⱼ."""
    if a.size != 4 or b.size != 4 or out.size != 4:
        raise ValueError("each multivector needs as many coefficients as the algebra has blades")
    a0, a1, a2, a3 = a[0], a[1], a[2], a[3]
    b0, b1, b2, b3 = b[0], b[1], b[2], b[3]
    out[0] = a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3
    out[1] = a1 * b0 + a0 * b1 - a3 * b2 + a2 * b3
    out[2] = a2 * b0 + a3 * b1 + a0 * b2 - a1 * b3
    out[3] = a3 * b0 - a2 * b1 + a1 * b2 + a0 * b3
