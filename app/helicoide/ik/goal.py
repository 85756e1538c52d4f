"""The accepted goal: the pose nearest to the target that the guarded arm reaches, from another posture if it helps."""

from __future__ import annotations

from dataclasses import dataclass
from math import dist, hypot

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import AtAcceleration, AtSpeed, Problem, Reason, reasons
from helicoide.ik.guard.work import work_for
from helicoide.ik.packing import packed
from helicoide.ik.rollout import Horizon, are_clear, roll_to_rest
from helicoide.ik.task import EVERY, GAIN, ORIENTATION_LENGTH, TOOL_SPEED, TOOL_TURN, allowed, rotation_error
from helicoide.kinematics.forward import link_poses

REACHED = 0.5e-3
TURNED = np.radians(1.0)
NEARER = 0.02
_AHEAD = Horizon(0.05, 120)
_COARSE = Horizon(0.1, 60)
_DRAWN, _STARTS = 400, 20


@dataclass(frozen=True, eq=False)
class Goal:
    """The accepted goal for a target.

    q (n,), rad or m, the link poses (m + 1, 4, 4) and T_world_tool (4, 4), m, at the goal; reached: whether the tool
    comes to the nearest point that the planes allow; position_error, m, and orientation_error, rad: between tool and
    target; reasons: the constraints that limit the arm there.
    """

    q: Array
    poses: Array
    T_world_tool: Array
    reached: bool
    position_error: float
    orientation_error: float
    reasons: tuple[Reason, ...]


def pose_of_tool(problem: Problem, poses: Array) -> Array:
    """T_world_tool (4, 4), m, from the link poses."""
    return frozen(poses[-1] @ problem.robot.T_link_tool)


def _goal(problem: Problem, q: Array, T_world_target: Array, multipliers: Array, tick: float) -> Goal:
    poses = frozen(link_poses(problem.robot.chain, q))
    T = pose_of_tool(problem, poses)
    target = T_world_target[:3, 3]
    short = dist(target, T[:3, 3])
    turned = hypot(*rotation_error(frozen(T_world_target[:3, :3]), frozen(T[:3, :3])))
    reach = problem.robot.reach
    turn = (ORIENTATION_LENGTH * reach) ** 2 * min(GAIN * turned, TOOL_TURN)
    pull = min(GAIN * short, TOOL_SPEED * reach) + turn
    return Goal(
        q=frozen(q),
        poses=poses,
        T_world_tool=T,
        reached=dist(allowed(packed(problem), target), T[:3, 3]) < REACHED,
        position_error=short,
        orientation_error=turned,
        reasons=tuple(
            reason
            for reason in reasons(problem, q, multipliers, tick * pull)
            if not isinstance(reason, AtSpeed | AtAcceleration)
        ),
    )


def goal_at_pose(
    problem: Problem, q: Array, T_world_target: Array, with_orientation: bool, horizon: Horizon = _AHEAD
) -> Goal:
    """Where the arm comes to rest when it is driven from q (n,), rad or m, towards T_world_target (4, 4), m."""
    arm = packed(problem.without_acceleration_limits, turn=ORIENTATION_LENGTH if with_orientation else 0.0)
    return _rest(problem, arm, q, T_world_target, (False, q, EVERY), horizon)


def goal_at_joints(problem: Problem, q: Array, q_target: Array, yielding: int = EVERY) -> Goal:
    """Where the arm comes to rest when its joints are driven from q to q_target, both (n,), rad or m.

    yielding: as in `joint_task`.
    """
    robot = problem.robot
    arm = packed(problem.without_acceleration_limits)
    T_world_target = pose_of_tool(problem, link_poses(robot.chain, q_target))
    return _rest(problem, arm, q, T_world_target, (True, q_target, yielding), _AHEAD)


def _rest(
    problem: Problem,
    arm: Array,
    q: Array,
    T_world_target: Array,
    joints: tuple[bool, Array, int],
    horizon: Horizon,
) -> Goal:
    """The goal where a packed arm comes to rest. Args: joints as in `roll_to_rest`."""
    rest, work = q.copy(), work_for(arm)
    roll_to_rest(arm, rest, T_world_target, joints, horizon, work.memory)
    return _goal(problem, rest, T_world_target, work.multipliers, horizon.dt)


def _starts(problem: Problem, q: Array) -> list[Array]:
    """Postures spread evenly over the limits (additive recurrence), without contacts, the nearest to q first."""
    limits, n = problem.limits, len(q)
    ratio = 2.0
    for _ in range(30):
        ratio = (1 + ratio) ** (1 / (n + 1))
    shares = (0.5 + np.outer(np.arange(_DRAWN), ratio ** -np.arange(1.0, n + 1))) % 1.0
    drawn = frozen([problem.robot.poses["ready"], *(limits.lower + shares * (limits.upper - limits.lower))])
    clear = drawn[are_clear(packed(problem), drawn)][:_STARTS]
    return [frozen(start) for start in sorted(clear, key=lambda start: float(np.abs(start - q).max()))]


def _better(goal: Goal, than: Goal, with_orientation: bool) -> bool:
    """Whether a goal is better than another.

    A reached goal is better than one that is not. Of two that are not, one is better if its position error is smaller
    by `NEARER`, m; of two that are, if its orientation error is smaller by `TURNED`, rad.
    """
    if goal.reached != than.reached:
        return goal.reached
    if not goal.reached:
        return goal.position_error < than.position_error - NEARER
    return with_orientation and goal.orientation_error < than.orientation_error - TURNED


def another_posture(
    problem: Problem, q: Array, T_world_target: Array, with_orientation: bool, found: Goal
) -> Goal | None:
    """A goal from another posture, better than `found`, to which the guarded arm can move from q; None without one."""
    best = found
    for start in _starts(problem, q):
        if best.reached and (best.orientation_error < TURNED or not with_orientation):
            break
        goal = goal_at_pose(problem, start, T_world_target, with_orientation, _COARSE)
        if _better(goal, best, with_orientation) and goal_at_joints(problem, q, goal.q).position_error < REACHED:
            best = goal
    return None if best is found else goal_at_pose(problem, best.q, T_world_target, with_orientation)


def best_goal(problem: Problem, q: Array, T_world_target: Array, with_orientation: bool) -> tuple[Goal, Array | None]:
    """The best goal, and the posture (n,), rad or m, to move to first; None where the goal is reached directly."""
    found = goal_at_pose(problem, q, T_world_target, with_orientation)
    better = another_posture(problem, q, T_world_target, with_orientation, found)
    return (found, None) if better is None else (better, better.q)
