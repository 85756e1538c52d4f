"""Measures of how well a shaft keeps its entry point: lateral distance, depth and lever ratio.

d is the unit direction of the shaft towards its tip. All points and directions are in one frame.
Source: Coutinho 2015, §1.2.2, §3.4.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array


def lateral_distance(d: Array, on_shaft: Array, entry: Array) -> float:
    """Distance of the entry point from the shaft: |d × (p_rcm − o)| = |(p_rcm − o) ∧ d|, m.

    Args: on_shaft: o, any point of the shaft, (3,), m; entry: p_rcm (3,), m.
    """
    return float(np.linalg.norm(np.cross(d, entry - on_shaft)))


def depth(d: Array, tip: Array, entry: Array) -> float:
    """Depth of the tip beyond the entry point: (p_tip − p_rcm)·d, m, negative outside. Args: (3,), m."""
    return float((tip - entry) @ d)


def fulcrum_ratio(d: Array, handle: Array, tip: Array, entry: Array) -> float:
    """Length outside over length inside. In a rotation about the entry point, handle motion = −ratio × tip motion.

    Infinite where the tip is at the entry point. Args: (3,), m. Source: Coutinho 2015, §1.2.2.
    """
    inside = depth(d, tip, entry)
    return -depth(d, handle, entry) / inside if inside else np.inf
