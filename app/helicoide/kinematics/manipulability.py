"""Analysis of a Jacobian: singular values, manipulability, ellipsoids, null space and pseudoinverse."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import Frame

# A singular value below this fraction of the largest one counts as zero.
RANK_TOLERANCE = 1e-10


@dataclass(frozen=True, eq=False)
class Ellipsoid:
    """Semi-axes of an ellipsoid: unit directions in the columns of axes (m, m), with their lengths (m,)."""

    axes: Array
    lengths: Array


@dataclass(frozen=True, eq=False)
class JacobianAnalysis:
    """Singular value decomposition J = U Σ Vᵀ = Σ σᵢ uᵢ vᵢᵀ of a Jacobian (m, n), and the quantities derived from it.

    All rows of J have one unit. U (m, m) and V (n, n) are orthogonal; sigma (min(m, n),) is in descending order.
    Source: Vargas 2013, eq. 3.1.
    """

    J: Array
    U: Array
    sigma: Array
    V: Array

    @property
    def w(self) -> float:
        """Manipulability w = σ₁ σ₂ … σₚ, p = min(m, n): √det(J Jᵀ) for m ≤ n, √det(Jᵀ J) for an arm with fewer joints.

        Source: Yoshikawa 1985; Vargas 2013, eq. 3.5; Coutinho 2015, eqs. 3.36, 3.39; Cerbaro 2022, eq. 11.
        """
        return float(np.prod(self.sigma))

    @property
    def rank(self) -> int:
        """How many singular values are larger than `RANK` times the largest."""
        return int(np.sum(self.sigma > RANK_TOLERANCE * self.sigma[0]))

    @property
    def condition_number(self) -> float:
        """Condition number σ₁/σₚ, infinite where the rank is less than p. Source: Vargas 2013, §2."""
        return float(self.sigma[0] / self.sigma[-1]) if self.rank == self.sigma.size else np.inf

    @cached_property
    def velocity_ellipsoid(self) -> Ellipsoid:
        """Velocities that ‖q̇‖ = 1 gives, νᵀ(J Jᵀ)⁻¹ν = 1: axes uᵢ, semi-axes σᵢ, zero beyond p.

        Source: Yoshikawa 1985; Vargas 2013, eq. 3.4.
        """
        return Ellipsoid(self.U, np.append(self.sigma, np.zeros(len(self.U) - self.sigma.size)))

    @cached_property
    def force_ellipsoid(self) -> Ellipsoid:
        """Forces that ‖τ‖ = 1 balances, fᵀ J Jᵀ f = 1: axes uᵢ, semi-axes 1/σᵢ, infinite beyond the rank.

        Source: Yoshikawa 1985, by τ = Jᵀ f.
        """
        lengths = np.full(len(self.U), np.inf)
        lengths[: self.rank] = 1 / self.sigma[: self.rank]
        return Ellipsoid(self.U, lengths)

    @cached_property
    def pseudoinverse(self) -> Array:
        """J† = Σ vᵢ uᵢᵀ/σᵢ over the rank, (n, m): J† ν is the least-squares q̇ of least norm.

        It is Jᵀ(J Jᵀ)⁻¹ for full row rank. Source: Vargas 2013, eq. 2.49; Cerbaro 2022, eq. 70.
        """
        r = self.rank
        return np.asarray(self.V[:, :r] / self.sigma[:r] @ self.U[:, :r].T)

    @cached_property
    def null_space(self) -> Array:
        """Orthonormal basis of the joint motions without effect, J N = 0: columns of (n, n − rank).

        Source: Cerbaro 2022, §4.4.1.
        """
        return self.V[:, self.rank :]

    @cached_property
    def null_projector(self) -> Array:
        """P = I − J† J = N Nᵀ, (n, n): J P q̇₀ = 0 for every q̇₀. Source: Cerbaro 2022, eq. 9; Vargas 2013, eq. 2.51."""
        return np.asarray(self.null_space @ self.null_space.T)

    @cached_property
    def lost_velocities(self) -> Array:
        """Orthonormal basis of the velocities that no q̇ gives, yᵀ J = 0: columns of (m, m − rank).

        Forces along them need no joint torque. Source: Vargas 2013, §3.1, App. A.2.
        """
        return self.U[:, self.rank :]


def analyse_jacobian(J: Array) -> JacobianAnalysis:
    """Singular value decomposition J = U Σ Vᵀ of a Jacobian (m, n) whose rows have one unit.

    Source: Vargas 2013, eq. 3.1.
    """
    U, sigma, Vt = np.linalg.svd(J)
    return JacobianAnalysis(J, U, sigma, Vt.T)


def scaled_jacobian(J: Array, length: float) -> Array:
    """A Jacobian (6, n) scaled so that all its rows have one unit: [J_p; ℓ J_o].

    Args: length: characteristic length ℓ, m: rotation at 1 rad/s counts as much as translation at ℓ metres a second.
    """
    return np.vstack([J[:3], length * J[3:]])


def position_manipulability(robot: Robot, q: ArrayLike, frame: Frame | None = None) -> JacobianAnalysis:
    """Manipulability of the position of a frame, by default the tool: that of J_p (3, n), m/rad or 1.

    Args: q (n,), rad or m. Raises HelicoideError for a wrong q. Source: Yoshikawa 1985; Cerbaro 2022, eq. 11.
    """
    return analyse_jacobian(frame_jacobian(robot, q, frame)[:3])


def twist_manipulability(robot: Robot, q: ArrayLike, length: float, frame: Frame | None = None) -> JacobianAnalysis:
    """Manipulability of position and orientation of a frame, by default the tool: that of [J_p; ℓ J_o] (6, n).

    Args: q (n,), rad or m; length: characteristic length ℓ, m. Raises HelicoideError for a wrong q.
    Source: Yoshikawa 1985; Vargas 2013, eqs. 3.1–3.5.
    """
    return analyse_jacobian(scaled_jacobian(frame_jacobian(robot, q, frame), length))
