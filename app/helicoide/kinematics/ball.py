"""A golf ball that a gripper takes along: what there is to grasp in a scene."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import dist

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot_parts import Gripper

# The least radius that the rules of golf allow, m.
BALL_RADIUS = 0.02135
# A ball is between the fingers where its centre is so near to the tool's point, m: ours.
GRASP_DISTANCE = 0.008


@dataclass(frozen=True, eq=False)
class GolfBall:
    """A ball in the scene: centre (3,), m, world frame; supports (k, 3), m: the tops of what it may stand on.

    grasp_offset: its centre in the tool's frame while the fingers hold it, (3,), m, else None. It has no weight: it
    stays where it is let go.
    """

    centre: Array
    supports: Array = field(default_factory=lambda: frozen(np.zeros((0, 3))))
    grasp_offset: Array | None = None

    def with_gripper(
        self, gripper: Gripper, before: float, after: float, T_world_tool: Array
    ) -> tuple[GolfBall, float]:
        """The ball, and how far the fingers are open, 0 to 1, as they go from `before` to `after`: it stops them."""
        on_it = holding_opening(gripper)
        if after > before:
            return (self if self.grasp_offset is None or after <= on_it else replace(self, grasp_offset=None)), after
        if self.grasp_offset is not None:
            return self, max(after, on_it)
        caught = before >= on_it > after and dist(self.centre, T_world_tool[:3, 3]) <= GRASP_DISTANCE
        if not caught:
            return self, after
        return replace(self, grasp_offset=frozen(T_world_tool[:3, :3].T @ (self.centre - T_world_tool[:3, 3]))), on_it

    def moved_with_tool(self, T_world_tool: Array) -> GolfBall:
        """The ball where the tool, T_world_tool (4, 4), m, takes it, if it holds it."""
        if self.grasp_offset is None:
            return self
        return replace(self, centre=frozen(T_world_tool[:3, :3] @ self.grasp_offset + T_world_tool[:3, 3]))


def holding_opening(gripper: Gripper) -> float:
    """How far open, 0 to 1, a gripper is that holds the ball; more than 1 where the ball is too large for it."""
    return 2 * BALL_RADIUS / gripper.opening
