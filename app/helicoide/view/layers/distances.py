"""Dimension lines: the shortest distances from the arm to each plane and each obstacle."""

from __future__ import annotations

import numpy as np

from helicoide import readout
from helicoide.confinement import Zone
from helicoide.text import Text
from helicoide.view.colours import BLUE, ORANGE, VERMILION
from helicoide.view.figures import Names, Segments
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "distances"
SHARED = False
TITLE = Text(en="Distances", pt_BR="Distâncias")
SHOWN = False
KIND = "confinement"
SAID = Text(
    en="The shortest lines to each plane, from the nearest monitored point, and to each obstacle, from the nearest "
    "body of the arm, in mm. Thin blue: free; orange: within the warning distance; thick red: at the least one.",
    pt_BR="As linhas mais curtas até cada plano, desde o ponto monitorado mais próximo, e até cada obstáculo, desde o "
    "corpo mais próximo do braço, em mm. Azul fina: livre; laranja: na distância de aviso; vermelha grossa: na mínima.",
)

# Colours, and thicknesses, × size, m.
STYLES = {Zone.FREE: (BLUE, 0.002), Zone.WARNING: (ORANGE, 0.004), Zone.CRITICAL: (VERMILION, 0.007)}
MILLIMETRES = Text(en="{mm:z.0f} mm", pt_BR="{mm:z.0f} mm")


def build(stage: Stage) -> DistancesLayer:
    """The layer."""
    return DistancesLayer(stage, NAME)


class DistancesLayer(OptionalLayer):
    """The lines by zone, and their lengths at their middles."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.lines = {zone: Segments(stage, f"/{name}/{zone.name}", *style) for zone, style in STYLES.items()}
        self.names = Names(stage, f"/{name}")

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture, planes and obstacles."""
        return view.state.arm.q, view.state.problem, view.state.arm.parked

    def draw(self, view: View) -> None:
        """Draw all lines."""
        found = readout.dimension_lines(view.state)
        for zone, lines in self.lines.items():
            lines.write(found.ends[np.array([one is zone for one in found.zones], dtype=bool)])
        said = [MILLIMETRES.format(mm=1000 * length)[view.seat.language] for length in found.lengths.tolist()]
        self.names.write(said, found.ends.mean(axis=1))
