"""The workspace of planar arms: which points the tool reaches with some orientation, and which with every one."""

from __future__ import annotations

from helicoide.arrays import Array

Ring = tuple[float, float]
# The rounding tolerance for a ring that is a single circle, m.
ROUNDING = 1e-12


def reachable(lengths: Array) -> Ring:
    """Inner and outer radius of the points that a planar arm reaches: max(0, 2 max lᵢ − Σ lᵢ) and Σ lᵢ, m.

    Two links: |l₁ − l₂| and l₁ + l₂. Args: lengths (n,), m. Source: Campos 1998, s.6–10.
    """
    total = float(lengths.sum())
    return max(0.0, 2 * float(lengths.max()) - total), total


def dexterous(lengths: Array) -> tuple[Ring, ...]:
    """The rings, by inner and outer radius, m, of the points that two or three links reach with every orientation.

    Three links: r + l₃ ≤ l₁ + l₂, and r ≥ |l₁ − l₂| + l₃ or r ≤ l₃ − |l₁ − l₂|: the circle of the wrist around the
    point lies in the annulus of the first two links. Two links: the centre alone, where they are equal.
    Args: lengths (2,) or (3,), m. Source: Campos 1998, s.6–10; the limits for three links follow from s.53.
    """
    l1, l2, l3 = (*lengths, 0.0)[:3]
    hole, widest = float(abs(l1 - l2)), float(l1 + l2 - l3)
    if len(lengths) == 2:
        return ((0.0, 0.0),) if hole == 0 else ()
    if hole == 0:
        return ((0.0, widest),) if widest >= 0 else ()
    rings = ((0.0, min(float(l3) - hole, widest)), (hole + float(l3), widest))
    return tuple((inner, max(inner, outer)) for inner, outer in rings if outer >= inner - ROUNDING)
