"""The controller that drives the tool to a pose: any method with its settings, always through the guarded step.

The guarded step solves the pose task directly. Every other method computes joint velocities for the closed loop, and
the guarded step takes the nearest displacement that limits and planes allow:  Δq = argmin ‖Δq − q̇ Δt‖².
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import hypot
from types import MappingProxyType
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem, methods, objectives
from helicoide.ik.clik import TaskError, solve_with_null_space, tool_task_error
from helicoide.ik.guard.guarded import indices
from helicoide.ik.guard.rows import Indices
from helicoide.ik.guard.rows import Task as Rows
from helicoide.ik.limit_gains import clipped
from helicoide.ik.method import ConfiguredMethod, Solution, Task
from helicoide.ik.objective import Posture
from helicoide.ik.packing import packed
from helicoide.ik.postures.subspace import project_to_subspace
from helicoide.ik.task import GAIN, ORIENTATION_LENGTH, TOOL_SPEED, TOOL_TURN
from helicoide.kinematics.generic_rank import movable_rows
from helicoide.text import Text

GUARDED = "guarded"
NO_ROWS = Text(
    en="No joint moves the position of the end effector, and its orientation is not asked for.",
    pt_BR="Nenhuma junta move a posição do efetuador, e a orientação não é pedida.",
)
Gains = tuple[float, float, float, float]
NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class SecondaryObjective:
    """What the joints do besides the task.

    objective: its name; options: its settings; weight: k₀, 1/s; as_row: as an additional row of the task instead of in
    its null space; adapts: whether the weight of a joint grows each time it is clipped to its limit (Algorithm 1 in
    `limit_gains`); weights: the weights after that, (n,), None before the first step.
    """

    objective: str
    options: Any
    weight: float = 1.0
    as_row: bool = False
    adapts: bool = False
    weights: Array | None = None


@dataclass(frozen=True, eq=False)
class Controller:
    """A method with its settings, gains and memory.

    changed: options of methods, by name, that differ from the defaults; gains: for x, y, z and orientation, 1/s;
    memory: of the method; solution: its last one, None for the guarded step; refusal: why the method gave none.
    """

    method: str = GUARDED
    changed: Mapping[str, Any] = field(default_factory=lambda: NOTHING)
    gains: Gains = (GAIN, GAIN, GAIN, GAIN)
    secondary: SecondaryObjective | None = None
    memory: Any = None
    solution: Solution | None = None
    refusal: Text | None = None

    def options(self, method: str) -> Any:
        """The options of a method: the changed ones, else the defaults."""
        return self.changed.get(method) or methods.named(method).Options()

    @property
    def inverse(self) -> ConfiguredMethod:
        """Its method with the options."""
        return ConfiguredMethod(methods.named(self.method), self.options(self.method))

    def with_method(self, method: str) -> Controller:
        """The same controller with another method and without memory."""
        return replace(self, method=method, memory=None, solution=None, refusal=None)

    def with_options(self, method: str, options: Any) -> Controller:
        """The same controller with other options of a method; the memory is kept."""
        return replace(self, changed=MappingProxyType({**self.changed, method: options}))


@dataclass(frozen=True, eq=False)
class ToolTarget:
    """Where the tool is asked to go. T_world_target (4, 4), m; with_orientation: whether its orientation counts too.

    ahead: velocity of its point, (3,), m/s.
    """

    T_world_target: Array
    with_orientation: bool
    ahead: Array


def reference_velocity(aim: TaskError, gains: Gains) -> Array:
    """ν = ẋ_d + Λ e, 1/s, scaled down to at most `TOOL_SPEED` in position and `TOOL_TURN` in orientation."""
    x, y, z, turn = gains
    asked = aim.feedforward.copy()
    asked[:3] = _no_faster(aim.feedforward[:3] + np.array([x, y, z]) * aim.error[:3], TOOL_SPEED)
    if len(asked) > 3:
        asked[3:] = _no_faster(aim.feedforward[3:] + turn * aim.error[3:], TOOL_TURN)
    return asked


def _no_faster(velocity: Array, most: float) -> Array:
    """A velocity (3,), scaled down to a norm of at most `most`."""
    length = hypot(*velocity)
    return velocity * (most / length) if length > most else velocity


def closed_loop_task(problem: Problem, posture: Posture, target: ToolTarget, gains: Gains, dt: float) -> Task:
    """The task of the closed loop at a posture: the rows of `clik.tool_task_error` that the arm can move at all.

    With orientation, the target is replaced by the nearest pose that an arm with fewer than six joints can take. The
    rows of the task then do not contradict each other. dt, s.
    """
    q, goal = posture.q, target.T_world_target
    if target.with_orientation:
        goal = project_to_subspace(problem.robot, goal, q).T_world_goal
    aim = tool_task_error(problem, posture.poses, goal, target.with_orientation, np.append(target.ahead, np.zeros(3)))
    rows = movable_rows(problem.robot)[: len(aim.J)]
    return Task(q, aim.J[rows], reference_velocity(aim, gains)[rows], dt)


def step(problem: Problem, task: Task, poses: Array, controller: Controller) -> tuple[Array, Controller]:
    """The joint displacement Δq (n,), rad or m, that the method gives for a task, and the controller after it.

    Where the method does not apply to the task, or the task has no rows, Δq = 0 and `refusal` says why.
    Args: poses (m + 1, 4, 4) at task.q.
    """
    inverse = controller.inverse
    task, push = with_secondary(problem, task, poses, controller)
    why = inverse.method.applies(task) if len(task.J) > 0 else NO_ROWS
    if why is not None:
        return np.zeros(len(task.q)), replace(controller, memory=None, solution=None, refusal=why)
    solution, memory = solve_with_null_space(problem, inverse, task, controller.memory, push)
    return joint_displacement(problem, task, replace(controller, memory=memory, solution=solution, refusal=None))


def with_secondary(problem: Problem, task: Task, poses: Array, controller: Controller) -> tuple[Task, Array | None]:
    """The task with the row of the secondary objective and None, or the task and its q̇₀ (n,) for the null space."""
    second = controller.secondary
    if second is None:
        return task, None
    objective = objectives.named(second.objective)
    cost = objective.cost(problem, Posture(task.q, poses, problem.obstacles.points), second.options)
    if second.as_row:
        return replace(task, J=np.vstack([task.J, cost.gradient]), rate=np.append(task.rate, -cost.value)), None
    weights = second.weight if second.weights is None else second.weights
    return task, -weights * cost.gradient


def joint_displacement(problem: Problem, task: Task, controller: Controller) -> tuple[Array, Controller]:
    """Δq (n,), rad or m, of the last solution, and the controller; with Algorithm 1 where the objective `adapts`."""
    assert controller.solution is not None
    displacement = problem.joint_units * controller.solution.rates * task.dt
    second = controller.secondary
    if second is None or not second.adapts:
        return displacement, controller
    weights = np.full(len(displacement), second.weight) if second.weights is None else second.weights
    q, weights = clipped(task.q + displacement, problem.limits.lower, problem.limits.upper, weights)
    return q - task.q, replace(controller, secondary=replace(second, weights=weights))


def displacement_task(displacement: Array) -> tuple[Array, Array, Array, Array]:
    """A joint displacement Δq (n,) as a task of the guarded step: J = I, v = Δq, equal weights, no damping."""
    n = len(displacement)
    return np.eye(n), np.asarray(displacement), np.ones(n), np.zeros(n)


def packed_arm(problem: Problem, controller: Controller, with_orientation: bool = True) -> Array:
    """The problem packed for the kernels, with the settings of the guarded step."""
    if GUARDED not in controller.changed:
        return packed(problem, turn=ORIENTATION_LENGTH if with_orientation else 0.0)
    options = controller.options(GUARDED)
    turn = options.turn if with_orientation else 0.0
    return packed(problem, options.damping**2, turn, options.gain, options.levels)


def level_starts(controller: Controller, with_orientation: bool) -> list[int]:
    """The rows at which further levels of a pose task begin, by the settings of the guarded step."""
    return [3] if with_orientation and controller.options(GUARDED).levels else []


def with_objective(
    problem: Problem, posture: Posture, task: Rows, begins: list[int], second: SecondaryObjective, dt: float
) -> tuple[Rows, Indices]:
    """A task with a secondary objective: one additional row, or n rows as the last level.

    Args: posture of the arm; task; begins: the rows at which its further levels begin; dt, s.
    Returns the new task and `begins`.
    """
    J, v, weights, damping = task
    rows = 6 if weights[3] > 0 else 3
    cost = objectives.named(second.objective).cost(problem, posture, second.options)
    if second.as_row:
        more, asked = cost.gradient[None] / problem.joint_units, np.array([-cost.value * dt])
        weight = problem.robot.reach
    else:
        begins = [*begins, rows]
        more, asked, weight = np.eye(len(posture.q)), -second.weight * cost.gradient * problem.joint_units * dt, 1.0
    J, v = np.vstack([J[:rows], more]), np.append(v[:rows], asked)
    return (J, v, np.append(weights[:rows], np.full(len(asked), weight)), damping), indices(begins)
