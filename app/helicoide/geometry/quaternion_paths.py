"""Two ways from one quaternion to another: along the great circle (slerp), and along the chord (lerp)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.geometry.clifford import Array

# Below this sine of the angle between p and q, the great circle through both is not determined.
PARALLEL = 1e-12


def slerp(p: Array, q: Array, t: ArrayLike) -> Array:
    """Spherical interpolation: (sin((1 − t)Ω) p + sin(tΩ) q)/sin Ω, Ω the angle between p and q as vectors of ℝ⁴.

    It moves at constant speed. It goes from p to q and not to −q, which is the same rotation: with p·q < 0 it takes
    the longer way. For q = p it stays; q = −p has no unique circle, so it stays at p too.
    p, q: unit (4,), wxyz; t: (...), 0 to 1; returns unit (..., 4). Source: Shoemake 1985.
    """
    s = np.asarray(t, dtype=float)[..., None]
    across = q - (p @ q) * p
    sine = float(np.linalg.norm(across))
    if sine < PARALLEL:
        return np.broadcast_to(p, (*np.shape(t), 4)).copy()
    omega = np.arctan2(sine, float(p @ q))
    return np.asarray(np.cos(s * omega) * p + np.sin(s * omega) * across / sine)


def lerp(p: Array, q: Array, t: ArrayLike) -> Array:
    """Linear interpolation: (1 − t) p + t q, along the chord; shorter than 1 between its ends.

    p, q: (4,), wxyz; t: (...); returns (..., 4). Source: Shoemake 1985.
    """
    s = np.asarray(t, dtype=float)[..., None]
    return np.asarray((1 - s) * p + s * q)


def slerp_speed(p: Array, q: Array) -> float:
    """Angular speed of the rotation along `slerp`: 2Ω, rad for a unit of t, everywhere the same."""
    return float(2 * np.arctan2(np.linalg.norm(q - (p @ q) * p), p @ q))


def lerp_speed(p: Array, q: Array, t: float) -> float:
    """Angular speed of the rotation along `lerp`, scaled to length one: 2 sin Ω/‖(1 − t) p + t q‖², rad per unit of t.

    It is slowest at the ends and fastest in the middle; infinite where the chord passes through zero (q = −p).
    """
    squared = float(np.sum(lerp(p, q, t) ** 2))
    across = float(np.linalg.norm(q - (p @ q) * p))
    return 2 * across / squared if squared > 0 else np.inf
