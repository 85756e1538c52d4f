"""Quantities derived from a State for display: named multivectors, distances, instruments and the status in words."""

from helicoide.readout.chain_terms import Chain, ChainTerms, Term, chain_of, chain_terms, joints_before
from helicoide.readout.coefficients import ALGEBRAS, Coefficient, coefficients, exact_text, in_algebra
from helicoide.readout.dimension_lines import DimensionLines, dimension_lines
from helicoide.readout.distances import distance_product, nearest_point_and_plane, plane_distances, zones
from helicoide.readout.elements import SYMBOLS, Element, Nature, element_of, elements
from helicoide.readout.instruments import (
    Instrument,
    counted_names,
    instruments,
    limited_by,
    method_modes,
    near_singular,
    target_pose,
)
from helicoide.readout.marks import Marks, coefficient_marks
from helicoide.readout.meanings import INTRODUCTION, meaning
from helicoide.readout.partial_products import partial_displacements
from helicoide.readout.pose_forms import PoseForms, forms_of_pose
from helicoide.readout.printed_planes import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.readout.roles import Role, role_of
from helicoide.readout.screws import DrawnScrew, drawn_screw
from helicoide.readout.shared_meanings import shared_meanings
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
    "ALGEBRAS",
    "INTRODUCTION",
    "SHORT",
    "SYMBOLS",
    "TURNED",
    "WHY_PRINTED_DIFFERS",
    "Chain",
    "ChainTerms",
    "Coefficient",
    "DimensionLines",
    "DrawnScrew",
    "Element",
    "Instrument",
    "Marks",
    "Nature",
    "PoseForms",
    "Role",
    "Status",
    "Term",
    "Tone",
    "balancing_torques",
    "chain_of",
    "chain_terms",
    "coefficient_marks",
    "coefficients",
    "counted_names",
    "dimension_lines",
    "distance_product",
    "drawn_screw",
    "element_of",
    "elements",
    "exact_text",
    "forms_of_pose",
    "in_algebra",
    "instruments",
    "joints_before",
    "limited_by",
    "limiting",
    "meaning",
    "method_modes",
    "near_singular",
    "nearest_point_and_plane",
    "partial_displacements",
    "plane_distances",
    "position_analysis",
    "printed_planes",
    "role_of",
    "shared_meanings",
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
