"""A golf ball that the gripper can grasp and carry."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import dist

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot_parts import Gripper

# Smallest radius that the rules of golf allow, m.
BALL_RADIUS = 0.02135
# The ball is between the fingers if its centre is within this distance of the tool's origin, m (assumed).
GRASP_DISTANCE = 0.008


@dataclass(frozen=True, eq=False)
class GolfBall:
    """A ball in the scene: centre (3,), m, world frame; supports (k, 3), m: top points of its supports.

    grasp_offset: its centre in the tool frame while the fingers hold it, (3,), m, else None. It has no weight: it stays
    where it is released.
    """

    centre: Array
    supports: Array = field(default_factory=lambda: frozen(np.zeros((0, 3))))
    grasp_offset: Array | None = None

    def with_gripper(
        self, gripper: Gripper, before: float, after: float, T_world_tool: Array
    ) -> tuple[GolfBall, float]:
        """The ball and the opening of the fingers, 0 to 1, on the way from `before` to `after`: the ball stops them."""
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
        """The ball moved with the tool, T_world_tool (4, 4), m, if the fingers hold it."""
        if self.grasp_offset is None:
            return self
        return replace(self, centre=frozen(T_world_tool[:3, :3] @ self.grasp_offset + T_world_tool[:3, 3]))


def holding_opening(gripper: Gripper) -> float:
    """Opening, 0 to 1, of a gripper that holds the ball; more than 1 if the ball is too large for it."""
    return 2 * BALL_RADIUS / gripper.opening
