"""Older methods to keep an entry point while the tool moves: one stacked Jacobian, or one task with priority.

Away from singularities they give the same joint velocities as the constrained Jacobian, if J^r is square.
Source: Coutinho 2015, §1.2.1.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.rcm.constrained import Constrained
from helicoide.kinematics.manipulability import RANK_TOLERANCE


def older_tool_jacobian(at: Constrained) -> Array:
    """J_e = [Ad_ei J_i, J_e2], body Jacobian of the tool, (6, n). Source: Coutinho 2015, eqs. 3.8, 3.14."""
    return np.hstack([at.Ad_tool_shaft @ at.J_arm, at.J[:, at.null.shape[1] :]])


def entry_jacobian(at: Constrained) -> Array:
    """J_c = [Λ J_i, 0] (r, n), from θ̇ to the forbidden velocities at the entry. Source: Coutinho 2015, eq. 3.6."""
    before = at.constraint @ at.J_arm
    return np.hstack([before, np.zeros((len(before), len(at.q) - before.shape[1]))])


def extended(at: Constrained, command: Array, entry_rate: Array) -> Array:
    """θ̇ = [J_e; J_c]† [ν; v_rd], (n,), rad/s or m/s: the Jacobian of tool and entry point together.

    With n = 6 + r joints |det [J_e; J_c]| = w_i w_r in the scaled basis. Args: ν (6,), v_rd (r,), m/s and rad/s.
    Source: Coutinho 2015, §1.2.1, after Baillieul and Funda.
    """
    stack = np.vstack([older_tool_jacobian(at), entry_jacobian(at)])
    return np.asarray(_pinv(stack) @ np.concatenate([command, entry_rate]))


def by_priority(first: Array, rate: Array, second: Array, second_rate: Array, share: float = 1.0) -> Array:
    """θ̇ = J₁† ẋ₁ + α (J₂ P)† (ẋ₂ − J₂ J₁† ẋ₁), P = I − J₁† J₁: the second task in the null space of the first.

    Args: J₁ (m, n), ẋ₁ (m,), J₂ (k, n), ẋ₂ (k,), the rows of each pair in the same units; share: α. Returns (n,).
    Source: Coutinho 2015, §1.2.1, after Maciejewski and Klein 1985.
    """
    inverse = _pinv(first)
    alone = inverse @ rate
    left = np.eye(first.shape[1]) - inverse @ first
    return np.asarray(alone + share * _pinv(second @ left) @ (second_rate - second @ alone))


def entry_first(at: Constrained, command: Array, entry_rate: Array) -> Array:
    """θ̇ = J_c† v_rd + (J_e P)† (ν − J_e J_c† v_rd), (n,): the entry point before the tool.

    Args: ν (6,), v_rd (r,). Source: Coutinho 2015, §1.2.1, after Azimian.
    """
    return by_priority(entry_jacobian(at), entry_rate, older_tool_jacobian(at), command)


def avoiding(
    J_tool: Array, command: Array, J_point: Array, away: Array, share: float = 1.0, speed: float = 1.0
) -> Array:
    """θ̇ = J_e† ẋ_e + α_η [J_o (I − J_e† J_e)]† (α₀ ẋ_o − J_o J_e† ẋ_e): obstacle avoidance in the null space.

    Args: J_e (m, n), ẋ_e (m,); J_point: J_o (k, n) of the arm's point nearest to the obstacle; away: ẋ_o (k,); share:
    α_η, from 0 far from the obstacle to 1 near it; speed: α₀, which grows towards the obstacle. Returns (n,).
    Source: Coutinho 2015, eqs. 1.1–1.4, after Maciejewski and Klein 1985.
    """
    return by_priority(J_tool, command, J_point, speed * away, share)


def _pinv(J: Array) -> Array:
    return np.asarray(np.linalg.pinv(J, rcond=RANK_TOLERANCE))
