"""The point clouds: points on the plane that was found are green, the others grey."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.state import FittedCloud
from helicoide.text import Text
from helicoide.view.colours import GREEN, GREY
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "cloud"
SHARED = False
TITLE = Text(en="Point clouds", pt_BR="Nuvens de pontos")
SHOWN = True
KIND = "confinement"
SAID = Text(
    en="The measured points: those on the plane that was found are green, the others grey.",
    pt_BR="Os pontos medidos: os do plano encontrado em verde, os outros em cinza.",
)

OFF_IT, ON_IT = GREY, GREEN
SIZE, MOST = 0.0025, 20_000


def build(stage: Stage) -> Clouds:
    """The layer, without clouds at first."""
    return Clouds(stage)


class Clouds:
    """A cloud for each plane that was searched for."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.clouds: dict[str, viser.PointCloudHandle] = {}
        self.drawn: dict[str, FittedCloud] = {}

    def update(self, old: View | None, new: View) -> None:
        """Draw new clouds, and show or hide all."""
        seen, shown = new.state.clouds, new.seat.visible_layers[NAME]
        if old is None or old.state.clouds is not seen:
            for name, one in seen.items():
                if self.drawn.get(name) is not one:
                    self._draw(name, one)
        for name, cloud in self.clouds.items():
            if cloud.visible != (shown and name in seen):
                cloud.visible = shown and name in seen

    def _draw(self, name: str, seen: FittedCloud) -> None:
        self.drawn[name] = seen
        kept = np.unique(np.linspace(0, len(seen.points) - 1, min(MOST, len(seen.points))).astype(int))
        colours = np.where(seen.on_plane[kept, None], ON_IT, OFF_IT).astype(np.uint8)
        points = seen.points[kept].astype(np.float32)
        self.clouds[name] = self.stage.scene.add_point_cloud(
            f"/cloud/{name}", points, colours, point_size=SIZE * self.stage.size
        )
