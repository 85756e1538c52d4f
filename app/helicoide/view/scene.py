"""The stage that all windows share: light, camera, ground, and the shared layers."""

from __future__ import annotations

import viser

from helicoide.kinematics.robot import Robot
from helicoide.state import Seat
from helicoide.view import layers
from helicoide.view.layers import Layer, Stage
from helicoide.view.rows import View
from helicoide.view.shapes import Shape

NOBODY = Seat(token="", language="en")


class Scene:
    """What every window shows alike."""

    def __init__(self, server: viser.ViserServer, robot: Robot, shapes: list[Shape]) -> None:
        server.scene.set_up_direction("+z")
        server.scene.add_grid("/ground", width=2.4, height=2.4, cell_size=0.1, section_size=0.5)
        server.initial_camera.position = (0.92, -1.18, 0.74)
        server.initial_camera.look_at = (0.52, 0.0, 0.27)
        stage = Stage(server.scene, robot, shapes, lambda wish: None, "")
        self.layers: list[Layer] = [layer.build(stage) for layer in layers.found() if layer.SHARED]
        self.shown: View | None = None

    def update(self, view: View) -> None:
        """Bring the shared scene to a state."""
        for layer in self.layers:
            layer.update(self.shown, view)
        self.shown = view
