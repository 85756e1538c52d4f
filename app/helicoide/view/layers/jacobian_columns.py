"""The columns of the tool's Jacobian as arrows: what each joint alone does to the tool."""

from __future__ import annotations

import numpy as np

from helicoide import readout
from helicoide.readout.signal import subscript
from helicoide.text import Text
from helicoide.view.colours import BLUE, ORANGE
from helicoide.view.figures import Arrows, Names
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

NAME = "columns"
SHARED = False
TITLE = Text(en="Jacobian columns", pt_BR="Colunas da jacobiana")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="Arrows J₁, J₂, …: the velocity of the end effector if only that joint moves, at 1 rad/s or 1 m/s. Blue: "
    "linear, 250 mm long for 1 m/s; orange: angular, for 1 rad/s.",
    pt_BR="Setas J₁, J₂, …: a velocidade do efetuador se só aquela junta se move, a 1 rad/s ou 1 m/s. Azul: linear, "
    "com 250 mm para 1 m/s; laranja: angular, para 1 rad/s.",
)

LINEAR = 0.25  # m for 1 m/s, so that the arrows grow with the arm
ANGULAR = 0.12  # × size, m for 1 rad/s


def build(stage: Stage) -> ColumnsLayer:
    """The layer."""
    return ColumnsLayer(stage, NAME)


class ColumnsLayer(OptionalLayer):
    """The arrows and their names."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.linear = Arrows(stage, f"/{name}/linear", BLUE)
        self.angular = Arrows(stage, f"/{name}/angular", ORANGE, 0.0025)
        self.names = Names(stage, f"/{name}")

    def draw(self, view: View) -> None:
        """Draw the arrows that have a length."""
        J, tool = readout.world_jacobian(view.state), view.state.T_world_tool[:3, 3]
        heads = tool + LINEAR * J[:3].T
        turns = tool + ANGULAR * self.stage.size * J[3:].T
        moves, rotates = (np.linalg.norm(part, axis=0) > 1e-9 for part in (J[:3], J[3:]))
        tools = np.broadcast_to(tool, heads.shape)
        self.linear.write(np.stack([tools, heads], axis=1)[moves])
        self.angular.write(np.stack([tools, turns], axis=1)[rotates])
        ends = np.where(moves[:, None], heads, turns)
        self.names.write([subscript("J", i + 1) for i in range(len(ends))], ends)
