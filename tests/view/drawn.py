"""Optional layers drawn in a scene of viser without a page."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.view import layers, shapes
from helicoide.view.figures import BETWEEN
from helicoide.view.layers import Stage
from helicoide.view.requests import PageRequest
from helicoide.view.window import new_seat
from helicoide.view.window_view import View


@contextmanager
def served() -> Iterator[viser.ViserServer]:
    """A server that no page opens."""
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield server
    server.stop()


def stage_of(server: viser.ViserServer, robot: Robot, asked: list[PageRequest] | None = None) -> Stage:
    """An empty scene for a robot. asked: gets the requests of the layers."""
    server.scene.reset()
    drawn = shapes.load_shapes(robot) if robot.urdf.exists() else []
    return Stage(server.scene, robot, drawn, [].append if asked is None else asked.append, "1")


def showing(state: State, *names: str, time: float = 0.0) -> View:
    """A view of a state that shows these layers and no other."""
    seat: Seat = new_seat("", "en", None)
    for layer in layers.optional():
        seat = seat.with_layer(layer.NAME, layer.NAME in names)
    return View(state, seat, time=time)


class Drawn:
    """One layer in a scene, and what it has drawn."""

    def __init__(self, server: viser.ViserServer, module: ModuleType, state: State) -> None:
        self.asked: list[PageRequest] = []
        self.stage = stage_of(server, state.robot, self.asked)
        self.module, self.view = module, showing(state, module.NAME)
        self.layer: Any = module.build(self.stage)
        self.layer.update(None, self.view)

    def node(self, name: str) -> Any:
        """The handle of a node below the layer; None if it has not been added or is hidden."""
        handle: Any = self.stage.scene._handle_from_node_name.get(f"/{self.module.NAME}/{name}")
        return handle if handle is not None and handle.visible else None

    def points(self, name: str) -> Array:
        """The points of lines or arrows (k, 2, 3), m; none without the node."""
        handle = self.node(name)
        return np.zeros((0, 2, 3)) if handle is None else np.asarray(handle.points, dtype=np.float64)

    @property
    def names(self) -> list[str]:
        """The visible texts, in their order."""
        labels: list[Any] = []
        while (label := self.node(f"name {len(labels)}")) is not None:
            labels.append(label)
        return [name for label in labels for name in label.text.split(BETWEEN)]

    def place(self, number: int) -> Array:
        """Where a text stands, (3,), m."""
        return np.asarray(self.node(f"name {number}").position)
