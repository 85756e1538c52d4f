"""The constrained Jacobian: the tool velocities that are possible while the shaft stays in its entry point.

    V_i = Λ# v + Λ† v_rd,   V_e = J^r u + Jc v_rd,   u = [v; θ̇ after the link]

The constraint holds with any inverse of J^r, because V_i is computed from u. Source: Coutinho 2015, §3.1–3.4.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.method import Task
from helicoide.ik.rcm.free_motions import Basis, constraint, null_basis
from helicoide.ik.rcm.passage import Insertion, Passage, insertion
from helicoide.kinematics import jacobian
from helicoide.kinematics.differential import adjoint, rotated_twist
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import JacobianAnalysis, analyse_jacobian


@dataclass(frozen=True, eq=False)
class Constrained:
    """An arm at a posture with its shaft in the entry point.

    T_world_tool (4, 4), m; R_world_shaft (3, 3); Ad_tool_shaft: Ad_ei (6, 6); null: Λ# (6, 6 − r); J_arm: J_i (6, i),
    body Jacobian of F_i; J: J^r (6, 6 − r + n − i), from u to the body velocity of the tool; units: the scale of each
    entry of u, see `task`. Source: Coutinho 2015, eqs. 3.9, 3.15.
    """

    problem: Problem
    q: Array
    place: Insertion
    T_world_tool: Array
    R_world_shaft: Array
    Ad_tool_shaft: Array
    null: Array
    J_arm: Array
    J: Array
    units: Array

    @cached_property
    def constraint(self) -> Array:
        """Λ (r, 6)."""
        return constraint(self.place)

    @cached_property
    def push(self) -> Array:
        """Λ† (6, r), with Λ Λ† = I: Λᵀ(Λ Λᵀ)⁻¹ for lengths divided by ℓ. From v_rd to a velocity of the shaft.

        Source: Coutinho 2015, eq. 3.32.
        """
        rows = _lengths(self.problem.length)
        Lambda = self.constraint * rows
        return np.asarray(rows[:, None] * np.linalg.solve(Lambda @ Lambda.T, Lambda).T)

    @cached_property
    def J_entry(self) -> Array:
        """Jc = Ad_ei Λ† (6, r), from v_rd to a body velocity of the tool. Source: Coutinho 2015, eq. 3.33."""
        return np.asarray(self.Ad_tool_shaft @ self.push)

    @cached_property
    def of_arm(self) -> JacobianAnalysis:
        """Analysis of J_i: if w_i > 0 the arm can give link i any velocity. Source: Coutinho 2015, §3.5."""
        return analyse_jacobian(self.J_arm)

    @cached_property
    def of_tool(self) -> JacobianAnalysis:
        """Analysis of J^r: if w_r > 0 some u gives the tool any velocity. Source: Coutinho 2015, eq. 3.36."""
        return analyse_jacobian(self.J)

    def task(self, command: Array, entry_rate: Array, dt: float) -> Task:
        """The task J^r u = ν − Jc v_rd, lengths divided by ℓ; its unknowns are u divided by `units`.

        Args: command: ν (6,), body velocity of the tool, m/s and rad/s; entry_rate: v_rd (r,), m/s; dt, s.
        Source: Coutinho 2015, eq. 3.34.
        """
        rows = _lengths(self.problem.length)
        rate = command - self.J_entry @ entry_rate
        return Task(self.q, self.J * self.units / rows[:, None], rate / rows, dt)

    def shaft_velocity(self, u: Array, entry_rate: Array) -> Array:
        """V_i = Λ# v + Λ† v_rd, (6,), m/s and rad/s. Args: u: rates of a solution of `task`; v_rd (r,), m/s."""
        free = self.null.shape[1]
        return np.asarray(self.null @ (self.units * u)[:free] + self.push @ entry_rate)

    def arm_task(self, velocity: Array, dt: float) -> Task:
        """The task J_i θ̇ = V_i of the joints before the entry point. Args: V_i (6,). Source: eqs. 3.3, 3.32."""
        rows, i = _lengths(self.problem.length), self.J_arm.shape[1]
        return Task(self.q, self.J_arm * self.problem.joint_units[:i] / rows[:, None], velocity / rows, dt)

    def rates(self, arm: Array, u: Array) -> Array:
        """θ̇ = [θ̇ before; θ̇ after], (n,), rad/s or m/s. Args: solutions of `arm_task` and `task`. Source: eq. 3.18."""
        i, free = self.J_arm.shape[1], self.null.shape[1]
        return np.concatenate([self.problem.joint_units[:i] * arm, (self.units * u)[free:]])

    def at_entry(self, rates: Array) -> Array:
        """Λ J_i θ̇, (r,), m/s: the velocity along N of the point of the shaft at the entry. Args: θ̇ (n,)."""
        return np.asarray(self.constraint @ (self.J_arm @ rates[: self.J_arm.shape[1]]))


def _lengths(length: float) -> Array:
    """The divisor of each row of a twist: ℓ for the linear part, 1 for the angular part."""
    return np.array([length] * 3 + [1.0] * 3)


def constrained(
    problem: Problem, passage: Passage, q: Array, entry_world: Array, basis: Basis = "scaled"
) -> Constrained:
    """J^r = [Ad_ei Λ#, J_e2] at a posture of any chain. J_e2: body Jacobian of the tool for the joints after link i.

    Args: q (n,), rad or m; entry_world: p_rcm (3,), m. Source: Coutinho 2015, eqs. 3.9–3.15.
    """
    chain, i = problem.robot.chain, passage.link
    poses = link_poses(chain, q)
    axes = jacobian.joint_axes(poses, chain)
    T_shaft = poses[i] @ passage.T_link_shaft
    T_tool = poses[-1] @ problem.robot.T_link_tool
    J_arm = jacobian.geometric_jacobian(poses, chain, axes, T_shaft[:3, 3].copy(), i)[:, :i]
    J_tool = jacobian.geometric_jacobian(poses, chain, axes, T_tool[:3, 3].copy(), len(chain))[:, i:]
    place = insertion(passage, T_shaft, entry_world)
    null = null_basis(place, basis)
    Ad = adjoint(_inverse(T_tool) @ T_shaft)
    velocities = 3 if basis == "source" else 3 - passage.r
    units = np.concatenate([_units(problem.length, velocities, null.shape[1]), problem.joint_units[i:]])
    return Constrained(
        problem,
        q,
        place,
        T_tool,
        T_shaft[:3, :3],
        Ad,
        null,
        rotated_twist(T_shaft[:3, :3].T, J_arm),
        np.hstack([Ad @ null, rotated_twist(T_tool[:3, :3].T, J_tool)]),
        units,
    )


def _units(length: float, velocities: int, free: int) -> Array:
    """The scale of each entry of v: ℓ for linear velocities, 1 for angular ones."""
    return np.array([length] * velocities + [1.0] * (free - velocities))


def _inverse(T: Array) -> Array:
    """The inverse of a pose, g⁻¹ = (Rᵀ, −Rᵀp). Source: Coutinho 2015, eqs. 2.19–2.20 (a transpose was lost)."""
    inverse = np.eye(4)
    inverse[:3, :3] = T[:3, :3].T
    inverse[:3, 3] = -T[:3, :3].T @ T[:3, 3]
    return inverse
