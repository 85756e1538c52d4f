"""The planned motion: a ghost that makes it again and again, and the way of the tool."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.goal import pose_of_tool
from helicoide.kinematics.forward import link_poses
from helicoide.state import Plan, State
from helicoide.text import Text
from helicoide.trajectory.spline import JointSpline
from helicoide.view.colours import SKY
from helicoide.view.figures import Segments, polyline
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "plan"
SHARED = False
TITLE = Text(en="Planned motion", pt_BR="Movimento planejado")
SHOWN = True
KIND = "comparison"
SAID = Text(
    en="A ghost that makes the planned motion in its own time, and the way of the end effector. The arm moves only "
    "when the plan is executed.",
    pt_BR="Um fantasma que faz o movimento planejado no tempo dele, e o caminho do efetuador. O braço só se move "
    "quando o plano é executado.",
)

PAUSE = 1.0  # s at the end, before the ghost begins again
POINTS = 100


def build(stage: Stage) -> PlannedLayer:
    """The layer, which draws nothing without a plan."""
    return PlannedLayer(stage, NAME)


def moves(view: View) -> bool:
    """While there is a plan."""
    return view.state.plan is not None


def planned_way(state: State, plan: Plan) -> Array:
    """The positions of the tool along a plan, at most (POINTS, 3), m."""
    kept = np.unique(np.linspace(0, len(plan.q) - 1, min(POINTS, len(plan.q))).round().astype(int))
    poses = [pose_of_tool(state.problem, link_poses(state.robot.chain, plan.q[k])) for k in kept]
    return np.array(poses)[:, :3, 3]


class PlannedLayer(OptionalLayer):
    """The ghost and the way."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.outline = Outline(stage, name, SKY)
        self.way = Segments(stage, f"/{name}/way", SKY, 0.004)
        self.plan: Plan | None = None
        self.path: JointSpline | None = None
        self.began = 0.0

    def depends(self, view: View) -> tuple[object, ...]:
        """The plan, and the time while there is one."""
        return view.state.plan, None if view.state.plan is None else view.time

    def draw(self, view: View) -> None:
        """Draw the ghost where it is now, or nothing."""
        plan = view.state.plan
        if plan is not self.plan:
            self.plan, self.began = plan, view.time
            self.path = None if plan is None else JointSpline(plan.times, plan.q)
            self.way.write(np.zeros((0, 2, 3)) if plan is None else polyline(planned_way(view.state, plan)))
        self.outline.show(plan is not None)
        if self.path is not None:
            s = min((view.time - self.began) % (self.path.duration + PAUSE), self.path.duration)
            self.outline.write(link_poses(self.stage.robot.chain, self.path.q(s)), view.state.arm.gripper)
