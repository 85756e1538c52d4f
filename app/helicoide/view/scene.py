"""The stage that all windows share: light, camera, ground, and the shared layers."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.kinematics.chain import Array
from helicoide.kinematics.robot import Robot
from helicoide.state import Seat, initial
from helicoide.view import layers
from helicoide.view.layers import Layer, Stage
from helicoide.view.rows import View
from helicoide.view.shapes import Shape

Server = viser.ViserServer
NOBODY = Seat(token="", language="en")
# From the side and above; what is looked at lies to the right of the arm, which the panel would cover else.
FROM_THE_SIDE, TO_THE_RIGHT = np.array([0.49, -1.44, 0.57]), np.array([0.28, 0.1, 0.0])


def outlook(robot: Robot) -> tuple[Array, Array]:
    """From where a robot is seen first, and where to, (3,) m each: as its file says, else from the side."""
    if robot.camera is not None:
        return robot.camera
    points = np.array([[0, 0, robot.floor], *initial(robot).guarded_points])
    low, high = points.min(axis=0), points.max(axis=0)
    size = max(robot.reach, float(np.linalg.norm(high - low)))
    centre = (low + high) / 2 + size * TO_THE_RIGHT
    return centre + size * FROM_THE_SIDE, centre


class Scene:
    """What every window shows alike."""

    def __init__(self, server: Server, robot: Robot, shapes: list[Shape]) -> None:
        stage = Stage(server.scene, robot, shapes, lambda wish: None, "")
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(cast_shadow=False)  # two frames of three, without a graphics card
        side, cell = 2.4 * stage.size, 0.1 * 2 ** round(np.log2(stage.size))
        server.scene.add_grid(
            "/ground", width=side, height=side, cell_size=cell, section_size=5 * cell, position=(0, 0, robot.floor)
        )
        server.initial_camera.position, server.initial_camera.look_at = outlook(robot)
        self.layers: list[Layer] = [layer.build(stage) for layer in layers.found() if layer.SHARED]
        self.shown: View | None = None

    def clear(self, server: Server) -> None:
        """Take everything away."""
        self.layers.clear()
        server.scene.reset()

    def update(self, view: View) -> None:
        """Bring the shared scene to a state."""
        for layer in self.layers:
            layer.update(self.shown, view)
        self.shown = view
