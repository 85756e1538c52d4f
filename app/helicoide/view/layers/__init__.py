"""The layers of the scene, one module each.

A module defines NAME, SHARED (whether one layer serves all windows) and `build(stage)`. With TITLE and SHOWN, its layer
can be shown and hidden by the user. A layer has `update(old, new)`, which writes only what changed.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Protocol

import viser

from helicoide import content
from helicoide.kinematics.robot import Robot
from helicoide.view.rows import Act, View
from helicoide.view.shapes import Shape

DRAWN_FOR = 0.82


@dataclass(frozen=True, eq=False)
class Stage:
    """What a layer is built from: a scene, a robot and its shapes, and the function that takes requests.

    who: client id of the window, empty for a shared scene; weight: scale of lines and handles, larger for a projector.
    """

    scene: viser.SceneApi
    robot: Robot
    shapes: list[Shape]
    act: Act
    who: str
    weight: float = 1.0

    @property
    def size(self) -> float:
        """Scale of arrows, lines and handles, 1 for an arm with a reach of `DRAWN_FOR` metres."""
        return self.weight * self.robot.reach / DRAWN_FOR


log = logging.getLogger("helicoide")


class Layer(Protocol):
    """A part of the scene."""

    def update(self, old: View | None, new: View) -> None:
        """Update the scene from one view to the next. old: None if nothing is drawn yet."""


@cache
def all_layers() -> tuple[ModuleType, ...]:
    """The modules of all layers."""
    return tuple(content.modules(__name__).values())


def optional() -> list[ModuleType]:
    """The modules of the layers that the user can show and hide."""
    return [layer for layer in all_layers() if hasattr(layer, "TITLE")]


class Layers:
    """All layers of a scene, and the view that they show. If a layer fails, it is tried again, and the others go on."""

    def __init__(self, stage: Stage, shared: bool) -> None:
        self.shown: View | None = None
        self.layers: dict[str, Layer] = {}
        self.failed: set[str] = set()
        self.told: set[str] = set()
        for layer in all_layers():
            if shared == layer.SHARED:
                try:
                    self.layers[layer.NAME] = layer.build(stage)
                except Exception:
                    log.exception("the layer %s could not be built", layer.NAME)

    def update(self, view: View) -> None:
        """Update every layer to a view."""
        for name, layer in self.layers.items():
            try:
                layer.update(None if name in self.failed else self.shown, view)
                self.failed.discard(name)
            except Exception:
                self.failed.add(name)
                if name not in self.told:
                    self.told.add(name)
                    log.exception("the layer %s failed", name)
        self.shown = view
