"""A wrench on the tool, its central axis, and the joint torques that balance it."""

from __future__ import annotations

import numpy as np

from helicoide import gate, readout
from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view.colours import GREEN, ORANGE, PURPLE
from helicoide.view.figures import Arrows, Names, Segments
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.requests import ForSeat, PageRequest
from helicoide.view.rows import Row, VectorRow
from helicoide.view.window_view import View

NAME = "wrench"
SHARED = False
TITLE = Text(en="Wrench and joint torques", pt_BR="Heliforça e torques de junta")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="A force (orange) and a moment (purple) on the end effector, the axis of this wrench, and along each joint axis "
    "the torque in N·m, or force in N, that balances it (green), without the weight of the arm. Lengths are relative.",
    pt_BR="Uma força (laranja) e um momento (púrpura) no efetuador, o eixo dessa heliforça e, em cada eixo de junta, o "
    "torque em N·m, ou a força em N, que a equilibra (verde), sem o peso do braço. Os comprimentos são relativos.",
)

ARROW, HALF = 0.25, 0.6  # the longest arrow of each kind, and half the axis, × size, m
LEAST = 1e-9  # N·m or N: what is smaller counts as zero
FORCE = Text(en="Force on the end effector [N]", pt_BR="Força no efetuador [N]")
MOMENT = Text(en="Moment on the end effector [N·m]", pt_BR="Momento no efetuador [N·m]")
NEWTONS = Text(en="{value:z.1f} N", pt_BR="{value:z.1f} N")
NEWTON_METRES = Text(en="{value:z.1f} N·m", pt_BR="{value:z.1f} N·m")


def rows(robot: Robot) -> list[Row]:
    """The force and the moment."""

    def force(view: View, values: tuple[float, float, float]) -> PageRequest:
        return ForSeat(gate.set_force(values))

    def moment(view: View, values: tuple[float, float, float]) -> PageRequest:
        return ForSeat(gate.set_moment(values))

    return [VectorRow(FORCE, 1.0, _force, force), VectorRow(MOMENT, 0.1, _moment, moment)]


def _force(view: View) -> tuple[float, float, float]:
    x, y, z, *_ = view.seat.wrench
    return x, y, z


def _moment(view: View) -> tuple[float, float, float]:
    *_, x, y, z = view.seat.wrench
    return x, y, z


def build(stage: Stage) -> WrenchLayer:
    """The layer."""
    return WrenchLayer(stage, NAME)


def moved_joints(robot: Robot) -> list[int]:
    """For each joint variable the first joint of the chain that it moves, by index."""
    return [int(np.argmax(robot.chain["driver"] == i)) for i in range(len(robot.variables))]


class WrenchLayer(OptionalLayer):
    """The arrows, the axis and the numbers."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.force = Arrows(stage, f"/{name}/force", ORANGE, 0.006)
        self.moment = Arrows(stage, f"/{name}/moment", PURPLE, 0.006)
        self.axis = Segments(stage, f"/{name}/axis", ORANGE, 0.002)
        self.torques = Arrows(stage, f"/{name}/torques", GREEN, 0.006)
        self.names = Names(stage, f"/{name}")

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture and wrench."""
        return view.state.arm.q, view.seat.wrench

    def draw(self, view: View) -> None:
        """Draw the wrench at the tool and a torque on each joint axis."""
        state, length = view.state, ARROW * self.stage.size
        wrench, torques = np.array(view.seat.wrench), readout.balancing_torques(state, view.seat.wrench)
        tool, language = state.T_world_tool[:3, 3], view.seat.language
        sizes = np.linalg.norm(wrench.reshape(2, 3), axis=1)
        texts, places = [], []
        for arrow, vector, size, words in zip(
            (self.force, self.moment), wrench.reshape(2, 3), sizes, (NEWTONS, NEWTON_METRES), strict=True
        ):
            head = tool + length * vector / size if size else tool
            arrow.write(np.array([[tool, head]])[: int(size > 0)])
            if size > 0:
                texts.append(words.format(value=float(size))[language])
                places.append(head)
        self.axis.write(self._axis(view))
        joints = moved_joints(state.robot)
        points, axes, largest = state.arm.poses[1:, :3, 3][joints], state.axes[joints], float(np.abs(torques).max())
        heads = points + length * (torques / max(largest, LEAST))[:, None] * axes
        self.torques.write(np.stack([points, heads], axis=1)[np.abs(torques) > LEAST])
        for joint, torque, head in zip(state.robot.variables, torques.tolist(), heads, strict=True):
            texts.append((NEWTONS if joint.is_prismatic else NEWTON_METRES).format(value=torque)[language])
            places.append(head)
        self.names.write(texts, places)

    def _axis(self, view: View) -> Array:
        axis = readout.wrench_axis(view.state, view.seat.wrench)
        if axis is None:
            return np.zeros((0, 2, 3))
        half = HALF * self.stage.size * axis.direction
        return np.array([[axis.point - half, axis.point + half]])
