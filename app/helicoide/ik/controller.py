"""How the tool is driven to a pose on the page: by any method with its settings, always under the guard.

The guarded step works on the pose itself. Every other method answers the closed loop's task with joint rates, and the
guard lets of those through what limits and planes allow:  Δq = argmin ‖Δq − q̇ Δt‖².
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import hypot
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.ik import Problem, methods, objectives
from helicoide.ik.clik import TaskError, solve_with_null_space, tool_task_error
from helicoide.ik.guard.guarded import indices
from helicoide.ik.guard.rows import Indices
from helicoide.ik.guard.rows import Task as Rows
from helicoide.ik.limit_gains import clipped
from helicoide.ik.method import Solution, Task
from helicoide.ik.objective import Posture
from helicoide.ik.packing import packed
from helicoide.ik.postures.subspace import project
from helicoide.ik.task import GAIN, ORIENTATION_LENGTH, TOOL_SPEED, TOOL_TURN
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

GUARDED = "guarded"
Gains = tuple[float, float, float, float]
NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class SecondaryObjective:
    """What the joints do besides, with the freedom that the task leaves them.

    objective: its name; options: of it; weight: k₀, 1/s; as_row: as one more row of the task instead of in its null
    space; adapts: Algorithm 1, by which the weight of a joint grows each time it is stopped at its limit; weights: what
    they have come to, (n,), None before the first step.
    """

    objective: str
    options: Any
    weight: float = 1.0
    as_row: bool = False
    adapts: bool = False
    weights: Array | None = None


@dataclass(frozen=True, eq=False)
class Controller:
    """A method at work.

    changed: options of methods, by name, where they are not the defaults; gains: of the tool's x, y, z and of its
    orientation, 1/s; memory: of the method; solution: its last answer, None for the guarded step; refusal: why there is
    none.
    """

    method: str = GUARDED
    changed: Mapping[str, Any] = field(default_factory=lambda: NOTHING)
    gains: Gains = (GAIN, GAIN, GAIN, GAIN)
    secondary: SecondaryObjective | None = None
    memory: Any = None
    solution: Solution | None = None
    refusal: Text | None = None

    def options(self, method: str) -> Any:
        """The options of a method."""
        return self.changed.get(method) or methods.named(method).Options()

    def with_method(self, method: str) -> Controller:
        """The same drive by another method, which starts with a memory of its own."""
        return replace(self, method=method, memory=None, solution=None, refusal=None)

    def with_options(self, method: str, options: Any) -> Controller:
        """The same drive with other options of a method; what it remembers stays."""
        return replace(self, changed=MappingProxyType({**self.changed, method: options}))


def reference_velocity(aim: TaskError, gains: Gains) -> Array:
    """ν = ẋ_d + Λ e, cut to the speed of the tool: a target that jumps by metres asks for no more than a near one."""
    x, y, z, turn = gains
    asked = aim.feedforward.copy()
    asked[:3] = _no_faster(aim.feedforward[:3] + np.array([x, y, z]) * aim.error[:3], TOOL_SPEED)
    if len(asked) > 3:
        asked[3:] = _no_faster(aim.feedforward[3:] + turn * aim.error[3:], TOOL_TURN)
    return asked


def _no_faster(velocity: Array, most: float) -> Array:
    """A velocity (3,), cut to a length of at most `most`."""
    length = hypot(*velocity)
    return velocity * (most / length) if length > most else velocity


@lru_cache(maxsize=32)
def movable_rows(robot: Robot) -> NDArray[np.bool_]:
    """Which of vx vy vz ωx ωy ωz the tool of a robot can have at all, (6,): an arm in a plane has no others."""
    rng = np.random.default_rng(0)
    size = sum(np.abs(frame_jacobian(robot, rng.uniform(robot.lower, robot.upper))) for _ in range(4))
    return np.asarray(np.max(size, axis=1) > 1e-9)


def closed_loop_task(
    problem: Problem,
    q: Array,
    poses: Array,
    T_world_target: Array,
    with_orientation: bool,
    ahead: Array,
    gains: Gains,
    dt: float,
) -> Task:
    """What the closed loop asks at a posture: the rows of `clik.tool_task_error` that the tool can move along at all.

    An arm with fewer than six joints is asked for the nearest pose of its subspace, which does not set the rows of the
    task against each other.

    Args: q (n,), rad or m, and its poses; T_world_target (4, 4), m; ahead: velocity of its point, (3,), m/s; dt, s.
    """
    goal = project(problem.robot, T_world_target, q).T_world_goal if with_orientation else T_world_target
    aim = tool_task_error(problem, poses, goal, with_orientation, np.append(ahead, np.zeros(3)))
    rows = movable_rows(problem.robot)[: len(aim.J)]
    return Task(q, aim.J[rows], reference_velocity(aim, gains)[rows], dt)


def step(problem: Problem, task: Task, poses: Array, drive: Controller) -> tuple[Array, Controller]:
    """The joint displacement Δq (n,), rad or m, that the method wishes for a task, and the drive after it.

    A method that does not apply to the task wishes for none, and `refusal` says why.
    poses (m + 1, 4, 4) at task.q.
    """
    method, options = methods.named(drive.method), drive.options(drive.method)
    task, push = with_secondary(problem, task, poses, drive)
    if (why := method.applies(task)) is not None:
        return np.zeros(len(task.q)), replace(drive, memory=None, solution=None, refusal=why)
    memory = method.start(task, options) if drive.memory is None else drive.memory
    solution, memory = solve_with_null_space(problem, method, task, memory, options, push)
    return joint_displacement(problem, task, replace(drive, memory=memory, solution=solution, refusal=None))


def with_secondary(problem: Problem, task: Task, poses: Array, drive: Controller) -> tuple[Task, Array | None]:
    """The task with the objective's row, or the objective's push q̇₀ (n,) for the null space."""
    second = drive.secondary
    if second is None:
        return task, None
    objective = objectives.named(second.objective)
    cost = objective.cost(problem, Posture(task.q, poses, problem.obstacles.points), second.options)
    if second.as_row:
        return replace(task, J=np.vstack([task.J, cost.gradient]), rate=np.append(task.rate, -cost.value)), None
    weights = second.weight if second.weights is None else second.weights
    return task, -weights * cost.gradient


def joint_displacement(problem: Problem, task: Task, drive: Controller) -> tuple[Array, Controller]:
    """Δq of the drive's last answer, with Algorithm 1 where it is asked for."""
    assert drive.solution is not None
    wished = problem.joint_units * drive.solution.rates * task.dt
    second = drive.secondary
    if second is None or not second.adapts:
        return wished, drive
    weights = np.full(len(wished), second.weight) if second.weights is None else second.weights
    q, weights = clipped(task.q + wished, problem.limits.lower, problem.limits.upper, weights)
    return q - task.q, replace(drive, secondary=replace(second, weights=weights))


