"""The highlighted object of the selected multivector: tool frame, joint axis, border of a plane, or point."""

from __future__ import annotations

import numpy as np
import viser

from helicoide import readout
from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.state import State
from helicoide.view.layers import Stage
from helicoide.view.layers.planes import border, pane_wxyz
from helicoide.view.pose import place_node
from helicoide.view.rows import View

NAME = "lit"
SHARED = False

LIGHT = (255, 214, 0)
HALF = 0.73


def build(stage: Stage) -> Highlight:
    """A frame, a line and a ball, hidden until something is selected."""
    scene, size = stage.scene, stage.size
    return Highlight(
        scene.add_frame(
            "/lit/frame",
            axes_length=0.16 * size,
            axes_radius=0.006 * size,
            origin_radius=0.02 * size,
            origin_color=LIGHT,
            visible=False,
        ),
        scene.add_line_segments("/lit/lines", np.zeros((1, 2, 3)), LIGHT, thickness=0.009 * size, visible=False),
        scene.add_icosphere("/lit/ball", radius=0.03 * size, color=LIGHT, opacity=0.85, visible=False),
    )


def lines_of(state: State, kind: str, index: int) -> Array:
    """The segments that highlight a joint's axis or a plane's border, (m, 2, 3), m."""
    if kind == "joint":
        axis, centre = state.axes[index], state.arm.poses[index + 1, :3, 3]
        half = HALF * state.robot.reach
        return np.array([[centre - half * axis, centre + half * axis]])
    planes = state.problem.planes
    edges = rotation.rotate(pane_wxyz(planes.normals[index]), border(state.problem.planes.panes[index].size))
    return np.asarray(planes.centres[index] + edges)


class Highlight:
    """The highlighted object."""

    def __init__(self, frame: viser.FrameHandle, lines: viser.LineSegmentsHandle, ball: viser.IcosphereHandle) -> None:
        self.frame, self.lines, self.ball = frame, lines, ball

    def update(self, old: View | None, new: View) -> None:
        """Follow the selected object."""
        state = new.state
        if (
            old is not None
            and old.state.arm.q is state.arm.q
            and old.state.problem is state.problem
            and old.seat is new.seat
        ):
            return
        chosen = readout.chosen_reading(state, new.seat.selected)
        kind, _, number = ("" if chosen is None else chosen.key).partition(" ")
        for handle, kinds in ((self.frame, ("tool",)), (self.lines, ("joint", "plane")), (self.ball, ("point",))):
            if handle.visible != (kind in kinds):
                handle.visible = kind in kinds
        if kind == "tool":
            place_node(self.frame, state.T_world_tool)
        elif kind in ("joint", "plane"):
            self.lines.points = lines_of(state, kind, int(number)).astype(np.float32)
        elif kind == "point":
            self.ball.position = state.monitored_points[int(number)]
