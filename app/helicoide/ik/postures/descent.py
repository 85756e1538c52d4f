"""One search for a posture of any arm by Levenberg-Marquardt: kernels.

It minimises ½ e², e = (Δp / ℓ, w θ a), within the joint limits:

    Δq = Jᵀ (J Jᵀ + λ)⁻¹ e = (JᵀJ + λ)⁻¹ Jᵀ e,   q ← q + Δq

Source: Chan and Lawrence 1988, General inverse kinematics with the error damped pseudoinverse, and Sugihara 2011,
Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method: λ ∝ e². Joints at a limit: Bertsekas 1982,
Projected Newton methods. For goals out of reach `minimise_error` adapts λ as in Marquardt 1963. Shapes are not checked.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.qp import copy_into
from helicoide.ik.postures.blocks import Error, solve_damped
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

DAMPING = 0.1  # λ / e²; the ½ and 1 of the sources take 1.5 times as many steps
LEAST = 1e-12  # added to λ: keeps the system solvable at the goal, also with fewer than six joints
SLACK = 1e-9  # the smallest λ of `minimise_error`: with a smaller one rounding errors of e / λ exceed the step
HOPELESS = 0.02  # `descend` fails where a step is predicted to reduce e² by less than this fraction
SETTLED = 1e-14  # `minimise_error` ends where a step is predicted to reduce e² by less than this fraction


@kernel_into
def by(a: Array | Error, e: Error) -> float:
    """a · e of six numbers."""
    return a[0] * e[0] + a[1] * e[1] + a[2] * e[2] + a[3] * e[3] + a[4] * e[4] + a[5] * e[5]


@kernel_into
def leave_out(table: Array, q: Array, e: Error, columns: Array) -> None:
    """Set to zero the columns of joints that e moves against a limit that is kept."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        if ranges[i, HELD] > 0.0 and not ranges[i, LOWER] < q[i] < ranges[i, UPPER]:
            pull = by(columns[i], e)
            if (q[i] <= ranges[i, LOWER] and pull < 0.0) or (q[i] >= ranges[i, UPPER] and pull > 0.0):
                columns[i] = 0.0


@kernel_into
def joints_at_limits(range_of: Array, x: float) -> float:
    """A value of a variable, clipped to its limits if the search keeps them."""
    return min(max(x, range_of[LOWER]), range_of[UPPER]) if range_of[HELD] > 0.0 else x


@kernel_into
def step_to(table: Array, q: Array, columns: Array, y: Error, there: Array) -> None:
    """Write q + Jᵀ y, within the limits."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        there[i] = joints_at_limits(ranges[i], q[i] + ranges[i, UNIT] * by(columns[i], y))


@kernel_into
def unwind(table: Array, q: Array) -> None:
    """Shift periodic joints that are outside their limits by whole periods into one period from the lower limit on."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        lower, period = ranges[i, LOWER], ranges[i, PERIOD]
        if period > 0.0 and not lower <= q[i] <= ranges[i, UPPER]:
            q[i] -= period * np.floor((q[i] - lower) / period)


@kernel_into
def descend(table: Array, goal: Goal, q: Array, buffers: Array) -> tuple[int, float, float]:
    """One search from q, in place, with λ = 0.1 e².

    Args: q (n,), rad or m; room of `packed.room_for`. Returns the number of steps, negative after a failure, and the
    errors of position, m, and orientation, rad, infinite after a failure.
    """
    setting, columns = table[SETTING], buffers[COLUMNS:]
    near, far = (setting[WITHIN] / setting[REACH]) ** 2, (setting[TURNING] * setting[WITHIN_TURN]) ** 2
    steps = int(setting[STEPS])
    for step in range(steps):
        e = linearised(table, goal, q, buffers)
        p, r = squares(e)
        if p <= near and r <= far:
            unwind(table, q)
            return step, setting[REACH] * np.sqrt(p), np.sqrt(r)
        leave_out(table, q, e, columns)
        damping = DAMPING * (p + r) + LEAST
        y = solve_damped(columns, e, damping)
        if p + r - damping * by(e, y) < HOPELESS * (p + r):
            return -step - 1, np.inf, np.inf
        step_to(table, q, columns, y, q)
    return -steps, np.inf, np.inf


@kernel_into
def promised(columns: Array, e: Error, y: Error) -> float:
    """Half the first-order reduction of e² by the step Jᵀ y: (Jᵀe) · (Jᵀy) = e · (e − λ y)."""
    lower = 0.0
    for i in range(columns.shape[0]):
        lower += by(columns[i], e) * by(columns[i], y)
    return lower


@kernel_into
def minimise_error(table: Array, goal: Goal, q: Array, trial: Array, buffers: Array) -> float:
    """One search from q, in place, for the minimum of e², which is returned; only steps that reduce e² are taken.

    Args: as in `descend`; trial (n,): temporary posture.
    Source: Marquardt 1963: λ decreases after a step that is taken and increases after one that is not.
    """
    columns = buffers[COLUMNS:]
    e = linearised(table, goal, q, buffers)
    least = sum(squares(e))
    damping = DAMPING * least + LEAST
    for _ in range(int(table[SETTING, STEPS])):
        leave_out(table, q, e, columns)
        y = solve_damped(columns, e, damping)
        if promised(columns, e, y) <= SETTLED * least:
            break
        step_to(table, q, columns, y, trial)
        tried = sum(squares(linearised(table, goal, trial, buffers)))
        if tried < least:
            copy_into(trial, q)
            least, damping = tried, max(damping / 3.0, SLACK)
        else:
            damping *= 4.0
        e = linearised(table, goal, q, buffers)
    return least
