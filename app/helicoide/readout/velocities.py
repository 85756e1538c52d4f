"""Velocities and forces at the tool: its Jacobian, its twist, its ellipsoids, slow directions, and joint torques."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.kinematics.central_axis import CentralAxis, central_axis
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.generic_rank import counted_rows, generic_rank, in_reaches, largest_singular_value
from helicoide.kinematics.manipulability import JacobianAnalysis, analyse_jacobian
from helicoide.kinematics.singularity import NEAR_SINGULAR
from helicoide.state import State


@lru_cache(maxsize=4)
def world_jacobian(state: State) -> Array:
    """The tool's Jacobian (6, n) in the world frame, rows vx vy vz ωx ωy ωz. Cached, as all windows share it."""
    return frozen(frame_jacobian(state.robot, state.arm.q))


def tool_twist(state: State) -> Array:
    """The twist of the tool V = J q̇, (6,): v, m/s, of its origin, and ω, rad/s, world frame."""
    return np.asarray(world_jacobian(state) @ state.arm.velocities)


def twist_axis(state: State) -> CentralAxis | None:
    """The instantaneous screw axis of the tool; None while the arm stands still."""
    twist = tool_twist(state)
    return (
        central_axis(twist[3:], twist[:3], state.T_world_tool[:3, 3], state.robot.reach) if state.arm.moving else None
    )


def wrench_axis(state: State, wrench: ArrayLike) -> CentralAxis | None:
    """The central axis of a wrench (6,) at the tool, N and N·m about its origin, world frame; None if it is zero."""
    F = np.asarray(wrench, dtype=np.float64)
    return central_axis(F[:3], F[3:], state.T_world_tool[:3, 3], state.robot.reach)


def balancing_torques(state: State, wrench: ArrayLike) -> Array:
    """Joint torques that hold the arm against a wrench F on its tool: τ = −Jᵀ F, (n,), N·m, N for a prismatic joint.

    The weight of the arm does not count. Args: wrench (6,): force, N, and moment about the origin of the tool, N·m,
    world frame. Source: Yoshikawa 1985, by virtual work.
    """
    return np.asarray(-world_jacobian(state).T @ np.asarray(wrench, dtype=np.float64))


@lru_cache(maxsize=4)
def position_analysis(state: State) -> JacobianAnalysis:
    """Analysis of the position rows of J (3, n), m/s for 1 rad/s; a prismatic joint counts with a reach per second."""
    units = [state.robot.reach if joint.is_prismatic else 1.0 for joint in state.robot.variables]
    return analyse_jacobian(world_jacobian(state)[:3] * units)


@lru_cache(maxsize=4)
def slow_directions(state: State, within: float = NEAR_SINGULAR) -> Array:
    """Twists (6, k) in which the tool has lost its velocity, or nearly so, though it has it in almost every posture.

    They are the columns uᵢ of J = U Σ Vᵀ, with lengths in reaches, whose σᵢ is at most `within` of the largest value
    that the smallest σ has in any posture. Without orientation the position alone counts, and the rest is zero.
    """
    robot = state.robot
    size = 6 if counted_rows(robot, state.request.with_orientation)[3:].any() else 3
    found = analyse_jacobian(in_reaches(robot, world_jacobian(state)[:size]))
    usual = generic_rank(robot, size)
    slow = found.sigma[:usual] <= within * largest_singular_value(robot, size)
    directions = np.zeros((6, int(slow.sum())))
    directions[:size] = found.U[:, :usual][:, slow]
    return frozen(directions)
