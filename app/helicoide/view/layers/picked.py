"""Clicks in the scene: each one selects the object under it; while the user picks a plane, it gives a point of it.

Three points give the plane.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.perception.pointing import point_under_ray
from helicoide.perception.selecting import selection_under_ray
from helicoide.state import State
from helicoide.view import bind
from helicoide.view.colours import VERMILION
from helicoide.view.layers import Stage
from helicoide.view.requests import ForArm, ForSeat
from helicoide.view.window_view import View

NAME = "picked"
SHARED = False

COLOUR, SIZE, NEEDED = VERMILION, 0.012, 3


def build(stage: Stage) -> Picked:
    """The layer, without points."""
    layer = Picked(stage)
    bind.on_pick(stage.scene, layer.clicked)
    return layer


class Picked:
    """The points of one window."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.view: View | None = None
        self.points: viser.PointCloudHandle | None = None

    def update(self, old: View | None, new: View) -> None:
        """Show the points."""
        before = None if old is None else old.seat.picked_points
        self.view = new
        picked = new.seat.picked_points
        if before != picked:
            self._draw(picked or ())

    def _draw(self, points: tuple[tuple[float, ...], ...]) -> None:
        if self.points is not None:
            self.points.remove()
            self.points = None
        if points:
            self.points = self.stage.scene.add_point_cloud(
                "/picked", np.array(points, dtype=np.float32), COLOUR, point_size=SIZE * self.stage.size
            )

    def clicked(self, eye: Array, ray: Array) -> None:
        """Add a point to the plane that is picked, else select the object; a second click on it ends the selection."""
        if self.view is None:
            return
        if self.view.seat.picked_points is not None:
            self._pick(self.view.state, self.view.seat.picked_points, (eye, ray))
            return
        selection = selection_under_ray(self.view.state, eye, ray)
        if selection is not None:
            self.stage.act(ForSeat(lambda seat: seat.inspecting(None if seat.selected == selection else selection)))

    def _pick(self, state: State, before: tuple[tuple[float, ...], ...], ray: tuple[Array, Array]) -> None:
        """Add the clicked point; the third one adds the plane."""
        point = point_under_ray(state, *ray)
        if point is None:
            return
        picked = (*before, tuple(map(float, point)))
        ended = len(picked) == NEEDED
        self.stage.act(ForSeat(lambda seat: replace(seat, picked_points=None if ended else picked)))
        if ended:
            self.stage.act(ForArm(gate.add_plane_through(picked)))
