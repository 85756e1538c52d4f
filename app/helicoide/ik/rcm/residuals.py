"""What shows how well an entry point is kept: distance, depth, lever.

d is the unit direction of the shaft towards its tip; all points and directions in one frame. Source: Coutinho 2015,
§1.2.2, §3.4.
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
    """How far the tip is beyond the entry point: (p_tip − p_rcm)·d, m; negative outside. Args: (3,), m."""
    return float((tip - entry) @ d)


def fulcrum_ratio(d: Array, handle: Array, tip: Array, entry: Array) -> float:
    """Outside over inside length: a turn about the entry point moves the handle by minus this times the tip's way.

    Infinite where the tip is at the entry point. Args: (3,), m. Source: Coutinho 2015, §1.2.2.
    """
    inside = depth(d, tip, entry)
    return -depth(d, handle, entry) / inside if inside else np.inf
