"""Tasks for the methods of the sources while the instrument stays in an entry point.

If the orientation is controlled, the method inverts the constrained Jacobian J^r and the pseudoinverse inverts J_i. If
not, tip and entry point are one task for the method. Source: Coutinho 2015, §3.4, fig. 3.3.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import EntryPoint, Problem
from helicoide.ik.clik import TaskError
from helicoide.ik.controller import Controller, Gains, ToolTarget, reference_velocity, step
from helicoide.ik.guard.entry import GAIN
from helicoide.ik.method import Task
from helicoide.ik.objective import Posture
from helicoide.ik.rcm import rod
from helicoide.ik.rcm.constrained import Constrained, constrained
from helicoide.ik.rcm.follow import PSEUDOINVERSE, pose_error
from helicoide.ik.rcm.passage import Passage, passage_refusal, through
from helicoide.ik.rcm.rod import TipTask
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

NOTHING_FREE = Text(
    en="The entry point and the orientation leave no redundant joint for an objective: switch one of them off.",
    pt_BR="O ponto de entrada e a orientação não deixam junta redundante para um objetivo: desligue um deles.",
)


def passage_of(robot: Robot, entry: EntryPoint) -> Passage:
    """The passage of the link that carries the instrument."""
    return through(robot, entry.link)


def refused(problem: Problem, with_orientation: bool, controller: Controller) -> Text | None:
    """Why the task with an entry point cannot be solved; None if it can."""
    assert problem.entry is not None
    passage = passage_of(problem.robot, problem.entry)
    if not with_orientation:
        return rod.rod_refusal(problem.robot, passage)
    return passage_refusal(problem.robot, passage) or (NOTHING_FREE if controller.secondary is not None else None)


def tip_task(problem: Problem, entry: EntryPoint, q: Array, target: ToolTarget, gains: Gains, dt: float) -> Task:
    """The task (5, n) that brings the tip to its target point and the shaft to the entry point: ν = ẋ_d + Λ e.

    Args: q (n,), rad or m; dt, s.
    """
    reference = TipTask(target.T_world_target[:3, 3], target.ahead, entry.point, np.zeros(2))
    aim = rod.aim(problem, passage_of(problem.robot, entry), q, reference)
    nu = reference_velocity(replace(aim, error=aim.error[:3], feedforward=aim.feedforward[:3]), gains)
    return Task(q, aim.J, np.concatenate([nu, GAIN * aim.error[3:]]), dt)


def tool_velocity(at: Constrained, target: ToolTarget, gains: Gains) -> Array:
    """ν (6,), body velocity of the tool, m/s and rad/s: `follow.body_velocity` with a gain for each world axis.

    Limited by `controller.reference_velocity`.
    """
    R, length = at.T_world_tool[:3, :3], at.problem.length
    error = pose_error(target.T_world_target, at.T_world_tool)
    scaled = np.concatenate([(R @ error[:3]) / length, 2.0 * error[3:]])
    nu = reference_velocity(TaskError(np.empty((6, 0)), scaled, np.append(target.ahead / length, np.zeros(3))), gains)
    return np.concatenate([R.T @ nu[:3] * length - np.cross(nu[3:], error[:3]), nu[3:]])


def rcm_step(
    problem: Problem, posture: Posture, target: ToolTarget, controller: Controller, dt: float
) -> tuple[Array, Controller]:
    """The joint displacement Δq (n,), rad or m, that the method asks for, and the controller after it. dt, s."""
    q, entry = posture.q, problem.entry
    assert entry is not None
    if (why := refused(problem, target.with_orientation, controller)) is not None:
        return np.zeros(len(q)), replace(controller, memory=None, solution=None, refusal=why)
    if not target.with_orientation:
        task = tip_task(problem, entry, q, target, controller.gains, dt)
        return step(problem, task, posture.poses, controller)
    at = constrained(problem, passage_of(problem.robot, entry), q, entry.point)
    asked = GAIN * at.place.lateral
    task = at.task(tool_velocity(at, target, controller.gains), asked, dt)
    inverse = controller.inverse
    if (why := inverse.method.applies(task)) is not None:
        return np.zeros(len(q)), replace(controller, memory=None, solution=None, refusal=why)
    tool, memory = inverse.answered(problem, task, controller.memory)
    arm, _ = PSEUDOINVERSE.answered(problem, at.arm_task(at.shaft_velocity(tool.rates, asked), dt), None)
    return at.rates(arm.rates, tool.rates) * dt, replace(controller, memory=memory, solution=tool, refusal=None)
