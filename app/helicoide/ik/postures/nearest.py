"""The posture whose tool comes nearest to a goal, by least squares: for arms without a closed form."""

from __future__ import annotations

from helicoide.ik.postures.descent import HELD
from helicoide.ik.postures.numeric import searcher
from helicoide.ik.postures.restarts import approach
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot

STEPS, SEARCHES = 200, 12


def nearest(robot: Robot, T_world_goal: Array, q: Array, with_orientation: bool) -> Array:
    """The best of several minima of ‖Δp‖²/ℓ² + ‖Δθ‖², ℓ the reach, or of ‖Δp‖² alone: (n,), rad or m.

    Slides keep their stroke, angles are free. The search starts at q (n,) and at postures that are always the same;
    what it finds is reached, but another minimum could lie nearer still.
    Args: T_world_goal (4, 4), m. Source: `restarts.approach`.
    """
    of = searcher(robot)
    ranges = of.wide.copy()
    ranges[:, HELD] = [joint.slides for joint in robot.variables]
    weights = (1.0 / of.reach, float(with_orientation))
    return frozen(approach(of.arm, ranges, T_world_goal.copy(), q.copy(), weights, STEPS, SEARCHES))
