"""Quantities derived from a State for display: named multivectors, distances, instruments and the status in words."""

from helicoide.readout.distances import nearest, plane_distances, zones
from helicoide.readout.instruments import (
    Instrument,
    counted_names,
    held_by,
    instruments,
    modes,
    near_singular,
    target_pose,
)
from helicoide.readout.multivectors import Reading, chosen, distance_product, readings
from helicoide.readout.printed_planes import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.readout.status import SHORT, TURNED, Status, Tone, holding, status, too_near

__all__ = [
    "SHORT",
    "TURNED",
    "WHY_PRINTED_DIFFERS",
    "Instrument",
    "Reading",
    "Status",
    "Tone",
    "chosen",
    "counted_names",
    "distance_product",
    "held_by",
    "holding",
    "instruments",
    "modes",
    "near_singular",
    "nearest",
    "plane_distances",
    "printed_planes",
    "readings",
    "status",
    "target_pose",
    "too_near",
    "zones",
]
