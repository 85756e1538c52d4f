"""One search for a posture of any arm by Levenberg-Marquardt: kernels.

A descent of ½ e², e = (Δp / ℓ, w θ a), in which every joint keeps its limits:

    (JᵀJ + λ D) Δq = Jᵀe,   q ← q + Δq

Source: Chan and Lawrence 1988, General inverse kinematics with the error damped pseudoinverse, and Sugihara 2011,
Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method: λ ∝ e². Joints held at a limit: Bertsekas
1982, Projected Newton methods. Where nothing can be reached, λ follows Marquardt 1963 instead. Shapes are not checked.
"""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel, kernel_into
from helicoide.kinematics.chain import Array
from helicoide.kinematics.tool import (
    DRIVER,
    SLIDE,
    TURN,
    X,
    Y,
    Z,
    along,
    carried,
    cross,
    ending,
    line,
    rows_of,
    standing,
    turn_to,
    twist,
)

# Columns of a joint in `ranges` (n, 6): its limits; after how much it stands alike, 2π or 0 for never; whether its
# limits hold it during a search; by how much draws differ; and its own unit, 1 for angles, ℓ for slides.
LOWER, UPPER, PERIOD, HELD, STRIDE, UNIT = range(6)

DAMPING = 0.1  # λ / e²; the sources have ½ and 1, which take half as many steps again
LEAST = 1e-12  # λ of an arm that has reached its goal: H stays invertible where joints outnumber what is asked
HOPELESS = 0.02  # a search ends where a step promises less than this share of e²
SETTLED = 1e-14  # and the approach to what cannot be reached where it promises less than this

Error = tuple[float, float, float, float, float, float]
Memory = tuple[Array, Array, Array]


@kernel_into
def linearised(arm: Array, q: Array, goal: Array, weights: tuple[float, float], columns: Array) -> Error:
    """The error e of a posture, and its columns ∂e/∂q with the sign turned, written as (n, 6).

    Args: arm of `tool.packed`; q (n,), rad or m; goal (4, 4), m; weights of the position, 1/ℓ, and of the orientation.
    """
    columns[:] = 0.0
    x, y, z = X, Y, Z
    last, n = arm.shape[0] - 1, q.shape[0]
    for i in range(last):
        j = int(arm[i, DRIVER])
        (axis, way), (slid, c, s) = line(arm[i]), standing(arm[i], q[j])
        turned_axis = (along(x, axis), along(y, axis), along(z, axis))
        x, y, z = (
            carried(x, axis, way, slid, c, s),
            carried(y, axis, way, slid, c, s),
            carried(z, axis, way, slid, c, s),
        )
        v, w = twist((x[3], y[3], z[3]), turned_axis, arm[i, TURN], arm[i, SLIDE])
        for a in range(3):
            columns[j, a] += v[a]
            columns[j, 3 + a] += w[a]
    tool = rows_of(arm[last])
    x, y, z = ending(x, tool), ending(y, tool), ending(z, tool)
    near, turned = weights
    for j in range(n):
        v = cross((columns[j, 3], columns[j, 4], columns[j, 5]), (x[3], y[3], z[3]))
        for a in range(3):
            columns[j, a] = near * (columns[j, a] + v[a])
            columns[j, 3 + a] *= turned
    r = turn_to(goal, x, y, z)
    p = (goal[0, 3] - x[3], goal[1, 3] - y[3], goal[2, 3] - z[3])
    return near * p[0], near * p[1], near * p[2], turned * r[0], turned * r[1], turned * r[2]


@kernel_into
def squares(e: Error) -> tuple[float, float]:
    """The squares of the errors of position and of orientation."""
    return e[0] * e[0] + e[1] * e[1] + e[2] * e[2], e[3] * e[3] + e[4] * e[4] + e[5] * e[5]


@kernel_into
def fill(ranges: Array, q: Array, e: Error, columns: Array, damping: float, H: Array, g: Array) -> None:
    """Write H = JᵀJ + λ D, its lower half, and g = Jᵀe; a joint that is pushed against its limit is left out."""
    for i in range(q.shape[0]):
        a = columns[i]
        g[i] = a[0] * e[0] + a[1] * e[1] + a[2] * e[2] + a[3] * e[3] + a[4] * e[4] + a[5] * e[5]
        for j in range(i + 1):
            b = columns[j]
            H[i, j] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5]
        H[i, i] += damping / (ranges[i, UNIT] * ranges[i, UNIT])
    for i in range(q.shape[0]):
        pushed = (q[i] <= ranges[i, LOWER] and g[i] < 0.0) or (q[i] >= ranges[i, UPPER] and g[i] > 0.0)
        if pushed and ranges[i, HELD] > 0.0:
            for j in range(q.shape[0]):
                H[max(i, j), min(i, j)] = 1.0 if i == j else 0.0
            g[i] = 0.0


