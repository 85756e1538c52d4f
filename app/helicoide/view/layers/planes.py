"""The planes: tinted panes with their normals, coloured by the zone of the nearest monitored point, grey when off."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.confinement import Zone, pane_axes
from helicoide.geometry import rotation
from helicoide.kinematics import robot_parts
from helicoide.readout import zones
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "planes"
SHARED = True

COLOURS = {Zone.FREE: (66, 133, 190), Zone.WARNING: (245, 166, 35), Zone.CRITICAL: (211, 47, 47)}
OFF = (150, 150, 150)
NORMAL_LENGTH = 0.07


def pane_wxyz(normal: Array) -> Array:
    """The orientation (4,) of a pane on a plane, as wxyz. normal: (3,)."""
    return rotation.from_matrix(pane_axes(normal))


def border(size: tuple[float, float]) -> Array:
    """The four edges of a pane in its own frame, (4, 2, 3), m."""
    w, h = size[0] / 2, size[1] / 2
    corners = np.array([[-w, -h, 0], [w, -h, 0], [w, h, 0], [-w, h, 0]])
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)


def build(stage: Stage) -> Panes:
    """The layer, without panes at first."""
    return Panes(stage)


def _pane(stage: Stage, index: int, size: tuple[float, float]) -> Pane:
    root = f"/planes/{index}"
    edges = border(size)
    faces, colour = np.array([[0, 1, 2], [0, 2, 3]]), COLOURS[Zone.FREE]
    return Pane(
        stage.scene.add_frame(root, show_axes=False),
        stage.scene.add_mesh_simple(
            f"{root}/pane",
            edges[:, 0],
            faces,
            color=colour,
            opacity=0.10,
            side="double",
            cast_shadow=False,
            receive_shadow=False,
        ),
        stage.scene.add_line_segments(f"{root}/border", edges, colour, thickness=0.004),
        stage.scene.add_arrows(
            f"{root}/normal",
            np.array([[[0, 0, 0], [0, 0, NORMAL_LENGTH]]]),
            colour,
            shaft_radius=0.004,
            head_radius=0.010,
            head_length=0.03,
        ),
    )


class Pane:
    """One pane: its frame, its glass, its border and its normal."""

    def __init__(
        self,
        frame: viser.FrameHandle,
        glass: viser.MeshHandle,
        border: viser.LineSegmentsHandle,
        arrow: viser.ArrowsHandle,
    ) -> None:
        self.frame, self.glass, self.border, self.arrow = frame, glass, border, arrow
        self.colour = COLOURS[Zone.FREE]

    def move(self, normal: Array, centre: Array) -> None:
        """Place the pane on a plane. normal, centre: (3,), centre in m."""
        self.frame.wxyz = pane_wxyz(normal)
        self.frame.position = centre

    def paint(self, colour: tuple[int, int, int]) -> None:
        """Set the colour."""
        if colour != self.colour:
            self.colour = colour
            self.glass.color = colour
            self.border.colors = self.arrow.colors = np.array(colour, dtype=np.uint8)


class Panes:
    """All panes. One is made for each new plane, made again if its size changes, and hidden without a plane."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.panes: list[Pane] = []
        self.shown: tuple[robot_parts.PlanePane, ...] = ()

    def update(self, old: View | None, new: View) -> None:
        """Follow the planes and the zone that each is in."""
        state, planes = new.state, new.state.problem.planes
        if old is None or old.state.problem.planes is not planes:
            self._make(planes.panes)
            for pane, normal, centre in zip(self.panes, planes.normals, planes.centres, strict=False):
                pane.move(normal, centre)
        if old is None or old.state.arm.q is not state.arm.q or old.state.problem is not state.problem:
            for pane, zone in zip(self.panes, zones(state), strict=False):
                pane.paint(OFF if state.arm.parked else COLOURS[zone])

    def _make(self, panes: tuple[robot_parts.PlanePane, ...]) -> None:
        for index, pane in enumerate(panes):
            if index >= len(self.panes):
                self.panes.append(_pane(self.stage, index, pane.size))
            elif index >= len(self.shown) or self.shown[index].size != pane.size:
                self.panes[index] = _pane(self.stage, index, pane.size)
        for index, drawn in enumerate(self.panes):
            drawn.frame.visible = index < len(panes)
        self.shown = panes
