"""A straight instrument on any arm: its tip follows a target point while its shaft stays in the entry point.

There is no wrist beyond the entry. The task has 3 + r rows, three for the tip and r for the entry point. The rotation
about the shaft stays free. Source: after Coutinho 2015, §3.4, §5.1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import TaskError, TaskFunction
from helicoide.ik.rcm.passage import Passage, insertion
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text


@dataclass(frozen=True, eq=False)
class TipTask:
    """The target of the tip and the entry point at one instant.

    target: p_d (3,), m; ahead: ṗ_d (3,), m/s; entry: p_rcm (3,), m; entry_rate: v_rd (r,), m/s, along the forbidden
    directions.
    """

    target: Array
    ahead: Array
    entry: Array
    entry_rate: Array


def rod_refusal(robot: Robot, passage: Passage) -> Text | None:
    """Why the tip cannot be moved in three directions; None if it can: n ≥ 3 + r."""
    n, rows = len(robot.variables), 3 + passage.r
    if n >= rows:
        return None
    return Text(
        en="{robot} has {n} joints; the tip and the entry point need at least {rows}.",
        pt_BR="{robot} tem {n} juntas; a ponta e o ponto de entrada requerem pelo menos {rows}.",
    ).format(robot=robot.title, n=n, rows=rows)


def aim(problem: Problem, passage: Passage, q: Array, task: TipTask) -> TaskError:
    """J_a = [J_p(tip); Pᵀ J_p(p_c)], e = [p_d − p; Pᵀ(p_rcm − p_c)], p_c the shaft's point nearest to the entry point.

    The columns of P are the forbidden directions in world axes. Rows are divided by ℓ. Args: q (n,), rad or m.
    Source: after Coutinho 2015, §3.4.
    """
    chain, length = problem.robot.chain, problem.length
    poses = link_poses(chain, q)
    axes = jacobian.joint_axes(poses, chain)
    tip = (poses[-1] @ problem.robot.T_link_tool)[:3, 3].copy()
    T_shaft = poses[passage.link] @ passage.T_link_shaft
    place = insertion(passage, T_shaft, task.entry)
    nearest = T_shaft[:3, 3] + place.outside * T_shaft[:3, 1]
    across = place.forbidden @ T_shaft[:3, :3].T
    of_tip = jacobian.geometric_jacobian(poses, chain, axes, tip, len(chain))[:3]
    of_entry = jacobian.geometric_jacobian(poses, chain, axes, nearest, passage.link)[:3]
    J = np.vstack([of_tip, across @ of_entry]) * problem.joint_units / length
    error = np.concatenate([task.target - tip, place.lateral]) / length
    return TaskError(J, error, np.concatenate([task.ahead, task.entry_rate]) / length)


def to_points(problem: Problem, passage: Passage, targets: Callable[[float], TipTask]) -> TaskFunction:
    """The task function for `clik.closed_loop`. Raises HelicoideError if the arm has too few joints."""
    refused = rod_refusal(problem.robot, passage)
    if refused:
        raise HelicoideError(refused)
    return lambda q, t: aim(problem, passage, q, targets(t))


def gains(passage: Passage, position: float, entry: float) -> Array:
    """Λ of the rows of `aim`: Kp for the tip, Kr for the entry point, (3 + r,), 1/s."""
    return np.array([position] * 3 + [entry] * passage.r)
