"""Quantities derived from a State for display: named multivectors, distances, instruments and the status in words."""

from helicoide.readout.dimension_lines import DimensionLines, dimension_lines
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
from helicoide.readout.partial_products import partial_displacements
from helicoide.readout.printed_planes import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.readout.status import SHORT, TURNED, Status, Tone, limiting, status, too_near
from helicoide.readout.velocities import (
    balancing_torques,
    position_analysis,
    slow_directions,
    tool_twist,
    twist_axis,
    world_jacobian,
    wrench_axis,
)

__all__ = [
    "SHORT",
    "TURNED",
    "WHY_PRINTED_DIFFERS",
    "DimensionLines",
    "Instrument",
    "Reading",
    "Status",
    "Tone",
    "balancing_torques",
    "chosen_reading",
    "counted_names",
    "dimension_lines",
    "distance_product",
    "instruments",
    "limited_by",
    "limiting",
    "method_modes",
    "near_singular",
    "nearest_point_and_plane",
    "partial_displacements",
    "plane_distances",
    "position_analysis",
    "printed_planes",
    "readings",
    "slow_directions",
    "status",
    "target_pose",
    "too_near",
    "tool_twist",
    "twist_axis",
    "world_jacobian",
    "wrench_axis",
    "zones",
]
