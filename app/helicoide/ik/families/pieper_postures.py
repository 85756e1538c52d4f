"""Every posture of an arm with a spherical wrist, by Pieper's polynomial of degree 4: kernels."""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.frames import framed
from helicoide.ik.families.pieper_arm import NONE
from helicoide.ik.families.polish import FREE, ROUNDING, is_known, linear, polished
from helicoide.ik.families.roots import zeros
from helicoide.ik.postures.measure import stand_of
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Chain
from helicoide.kinematics.tool_kernels import write_pose

ACCEPTED = 1e-9  # the largest error of a posture, m and rad
# Columns of a posture after its q: the number of the posture of θ₁ to θ₃ (from 0 in `pieper_wrist_postures`, 1 in
# `pieper_joint_values`), whether the wrist is flipped, and the free joints, as the sum of the three numbers below.
ARM, FLIPPED, LOOSE = 6, 7, 8
WAIST, SHOULDER, WRIST = 1, 2, 4


@kernel
def row_at(row: Array, c: float, s: float) -> float:
    """row₀ + row₁ cos θ₃ + row₂ sin θ₃."""
    return float(row[0] + row[1] * c + row[2] * s)


@kernel
def third_angles(arm: Any, r: float, z: float, kept: float, angles: Array) -> int:
    """Write θ₃ into angles (4,), rad: of r = k₃ if a₁ = 0, of z = k₄ if sα₁ = 0, else of the quartic.

    Returns their number. kept: θ₃ where it is free, rad.
    """
    a1, sa1, k3, k4, f3, size = arm["a"][0], sin(arm["alpha"][0]), arm["k"][0], arm["k"][1], arm["f"][2], arm["size"]
    if a1 < NONE:
        count, angles[0], angles[1] = linear(k3[1], k3[2], r - k3[0], kept)
        return count
    if abs(sa1) < NONE:
        count, angles[0], angles[1] = linear(k4[1], k4[2], z - k4[0], kept)
        return count
    n = 4 * a1 * a1 * sa1 * sa1
    l0, c1, s1, c2, s2 = -n * size[0], -n * size[1], -n * size[2], 0.0, 0.0
    for way in range(3):  # the squares of three sums u + v cos θ₃ + w sin θ₃
        if way == 0:
            u, v, w = sa1 * (r - k3[0]), -sa1 * k3[1], -sa1 * k3[2]
        elif way == 1:
            u, v, w = 2 * a1 * (z - k4[0]), -2 * a1 * k4[1], -2 * a1 * k4[2]
        else:
            u, v, w = 2 * a1 * sa1 * f3[0], 2 * a1 * sa1 * f3[1], 2 * a1 * sa1 * f3[2]
        l0 += u * u + 0.5 * (v * v + w * w)
        c1, s1, c2, s2 = c1 + 2 * u * v, s1 + 2 * u * w, c2 + 0.5 * (v * v - w * w), s2 + v * w
    return zeros(l0, c1, s1, c2, s2, angles)


@kernel
def second_angles(arm: Any, theta3: float, r: float, z: float, kept: float) -> tuple[int, float, float]:
    """The number of θ₂, and two, rad, of k₁c₂ + k₂s₂ = (r − k₃)/2a₁ and k₁s₂ − k₂c₂ = (z − k₄)/sα₁.

    If a₁ or sα₁ is zero, only the other equation is used. kept: θ₂ where it is free, rad.
    """
    a1, sa1, c, s = arm["a"][0], sin(arm["alpha"][0]), cos(theta3), sin(theta3)
    k1, minus_k2 = row_at(arm["f"][0], c, s), row_at(arm["f"][1], c, s)
    k3, k4 = row_at(arm["k"][0], c, s), row_at(arm["k"][1], c, s)
    if a1 < NONE:
        return linear(minus_k2, k1, (z - k4) / sa1, kept)
    x = (r - k3) / (2 * a1)
    if abs(sa1) < NONE:
        return linear(k1, -minus_k2, x, kept)
    y = (z - k4) / sa1
    if hypot(k1, minus_k2) < FREE:
        return 1, kept, kept
    return 1, atan2(k1 * y - minus_k2 * x, k1 * x + minus_k2 * y), kept


@kernel
def undo(M: Array, theta: float, alpha: float) -> None:
    """M ← Rx(α)ᵀ Rz(θ)ᵀ M."""
    c, s, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
    for j in range(3):
        x, y, z = M[0, j], M[1, j], M[2, j]
        x, y = c * x + s * y, c * y - s * x
        M[0, j], M[1, j], M[2, j] = x, ca * y + sa * z, ca * z - sa * y