@kernel_into
def solve_in_place(H: Array, g: Array) -> float:
    """Write x with H x = g over g (n,), by H = L Lᵀ, and return gᵀx; of H (n, n) the lower half is read and lost."""
    n, promised = g.shape[0], 0.0
    for i in range(n):
        for j in range(i):
            total = H[i, j]
            for k in range(j):
                total -= H[i, k] * H[j, k]
            H[i, j] = total * H[j, j]
        total, y = H[i, i], g[i]
        for k in range(i):
            total -= H[i, k] * H[i, k]
            y -= H[i, k] * g[k]
        H[i, i] = 1.0 / np.sqrt(total)
        g[i] = y * H[i, i]
        promised += g[i] * g[i]
    for i in range(n - 1, -1, -1):
        y = g[i]
        for k in range(i + 1, n):
            y -= H[k, i] * g[k]
        g[i] = y * H[i, i]
    return promised


@kernel_into
def held(ranges: Array, i: int, x: float) -> float:
    """A value of joint i, brought back to the limits where they hold it."""
    return min(max(x, ranges[i, LOWER]), ranges[i, UPPER]) if ranges[i, HELD] > 0.0 else x


@kernel_into
def unwind(ranges: Array, q: Array) -> None:
    """Bring joints that stand alike after a turn back into their limits."""
    for i in range(q.shape[0]):
        if ranges[i, PERIOD] > 0.0 and (q[i] < ranges[i, LOWER] or q[i] > ranges[i, UPPER]):
            q[i] -= ranges[i, PERIOD] * np.floor((q[i] - ranges[i, LOWER]) / ranges[i, PERIOD])


@kernel
def memory_of(n: int) -> Memory:
    """Room for the columns (n, 6), H (n, n) and g (n,) of a search."""
    return np.empty((n, 6)), np.empty((n, n)), np.empty(n)


@kernel_into
def descend(
    arm: Array,
    ranges: Array,
    goal: Array,
    weights: tuple[float, float],
    tolerances: tuple[float, float],
    iterations: int,
    q: Array,
    memory: Memory,
) -> tuple[int, float, float]:
    """One search, from q and in q; λ = 0.1 e². Returns the number of steps, negative if in vain, and both errors."""
    columns, H, g = memory
    near, far = (weights[0] * tolerances[0]) ** 2, (weights[1] * tolerances[1]) ** 2
    for step in range(iterations):
        e = linearised(arm, q, goal, weights, columns)
        p, r = squares(e)
        if p <= near and r <= far:
            unwind(ranges, q)
            return step, np.sqrt(p) / weights[0], np.sqrt(r)
        fill(ranges, q, e, columns, DAMPING * (p + r) + LEAST, H, g)
        if solve_in_place(H, g) < HOPELESS * (p + r):
            return -step - 1, np.inf, np.inf
        for i in range(q.shape[0]):
            q[i] = held(ranges, i, q[i] + g[i])
    return -iterations, np.inf, np.inf


@kernel
def settle(
    arm: Array,
    ranges: Array,
    goal: Array,
    weights: tuple[float, float],
    iterations: int,
    q: Array,
    trial: Array,
    memory: Memory,
) -> float:
    """One search for the least e² from q and in q, and that e²; a step that does not lower it is not taken.

    Source: Marquardt 1963: λ shrinks with a step that is taken and grows with one that is not.
    """
    columns, H, g = memory
    e = linearised(arm, q, goal, weights, columns)
    least = sum(squares(e))
    damping = DAMPING * least + LEAST
    for _ in range(iterations):
        fill(ranges, q, e, columns, damping, H, g)
        if solve_in_place(H, g) <= SETTLED * least:
            break
        for i in range(q.shape[0]):
            trial[i] = held(ranges, i, q[i] + g[i])
        tried = sum(squares(linearised(arm, trial, goal, weights, columns)))
        if tried < least:
            q[:], least, damping = trial, tried, max(damping / 3.0, LEAST)
        else:
            damping *= 4.0
        e = linearised(arm, q, goal, weights, columns)
    return least
