"""What a State says of itself: named multivectors, distances, and the status in words."""

from helicoide.readout.distances import nearest, plane_distances, zones
from helicoide.readout.instruments import Instrument, held_by, instruments
from helicoide.readout.multivectors import Reading, chosen, distance_product, readings
from helicoide.readout.status import SHORT, TURNED, Status, Tone, holding, status

__all__ = [
    "SHORT",
    "TURNED",
    "Instrument",
    "Reading",
    "Status",
    "Tone",
    "chosen",
    "distance_product",
    "held_by",
    "holding",
    "instruments",
    "nearest",
    "plane_distances",
    "readings",
    "status",
    "zones",
]
