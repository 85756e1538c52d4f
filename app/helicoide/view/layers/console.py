"""The results of the console in the scene: points, lines, planes, and motors as frames, with the names of the lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement.planes import pane_axes
from helicoide.console import kind_of, sheet_results
from helicoide.console.values import coefficients_in_sources
from helicoide.geometry import incidence, rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.text import Text
from helicoide.view.colours import GREEN
from helicoide.view.figures import Names
from helicoide.view.layers import Stage
from helicoide.view.pose import place_node
from helicoide.view.window_view import View

NAME = "console"
SHARED = False
TITLE = Text(en="Results of the console", pt_BR="Resultados do console")
SHOWN = True
KIND = "algebra"
SAID = Text(
    en="The points, lines, planes and motors (as frames) that the lines of the console give, with their names.",
    pt_BR="Os pontos, retas, planos e motores (como referenciais) que resultam das linhas do console, com seus nomes.",
)

COLOUR = GREEN
DRAWN = ("point", "line", "plane", "motor")
FARTHEST, LARGEST = 1e4, 1e9  # m, and of a coefficient; the scene draws nothing beyond


def build(stage: Stage) -> ConsoleResults:
    """The layer, without results at first."""
    return ConsoleResults(stage)


class ConsoleResults:
    """A shape and a name for each drawn line of the sheet; shapes are added when needed, and hidden otherwise."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.middle = rigid.point((0.0, 0.0, 0.5 * stage.robot.reach))
        self.nodes: list[dict[str, Any]] = []
        self.names = Names(stage, f"/{NAME}")

    def update(self, old: View | None, new: View) -> None:
        """Draw the results again if the sheet or the arm has changed."""
        if not new.ready or (old is not None and old.ready and _depends(old) == _depends(new)):
            return
        shown = list(self._shapes(new)) if new.seat.visible_layers[NAME] else []
        self.nodes += [{} for _ in shown[len(self.nodes) :]]
        for index, node in enumerate(self.nodes):
            self._draw(index, node, shown[index] if index < len(shown) else None)
        self.names.write([name for _, _, name in shown], [pose[:3, 3] for _, pose, _ in shown])

    def _shapes(self, view: View) -> Iterator[tuple[str, Array, str]]:
        """The kind, the pose T_world_shape (4, 4), m, and the name of each result that is drawn."""
        sheet = view.seat.sheet
        for n, (line, result) in enumerate(zip(sheet.lines, sheet_results(sheet, view.state), strict=True), 1):
            value = result.value
            if not line.shown or not isinstance(value, Multivector) or np.abs(value.values).max() > LARGEST:
                continue
            if (kind := kind_of(value).name) in DRAWN:
                pose = shape_pose(kind, value, self.middle)
                if np.abs(pose).max() < FARTHEST:
                    yield kind, pose, result.name or str(n)

    def _draw(self, index: int, node: dict[str, Any], shape: tuple[str, Array, str] | None) -> None:
        """Show one shape of a node's, and hide its others. node: its shapes by kind."""
        for kind, handle in node.items():
            if handle.visible != (shape is not None and kind == shape[0]):
                handle.visible = not handle.visible
        if shape is None:
            return
        kind, pose, _ = shape
        if kind not in node:
            node[kind] = self._made(f"/{NAME}/{index}/{kind}", kind)
        place_node(node[kind], pose)

    def _made(self, path: str, kind: str) -> Any:
        """The node of a kind of shape."""
        scene, size, reach = self.stage.scene, self.stage.size, self.stage.robot.reach
        makers: dict[str, Callable[[], Any]] = {
            "point": lambda: scene.add_icosphere(path, radius=0.014 * size, color=COLOUR),
            "line": lambda: scene.add_line_segments(
                path, np.array([[[0, 0, -reach], [0, 0, reach]]]), COLOUR, thickness=0.005 * size
            ),
            "plane": lambda: scene.add_mesh_simple(
                path,
                0.5 * reach * np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]),
                np.array([[0, 1, 2], [0, 2, 3]]),
                color=COLOUR,
                opacity=0.25,
                side="double",
                cast_shadow=False,
                receive_shadow=False,
            ),
            "motor": lambda: scene.add_frame(path, axes_length=0.12 * size, axes_radius=0.004 * size),
        }
        return makers[kind]()


def shape_pose(kind: str, value: Multivector, middle: Array) -> Array:
    """Where a result is drawn: T_world_shape (4, 4), m; a line is the z axis of its shape, a plane is ⊥ z.

    middle: the point (16,) of the scene; the shape of a line or plane is centred at the foot of its perpendicular.
    """
    X, T = coefficients_in_sources(value), np.eye(4)
    if kind == "motor":
        return rigid.pose_from_motor(X)
    if kind == "point":
        T[:3, 3] = rigid.coordinates(X)
        return T
    unit = X / CL031.norm(X)
    direction, _ = rigid.direction_and_moment(unit) if kind == "line" else rigid.normal_and_offset(unit)
    T[:3, :3] = pane_axes(direction)
    T[:3, 3] = rigid.coordinates(incidence.perpendicular_foot(middle, unit))
    return T


def _depends(view: View) -> tuple[object, ...]:
    """The parts of the view that the results depend on. Equal results: nothing has to be drawn."""
    state, seat = view.state, view.seat
    parts = (state.arm.q, state.problem, state.request.command)
    return seat.sheet, seat.visible_layers[NAME], *map(id, parts)
