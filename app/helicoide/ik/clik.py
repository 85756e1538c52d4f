"""Closed-loop inverse kinematics: a method computes joint velocities from the feedforward and the error of the tool.

    ν = ẋ_d + Λ e,   q̇ = method(J, ν) + (I − J† J) q̇₀,   q ← q + q̇ Δt

Source: Vargas 2013, eqs. 2.33–2.51; Cerbaro 2022, §4.4.2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from math import sin, sqrt
from typing import Any, Literal

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem
from helicoide.ik.method import ConfiguredMethod, Solution, Task
from helicoide.ik.task import rotation_error
from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import analyse_jacobian

OrientationError = Literal["rotation vector", "quaternion"]
STILL = frozen(np.zeros(6))


@dataclass(frozen=True, eq=False)
class TaskError:
    """Jacobian, error and feedforward at one posture and instant, lengths divided by ℓ (see `method.Task`).

    J (r, n); error: e (r,); feedforward: velocity ẋ_d of the target, (r,), 1/s.
    """

    J: Array
    error: Array
    feedforward: Array


TaskFunction = Callable[[Array, float], TaskError]
# q̇₀ (n,) as a function of q (n,) and t, s.
NullSpaceVelocity = Callable[[Array, float], Array]


def quaternion_vector_error(R_target: Array, R_tool: Array) -> Array:
    """Vector part of Q_d * Q_e⁻¹, the shorter way round, world frame, (3,): sin(ϑ/2) a, about half the angle.

    Args: rotations (3, 3). Source: Vargas 2013, eqs. 2.40–2.43; the sign is reversed where Δη < 0.
    """
    vector = rotation_error(R_target, R_tool)
    half = sqrt(vector @ vector) / 2
    return np.asarray(vector * (sin(half) / (2 * half) if half > 0 else 0.5))


def tool_task_error(
    problem: Problem,
    poses: Array,
    T_world_target: Array,
    with_orientation: bool,
    ahead: Array = STILL,
    measure: OrientationError = "rotation vector",
) -> TaskError:
    """The task of bringing the tool to a pose: three rows of position over ℓ, then three of orientation if asked for.

    Args: poses (m + 1, 4, 4) of `forward.link_poses`; T_world_target (4, 4), m; ahead: (v, ω) of the target, (6,),
    m/s and rad/s; measure: of the orientation error.
    """
    chain, length = problem.robot.chain, problem.length
    T = poses[-1] @ problem.robot.T_link_tool
    J = jacobian.geometric_jacobian(poses, chain, jacobian.joint_axes(poses, chain), T[:3, 3].copy(), len(chain))
    J *= problem.joint_units
    J[:3] /= length
    rows = 6 if with_orientation else 3
    error = np.zeros(rows)
    error[:3] = (T_world_target[:3, 3] - T[:3, 3]) / length
    if with_orientation:
        turned = rotation_error if measure == "rotation vector" else quaternion_vector_error
        error[3:] = turned(T_world_target[:3, :3].copy(), T[:3, :3].copy())
    rate = ahead[:rows].copy()
    rate[:3] /= length
    return TaskError(J[:rows], error, rate)


def to_pose(problem: Problem, T_world_target: Array, with_orientation: bool = True) -> TaskFunction:
    """The task of a fixed target pose (4, 4), m."""
    return lambda q, t: tool_task_error(problem, link_poses(problem.robot.chain, q), T_world_target, with_orientation)


@dataclass(frozen=True, eq=False)
class ControlLaw:
    """The control law q̇ = inverse(J)(ẋ_d + Λ e) of a closed loop, and its sample time.

    gains: Λ, 1/s, one for all rows or (r,); dt, s. Source: Vargas 2013, eq. 2.33; Cerbaro 2022, §4.4.2.
    """

    inverse: ConfiguredMethod
    gains: Array | float
    dt: float

    def task(self, aim: TaskError, q: Array) -> Task:
        """The task of one step at q (n,), rad or m."""
        return task_from(aim, self.gains, q, self.dt)


def task_from(aim: TaskError, gains: Array | float, q: Array, dt: float) -> Task:
    """The task with ν = ẋ_d + Λ e. Args: gains: Λ, 1/s, one for all rows or (r,); q (n,), rad or m; dt, s."""
    return Task(q, aim.J, aim.feedforward + gains * aim.error, dt)


def solve_with_null_space(
    problem: Problem, inverse: ConfiguredMethod, task: Task, memory: Any, push: Array | None = None
) -> tuple[Solution, Any]:
    """The solution of a method plus q̇₀ (n,) in the null space of J, and the new memory: q̇ + (I − J† J) q̇₀.

    memory: of the method, None at the start. Source: Cerbaro 2022, eq. 9; Vargas 2013, eq. 2.51.
    """
    solution, memory = inverse.answered(problem, task, memory)
    if push is None:
        return solution, memory
    return replace(solution, rates=solution.rates + analyse_jacobian(task.J).null_projector @ push), memory


@dataclass(frozen=True, eq=False)
class LoopStep:
    """One step of a closed loop: t, s; q (n,), rad or m, before it; task error; solution; memory after it."""

    t: float
    q: Array
    task_error: TaskError
    solution: Solution
    memory: Any


def closed_loop(
    problem: Problem,
    law: ControlLaw,
    aiming: TaskFunction,
    q: Array,
    push: NullSpaceVelocity | None = None,
    memory: Any = None,
) -> Iterator[LoopStep]:
    """The closed loop from q (n,), without the guarded step: an endless iterator of steps, explicit Euler in q.

    push: q̇₀ at q and t, (n,); memory: of the method, None at the start.
    """
    t = 0.0
    while True:
        aim = aiming(q, t)
        solution, memory = solve_with_null_space(problem, law.inverse, law.task(aim, q), memory, push and push(q, t))
        yield LoopStep(t, q, aim, solution, memory)
        q = q + problem.joint_units * solution.rates * law.dt
        t += law.dt
