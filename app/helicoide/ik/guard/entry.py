"""A straight instrument through an entry point: two rows that keep its shaft there (remote centre of motion).

With d the direction of the shaft, P (3, 2) perpendicular to it and c its point nearest to the entry point r,

    Pᵀ J_c Δq = k Pᵀ (r − c) + ℓ,   k = 1 − e^(−K dt).

A miss up to `AT_ONCE` is corrected in one tick. ℓ corrects the second-order error of a step and is known only after
that step was tried.
Source: Coutinho 2015, §3.3, here with feedback of the drift; there P is the x and z axes of the restricted link.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.packed import CARRIER, DIRECTION, ENTRY, INSTRUMENT, SETTING, SHAFT, PlacedArm
from helicoide.ik.guard.rows import add_point, at_row
from helicoide.kernels import kernel

GAIN = 12.5
AT_ONCE = 0.2e-3
# Weight of the two rows: large against the damping of the task, so that a miss is corrected as asked.
FIRM = 10.0


@kernel
def nearest_of_shaft(arm: Array, poses: Array) -> tuple[Array, Array]:
    """The point of the shaft nearest to the entry point, (3,), m, and the shaft's direction, (3,), both world."""
    instrument, pose = arm[INSTRUMENT], poses[int(arm[SETTING, CARRIER])]
    c, d, along = np.empty(3), np.empty(3), 0.0
    for a in range(3):
        c[a], d[a] = pose[a, 3], 0.0
        for b in range(3):
            c[a] += pose[a, b] * instrument[SHAFT + b]
            d[a] += pose[a, b] * instrument[DIRECTION + b]
        along += d[a] * (instrument[ENTRY + a] - c[a])
    for a in range(3):
        c[a] += along * d[a]
    return c, d


@kernel
def across(direction: Array) -> Array:
    """Two unit vectors perpendicular to a direction and to each other, (2, 3)."""
    x, y, z = direction
    if abs(x) < 0.6:
        length = np.sqrt(y * y + z * z)
        first = np.array([0.0, -z / length, y / length])
    else:
        length = np.sqrt(x * x + y * y)
        first = np.array([-y / length, x / length, 0.0])
    pair = np.empty((2, 3))
    pair[0] = first
    pair[1, 0] = y * first[2] - z * first[1]
    pair[1, 1] = z * first[0] - x * first[2]
    pair[1, 2] = x * first[1] - y * first[0]
    return pair


@kernel
def miss(arm: Array, poses: Array, pair: Array) -> Array:
    """The entry point relative to its nearest point of the shaft, along two directions (2, 3): (2,), m."""
    c, _ = nearest_of_shaft(arm, poses)
    away = np.zeros(2)
    for i in range(2):
        for a in range(3):
            away[i] += pair[i, a] * (arm[INSTRUMENT, ENTRY + a] - c[a])
    return away


@kernel
def entry_rows(placed: PlacedArm, dt: float) -> tuple[Array, Array, Array, Array]:
    """The two rows (2, n) of the shaft, what they ask for (2,), m, their directions (2, 3), and the miss (2,), m."""
    c, d = nearest_of_shaft(placed.arm, placed.poses)
    pair, rows, asked = across(d), np.zeros((2, placed.at.n)), np.empty(2)
    for i in range(2):
        add_point(rows[i], at_row(pair, i), (c[0], c[1], c[2]), 0, int(placed.arm[SETTING, CARRIER]), placed)
    away = miss(placed.arm, placed.poses, pair)
    far = np.sqrt(away[0] ** 2 + away[1] ** 2)
    share = max(1.0 - np.exp(-GAIN * dt), AT_ONCE / max(far, AT_ONCE))
    for i in range(2):
        asked[i] = share * away[i]
    return rows, asked, pair, away
