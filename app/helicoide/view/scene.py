"""The scene that all windows of a workcell share: the ground and the shared layers. The lights are for all scenes."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.state import initial_state
from helicoide.view.layers import Layers, Stage
from helicoide.view.shapes import Shape
from helicoide.view.window_view import View

# Windows with a light and a dark background share the grid.
CELLS, SECTIONS = (170, 170, 170), (120, 120, 120)
NOBODY = Seat(token="", language="en")
# From the side and above; the camera looks to the right of the arm, since the panel covers the right side.
FROM_THE_SIDE, TO_THE_RIGHT, FARTHER = np.array([0.49, -1.44, 0.57]), np.array([0.28, 0.1, 0.0]), 1.25


def outlook(robot: Robot, upright: bool = False) -> tuple[Array, Array]:
    """The first camera position and the point that it looks at, (3,) m each: from the robot's file, or from the side.

    upright: for a phone, where the panel is below the arm and not at the right.
    """
    if robot.camera is not None and not upright:
        return robot.camera
    points = np.array([[0, 0, robot.floor], *initial_state(robot).monitored_points])
    low, high = points.min(axis=0), points.max(axis=0)
    size = max(robot.reach, float(np.linalg.norm(high - low)))
    if upright:
        return (low + high) / 2 + FARTHER * size * FROM_THE_SIDE, (low + high) / 2
    centre = (low + high) / 2 + size * TO_THE_RIGHT
    return centre + size * FROM_THE_SIDE, centre


def light_scene(scene: viser.SceneApi) -> None:
    """Set the up direction and the lights, the same for every workcell."""
    scene.set_up_direction("+z")
    scene.configure_default_lights(cast_shadow=False)  # without a GPU, shadows cost two of three frames


class Scene:
    """The part of the scene that is the same in every window."""

    def __init__(self, scene: viser.SceneApi, robot: Robot, shapes: list[Shape]) -> None:
        stage = Stage(scene, robot, shapes, lambda request: None, "")
        side, cell = 2.4 * stage.size, 0.1 * 2 ** round(np.log2(stage.size))
        scene.add_grid(
            "/ground",
            width=side,
            height=side,
            cell_size=cell,
            section_size=5 * cell,
            cell_color=CELLS,
            section_color=SECTIONS,
            position=(0, 0, robot.floor),
        )
        self.layers = Layers(stage, shared=True)

    def update(self, view: View) -> None:
        """Update the shared scene to a view."""
        self.layers.update(view)
