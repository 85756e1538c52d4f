"""What confines the arm: planes with their zones, and obstacles."""

from helicoide.confinement.obstacles import Obstacles, last_free_point, segment_distances
from helicoide.confinement.plane_input import BOX, box_planes, from_coefficients, through_points
from helicoide.confinement.planes import (
    Plane,
    Planes,
    limited_plane_centre,
    pane_axes,
    pane_on_plane,
    planes_around,
    planes_of,
    signed_distances,
)
from helicoide.confinement.zones import Zone, Zones

__all__ = [
    "BOX",
    "Obstacles",
    "Plane",
    "Planes",
    "Zone",
    "Zones",
    "box_planes",
    "from_coefficients",
    "last_free_point",
    "limited_plane_centre",
    "pane_axes",
    "pane_on_plane",
    "planes_around",
    "planes_of",
    "segment_distances",
    "signed_distances",
    "through_points",
]
