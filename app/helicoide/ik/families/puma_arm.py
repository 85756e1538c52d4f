"""Arms with the rows of the PUMA: their lengths, where they can be, and all their postures: kernels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot, pi

import numpy as np
from numpy import empty
from numpy.typing import NDArray

from helicoide.ik.families.frames import framed
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot

# Modified rows without what is free: α, and which of a and d may differ from zero.
TWISTS = (0.0, -pi / 2, 0.0, -pi / 2, pi / 2, -pi / 2)
LENGTHS = ((False, False), (False, False), (True, True), (True, True), (False, False), (False, False))
SAME = 1e-9
# What rounding may take from a radicand, m²; the angle, rad, below which two postures are one; sines and, in m, lengths
# that count as zero.
ROUNDING, MERGED, FREE = 1e-12, 1e-6, 1e-10


@dataclass(frozen=True, eq=False)
class Puma:
    """Such an arm as the kernels take it: a₂, a₃, d₃ and d₄ (4,), m; frames (2, 4, 4): T_dh_world and T_tool_dh, m;
    shifts (6,): θ at q = 0, rad.
    """

    lengths: Array
    frames: Array
    shifts: Array


@lru_cache(maxsize=64)
def puma(robot: Robot) -> Puma | None:
    """The robot as such an arm, or None: any a₂ ≠ 0, a₃, d₃ and d₄ in the modified rows of the PUMA."""
    rows = robot.dh.rows
    fits = (
        robot.dh.convention == "modified"
        and len(rows) == len(TWISTS)
        and all(abs(row.alpha - twist) < SAME for row, twist in zip(rows, TWISTS, strict=True))
        and all(
            (a or abs(row.a) < SAME) and (d or abs(row.d) < SAME) for row, (a, d) in zip(rows, LENGTHS, strict=True)
        )
        and rows[2].a > SAME
        and not any(joint.slides or joint.mimic for joint in robot.joints)
    )
    if not fits:
        return None
    frames = np.linalg.inv(np.array([robot.dh.T_world_dh, robot.dh.T_dh_tool]))
    return Puma(lengths_of(robot), frozen(frames), frozen([row.theta for row in rows]))


def lengths_of(robot: Robot) -> Array:
    """a₂, a₃, d₃, d₄, (4,), m, of the robot's rows."""
    upper, fore = robot.dh.rows[2:4]
    return frozen([upper.a, fore.a, upper.d, fore.d])


@kernel
def is_folded(side: float, pz: float, d3: float) -> bool:
    """Whether the wrist centre is on the axis of the shoulder, by px² + py² − d₃², m², and pz, m: θ2 is then free."""
    return abs(pz) < FREE and side < FREE * (FREE + 2.0 * abs(d3))


