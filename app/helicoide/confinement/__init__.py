"""What confines the arm: planes with their zones, and obstacles."""

from helicoide.confinement.given import BOX, box, from_coefficients, through_points
from helicoide.confinement.obstacles import Obstacles, from_pieces, last_clear
from helicoide.confinement.planes import (
    Plane,
    Planes,
    distances,
    pane_axes,
    pane_on,
    planes_of,
    standing,
    stopped_at_arm,
)
from helicoide.confinement.zones import Zone, Zones

__all__ = [
    "BOX",
    "Obstacles",
    "Plane",
    "Planes",
    "Zone",
    "Zones",
    "box",
    "distances",
    "from_coefficients",
    "from_pieces",
    "last_clear",
    "pane_axes",
    "pane_on",
    "planes_of",
    "standing",
    "stopped_at_arm",
    "through_points",
]
