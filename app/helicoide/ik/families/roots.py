"""The zeros of a trigonometric polynomial of degree two: a kernel."""

from __future__ import annotations

from math import atan2

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.polish import linear
from helicoide.kernels import kernel

CIRCLE = 1e-3  # the largest distance of a root from the unit circle
NONE, STILL, ROUNDS = (
    1e-14,
    1e-15,
    80,
)  # leading coefficients and corrections that count as zero; largest number of corrections


@kernel
def zeros(l0: float, c1: float, s1: float, c2: float, s2: float, angles: Array) -> int:
    """Write the θ of l₀ + c₁ cos θ + s₁ sin θ + c₂ cos 2θ + s₂ sin 2θ = 0 into angles (4,), rad, in increasing order.

    Returns their number. They are the roots w = e^(iθ) on the unit circle of a quartic; tan(θ/2) would have a root at
    infinity for θ = π. All roots are iterated at once, by Newton's correction with a term for each other root.
    Source: Ehrlich 1967 and Aberth 1973, Iteration methods for finding all zeros of a polynomial simultaneously.
    """
    a, b = c2 - 1j * s2, c1 - 1j * s1
    largest = max(abs(a), abs(b), abs(l0))
    if abs(a) <= NONE * largest:
        count, angles[0], angles[1] = linear(c1, s1, -l0, 0.0)
        return count if abs(b) > NONE * largest else 0
    w = np.empty(4, np.complex128)
    for i in range(4):
        w[i] = (1.2, 0.8, 1.1, 0.9)[i] * (0.4 + 0.9j) ** i
    for _ in range(ROUNDS):
        moved = 0.0
        for i in range(4):
            x = w[i]
            p = (((a * x + b) * x + 2 * l0) * x + b.conjugate()) * x + a.conjugate()
            slope = ((4 * a * x + 3 * b) * x + 4 * l0) * x + b.conjugate()
            drawn = 0j
            for j in range(4):
                if j != i and w[j] != x:
                    drawn += 1.0 / (x - w[j])
            below = slope - p * drawn
            step = p / below if below != 0 else 0j
            w[i] = x - step
            moved = max(moved, abs(step))
        if moved < STILL:
            break
    count = 0
    for i in range(4):
        if abs(abs(w[i]) - 1.0) < CIRCLE:
            angle, place = atan2(w[i].imag, w[i].real), count
            while place > 0 and angles[place - 1] > angle:
                angles[place] = angles[place - 1]
                place -= 1
            angles[place] = angle
            count += 1
    return count
