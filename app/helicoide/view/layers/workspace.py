"""The map of the workspace: a point for each cell that the tool reaches. A vertical cut hides the front part."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.kinematics.grid import Counts, Mask
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import WorkspaceMap, plane_normal
from helicoide.state import initial_state
from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.scene import outlook
from helicoide.view.window_view import View
from helicoide.view.workspace_rows import middles, scale_of, values

NAME = "workspace"
SHARED = False
TITLE = Text(en="Workspace map", pt_BR="Mapa do espaço de trabalho")
SHOWN = True
KIND = "arm"
SAID = Text(
    en="The positions that the end effector reaches, coloured by the chosen map; the front part is cut away.",
    pt_BR="As posições que o efetuador alcança, nas cores do mapa escolhido; a parte da frente fica oculta pelo corte.",
)

# Size of a point, in cells; number of points across the map, for which coarse cells are divided; most points sent.
SIZE, FINE, MOST = 1.05, 66, 30_000


def build(stage: Stage) -> WorkspaceLayer:
    """The layer, without a map at first."""
    return WorkspaceLayer(stage)


def away(robot: Robot) -> tuple[int, int]:
    """The axis, 0 or 1, and its sign, 1 or −1, that point away from the first camera position."""
    position, centre = outlook(robot)
    way = (centre - position)[:2]
    axis = int(np.argmax(np.abs(way)))
    return axis, 1 if way[axis] > 0 else -1


def behind(stage: Stage) -> Array:
    """The displacement (3,), m, that puts the map of an arm in a plane behind its moving links, as the camera sees it.

    Zero for an arm in space.
    """
    robot, normal = stage.robot, plane_normal(stage.robot)
    if normal is None:
        return np.zeros(3)
    position, centre = outlook(robot)
    back = normal if normal @ (centre - position) > 0 else -normal
    poses = initial_state(robot).arm.poses
    moving = [
        (shape.edges.reshape(-1, 3) @ T[:3, :3].T + T[:3, 3] - robot.T_world_tool_0[:3, 3]) @ back
        for shape in stage.shapes
        if shape.link > 0
        for T in (poses[shape.link] @ shape.T_link_shape,)
    ]
    return np.asarray(back * max((float(along.max(initial=0.0)) for along in moving), default=0.0))


def layers_before_cut(cut: float, count: int) -> int:
    """How many of `count` layers have their centre before the cut. cut: −1 to 1, from one end to the other."""
    return int(np.clip(np.ceil(count / 2 * (1 + cut) - 0.5 - 1e-9), 0, count))


def split_cells(found: WorkspaceMap, parts: int) -> Mask:
    """The reached cells, each divided into `parts` along every axis, so that large cells are drawn as cubes."""
    mask = found.reached.reshape(found.cells.shape)
    for axis in range(mask.ndim):
        mask = np.repeat(mask, parts, axis)
    return mask


def remaining(mask: Mask, hidden: int, axis: int, way: int) -> Mask:
    """A mask without its first `hidden` layers along an axis, from the end if `way` is −1; a flat mask unchanged."""
    mask = mask.copy()
    if mask.ndim == 3:
        np.moveaxis(mask, axis, 0)[::way][:hidden] = False
    return mask


def visible(mask: Mask) -> Counts:
    """The indices (k, d) of the visible cells: in space those with a neighbour that is not drawn."""
    if mask.ndim == 2:
        return np.argwhere(mask)
    padded = np.pad(mask, 1)
    within = padded.copy()
    for axis in range(3):
        within &= np.roll(padded, 1, axis) & np.roll(padded, -1, axis)
    return np.argwhere(mask & ~within[1:-1, 1:-1, 1:-1])


class WorkspaceLayer:
    """The map as a cloud of points."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.axis, self.way = away(stage.robot)
        self.behind = behind(stage)
        self.cloud: viser.PointCloudHandle | None = None
        self.drawn: tuple[WorkspaceMap, int] | None = None

    def update(self, old: View | None, new: View) -> None:
        """Draw the map if it or its cut has changed, and only while it is shown."""
        found = new.state.workspace.map
        shown = found is not None and new.seat.visible_layers[NAME]
        if found is not None and shown:
            parts = max(1, FINE // max(found.cells.shape))
            self._draw(found, parts, layers_before_cut(new.seat.cut, parts * found.cells.shape[self.axis]))
        if self.cloud is not None and self.cloud.visible != shown:
            self.cloud.visible = shown

    def _draw(self, found: WorkspaceMap, parts: int, hidden: int) -> None:
        if self.drawn is not None and self.drawn[0] is found and self.drawn[1] == hidden:
            return
        self.drawn = found, hidden
        steps = visible(remaining(split_cells(found, parts), hidden, self.axis, self.way))
        steps = steps[np.unique(np.linspace(0, len(steps) - 1, min(MOST, len(steps))).astype(int))]
        points = middles(found, (steps + 0.5) / parts - 0.5) + self.behind
        self.cloud = self.stage.scene.add_point_cloud(
            "/workspace",
            points.astype(np.float32),
            scale_of(self.stage.robot, found).colours(values(found, steps // parts)),
            point_size=SIZE * found.cells.size / parts,
            point_shape="rounded",
        )
