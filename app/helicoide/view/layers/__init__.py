"""The layers of the scene, one module each.

A module defines NAME, SHARED (whether one layer serves all windows) and `build(stage)`. A layer has `update(old, new)`,
which writes only what changed. A layer that the user can show and hide is not shared, and its module also defines:

- TITLE, its name on the page, and SAID, one line that says what is seen, in words and units;
- KIND, a key of `KINDS`: the heading under which it is listed; SHOWN, whether it is shown at first;
- `rows(robot)`, if it has settings; `moves(view)`, if it moves while the arm is at rest: whether it does so now;
  `needs(view)`, if it shows what takes long to compute: the request for it, or None if that is there.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Protocol

import viser

from helicoide import content
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.requests import Act, PageRequest
from helicoide.view.shapes import Shape
from helicoide.view.window_view import View

DRAWN_FOR = 0.82
KINDS = {
    "arm": Text(en="Arm and motion", pt_BR="Braço e movimento"),
    "algebra": Text(en="Frames and algebra", pt_BR="Referenciais e álgebra"),
    "velocity": Text(en="Velocities and forces", pt_BR="Velocidades e forças"),
    "confinement": Text(en="Planes, obstacles, entry point", pt_BR="Planos, obstáculos, ponto de entrada"),
    "comparison": Text(en="Other postures and arms", pt_BR="Outras posturas e braços"),
}


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


@cache
def optional() -> tuple[ModuleType, ...]:
    """The modules of the layers that the user can show and hide, in the order of `KINDS`."""
    kinds = list(KINDS)
    found = (layer for layer in all_layers() if hasattr(layer, "TITLE"))
    return tuple(sorted(found, key=lambda one: kinds.index(one.KIND)))


def _shown_with(member: str, view: View) -> list[ModuleType]:
    """The layers that a view shows and whose modules define a member; none until the kernels are compiled."""
    return [layer for layer in _optional_with(member) if view.ready and view.seat.visible_layers[layer.NAME]]


@cache
def _optional_with(member: str) -> tuple[ModuleType, ...]:
    return tuple(layer for layer in optional() if hasattr(layer, member))


def any_moves(view: View) -> bool:
    """Whether a layer that the view shows moves by itself, so that it is drawn again although nothing has changed."""
    return any(layer.moves(view) for layer in _shown_with("moves", view))


def needed(view: View) -> Iterator[PageRequest]:
    """Requests for what the shown layers of a view need and its state does not have."""
    for layer in _shown_with("needs", view):
        request = layer.needs(view)
        if request is not None:
            yield request


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
