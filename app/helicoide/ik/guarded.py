"""The guarded step: damped least squares under joint limits, speed limits and planes, checked exactly afterwards.

One tick solves, for the joint displacement Δq,

    minimise   ‖W (J Δq − v)‖² + Σ dᵢ Δqᵢ²
    subject to max(−ω dt, lower − q) ≤ Δq ≤ min(ω dt, upper − q)          speed and position limits
               nₖᵀ Jⱼ Δq ≥ −κ dt (lⱼₖ − δ)  for lⱼₖ > δ,  else ≥ 0          velocity damper of point j and plane k

A damper holds to first order only. The poses at q + Δq are therefore computed; where a point came closer than it may,
the second-order loss is added to its row and the programme is solved once more; what is still too close is settled by
shortening the step. Δq = 0 satisfies every row, so there is always an answer.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.confinement import distances
from helicoide.ik import qp
from helicoide.kernels import kernel
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, Chain
from helicoide.kinematics.forward import carried_points, link_poses

DAMPER_GAIN = 10.0
SMALLEST_SHARE = 1e-6


@kernel
def limit_rows(q: Array, lower: Array, upper: Array, reach: Array) -> tuple[Array, Array]:
    """Rows A Δq ≥ b of the joint limits: n lower rows, then n upper rows.

    A joint beyond its limit may stay or come back, never go further. Args: all (n,), rad; reach: speed limit times dt.
    """
    n = q.shape[0]
    A, b = np.zeros((2 * n, n)), np.empty(2 * n)
    for i in range(n):
        A[i, i], A[n + i, i] = 1.0, -1.0
        b[i] = max(-reach[i], min(0.0, lower[i] - q[i]))
        b[n + i] = max(-reach[i], min(0.0, q[i] - upper[i]))
    return A, b


@kernel
def plane_rows(
    poses: Array,
    chain: Chain,
    axes: Array,
    points: Array,
    links: NDArray[np.int64],
    normals: Array,
    near: Array,
    decay: float,
) -> tuple[Array, Array]:
    """Rows A Δq ≥ b of the velocity dampers, point after point, plane after plane.

    Args: points (m, 3), m, world; links (m,): link that carries each; normals (k, 3); near (m, k): l − δ, m;
    decay: the share of a distance that one tick may use up.
    """
    m, k = points.shape[0], normals.shape[0]
    n = jacobian.columns(chain)
    A, b = np.zeros((m * k, n)), np.empty(m * k)
    for j in range(m):
        columns = jacobian.geometric(poses, chain, axes, points[j], links[j])
        for p in range(k):
            row = j * k + p
            b[row] = -decay * max(0.0, near[j, p])
            for i in range(n):
                A[row, i] = (
                    normals[p, 0] * columns[0, i] + normals[p, 1] * columns[1, i] + normals[p, 2] * columns[2, i]
                )
    return A, b


@kernel
def normal_equations(J: Array, v: Array, weights: Array, damping: Array) -> tuple[Array, Array]:
    """H = Jᵀ W² J + diag(d) and g = Jᵀ W² v, for J (r, n), v (r,), weights (r,), damping d (n,)."""
    r, n = J.shape
    H, g = np.zeros((n, n)), np.zeros(n)
    for a in range(n):
        for s in range(r):
            g[a] += weights[s] * weights[s] * J[s, a] * v[s]
        for c in range(a + 1):
            total = 0.0
            for s in range(r):
                total += weights[s] * weights[s] * J[s, a] * J[s, c]
            H[a, c] = H[c, a] = total
        H[a, a] += damping[a]
    return H, g


@kernel
def shortfall(near: Array, near_after: Array) -> float:
    """By how much the worst point came closer than it may: δ, or where it already was if that is nearer; m."""
    worst = 0.0
    for j in range(near.shape[0]):
        for p in range(near.shape[1]):
            worst = max(worst, min(0.0, near[j, p]) - near_after[j, p])
    return worst


@kernel
def raise_by_loss(b: Array, A: Array, step: Array, near: Array, after: Array) -> None:
    """Add to the row of each point that came too close what its linear prediction lost, and a tenth for the rest."""
    k = near.shape[1]
    for j in range(near.shape[0]):
        for p in range(k):
            row = j * k + p
            if after[j, p] < min(0.0, near[j, p]):
                b[row] += 1.1 * (near[j, p] + qp.dot(A[row], step) - after[j, p])


@kernel
def within(q: Array, step: Array, lower: Array, upper: Array, reach: Array) -> Array:
    """q + Δq, cut to the limits to the last bit; a joint that is outside keeps its place as its limit."""
    moved = np.empty_like(q)
    for i in range(q.shape[0]):
        value = q[i] + min(max(step[i], -reach[i]), reach[i])
        moved[i] = min(max(value, min(lower[i], q[i])), max(upper[i], q[i]))
    return moved


@kernel
def guarded_step(
    arm: tuple[Chain, Array, NDArray[np.int64]],
    q: Array,
    poses: Array,
    task: tuple[Array, Array, Array, Array],
    limits: tuple[Array, Array, Array],
    planes: tuple[Array, Array, float],
    dt: float,
) -> tuple[Array, Array, Array, float]:
    """One guarded tick from q towards a task.

    Args: arm: the chain of joints, guarded points (m, 3) on the links (m,) that carry them;
    q (n,), rad, and its `link_poses`; task: J (r, n), v (r,) the wished displacement, weights (r,), damping d (n,);
    limits: lower, upper (n,), rad, speed (n,), rad/s; planes: normals (k, 3), offsets (k,), m, critical distance, m;
    dt, s.
    Returns q' (n,), its link poses (n + 1, 4, 4), the multipliers of the 2 n limit rows and m k plane rows, and the
    share of the step that was taken.
    """
    chain, guarded, links = arm
    lower, upper, speed = limits
    normals, offsets, critical = planes
    reach = speed * dt
    axes = jacobian.joint_axes(poses, chain)
    points = carried_points(poses, guarded, links)
    near = distances(normals, offsets, points) - critical
    H, g = normal_equations(*task)
    A_limits, b_limits = limit_rows(q, lower, upper, reach)
    A_planes, b_planes = plane_rows(poses, chain, axes, points, links, normals, near, min(1.0, DAMPER_GAIN * dt))
    A = np.concatenate((A_limits, A_planes))
    step, multipliers, _ = qp.solve(H, g, A, np.concatenate((b_limits, b_planes)))
    share, corrected = 1.0, False
    while share > SMALLEST_SHARE:
        q_after = within(q, share * step, lower, upper, reach)
        poses_after = link_poses(chain, q_after)
        after = distances(normals, offsets, carried_points(poses_after, guarded, links)) - critical
        if shortfall(near, after) <= 0.0:
            return q_after, poses_after, multipliers, share
        if not corrected:
            corrected = True
            raise_by_loss(b_planes, A_planes, step, near, after)
            again, multipliers_again, verdict = qp.solve(H, g, A, np.concatenate((b_limits, b_planes)))
            if verdict == qp.SOLVED:
                step, multipliers = again, multipliers_again
                continue
        share *= 0.5
    return q.copy(), poses, multipliers, 0.0