def displacement_task(wished: Array) -> tuple[Array, Array, Array, Array]:
    """A joint displacement Δq (n,) as a task of the guarded step: J = I, v = Δq, equal weights, no damping."""
    n = len(wished)
    return np.eye(n), np.asarray(wished), np.ones(n), np.zeros(n)


def packed_arm(problem: Problem, drive: Controller, with_orientation: bool = True) -> Array:
    """The problem as the kernels take it, with the settings of the guarded step."""
    if GUARDED not in drive.changed:
        return packed(problem, turn=ORIENTATION_LENGTH if with_orientation else 0.0)
    options = drive.options(GUARDED)
    turn = options.turn if with_orientation else 0.0
    return packed(problem, options.damping**2, turn, options.gain, options.levels)


def level_starts(drive: Controller, with_orientation: bool) -> list[int]:
    """The rows at which levels of a pose begin, by the settings of the guarded step."""
    return [3] if with_orientation and drive.options(GUARDED).levels else []


def with_objective(
    problem: Problem, q: Array, poses: Array, task: Rows, begins: list[int], second: SecondaryObjective, dt: float
) -> tuple[Rows, Indices]:
    """A task with a secondary objective: one more row, or a level of its own behind the others.

    Args: q (n,), rad or m, and its poses; task and the rows at which its levels begin; dt, s.
    """
    J, v, weights, damping = task
    rows = 6 if weights[3] > 0 else 3
    here = Posture(q, poses, problem.obstacles.points)
    cost = objectives.named(second.objective).cost(problem, here, second.options)
    if second.as_row:
        more, asked = cost.gradient[None] / problem.joint_units, np.array([-cost.value * dt])
        weight = problem.robot.reach
    else:
        begins = [*begins, rows]
        more, asked, weight = np.eye(len(q)), -second.weight * cost.gradient * problem.joint_units * dt, 1.0
    J, v = np.vstack([J[:rows], more]), np.append(v[:rows], asked)
    return (J, v, np.append(weights[:rows], np.full(len(asked), weight)), damping), indices(begins)
