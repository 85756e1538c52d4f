"""What a State says of itself: named multivectors, distances, and the status in words."""

from helicoide.readout.distances import nearest, plane_distances, zones
from helicoide.readout.multivectors import Reading, distance_product, readings
from helicoide.readout.status import SHORT, TURNED, Status, Tone, status

__all__ = [
    "SHORT",
    "TURNED",
    "Reading",
    "Status",
    "Tone",
    "distance_product",
    "nearest",
    "plane_distances",
    "readings",
    "status",
    "zones",
]
