"""Directions, places and motions that the tests of geometry draw, with those where formulas break among them."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from helicoide.geometry.clifford import CL031, Array

ANGLES = (0.0, 1e-9, np.pi / 2, np.pi - 1e-9, np.pi)
angles = st.one_of(st.sampled_from([*ANGLES, -np.pi]), st.floats(-3, 3))
vectors = st.tuples(*[st.floats(-2, 2)] * 3).map(np.array)
axes = vectors.filter(lambda v: np.linalg.norm(v) > 1e-3).map(lambda v: v / np.linalg.norm(v))


def rodrigues(axis: Array, angle: float) -> Array:
    """Matrix of a turn about a unit axis: I + sin θ K + (1 − cos θ) K²."""
    K = np.cross(np.eye(3), axis)
    return np.asarray(np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K))


def pose(axis: Array, angle: float, t: Array) -> Array:
    T = np.eye(4)
    T[:3, :3] = rodrigues(axis, angle)
    T[:3, 3] = t
    return T


poses = st.builds(pose, axes, angles, vectors)


def of(**blades: float) -> Array:
    """Multivector of Cl(0,3,1) by its coefficients; `one` is the scalar."""
    return np.asarray(sum(value * CL031.blade(name.replace("one", "1")) for name, value in blades.items()))
