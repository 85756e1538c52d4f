"""The remote centre of motion: a ring at the entry point, the shaft through it, and where the shaft has been."""

from __future__ import annotations

from collections import deque

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import EntryPoint
from helicoide.kinematics.dh_parts import arc
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.colours import GREY, PURPLE, SKY
from helicoide.view.figures import Names, Segments, polyline
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "shaft"
SHARED = False
TITLE = Text(en="RCM ring and shaft poses", pt_BR="Anel do RCM e poses da haste")
SHOWN = False
KIND = "confinement"
SAID = Text(
    en="With an entry point: a ring around it, perpendicular to the shaft; the axis of the shaft down to the end "
    "effector; its last 60 poses in grey; and how far the axis passes from the entry point, in mm.",
    pt_BR="Com um ponto de entrada: um anel em torno dele, perpendicular à haste; o eixo da haste até o efetuador; as "
    "últimas 60 poses em cinza; e a que distância do ponto de entrada o eixo passa, em mm.",
)

RING, MOST, SPACING = (
    0.03,
    60,
    0.01,
)  # radius of the ring × size, m; kept poses; motion of the tip between two × size, m
PASSES = Text(en="{mm:.2f} mm", pt_BR="{mm:.2f} mm")


def build(stage: Stage) -> ShaftLayer:
    """The layer, which draws nothing without an entry point."""
    return ShaftLayer(stage, NAME)


def shaft_segment(state: State, entry: EntryPoint) -> Array:
    """The axis of the shaft (2, 3), m: from its point on the link to the point nearest to the tool."""
    T = state.arm.poses[entry.link]
    start, along = T[:3, :3] @ entry.shaft[0] + T[:3, 3], T[:3, :3] @ entry.shaft[1]
    return np.array([start, start + ((state.T_world_tool[:3, 3] - start) @ along) * along])


def distance_to_axis(line: Array, point: Array) -> float:
    """The distance of a point (3,), m, from the line through two points (2, 3), m."""
    along = line[1] - line[0]
    return float(np.linalg.norm(np.cross(point - line[0], along)) / np.linalg.norm(along))


class ShaftLayer(OptionalLayer):
    """The ring, the shaft and its earlier poses, which are forgotten when the entry point moves."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.ring = Segments(stage, f"/{name}/ring", PURPLE, 0.005)
        self.shaft = Segments(stage, f"/{name}/axis", SKY, 0.005)
        self.before = Segments(stage, f"/{name}/poses", GREY, 0.0015)
        self.names = Names(stage, f"/{name}")
        self.entry: EntryPoint | None = None
        self.poses: deque[Array] = deque(maxlen=MOST)

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture and entry point."""
        return view.state.arm.q, view.state.problem.entry

    def draw(self, view: View) -> None:
        """Draw the shaft as it is now, or nothing."""
        state, entry = view.state, view.state.problem.entry
        if entry is not self.entry:
            self.entry = entry
            self.poses.clear()
        if entry is None:
            for part in (self.ring, self.shaft, self.before):
                part.write(np.zeros((0, 2, 3)))
            self.names.write([], [])
            return
        segment = shaft_segment(state, entry)
        if not self.poses or np.abs(segment - self.poses[-1]).max() > SPACING * self.stage.size:
            self.poses.append(segment)
        along = state.arm.poses[entry.link][:3, :3] @ entry.shaft[1]
        side = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
        ring = arc(entry.point, side / np.linalg.norm(side), along, 2 * np.pi, RING * self.stage.size)
        self.ring.write(polyline(ring))
        self.shaft.write(segment[None])
        self.before.write(np.array(self.poses))
        mm = 1000 * distance_to_axis(np.array([segment[0], segment[0] + along]), entry.point)
        self.names.write([PASSES.format(mm=mm)[view.seat.language]], [entry.point])
