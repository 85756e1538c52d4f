"""One search for a posture of any arm by Levenberg-Marquardt: kernels.

A descent of ½ e², e = (Δp / ℓ, w θ a), in which every joint keeps its limits:

    Δq = Jᵀ (J Jᵀ + λ)⁻¹ e = (JᵀJ + λ)⁻¹ Jᵀ e,   q ← q + Δq

Source: Chan and Lawrence 1988, General inverse kinematics with the error damped pseudoinverse, and Sugihara 2011,
Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method: λ ∝ e². Joints held at a limit: Bertsekas
1982, Projected Newton methods. Where nothing can be reached, λ follows Marquardt 1963 instead. Shapes are not checked.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.blocks import Error, solved
from helicoide.ik.postures.errors import COLUMNS, Goal, linearised, squares
from helicoide.ik.postures.packed import (
    HELD,
    LOWER,
    PERIOD,
    REACH,
    SETTING,
    STEPS,
    TURNING,
    UNIT,
    UPPER,
    WITHIN,
    WITHIN_TURN,
    behind_joints,
)
from helicoide.kernels import kernel_into

DAMPING = 0.1  # λ / e²; the sources have ½ and 1, which take half as many steps again
LEAST = 1e-12  # λ of an arm that has reached its goal: a solution is there with fewer joints than six, too
SLACK = 1e-9  # and of one that cannot: what is left, over λ, must not drown the step in rounding
HOPELESS = 0.02  # a search ends where a step promises less than this share of e²
SETTLED = 1e-14  # and the approach to what cannot be reached where it promises less than this


@kernel_into
def by(a: Array | Error, e: Error) -> float:
    """a · e, of six numbers."""
    return a[0] * e[0] + a[1] * e[1] + a[2] * e[2] + a[3] * e[3] + a[4] * e[4] + a[5] * e[5]


@kernel_into
def leave_out(table: Array, q: Array, e: Error, columns: Array) -> None:
    """Clear the columns of joints that are pushed against a limit which holds them."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        if ranges[i, HELD] > 0.0 and not ranges[i, LOWER] < q[i] < ranges[i, UPPER]:
            pull = by(columns[i], e)
            if (q[i] <= ranges[i, LOWER] and pull < 0.0) or (q[i] >= ranges[i, UPPER] and pull > 0.0):
                columns[i] = 0.0


@kernel_into
def held(range_of: Array, x: float) -> float:
    """A value of a variable, brought back to the limits where they hold it."""
    return min(max(x, range_of[LOWER]), range_of[UPPER]) if range_of[HELD] > 0.0 else x


@kernel_into
def step_to(table: Array, q: Array, columns: Array, y: Error, there: Array) -> None:
    """Write q + Jᵀ y, within the limits."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        there[i] = held(ranges[i], q[i] + ranges[i, UNIT] * by(columns[i], y))


@kernel_into
def unwind(table: Array, q: Array) -> None:
    """Bring joints that stand alike after a turn back into their limits."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        lower, period = ranges[i, LOWER], ranges[i, PERIOD]
        if period > 0.0 and not lower <= q[i] <= ranges[i, UPPER]:
            q[i] -= period * np.floor((q[i] - lower) / period)


@kernel_into
def descend(table: Array, goal: Goal, q: Array, room: Array) -> tuple[int, float, float]:
    """One search, from q and in q; λ = 0.1 e². Returns the number of steps, negative if in vain, and both errors.

    Args: q (n,), rad or m; room of `packed.room_for`.
    """
    setting, columns = table[SETTING], room[COLUMNS:]
    near, far = (setting[WITHIN] / setting[REACH]) ** 2, (setting[TURNING] * setting[WITHIN_TURN]) ** 2
    steps = int(setting[STEPS])
    for step in range(steps):
        e = linearised(table, goal, q, room)
        p, r = squares(e)
        if p <= near and r <= far:
            unwind(table, q)
            return step, setting[REACH] * np.sqrt(p), np.sqrt(r)
        leave_out(table, q, e, columns)
        damping = DAMPING * (p + r) + LEAST
        y = solved(columns, e, damping)
        if p + r - damping * by(e, y) < HOPELESS * (p + r):
            return -step - 1, np.inf, np.inf
        step_to(table, q, columns, y, q)
    return -steps, np.inf, np.inf


@kernel_into
def copy(a: Array, b: Array) -> None:
    """Write a into b, both (n,), without the array between them that `b[:] = a` makes."""
    for i in range(a.shape[0]):
        b[i] = a[i]


@kernel_into
def promised(columns: Array, e: Error, y: Error) -> float:
    """Half of that by which the step Jᵀ y lowers e² to first order: (Jᵀe) · (Jᵀy), which is e · (e − λ y)."""
    lower = 0.0
    for i in range(columns.shape[0]):
        lower += by(columns[i], e) * by(columns[i], y)
    return lower


@kernel_into
def settle(table: Array, goal: Goal, q: Array, trial: Array, room: Array) -> float:
    """One search for the least e² from q and in q, and that e²; a step that does not lower it is not taken.

    Args: as in `descend`; trial (n,): room for another posture.
    Source: Marquardt 1963: λ shrinks with a step that is taken and grows with one that is not.
    """
    columns = room[COLUMNS:]
    e = linearised(table, goal, q, room)
    least = sum(squares(e))
    damping = DAMPING * least + LEAST
    for _ in range(int(table[SETTING, STEPS])):
        leave_out(table, q, e, columns)
        y = solved(columns, e, damping)
        if promised(columns, e, y) <= SETTLED * least:
            break
        step_to(table, q, columns, y, trial)
        tried = sum(squares(linearised(table, goal, trial, room)))
        if tried < least:
            copy(trial, q)
            least, damping = tried, max(damping / 3.0, SLACK)
        else:
            damping *= 4.0
        e = linearised(table, goal, q, room)
    return least
