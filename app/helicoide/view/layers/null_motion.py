"""Null-space motion: a ghost of the arm that moves its joints while its tool stays in place."""

from __future__ import annotations

from functools import lru_cache
from math import inf

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.self_motion import Rows, freest_joint, self_motion_step
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.colours import PURPLE
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "null"
SHARED = False
TITLE = Text(en="Null-space motion", pt_BR="Movimento no espaço nulo")
SHOWN = False
KIND = "velocity"
SAID = Text(
    en="A ghost of the arm that moves to and fro without moving the end effector, for an arm with more joints than the "
    "task needs; with “Keep orientation” off, the position alone counts. Without a null space nothing is drawn.",
    pt_BR="Um fantasma do braço que vai e vem sem mover o efetuador, se o braço tem mais juntas do que a tarefa "
    "requer; sem “Manter a orientação”, só a posição conta. Sem espaço nulo nada é desenhado.",
)

# rad/s, and rad, of the joint velocities and of the joint that moves most; for prismatic joints in reaches. Longest
# time step, s: after a pause the ghost goes on where it was.
SPEED, AMPLITUDE, LONGEST_STEP = 0.5, 0.7, 0.1


def build(stage: Stage) -> NullMotionLayer:
    """The layer, which draws nothing for an arm without a null space."""
    return NullMotionLayer(stage, NAME)


def moves(view: View) -> bool:
    """While there is a null space."""
    return _followed_joint(view.state) is not None


@lru_cache(maxsize=4)
def _followed_joint(state: State) -> int | None:
    """The joint that the ghost follows; None without a null space. Cached, as all windows share it."""
    return freest_joint(state.robot, state.arm.q, counted_rows(state.robot, state.request.with_orientation))


class NullMotionLayer(OptionalLayer):
    """The ghost: its joint values, the joint that it follows, None without a null space, and its sense."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.outline = Outline(stage, name, PURPLE)
        self.begun = self.q = np.zeros(0)
        self.rows: Rows = np.zeros(0, dtype=bool)
        self.joint: int | None = None
        self.way, self.time = 1.0, -inf

    def depends(self, view: View) -> tuple[object, ...]:
        """Posture, whether the orientation counts, and the time."""
        return view.state.arm.q, view.state.request.with_orientation, view.time

    def draw(self, view: View) -> None:
        """Move the ghost on; it begins again where the arm is when the arm has moved."""
        state, robot = view.state, self.stage.robot
        rows = counted_rows(robot, state.request.with_orientation)
        if self.begun is not state.arm.q or self.rows is not rows:
            self.begun, self.rows, self.q, self.way = state.arm.q, rows, state.arm.q, 1.0
            self.joint = _followed_joint(state)
        step = SPEED * min(max(view.time - self.time, 0.0), LONGEST_STEP)
        self.time = view.time
        self.outline.show(self.joint is not None)
        if self.joint is not None:
            self._advance(robot, state.T_world_tool, self.joint, step)
            self.outline.write(link_poses(robot.chain, self.q), state.arm.gripper)

    def _advance(self, robot: Robot, T_world_tool: Array, joint: int, step: float) -> None:
        """One step; the ghost turns back at a joint limit and when its joint has moved far enough."""
        q = self_motion_step(robot, self.q, T_world_tool, self.rows, joint, self.way * step)
        away = float(q[joint] - self.begun[joint]) / (robot.reach if robot.variables[joint].is_prismatic else 1.0)
        outside = bool(((q < robot.lower) | (q > robot.upper)).any())
        if outside or away * self.way > AMPLITUDE:
            self.way = -self.way
        if not outside:
            self.q = q
