"""The screw of the inspected frame or joint: its axis, the helix that carries the base to it, and the angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import viser

from helicoide import readout
from helicoide.arrays import Array
from helicoide.readout import DrawnScrew
from helicoide.text import Text
from helicoide.view.colours import BLUE, GREY, VERMILION
from helicoide.view.figures import polyline
from helicoide.view.layers import Stage
from helicoide.view.layers.highlight import inspected_parts
from helicoide.view.window_view import View

NAME = "screw"
SHARED = False
TITLE = Text(en="Screw of the highlighted object", pt_BR="Helicoide do objeto destacado")
SHOWN = True
KIND = "algebra"
SAID = Text(
    en="The screw axis, the helix from the base (or from the joint's zero) to the object, and the angle φ as an arc.",
    pt_BR="O eixo helicoidal, a hélice da base (ou do zero da junta) até o objeto e o ângulo φ como um arco.",
)

AXIS, HELIX, ARC = GREY, BLUE, VERMILION
FAR = 6.0  # an axis farther than this from the origin, × reach, is not drawn: the motion is almost a translation
HALF = 0.5  # length of the axis on both sides of the helix, × reach


@dataclass(frozen=True, eq=False)
class ScrewNodes:
    """The axis, the helix, the arc with its two radii, and the name of the angle."""

    axis: viser.LineSegmentsHandle
    helix: viser.LineSegmentsHandle
    arc: viser.LineSegmentsHandle
    name: viser.LabelHandle


def build(stage: Stage) -> ScrewLayer:
    """All nodes, hidden until an object with a screw is highlighted."""
    scene, size, none = stage.scene, stage.size, np.zeros((1, 2, 3))
    return ScrewLayer(
        ScrewNodes(
            scene.add_line_segments("/screw/axis", none, AXIS, thickness=0.004 * size, visible=False),
            scene.add_line_segments("/screw/helix", none, HELIX, thickness=0.007 * size, visible=False),
            scene.add_line_segments("/screw/arc", none, ARC, thickness=0.004 * size, visible=False),
            scene.add_label("/screw/name", "φ", anchor="bottom-center", visible=False),
        )
    )


class ScrewLayer:
    """The screw of one window."""

    def __init__(self, nodes: ScrewNodes) -> None:
        self.nodes = nodes

    def update(self, old: View | None, new: View) -> None:
        """Follow the highlighted object while shown."""
        if old is not None and old.seat is new.seat and inspected_parts(old) == inspected_parts(new):
            return
        state, nodes, shown = new.state, self.nodes, new.ready and new.seat.visible_layers[NAME]
        element = readout.element_of(state, new.seat.selected) if shown else None
        drawn = None if element is None else readout.drawn_screw(state, element)
        moves = drawn is not None and bool(drawn.screw.angle or drawn.screw.displacement)
        near = moves and drawn is not None and _near(drawn, state.robot.reach)
        turns = near and drawn is not None and bool(drawn.screw.angle)
        for node, visible in ((nodes.helix, moves), (nodes.axis, near), (nodes.arc, turns), (nodes.name, turns)):
            if node.visible != visible:
                node.visible = visible
        if drawn is not None and moves:
            nodes.helix.points = polyline(drawn.helix).astype(np.float32)
        if drawn is not None and near:
            nodes.axis.points = axis_segment(drawn, state.robot.reach)[None].astype(np.float32)
        if drawn is not None and turns:
            nodes.arc.points = drawn.sector().astype(np.float32)
            nodes.name.position = drawn.arc(0.5)[-1]


def axis_segment(drawn: DrawnScrew, reach: float) -> Array:
    """The part of the axis that is drawn, (2, 3), m."""
    over = HALF * reach * drawn.screw.direction
    return np.array([drawn.slide[0] - over, drawn.slide[1] + over])


def _near(drawn: DrawnScrew, reach: float) -> bool:
    return bool(np.linalg.norm(drawn.centre - drawn.start) < FAR * reach)
