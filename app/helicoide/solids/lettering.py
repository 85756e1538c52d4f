"""Raised lettering for the names on all machines."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from trimesh import Trimesh

from helicoide import solids as cad

Place = tuple[float, float, float]
ADVANCE = 6.4  # from one letter to the next
# Letters on a grid 4 wide and 6 high, drawn with a square pen.
STROKES: dict[str, list[list[tuple[float, float]]]] = {
    "A": [[(0, 0), (2, 6), (4, 0)], [(0.8, 2), (3.2, 2)]],
    "B": [[(0, -0.5), (0, 6.5)], [(0, 6), (3.6, 6), (3.6, 3)], [(0, 3), (4, 3), (4, 0), (0, 0)]],
    "C": [[(4, 0), (0, 0), (0, 6), (4, 6)]],
    "D": [[(2, 0), (0, 0), (0, 6), (2, 6)], [(2, 6), (4, 5), (4, 1), (2, 0)]],
    "E": [[(4, 0), (0, 0), (0, 6), (4, 6)], [(0, 3), (3.2, 3)]],
    "I": [[(2, -0.5), (2, 6.5)]],
    "L": [[(0, 6.5), (0, 0), (4, 0)]],
    "M": [[(0, 0), (0, 6), (2, 2.4), (4, 6), (4, 0)]],
    "N": [[(0, -0.5), (0, 6), (4, 0), (4, 6.5)]],
    "O": [[(2, 0), (0, 0), (0, 6), (2, 6)], [(2, 6), (4, 6), (4, 0), (2, 0)]],
    "P": [[(0, -0.5), (0, 6.5)], [(0, 6), (4, 6), (4, 3), (0, 3)]],
    "R": [[(0, -0.5), (0, 6.5)], [(0, 6), (4, 6), (4, 3), (0, 3)], [(1.8, 3), (3.8, -0.4)]],
    "S": [[(0, 0), (4, 0), (4, 3), (0, 3), (0, 6), (4, 6)]],
    "T": [[(0, 6), (4, 6)], [(2, 6), (2, -0.5)]],
    "U": [[(0, 6.5), (0, 0), (4, 0), (4, 6.5)]],
    "V": [[(0, 6.4), (2, 0), (4, 6.4)]],
    "Z": [[(0, 6), (4, 6), (0, 0), (4, 0)]],
    "0": [[(2, 0), (0, 0), (0, 6), (2, 6)], [(2, 6), (4, 6), (4, 0), (2, 0)]],
    "1": [[(0.8, 4.6), (2, 6), (2, -0.5)]],
    "2": [[(0, 6), (4, 6), (4, 3.2), (0, 2.8), (0, 0), (4, 0)]],
    "3": [[(0, 6), (4, 6), (4, 0), (0, 0)], [(4, 3), (1, 3)]],
    "5": [[(4, 6), (0, 6), (0, 3.2), (4, 3.2), (4, 0), (0, 0)]],
    "6": [[(4, 6), (0, 6), (0, 0)], [(0, 0), (4, 0), (4, 3), (0, 3)]],
    "-": [[(0.6, 3), (3.4, 3)]],
    " ": [],
}


class Lettering(NamedTuple):
    """The size of raised letters: their height, how far they stand out, and the width of the pen in squares."""

    height: float
    depth: float
    pen: float = 0.9


def word(text: str, size: Lettering, axis: cad.Axis, at: Place, upright: bool = True) -> Trimesh:
    """Raised letters centred on `at`, along u, or downwards when not upright."""
    height, depth, pen = size
    square, start = height / 6, -(ADVANCE * len(text) - (ADVANCE - 4)) / 2
    strokes = [np.add(s, [start + ADVANCE * i, -3]) * square for i, c in enumerate(text) for s in STROKES[c]]
    if not upright:
        strokes = [np.column_stack([s[:, 1], -s[:, 0]]) for s in strokes]
    return cad.letters(strokes, pen * square, depth, axis, at)


def on_both_sides(text: str, size: Lettering, at: Place) -> list[Trimesh]:
    """The word on the right side of the arm, centred on `at`, and mirrored in position on its left side."""
    x, y, z = at
    return [word(text, size, "-y", at), word(text, size, "y", (x, -y, z))]