@kernel
def wrist_angles(alpha: Array, M: Array, kept: float, flipped: bool) -> tuple[float, float, float, bool]:
    """θ₄, θ₅, θ₆ of Rz(θ₄) Rx(α₄) Rz(θ₅) Rx(α₅) Rz(θ₆) = M, and whether θ₄ is free and kept; NaN where |c₅| > 1.

    c₅ = (cα₄ cα₅ − m₃₃) / sα₄ sα₅, s₅ of either sign, θ₄ from the last column of M, θ₆ from the remaining rotation.
    """
    ca4, ca5, sa4, sa5 = cos(alpha[3]), cos(alpha[4]), sin(alpha[3]), sin(alpha[4])
    c5 = (ca4 * ca5 - M[2, 2]) / (sa4 * sa5)
    y = -ca4 * sa5 * c5 - sa4 * ca5
    square = (M[0, 2] * M[0, 2] + M[1, 2] * M[1, 2] - y * y) / (sa5 * sa5)
    if square < -ROUNDING:
        return np.nan, np.nan, np.nan, False
    s5 = sqrt(max(square, 0.0))
    s5 = -s5 if flipped else s5
    free = hypot(sa5 * s5, y) < FREE
    theta5 = atan2(s5, c5)
    theta4 = kept if free else atan2(M[1, 2], M[0, 2]) - atan2(y, sa5 * s5)
    N = M.copy()
    undo(N, theta4, alpha[3])
    undo(N, theta5, alpha[4])
    return theta4, theta5, atan2(N[1, 0], N[0, 0]), free


@kernel
def pieper_wrist_postures(arm: Any, T: Array, kept: Array) -> Array:
    """Every θ for a pose of the wrist (4, 4), m, as rows (k, 9): θ, rad, and the columns above.

    Args: arm of PIEPER; kept (6,), rad: θ where a joint is free.
    """
    rows, angles, M, k, number = np.empty((16, 9)), np.empty(4), np.empty((3, 3)), 0, 0
    alpha, ca1, sa1 = arm["alpha"].copy(), cos(arm["alpha"][0]), sin(arm["alpha"][0])
    px, py, z = T[0, 3], T[1, 3], T[2, 3]
    r = px * px + py * py + z * z
    for third in range(third_angles(arm, r, z, kept[2], angles)):
        theta3 = angles[third]
        c, s = cos(theta3), sin(theta3)
        f1, f2, f3 = row_at(arm["f"][0], c, s), row_at(arm["f"][1], c, s), row_at(arm["f"][2], c, s)
        count, one, other = second_angles(arm, theta3, r, z, kept[1])
        for second in range(count):
            theta2 = one if second == 0 else other
            c2, s2 = cos(theta2), sin(theta2)
            g1, g2 = c2 * f1 - s2 * f2 + arm["a"][0], ca1 * (s2 * f1 + c2 * f2) - sa1 * (f3 + arm["d"][1])
            over = hypot(g1, g2) < FREE
            theta1 = kept[0] if over else atan2(py, px) - atan2(g2, g1)
            for i in range(3):
                for j in range(3):
                    M[i, j] = T[i, j]
            undo(M, theta1, alpha[0])
            undo(M, theta2, alpha[1])
            undo(M, theta3, alpha[2])
            for flipped in range(2):
                theta4, theta5, theta6, free = wrist_angles(alpha, M, kept[3], flipped == 1)
                if np.isnan(theta4):
                    continue
                row = rows[k]
                row[0], row[1], row[2], row[3], row[4], row[5] = theta1, theta2, theta3, theta4, theta5, theta6
                row[ARM], row[FLIPPED] = number, flipped
                row[LOOSE] = WAIST * over + SHOULDER * (hypot(f1, f2) < FREE) + WRIST * free
                k += 1
            number += 1
    return rows[:k]


@kernel
def wrist_pose(arm: Any, T_world_tool: Array) -> Array:
    """The pose of the last DH frame of an arm of PIEPER, origin at the wrist centre, moved by −d₁ z, (4, 4), m."""
    T = T_world_tool
    if arm["backwards"]:
        T = np.zeros((4, 4))
        for i in range(3):
            for j in range(3):
                T[i, j] = T_world_tool[j, i]
                T[i, 3] -= T_world_tool[j, i] * T_world_tool[j, 3]
        T[3, 3] = 1.0
    seen = np.empty((4, 4))
    x, y, z = framed(arm["frames"][0], T, arm["frames"][1])
    write_pose(seen, x, y, z)
    seen[2, 3] -= arm["d"][0]
    return seen


@kernel
def pieper_joint_values(arms: Chain, table: Array, T_world_tool: Array, q: Array) -> Array:
    """Every posture for a tool pose (4, 4), m, polished and verified, each once: q, rad, and the columns above.

    Args: arms (1,) of PIEPER; table of `polish.polisher`; q (6,), rad: kept where a joint is free.
    """
    form, goal = arms[0], stand_of(T_world_tool)
    shifts, backwards = form["shifts"], form["backwards"]
    kept, there = np.empty(6), np.empty(6)
    for i in range(6):
        kept[i] = (q[5 - i] if backwards else q[i]) + shifts[i]
    rows = pieper_wrist_postures(form, wrist_pose(form, T_world_tool), kept)
    k, number, last = 0, 0, -1.0
    for row in rows:
        for i in range(6):
            there[5 - i if backwards else i] = row[i] - shifts[i]
        if polished(table, T_world_tool, goal, there) < ACCEPTED and not is_known(rows, k, there):
            number += int(row[ARM] != last)
            last = row[ARM]
            for i in range(6):
                rows[k, i] = there[i]
            rows[k, ARM], rows[k, FLIPPED], rows[k, LOOSE] = number, row[FLIPPED], row[LOOSE]
            k += 1
    return rows[:k]
