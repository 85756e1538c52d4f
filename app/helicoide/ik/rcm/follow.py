"""Following a path while the shaft passes through an entry point, which may move.

    ν = [v_d + Kp e_p − ω × e_p; ω],  ω = ω_d + Ko ε̃,   u = inverse(J^r)(ν − Jc v),   v = v_rd + Kr e_r

Source: Coutinho 2015, §2.4, fig. 3.3, table 4.1. Kr, and the depth l_a computed anew at each step, are added here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik import Problem
from helicoide.ik.method import ConfiguredMethod, Solution
from helicoide.ik.methods import configured_method
from helicoide.ik.rcm.constrained import Constrained, constrained
from helicoide.ik.rcm.free_motions import Basis
from helicoide.ik.rcm.passage import Passage, passage_refusal
from helicoide.text import HelicoideError


@dataclass(frozen=True, eq=False)
class RcmReference:
    """The target of the tool and the velocity of the entry point at one instant.

    T_world_target (4, 4), m; feedforward: (v, ω) of the target, (6,), world axes, m/s and rad/s; entry_rate: v_rd (r,),
    m/s, along the forbidden directions.
    """

    T_world_target: Array
    feedforward: Array
    entry_rate: Array


PSEUDOINVERSE = configured_method("pseudoinverse")


@dataclass(frozen=True, eq=False)
class RcmControl:
    """Gains and inverses of the closed loop with an entry point.

    of_tool inverts J^r, of_arm inverts J_i; position, orientation, entry: gains Kp, Ko, Kr, 1/s. A damped inverse of
    J^r keeps the entry point exactly, a damped inverse of J_i does not.
    Source: Coutinho 2015, tables 4.1, 4.2, eqs. 3.43, 3.46.
    """

    of_tool: ConfiguredMethod = PSEUDOINVERSE
    of_arm: ConfiguredMethod = PSEUDOINVERSE
    position: float = 5.0
    orientation: float = 10.0
    entry: float = 0.0
    basis: Basis = "scaled"


@dataclass(frozen=True, eq=False)
class RcmState:
    """The state of the loop. q (n,), rad or m; entry_world: p_rcm (3,), m; memory: of the inverses of tool and arm.

    memory: None for the initial memory of an inverse.
    """

    q: Array
    entry_world: Array
    memory: tuple[Any, Any] = (None, None)


@dataclass(frozen=True, eq=False)
class RcmStep:
    """One step of the loop. t, s; q (n,); entry_world: p_rcm (3,), m; at: the Jacobians: all before the step.

    error: (e_p, ε̃) (6,), body axes, m and sin(φ/2); asked: v_rd + Kr e_r (r,), m/s; command: ν (6,), body velocity of
    the tool, m/s and rad/s; tool, arm: solutions of the two inverses; rates: θ̇ (n,), rad/s or m/s; memory: of both
    inverses, after the step.
    """

    t: float
    q: Array
    entry_world: Array
    at: Constrained
    error: Array
    task: Array
    command: Array
    tool: Solution
    arm: Solution
    rates: Array
    memory: tuple[Any, Any]

    @property
    def entry_slip(self) -> Array:
        """Λ J_i θ̇ − v (r,), m/s: error of the shaft's velocity at the entry point."""
        return self.at.at_entry(self.rates) - self.task


def pose_error(T_world_target: Array, T_world_tool: Array) -> Array:
    """Pose error in the tool frame: e_p = Rᵀ (p_d − p), ε̃ = vector part of Q⁻¹ ⊗ Q_d for the shorter rotation.

    The source uses Q_d ⊗ Q⁻¹, which is in the base frame and must not be added to a body velocity.
    Args: (4, 4), m. Returns (6,), m and sin(φ/2). Source: Coutinho 2015, eqs. 2.59, 2.62–2.63 corrected.
    """
    R = T_world_tool[:3, :3]
    position = R.T @ (T_world_target[:3, 3] - T_world_tool[:3, 3])
    return np.concatenate([position, rotation.from_matrix(R.T @ T_world_target[:3, :3])[1:]])


def body_velocity(R_world_tool: Array, ahead: Array, error: Array, position: float, orientation: float) -> Array:
    """ν = [v_d + Kp e_p − ω × e_p; ω], ω = ω_d + Ko ε̃: the body velocity of the tool that gives ė_p = −Kp e_p.

    Args: ahead: (v, ω) of the target in world axes (6,); error (6,) of `pose_error`; gains, 1/s. Returns (6,).
    Source: Coutinho 2015, eq. 2.66.
    """
    turn = R_world_tool.T @ ahead[3:] + orientation * error[3:]
    move = R_world_tool.T @ ahead[:3] + position * error[:3] - np.cross(turn, error[:3])
    return np.concatenate([move, turn])


def loop_pass(
    at: Constrained, control: RcmControl, task: RcmReference, error: Array, dt: float, memory: tuple[Any, Any]
) -> tuple[Array, Array, Solution, Solution, Array, tuple[Any, Any]]:
    """One pass of the loop of fig. 3.3: v_rd + Kr e_r, ν, the solutions for u and for the arm, θ̇, and both memories."""
    asked = task.entry_rate + control.entry * at.place.lateral
    nu = body_velocity(at.T_world_tool[:3, :3], task.feedforward, error, control.position, control.orientation)
    tool, of_tool = control.of_tool.answered(at.problem, at.task(nu, asked, dt), memory[0])
    velocity = at.shaft_velocity(tool.rates, asked)
    arm, of_arm = control.of_arm.answered(at.problem, at.arm_task(velocity, dt), memory[1])
    return asked, nu, tool, arm, at.rates(arm.rates, tool.rates), (of_tool, of_arm)


def rcm_loop(
    problem: Problem,
    passage: Passage,
    control: RcmControl,
    task_at: Callable[[float], RcmReference],
    start: RcmState,
    dt: float,
) -> Iterator[RcmStep]:
    """Steps of the closed loop from its state at the start, without end. dt, s.

    Explicit Euler, also for the entry point: p_rcm ← p_rcm + R_0i Nᵀ v_rd Δt. Raises HelicoideError where the arm has
    too few joints, see `passage_refusal`.
    """
    refused = passage_refusal(problem.robot, passage)
    if refused:
        raise HelicoideError(refused)
    t, q, entry_world, memory = 0.0, start.q, start.entry_world, start.memory
    while True:
        at = constrained(problem, passage, q, entry_world, control.basis)
        reference = task_at(t)
        error = pose_error(reference.T_world_target, at.T_world_tool)
        asked, nu, tool, arm, rates, memory = loop_pass(at, control, reference, error, dt, memory)
        yield RcmStep(t, q, entry_world, at, error, asked, nu, tool, arm, rates, memory)
        q = q + rates * dt
        entry_world = entry_world + at.R_world_shaft @ (at.place.forbidden.T @ reference.entry_rate) * dt
        t += dt
