"""The directions in which the tool has lost its velocity, near a singularity."""

from __future__ import annotations

import numpy as np

from helicoide import readout
from helicoide.text import Text
from helicoide.view.colours import ORANGE, VERMILION
from helicoide.view.figures import Segments
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "singular"
SHARED = False
TITLE = Text(en="Singular directions", pt_BR="Direções singulares")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="Near a singularity: the direction in which the end effector hardly moves (thick line) and the axis about which "
    "it hardly turns (thin line), at most 5 % of its best. Elsewhere nothing is drawn.",
    pt_BR="Perto de uma singularidade: a direção em que o efetuador quase não se move (linha grossa) e o eixo em torno "
    "do qual quase não gira (linha fina), no máximo 5 % do melhor. Longe dela nada é desenhado.",
)

HALF = 0.4  # half the line of a direction that is a pure translation or rotation, × size, m


def build(stage: Stage) -> SlowDirectionsLayer:
    """The layer."""
    return SlowDirectionsLayer(stage, NAME)


class SlowDirectionsLayer(OptionalLayer):
    """A line through the tool for each part of a direction, with the length of its share."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.linear = Segments(stage, f"/{name}/linear", VERMILION, 0.012)
        self.angular = Segments(stage, f"/{name}/angular", ORANGE, 0.005)

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture, and whether the orientation counts."""
        return view.state.arm.q, view.state.request.with_orientation

    def draw(self, view: View) -> None:
        """Draw the lines, or nothing."""
        slow, tool = readout.slow_directions(view.state).T, view.state.T_world_tool[:3, 3]
        half = HALF * self.stage.size
        for lines, ways in ((self.linear, half * slow[:, :3]), (self.angular, half * slow[:, 3:])):
            seen = np.linalg.norm(ways, axis=1) > 1e-3 * half
            lines.write(np.stack([tool - ways, tool + ways], axis=1)[seen])
