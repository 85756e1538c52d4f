"""The posture whose tool is nearest to a goal, by least squares: for arms without a closed form."""

from __future__ import annotations

from functools import lru_cache

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.numeric import WITHIN, approached
from helicoide.ik.postures.packed import HELD, Search, search_of, wide
from helicoide.kinematics.robot import Robot

STEPS, SEARCHES = 200, 12


def nearest_posture(robot: Robot, T_world_goal: Array, q: Array, with_orientation: bool) -> Array:
    """The best of several minima of ‖Δp‖²/ℓ² + ‖Δθ‖², ℓ the reach, or of ‖Δp‖² alone: (n,), rad or m.

    Prismatic joints keep their limits, angles are free. The searches start at q (n,) and at fixed other postures. The
    arm can take the result, but a nearer minimum may exist.
    Args: T_world_goal (4, 4), m. Source: `restarts.approach`.
    """
    return frozen(approached(_towards(robot, with_orientation), T_world_goal.copy(), q.copy()))


@lru_cache(maxsize=32)
def _towards(robot: Robot, with_orientation: bool) -> Search:
    ranges = wide(robot)
    ranges[:, HELD] = [joint.is_prismatic for joint in robot.variables]
    return search_of(robot, ranges, float(with_orientation), WITHIN, STEPS, SEARCHES)
