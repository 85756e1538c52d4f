"""A colour for each joint, in formulas and in the scene; neighbours differ for colour-blind people too."""

from __future__ import annotations

Colour = tuple[int, int, int]

# Okabe & Ito 2008. static/inspector.css has the same ones as joint-0 to joint-7.
JOINT_COLOURS: tuple[Colour, ...] = (
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
    (120, 94, 240),
    (80, 80, 80),
)


def joint_colour(index: int) -> Colour:
    """The colour of a joint, from 0; after eight joints they repeat."""
    return JOINT_COLOURS[index % len(JOINT_COLOURS)]
