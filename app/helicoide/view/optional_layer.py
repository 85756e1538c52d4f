"""What the layers that people show and hide have in common: they draw only while they are shown."""

from __future__ import annotations

from abc import ABC, abstractmethod

import viser

from helicoide.view.layers import Stage
from helicoide.view.window_view import View


class OptionalLayer(ABC):
    """A layer that adds its nodes when it is first shown, and draws when what it depends on has changed.

    Its nodes are below `/name`, which is hidden with the layer. It waits until the kernels are compiled.
    """

    def __init__(self, stage: Stage, name: str) -> None:
        self.stage, self.name = stage, name
        self.root: viser.FrameHandle | None = None
        self.drawn: tuple[object, ...] = ()

    def depends(self, view: View) -> tuple[object, ...]:
        """What the drawing depends on: parts of a view that are replaced when they change."""
        return (view.state.arm.q,)

    @abstractmethod
    def draw(self, view: View) -> None:
        """Draw what a view shows."""

    def update(self, old: View | None, new: View) -> None:
        """Draw if the layer is shown and something has changed."""
        shown = new.seat.visible_layers[self.name] and new.ready
        if shown:
            if self.root is None:
                self.root = self.stage.scene.add_frame(f"/{self.name}", show_axes=False, visible=False)
            parts = (new.seat.language, *self.depends(new))
            if old is None or len(parts) != len(self.drawn) or any(map(_differ, parts, self.drawn)):
                self.draw(new)
                self.drawn = parts
        if self.root is not None and self.root.visible != shown:
            self.root.visible = shown


def _differ(one: object, other: object) -> bool:
    return one is not other
