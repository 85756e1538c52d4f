"""A golf ball that the gripper can grasp and carry."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import dist

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot_parts import Gripper

# Smallest radius that the rules of golf allow, m.
RADIUS = 0.02135
# The ball is between the fingers if its centre is within this distance of the tool's origin, m (assumed).
CATCH = 0.008


@dataclass(frozen=True, eq=False)
class Ball:
    """A ball in the scene: centre (3,), m, world frame; stands (k, 3), m: top points of its supports.

    held: its centre in the tool frame while the fingers hold it, (3,), m; else None. It has no weight: it stays where
    it is released.
    """

    centre: Array
    stands: Array = field(default_factory=lambda: frozen(np.zeros((0, 3))))
    held: Array | None = None

    def gripped(self, gripper: Gripper, before: float, after: float, T_world_tool: Array) -> tuple[Ball, float]:
        """The ball and the opening of the fingers, 0 to 1, on the way from `before` to `after`: the ball stops them."""
        on_it = closed_on(gripper)
        if after > before:
            return (self if self.held is None or after <= on_it else replace(self, held=None)), after
        if self.held is not None:
            return self, max(after, on_it)
        caught = before >= on_it > after and dist(self.centre, T_world_tool[:3, 3]) <= CATCH
        if not caught:
            return self, after
        return replace(self, held=frozen(T_world_tool[:3, :3].T @ (self.centre - T_world_tool[:3, 3]))), on_it

    def carried(self, T_world_tool: Array) -> Ball:
        """The ball moved with the tool, T_world_tool (4, 4), m, if the fingers hold it."""
        if self.held is None:
            return self
        return replace(self, centre=frozen(T_world_tool[:3, :3] @ self.held + T_world_tool[:3, 3]))


def closed_on(gripper: Gripper) -> float:
    """Opening, 0 to 1, of a gripper that holds the ball; more than 1 if the ball is too large for it."""
    return 2 * RADIUS / gripper.opening
