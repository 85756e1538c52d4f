"""The highlighted object: the inspected one, what its chosen coefficient means, and the joint of a term."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import viser

from helicoide import readout
from helicoide.arrays import Array
from helicoide.geometry import rigid, rotation
from helicoide.readout import Element, Marks
from helicoide.seat import Selection
from helicoide.state import State
from helicoide.view.joint_colours import joint_colour
from helicoide.view.layers import Stage
from helicoide.view.layers.planes import border, pane_wxyz
from helicoide.view.pose import place_node
from helicoide.view.window_view import View

NAME = "lit"
SHARED = False

LIGHT, MARK = (255, 214, 0), (213, 0, 249)
HALF = 0.73


@dataclass(frozen=True, eq=False)
class HighlightNodes:
    """The nodes of the layer: object (frame, lines, ball), coefficient (arrows, segments, area), joint of a term."""

    frame: viser.FrameHandle
    lines: viser.LineSegmentsHandle
    ball: viser.IcosphereHandle
    arrows: viser.ArrowsHandle
    segments: viser.LineSegmentsHandle
    area: viser.MeshHandle
    joint: viser.LineSegmentsHandle


def build(stage: Stage) -> Highlight:
    """All nodes, hidden until something is selected."""
    scene, size = stage.scene, stage.size
    none = np.zeros((1, 2, 3))
    nodes = HighlightNodes(
        scene.add_frame(
            "/lit/frame",
            axes_length=0.16 * size,
            axes_radius=0.006 * size,
            origin_radius=0.02 * size,
            origin_color=LIGHT,
            visible=False,
        ),
        scene.add_line_segments("/lit/lines", none, LIGHT, thickness=0.009 * size, visible=False),
        scene.add_icosphere("/lit/ball", radius=0.03 * size, color=LIGHT, opacity=0.85, visible=False),
        scene.add_arrows(
            "/lit/arrows",
            none,
            MARK,
            shaft_radius=0.006 * size,
            head_radius=0.016 * size,
            head_length=0.045 * size,
            visible=False,
        ),
        scene.add_line_segments("/lit/segments", none, MARK, thickness=0.009 * size, visible=False),
        scene.add_mesh_simple(
            "/lit/area", np.zeros((4, 3)), TRIANGLES, color=MARK, opacity=0.3, side="double", visible=False
        ),
        scene.add_line_segments("/lit/joint", none, LIGHT, thickness=0.014 * size, visible=False),
    )
    return Highlight(nodes)


TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]])


def lines_of(state: State, selection: Selection) -> Array:
    """The segments that highlight a joint's axis or a plane's border, (m, 2, 3), m."""
    index = selection.index
    if selection.kind == "joint":
        axis, centre = state.axes[index], state.arm.poses[index + 1, :3, 3]
        half = HALF * state.robot.reach
        return np.array([[centre - half * axis, centre + half * axis]])
    planes = state.problem.planes
    edges = rotation.rotate(pane_wxyz(planes.normals[index]), border(state.problem.planes.panes[index].size))
    return np.asarray(planes.centres[index] + edges)


class Highlight:
    """The highlighted object and the marks of its coefficient."""

    def __init__(self, nodes: HighlightNodes) -> None:
        self.nodes = nodes

    def update(self, old: View | None, new: View) -> None:
        """Follow the selected object."""
        if old is not None and old.seat is new.seat and inspected_parts(old) == inspected_parts(new):
            return
        element = readout.element_of(new.state, new.seat.selected)
        self._object(new.state, element)
        self._marks(new, element)
        self._joint(new, element)

    def _object(self, state: State, element: Element | None) -> None:
        nodes, nature = self.nodes, None if element is None else element.nature
        _show(nodes.frame, nature == "motor")
        _show(nodes.lines, nature in ("line", "plane"))
        _show(nodes.ball, nature == "point")
        if element is None:
            return
        if element.pose is not None:
            place_node(nodes.frame, element.pose(state))
        elif nature == "point":
            nodes.ball.position = rigid.coordinates(element.values(state))
        else:
            nodes.lines.points = lines_of(state, element.selection).astype(np.float32)

    def _marks(self, view: View, element: Element | None) -> None:
        """Draw what the chosen coefficient means."""
        nodes, marks = self.nodes, Marks()
        if element is not None and view.ready:  # the products of multivectors are kernels
            values, reach = element.values(view.state), view.state.robot.reach
            marks = readout.coefficient_marks(element.nature, values, view.seat.coefficient, reach)
        for node, points in ((nodes.arrows, marks.arrows), (nodes.segments, marks.segments)):
            if len(points):
                node.points = points.astype(np.float32)
            _show(node, len(points) > 0)
        if len(marks.area):
            nodes.area.vertices = marks.area.astype(np.float32)
        _show(nodes.area, len(marks.area) > 0)

    def _joint(self, view: View, element: Element | None) -> None:
        """Draw the axis of the joint that is chosen in “Why this number”."""
        joint, node = view.seat.term_joint, self.nodes.joint
        shown = element is not None and element.nature == "motor" and joint in range(len(view.state.robot.joints))
        if shown and joint is not None:
            node.points = lines_of(view.state, Selection("joint", joint)).astype(np.float32)
            node.colors = np.array(joint_colour(joint), dtype=np.uint8)
        _show(node, shown)


def inspected_parts(view: View) -> tuple[object, ...]:
    """The parts of the view on which the inspected object depends. Equal results: nothing has to be drawn."""
    state = view.state
    return id(state.arm.q), id(state.problem), id(state.request.command), view.ready


def _show(node: viser.SceneNodeHandle, shown: bool) -> None:
    if node.visible != shown:
        node.visible = shown
