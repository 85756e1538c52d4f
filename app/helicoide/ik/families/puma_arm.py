"""Arms with the DH rows of the PUMA: their lengths, their workspace, and all their postures: kernels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import atan2, hypot, pi, sqrt

import numpy as np
from numpy import empty

from helicoide.arrays import Array, frozen
from helicoide.ik.families.frames import Tool, framed
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import Triple
from helicoide.kinematics.trigonometry import cosine_and_sine

# The fixed values of the modified rows: α, and which of a and d may differ from zero.
TWISTS = (0.0, -pi / 2, 0.0, -pi / 2, pi / 2, -pi / 2)
LENGTHS = ((False, False), (False, False), (True, True), (True, True), (False, False), (False, False))
SAME = 1e-9
# By how much a radicand may be negative, m²; the angle, rad, below which two postures are equal; sines and lengths, m,
# that count as zero.
ROUNDING, MERGED, FREE = 1e-12, 1e-6, 1e-10


# Rows of the packed arm: a₂, a₃, d₃ and d₄, m; θ at q = 0, rad; three of T_dh_world and three of T_tool_dh, m.
LENGTHS_OF, SHIFTS, WORLD, TOOL, ROWS = 0, 1, 2, 5, 8
NUMBER = 6  # column of a posture after its q: which of the eight it is


@dataclass(frozen=True, eq=False)
class Puma:
    """An arm with the rows of the PUMA.

    lengths: a₂, a₃, d₃ and d₄ (4,), m; frames (2, 4, 4): T_dh_world and T_tool_dh, m; shifts (6,): θ at q = 0, rad;
    packed (8, 6): all of it, with the rows above.
    """

    lengths: Array
    frames: Array
    shifts: Array
    packed: Array


@lru_cache(maxsize=64)
def puma(robot: Robot) -> Puma | None:
    """The robot as a `Puma`, or None: the modified rows of the PUMA with any a₂ > 0, a₃, d₃ and d₄."""
    rows = robot.dh.rows
    fits = (
        robot.dh.convention == "modified"
        and len(rows) == len(TWISTS)
        and all(abs(row.alpha - twist) < SAME for row, twist in zip(rows, TWISTS, strict=True))
        and all(
            (a or abs(row.a) < SAME) and (d or abs(row.d) < SAME) for row, (a, d) in zip(rows, LENGTHS, strict=True)
        )
        and rows[2].a > SAME
        and not any(joint.is_prismatic or joint.mimic for joint in robot.joints)
    )
    if not fits:
        return None
    frames = np.linalg.inv(np.array([robot.dh.T_world_dh, robot.dh.T_dh_tool]))
    packed = np.zeros((ROWS, 6))
    packed[LENGTHS_OF, :4], packed[SHIFTS] = lengths_of(robot), [row.theta for row in rows]
    packed[WORLD:TOOL, :4], packed[TOOL:, :4] = frames[:, :3]
    return Puma(lengths_of(robot), frozen(frames), frozen(packed[SHIFTS]), packed)


def lengths_of(robot: Robot) -> Array:
    """a₂, a₃, d₃, d₄, (4,), m, of the robot's rows."""
    upper, fore = robot.dh.rows[2:4]
    return frozen([upper.a, fore.a, upper.d, fore.d])


@kernel_into
def is_folded(side: float, pz: float, d3: float) -> bool:
    """Whether the wrist centre is on the shoulder axis, so that θ2 is free. Args: side: px² + py² − d₃², m²; pz, m."""
    return abs(pz) < FREE and side < FREE * (FREE + 2.0 * abs(d3))


