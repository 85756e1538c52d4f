"""Quantities derived from a State for display: named multivectors, distances, instruments and the status in words."""

from helicoide.readout.distances import nearest_point_and_plane, plane_distances, zones
from helicoide.readout.instruments import (
    Instrument,
    counted_names,
    instruments,
    limited_by,
    method_modes,
    near_singular,
    target_pose,
)
from helicoide.readout.multivectors import Reading, chosen_reading, distance_product, readings
from helicoide.readout.printed_planes import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.readout.status import SHORT, TURNED, Status, Tone, limiting, status, too_near

__all__ = [
    "SHORT",
    "TURNED",
    "WHY_PRINTED_DIFFERS",
    "Instrument",
    "Reading",
    "Status",
    "Tone",
    "chosen_reading",
    "counted_names",
    "distance_product",
    "instruments",
    "limited_by",
    "limiting",
    "method_modes",
    "near_singular",
    "nearest_point_and_plane",
    "plane_distances",
    "printed_planes",
    "readings",
    "status",
    "target_pose",
    "too_near",
    "zones",
]
