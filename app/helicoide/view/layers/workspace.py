"""The map of the workspace: a point for each cell that the tool comes to, beyond a vertical cut that bares the arm."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.kinematics.cells import Counts, Mask
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import Map
from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.mapping import middles, scale_of, values
from helicoide.view.rows import View
from helicoide.view.scene import outlook

NAME = "workspace"
SHARED = False
TITLE = Text(en="Map of the workspace", pt_BR="Mapa do espaço de trabalho")
SHOWN = True

SIZE, MOST = 1.25, 30_000  # of a point, in cells; the most points that are sent


def build(stage: Stage) -> Workspace:
    """Nothing to begin with."""
    return Workspace(stage)


def away(robot: Robot) -> tuple[int, int]:
    """The axis, 0 or 1, and the way along it, 1 or −1, that lead most away from where the arm is first seen from."""
    position, centre = outlook(robot)
    way = (centre - position)[:2]
    axis = int(np.argmax(np.abs(way)))
    return axis, 1 if way[axis] > 0 else -1


def beyond(cut: float, count: int) -> int:
    """How many of so many layers of cells lie wholly or half before a cut, −1 to 1 of the way to either end."""
    return int(np.clip(np.ceil(count / 2 * (1 + cut) - 0.5 - 1e-9), 0, count))


def part(found: Map, hidden: int, axis: int, way: int) -> Mask:
    """Which cells (shape) are reached and lie beyond so many hidden layers; all of a map in a plane."""
    mask = found.reached.reshape(found.cells.shape).copy()
    if mask.ndim == 3:
        ordered = np.moveaxis(mask, axis, 0)[::way]
        ordered[:hidden] = False
    return mask


def visible(mask: Mask) -> Counts:
    """The steps (k, d) to the cells that can be seen: in space those with a neighbour that is not drawn."""
    if mask.ndim == 2:
        return np.argwhere(mask)
    padded = np.pad(mask, 1)
    within = padded.copy()
    for axis in range(3):
        within &= np.roll(padded, 1, axis) & np.roll(padded, -1, axis)
    return np.argwhere(mask & ~within[1:-1, 1:-1, 1:-1])


class Workspace:
    """The map as a cloud of points."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.axis, self.way = away(stage.robot)
        self.cloud: viser.PointCloudHandle | None = None
        self.drawn: tuple[Map, int] | None = None

    def update(self, old: View | None, new: View) -> None:
        """Draw another map, or another part of it, once it is to be seen."""
        found = new.state.workspace.map
        shown = found is not None and new.seat.shows[NAME]
        if found is not None and shown:
            self._draw(found, beyond(new.seat.cut, found.cells.shape[self.axis]))
        if self.cloud is not None and self.cloud.visible != shown:
            self.cloud.visible = shown

    def _draw(self, found: Map, hidden: int) -> None:
        if self.drawn is not None and self.drawn[0] is found and self.drawn[1] == hidden:
            return
        self.drawn = found, hidden
        steps = visible(part(found, hidden, self.axis, self.way))
        steps = steps[np.unique(np.linspace(0, len(steps) - 1, min(MOST, len(steps))).astype(int))]
        points = middles(found, steps)
        self.cloud = self.stage.scene.add_point_cloud(
            "/workspace",
            points.astype(np.float32),
            scale_of(self.stage.robot, found).colours(values(found, steps)),
            point_size=SIZE * found.cells.size,
            point_shape="rounded",
        )