@kernel_into
def puma_wrist_postures(lengths: Array, wrist: Tool, kept: Triple, rows: Array) -> int:
    """Write every θ, rad, and its number into rows (8, 7); returns how many there are.

    The order is shoulder +, −, for each elbow +, −, for each the wrist and its flip. Of equal postures only the first
    is written. Where θ1, θ2 or θ4 is free, it is the one of `kept`, rad; where θ4 is free, there is no flip.
    Args: lengths: a₂, a₃, d₃, d₄ (4,), m; wrist: DH frame 6 in the base of the rows, m.
    Source: Campos 1998, s.55, after Craig.
    """
    k, (a2, a3, d3, d4) = 0, (lengths[0], lengths[1], lengths[2], lengths[3])
    (r11, _, r13, px), (r21, _, r23, py), (r31, _, r33, pz) = wrist
    across, fore = px * px + py * py, a3 * a3 + d4 * d4
    K = (across + pz * pz - a2 * a2 - fore - d3 * d3) / (2 * a2)
    side, bend = across - d3 * d3, fore - K * K
    if side < -ROUNDING or bend < -ROUNDING:
        return 0
    folded = is_folded(side, pz, d3)
    side, bend = (0.0, 0.0) if folded else (sqrt(max(side, 0.0)), sqrt(max(bend, 0.0)))
    heading, slant = atan2(py, px), atan2(a3, d4)
    over = across < FREE * FREE
    shoulders = 2 if side > MERGED * abs(d3) and not over else 1
    elbows = 2 if bend > MERGED * abs(K) else 1
    for shoulder in range(shoulders):
        theta1 = kept[0] if over else heading - atan2(d3, side if shoulder == 0 else -side)
        c1, s1 = cosine_and_sine(theta1)
        u, along, beside = c1 * px + s1 * py, c1 * r13 + s1 * r23, c1 * r23 - s1 * r13
        x11, x21 = c1 * r11 + s1 * r21, c1 * r21 - s1 * r11
        for elbow in range(elbows):
            theta3 = slant - atan2(K, bend if elbow == 0 else -bend)
            c3, s3 = cosine_and_sine(theta3)
            y = (-a3 - a2 * c3) * pz - u * (d4 - a2 * s3)
            x = (a2 * s3 - d4) * pz + (a3 + a2 * c3) * u
            theta23 = kept[1] + theta3 if folded else atan2(y, x)
            c23, s23 = cosine_and_sine(theta23)
            y, x = beside, r33 * s23 - along * c23
            s5, c5 = sqrt(x * x + y * y), -along * s23 - r33 * c23
            singular = s5 < FREE
            theta4 = kept[2] if singular else atan2(y, x)
            c4, s4 = cosine_and_sine(theta4) if singular else (x / s5, y / s5)
            s6 = -x21 * c4 - (x11 * c23 - r31 * s23) * s4
            c6 = ((x11 * c23 - r31 * s23) * c4 - x21 * s4) * c5 - (x11 * s23 + r31 * c23) * s5
            theta5, theta6 = atan2(s5, c5), atan2(s6, c6)
            for flipped in range(1 if singular else 2):
                row = rows[k]
                row[0], row[1], row[2] = theta1, theta23 - theta3, theta3
                row[3], row[4], row[5] = theta4 + flipped * pi, theta5 * (1 - 2 * flipped), theta6 + flipped * pi
                row[NUMBER] = 4 * shoulder + 2 * elbow + flipped
                k += 1
    return k


def puma_joint_values(arm: Array, T_world_tool: Array, q: Array) -> Array:
    """Every posture for a tool pose (4, 4), m, as rows (k, 7): q (6,), rad, and its number as in `puma_wrist_postures`.

    Args: arm: `Puma.packed`; q (6,), rad: kept where a joint is free.
    """
    rows = empty((8, 7))
    return rows[: puma_joint_values_into(arm, T_world_tool, q, rows)]


@kernel_into
def puma_joint_values_into(arm: Array, T_world_tool: Array, q: Array, rows: Array) -> int:
    """Write the rows of `puma_joint_values` into rows (8, 7); returns their number."""
    shifts = arm[SHIFTS]
    kept = (q[0] + shifts[0], q[1] + shifts[1], q[3] + shifts[3])
    count = puma_wrist_postures(arm[LENGTHS_OF], framed(arm[WORLD:], T_world_tool, arm[TOOL:]), kept, rows)
    for row in range(count):
        for joint in range(6):
            rows[row, joint] -= shifts[joint]
    return count


def puma_distance_beyond(lengths: Array, p: Array) -> float:
    """The distance of a point (3,), m, from the workspace of the wrist centre, m: a shell outside a cylinder.

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
    """Smallest and largest distance of wrist centre and shoulder in the plane of the arm: |a₂ − ρ|, a₂ + ρ, m."""
    a2, rho = float(lengths[0]), hypot(lengths[1], lengths[3])
    return abs(a2 - rho), a2 + rho