@kernel
def postures(lengths: Array, T_base_wrist: Array, q: Array) -> tuple[Array, NDArray[np.bool_]]:
    """All θ (8, 6), rad, and which exist (8,): shoulder +, −, in each elbow +, −, in each the wrist and its flip.

    Of postures that are one the first counts. Where θ1, θ2 or θ4 is free, that of q is kept, and no wrist flipped.
    Args: lengths: a₂, a₃, d₃, d₄ (4,), m; T_base_wrist (4, 4), m, of DH frame 6; q (6,): DH angles now, rad.
    Source: Campos 1998, s.55, after Craig.
    """
    theta, exists = np.empty((8, 6)), np.zeros(8, np.bool_)
    a2, a3, d3, d4 = lengths[0], lengths[1], lengths[2], lengths[3]
    T = T_base_wrist
    px, py, pz, r13, r23, r33 = T[0, 3], T[1, 3], T[2, 3], T[0, 2], T[1, 2], T[2, 2]
    across, fore = px * px + py * py, a3 * a3 + d4 * d4
    K = (across + pz * pz - a2 * a2 - fore - d3 * d3) / (2 * a2)
    side, bend = across - d3 * d3, fore - K * K
    if side < -ROUNDING or bend < -ROUNDING:
        return theta, exists
    folded = is_folded(side, pz, d3)
    side, bend = (0.0, 0.0) if folded else (np.sqrt(max(side, 0.0)), np.sqrt(max(bend, 0.0)))
    heading, slant = np.arctan2(py, px), np.arctan2(a3, d4)
    over = across < FREE * FREE
    shoulders = 2 if side > MERGED * abs(d3) and not over else 1
    elbows = 2 if bend > MERGED * abs(K) else 1
    for shoulder in range(shoulders):
        theta1 = q[0] if over else heading - np.arctan2(d3, side if shoulder == 0 else -side)
        c1, s1 = np.cos(theta1), np.sin(theta1)
        u, along, beside = c1 * px + s1 * py, c1 * r13 + s1 * r23, c1 * r23 - s1 * r13
        for elbow in range(elbows):
            theta3 = slant - np.arctan2(K, bend if elbow == 0 else -bend)
            c3, s3 = np.cos(theta3), np.sin(theta3)
            y = (-a3 - a2 * c3) * pz - u * (d4 - a2 * s3)
            x = (a2 * s3 - d4) * pz + (a3 + a2 * c3) * u
            theta23 = q[1] + theta3 if folded else np.arctan2(y, x)
            c23, s23 = np.cos(theta23), np.sin(theta23)
            y, x = beside, r33 * s23 - along * c23
            s5, c5 = np.sqrt(x * x + y * y), -along * s23 - r33 * c23
            singular = s5 < FREE
            theta4 = q[3] if singular else np.arctan2(y, x)
            c4, s4 = (np.cos(theta4), np.sin(theta4)) if singular else (x / s5, y / s5)
            x11, x21 = c1 * T[0, 0] + s1 * T[1, 0], c1 * T[1, 0] - s1 * T[0, 0]
            s6 = -x21 * c4 - (x11 * c23 - T[2, 0] * s23) * s4
            c6 = ((x11 * c23 - T[2, 0] * s23) * c4 - x21 * s4) * c5 - (x11 * s23 + T[2, 0] * c23) * s5
            row = 4 * shoulder + 2 * elbow
            theta5, theta6 = np.arctan2(s5, c5), np.arctan2(s6, c6)
            theta[row, 0], theta[row, 1], theta[row, 2] = theta1, theta23 - theta3, theta3
            theta[row, 3], theta[row, 4], theta[row, 5] = theta4, theta5, theta6
            theta[row + 1, 0], theta[row + 1, 1], theta[row + 1, 2] = theta1, theta23 - theta3, theta3
            theta[row + 1, 3], theta[row + 1, 4], theta[row + 1, 5] = theta4 + np.pi, -theta5, theta6 + np.pi
            exists[row], exists[row + 1] = True, not singular
    return theta, exists


def joint_values(lengths: Array, frames: Array, shifts: Array, T_world_tool: Array, q: Array) -> Array:
    """The postures that exist for a tool pose (4, 4), m, as rows (k, 7): q (6,), rad, and the row of `postures`."""
    rows = empty((8, 7))
    return rows[: joint_values_into(lengths, frames, shifts, T_world_tool, q, rows)]


@kernel
def joint_values_into(lengths: Array, frames: Array, shifts: Array, T_world_tool: Array, q: Array, rows: Array) -> int:
    """Write the rows of `joint_values` into rows (8, 7); returns how many there are."""
    theta, exists = postures(lengths, framed(frames[0], T_world_tool, frames[1]), q + shifts)
    k = 0
    for row in range(8):
        if exists[row]:
            for joint in range(6):
                rows[k, joint] = theta[row, joint] - shifts[joint]
            rows[k, 6] = row
            k += 1
    return k


def beyond(lengths: Array, p: Array) -> float:
    """How far the wrist centre (3,), m, lies from where the arm brings it, m: a shell without a tube about the waist.

    √(px² + py²) ≥ |d₃| and |a₂ − ρ| ≤ √(|p|² − d₃²) ≤ a₂ + ρ with ρ² = a₃² + d₄². Source: Campos 1998, s.55 (ranges).
    """
    tube = abs(float(lengths[2]))
    inner, outer = wrist_range(lengths)
    out, up = hypot(p[0], p[1]), abs(p[2])
    size = hypot(out, up)
    onto = min(max(size, hypot(inner, tube)), hypot(outer, tube)) / size if size else 0.0
    if onto * out < tube or not size:
        return hypot(out - tube, up - min(max(up, inner), outer))
    return abs(onto - 1) * size


def wrist_range(lengths: Array) -> tuple[float, float]:
    """Least and largest distance of the wrist centre from the shoulder in the plane of the arm: |a₂ − ρ|, a₂ + ρ, m."""
    a2, rho = float(lengths[0]), hypot(lengths[1], lengths[3])
    return abs(a2 - rho), a2 + rho
