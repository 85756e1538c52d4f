"""Points clicked in the scene: while the user picks, each click gives a point, and three points give a plane."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.perception.pointing import point_under_ray
from helicoide.view import bind
from helicoide.view.colours import VERMILION
from helicoide.view.layers import Stage
from helicoide.view.rows import ForArm, ForSeat, View

NAME = "picked"
SHARED = False

COLOUR, SIZE, NEEDED = VERMILION, 0.012, 3


def build(stage: Stage) -> Picked:
    """The layer, without points, and ignoring clicks at first."""
    bind.stop_picking(stage.scene)
    return Picked(stage)


class Picked:
    """The points of one window."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.view: View | None = None
        self.points: viser.PointCloudHandle | None = None

    def update(self, old: View | None, new: View) -> None:
        """Receive clicks while the user picks, and show the points."""
        before = None if old is None else old.seat.picked_points
        self.view = new
        picked = new.seat.picked_points
        if before == picked:
            return
        if before is None:
            bind.on_pick(self.stage.scene, self._clicked)
        if picked is None:
            bind.stop_picking(self.stage.scene)
        self._draw(picked or ())

    def _draw(self, points: tuple[tuple[float, ...], ...]) -> None:
        if self.points is not None:
            self.points.remove()
            self.points = None
        if points:
            self.points = self.stage.scene.add_point_cloud(
                "/picked", np.array(points, dtype=np.float32), COLOUR, point_size=SIZE * self.stage.size
            )

    def _clicked(self, eye: Array, ray: Array) -> None:
        """Add the clicked point; the third one adds the plane."""
        if self.view is None or self.view.seat.picked_points is None:
            return
        point = point_under_ray(self.view.state, eye, ray)
        if point is None:
            return
        picked = (*self.view.seat.picked_points, tuple(map(float, point)))
        ended = len(picked) == NEEDED
        self.stage.act(ForSeat(lambda seat: replace(seat, picked_points=None if ended else picked)))
        if ended:
            self.stage.act(ForArm(gate.add_plane_through(picked)))
