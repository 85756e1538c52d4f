"""The obstacles: spheres, red while they limit the arm."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.ik import ObstacleContact
from helicoide.readout import limited_by
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "obstacles"
SHARED = True

FREE, HOLDS = (120, 110, 95), (211, 47, 47)


def build(stage: Stage) -> ObstacleLayer:
    """The layer, without spheres at first."""
    return ObstacleLayer(stage)


class ObstacleLayer:
    """A scaled unit sphere for each obstacle. Spheres are added when needed, and hidden when not needed."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.spheres: list[viser.IcosphereHandle] = []
        self.colours: list[tuple[int, int, int]] = []

    def update(self, old: View | None, new: View) -> None:
        """Follow the obstacles, and colour those that limit the arm."""
        state = new.state
        if old is None or old.state.problem.obstacles is not state.problem.obstacles:
            self._place(state.problem.obstacles.ends[:, 0], state.problem.obstacles.radii)
        if len(state.problem.obstacles.radii) and (old is None or old.state.arm.active_set is not state.arm.active_set):
            holding = {reason.obstacle for reason in limited_by(state) if isinstance(reason, ObstacleContact)}
            self._paint(holding)

    def _place(self, centres: np.ndarray, radii: np.ndarray) -> None:
        while len(self.spheres) < len(radii):
            name = f"/obstacles/{len(self.spheres)}"
            self.spheres.append(self.stage.scene.add_icosphere(name, 1.0, FREE, opacity=0.6, cast_shadow=False))
            self.colours.append(FREE)
        for index, sphere in enumerate(self.spheres):
            sphere.visible = index < len(radii)
            if sphere.visible:
                sphere.position, sphere.scale = centres[index], float(radii[index])

    def _paint(self, limiting: set[int]) -> None:
        for index, sphere in enumerate(self.spheres):
            colour = HOLDS if index in limiting else FREE
            if colour != self.colours[index]:
                sphere.color = self.colours[index] = colour
