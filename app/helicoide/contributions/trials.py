"""Trials of methods: an arm without surroundings, tasks of the closed loop, regular and singular postures."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import planes_of
from helicoide.geometry import rotation
from helicoide.ik.controller import Controller, ToolTarget, closed_loop_task, step
from helicoide.ik.method import Task
from helicoide.ik.objective import Posture
from helicoide.kinematics import library
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial_state, with_joints
from helicoide.text import HelicoideError, Text

STILL = np.zeros(3)
GAIN = 5.0
MOST_DRAWS = 2000
ALWAYS_SINGULAR = Text(
    en="nearly all postures of {robot} are singular for this task",
    pt_BR="quase toda postura de {robot} é singular para esta tarefa",
)


@cache
def bare_state(robot: str) -> State:
    """The arm at `ready`, without planes."""
    state = initial_state(library.load_robot(robot))
    return replace(state, problem=replace(state.problem, planes=planes_of(())))


def closed_loop_to(state: State, T: Array, with_orientation: bool, dt: float = 0.01, gain: float = GAIN) -> Task:
    """The task of the closed loop towards a pose (4, 4), m."""
    posture, target = Posture(state.arm.q, state.arm.poses), ToolTarget(T, with_orientation, STILL)
    return closed_loop_task(state.problem, posture, target, (gain,) * 4, dt)


def controller_step(
    state: State, T: Array, with_orientation: bool, controller: Controller, dt: float = 0.01
) -> tuple[Array, Controller]:
    """The joint displacement (n,) of one step towards a pose (4, 4), m, and the controller after the step."""
    return step(state.problem, closed_loop_to(state, T, with_orientation, dt), state.arm.poses, controller)


def far_poses(robot: Robot, rng: np.random.Generator) -> Iterator[Array]:
    """Four random poses (4, 4), m, most of them far out of reach."""
    for _ in range(4):
        T = np.eye(4)
        T[:3, :3] = rotation.to_matrix(rotation.from_rotation_vector(rng.normal(size=3)))
        T[:3, 3] = 3 * robot.reach * rng.normal(size=3)
        yield T


def missing(state: State, T: Array, with_orientation: bool) -> float:
    """The norm of the error to a pose (4, 4), m, with lengths divided by the reach, and angles in radians."""
    return float(np.linalg.norm(closed_loop_to(state, T, with_orientation, gain=1.0).rate))


def clear_of_singularities(robot: Robot, rng: np.random.Generator, with_orientation: bool) -> tuple[Array, Array]:
    """A start and a goal near each other, (n,), rad or m, well inside the limits and away from singular postures.

    Raises HelicoideError if nearly all postures are singular.
    """
    state, middle, half = bare_state(robot.name), (robot.lower + robot.upper) / 2, (robot.upper - robot.lower) / 2
    for _ in range(MOST_DRAWS):
        goal = middle + rng.uniform(-0.6, 0.6, len(half)) * half
        start = goal + rng.uniform(-0.1, 0.1, len(half)) * np.minimum(half, 2.0)
        worth = [least(with_joints(state, frozen(q)), with_orientation) for q in np.linspace(start, goal, 5)]
        if min(worth) > 0.05:
            return frozen(start), frozen(goal)
    raise HelicoideError(ALWAYS_SINGULAR.format(robot=robot.name))


def least(state: State, with_orientation: bool) -> float:
    """The smallest of the singular values that are not zero at a generic posture."""
    here = analyse_jacobian(closed_loop_to(state, state.T_world_tool, with_orientation).J)
    return float(here.sigma[usual(state.robot.name, with_orientation) - 1])


@cache
def usual(robot: str, with_orientation: bool) -> int:
    """The rank of the task's Jacobian at a generic posture."""
    state, rng = bare_state(robot), np.random.default_rng(3)
    q = frozen(rng.uniform(state.robot.lower, state.robot.upper))
    return analyse_jacobian(closed_loop_to(with_joints(state, q), state.T_world_tool, with_orientation).J).rank


def singular_starts(state: State, with_orientation: bool) -> list[Array]:
    """Up to four postures with a rank lower than usual: named ones, or with every joint at a multiple of 90°."""
    n, robot = len(state.arm.q), state.robot
    rng = np.random.default_rng(5)
    grid = [np.zeros(n), *(rng.integers(-2, 3, n) * np.pi / 2 for _ in range(200)), *robot.poses.values()]
    expected = usual(robot.name, with_orientation)
    lost = [
        q
        for q in grid
        if analyse_jacobian(closed_loop_to(with_joints(state, q), state.T_world_tool, with_orientation).J).rank
        < expected
    ]
    return [frozen(q) for q in lost[:4]]
