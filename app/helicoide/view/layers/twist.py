"""The screw axis of the tool's present twist: the line about which the tool turns and along which it slides."""

from __future__ import annotations

import numpy as np

from helicoide import readout
from helicoide.text import Text
from helicoide.view.colours import BLUE, GREY
from helicoide.view.figures import Arrows, Names, Segments
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "twist"
SHARED = False
TITLE = Text(en="Twist axis", pt_BR="Eixo da velocidade espacial")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="While the end effector moves: the axis about which it turns at this instant, with the angular velocity in "
    "rad/s and the pitch in mm/rad; for a translation, the direction and mm/s.",
    pt_BR="Enquanto o efetuador se move: o eixo em torno do qual ele gira neste instante, com a velocidade angular em "
    "rad/s e o passo em mm/rad; numa translação, a direção e mm/s.",
)

HALF, ARROW = 0.6, 0.25  # half the line, and the arrow on it, × size, m
TURNS = Text(en="{speed:.2f} rad/s, {pitch:z.0f} mm/rad", pt_BR="{speed:.2f} rad/s, {pitch:z.0f} mm/rad")
SLIDES = Text(en="{speed:.0f} mm/s", pt_BR="{speed:.0f} mm/s")


def build(stage: Stage) -> TwistLayer:
    """The layer, which draws nothing while the arm stands still."""
    return TwistLayer(stage, NAME)


class TwistLayer(OptionalLayer):
    """The axis, an arrow along it, and the shortest way from the tool to it."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.line = Segments(stage, f"/{name}/axis", BLUE)
        self.arrow = Arrows(stage, f"/{name}/arrow", BLUE, 0.006)
        self.way = Segments(stage, f"/{name}/way", GREY, 0.002)
        self.names = Names(stage, f"/{name}")

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture and velocities."""
        return view.state.arm.q, view.state.arm.velocities

    def draw(self, view: View) -> None:
        """Draw the axis, or nothing."""
        axis, size = readout.twist_axis(view.state), self.stage.size
        if axis is None:
            for part in (self.line, self.arrow, self.way):
                part.write(np.zeros((0, 2, 3)))
            self.names.write([], [])
            return
        half, head = HALF * size * axis.direction, axis.point + ARROW * size * axis.direction
        self.line.write(np.array([[axis.point - half, axis.point + half]]))
        self.arrow.write(np.array([[axis.point, head]]))
        self.way.write(np.array([[view.state.T_world_tool[:3, 3], axis.point]]))
        said = (
            TURNS.format(speed=axis.size, pitch=1000 * axis.pitch)
            if axis.size
            else SLIDES.format(speed=1000 * axis.along)
        )
        self.names.write([said[view.seat.language]], [head])
