"""The Movemaster and its kin in the plane of the arm, and all their postures: a kernel.

What lies in that plane is a complex number ζ = x − i z there: a turn by θ about y multiplies it by e^(iθ).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import atan2, cos, pi, sin
from typing import Any

import numpy as np

from helicoide.ik.families.elbow import EDGE, Annulus
from helicoide.ik.families.pointing import into_plane
from helicoide.ik.families.turret import Turret, normal_of, turret
from helicoide.ik.families.two_links import bent, elbows, two_links
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain
from helicoide.kinematics.robot import Robot

NO_LINK = 1e-9

# The arm at q = 0 as the kernel takes it. Seen from the base: the tool (4, 4), m, and the last axis; links in the plane
# of the arm, m; signs: ±1, the joints 2, 3 and 4 against the y of the base; hand: the last axis in the tool.
SIDE = np.dtype(
    [
        ("T_base_world", "f8", (4, 4)),
        ("home", "f8", (3, 3)),
        ("hand", "f8", 3),
        ("pointing", "f8", 3),
        ("signs", "f8", 3),
        ("shoulder", "c16"),
        ("l1", "c16"),
        ("l2", "c16"),
        ("l3", "c16"),
        ("over", "f8"),
    ],
    align=True,
)
# Columns of a posture behind its q: the waist turned back, the sign of the bend.
BACK, BEND = 5, 6


@dataclass(frozen=True, eq=False)
class Side:
    """Such an arm: its turret and, in an array (1,) of SIDE, the rest."""

    turret: Turret
    packed: Chain

    @property
    def links(self) -> Annulus:
        """The upper arm and the forearm."""
        return Annulus(abs(self.packed[0]["l1"]), abs(self.packed[0]["l2"]))


@lru_cache(maxsize=64)
def side_of(robot: Robot) -> Side | None:
    """The robot as such an arm, or None."""
    if (arm := turret(robot)) is None:
        return None
    R, tool = arm.T_world_base[:3, :3], robot.T_world_tool_0
    points = np.array([*robot.points[1:4], tool[:3, 3]]) - arm.T_world_base[:3, 3]
    shoulder, elbow_0, wrist, tip = points @ R[:, 0] - 1j * points @ R[:, 2]
    if min(abs(elbow_0 - shoulder), abs(wrist - elbow_0)) < NO_LINK:
        return None
    packed = np.zeros(1, SIDE)
    packed["T_base_world"], packed["home"] = np.linalg.inv(arm.T_world_base), R.T @ tool[:3, :3]
    packed["hand"], packed["pointing"] = arm.hand, R.T @ robot.directions[4]
    packed["signs"] = np.sign(robot.directions[1:4] @ R[:, 1])
    packed["shoulder"], packed["l1"], packed["l2"] = shoulder, elbow_0 - shoulder, wrist - elbow_0
    packed["l3"], packed["over"] = tip - wrist, arm.over
    return Side(arm, packed)


@kernel
def seen(arm: Any, T: Array, theta1: float) -> tuple[complex, float, complex]:
    """ζ_P, m, of the tool (4, 4) of the base in the plane of θ₁; α, how far its hand is turned there; and ζ_W, m."""
    c, s, hand, pointing = cos(theta1), sin(theta1), arm["hand"], arm["pointing"]
    x, y, z = T[0], T[1], T[2]
    zeta = c * x[3] + s * y[3] - 1j * z[3]
    there = 0j
    for k in range(3):
        there += hand[k] * (c * x[k] + s * y[k] - 1j * z[k])
    turn = there / (pointing[0] - 1j * pointing[2])
    alpha = atan2(turn.imag, turn.real)
    return zeta, alpha, zeta - arm["l3"] * (cos(alpha) + 1j * sin(alpha)) - arm["shoulder"]


@kernel
def roll(arm: Any, T: Array, theta1: float, alpha: float) -> float:
    """θ₅ of R_ẑ(θ₅) = R_y(α)ᵀ R_z(θ₁)ᵀ R R₀ᵀ: from the part of the turn about ẑ and its trace."""
    c, s, ca, sa, home, axis = cos(theta1), sin(theta1), cos(alpha), sin(alpha), arm["home"], arm["pointing"]
    turn = np.empty((3, 3))
    for j in range(3):
        x = T[0, 0] * home[j, 0] + T[0, 1] * home[j, 1] + T[0, 2] * home[j, 2]
        y = T[1, 0] * home[j, 0] + T[1, 1] * home[j, 1] + T[1, 2] * home[j, 2]
        z = T[2, 0] * home[j, 0] + T[2, 1] * home[j, 1] + T[2, 2] * home[j, 2]
        x, y = c * x + s * y, c * y - s * x
        turn[0, j], turn[1, j], turn[2, j] = ca * x - sa * z, y, sa * x + ca * z
    sine = axis[0] * (turn[2, 1] - turn[1, 2]) + axis[1] * (turn[0, 2] - turn[2, 0])
    sine += axis[2] * (turn[1, 0] - turn[0, 1])
    return atan2(sine, turn[0, 0] + turn[1, 1] + turn[2, 2] - 1.0)


@kernel
def joint_values(arms: Chain, T_world_tool: Array, q: Array) -> tuple[Array, Array, Array]:
    """Every posture for a tool pose (4, 4), m, whose hand is first turned into the plane of the arm.

    Args: arms (1,) of SIDE; q (5,), rad: where θ₁ or θ₂ is free, it is kept. Returns rows (k, 7): q, rad, whether the
    waist is turned back and the sign of the bend; what was solved for, (4, 4), m; and in one array the turn to there,
    rad, and 1 where θ₁ and θ₂ are free.
    """
    arm, goal = arms[0], T_world_tool.copy()
    T = np.zeros((4, 4))
    base, hand, signs, two = arm["T_base_world"], arm["hand"].copy(), arm["signs"], two_links(arm["l1"], arm["l2"])
    for i in range(3):
        for j in range(4):
            for k in range(4):
                T[i, j] += base[i, k] * T_world_tool[k, j]
    M, _ = normal_of(T, hand, arm["over"], q[0])
    _, _, cosine, sine, R = into_plane(T, hand, M)
    for i in range(3):
        for j in range(3):
            T[i, j] = R[i, j]
            goal[i, j] = base[0, i] * R[0, j] + base[1, i] * R[1, j] + base[2, i] * R[2, j]
    turned = abs(atan2(sine, cosine))
    M, over = normal_of(T, hand, arm["over"], q[0])
    rows, k, folded = np.empty((4, 7)), 0, False
    for back in range(2):
        theta1 = atan2(-M[0], M[1]) + back * pi
        _, alpha, wrist = seen(arm, T, theta1)
        count, cosine, centred = elbows(wrist, two, EDGE)
        folded = folded or centred
        theta5 = roll(arm, T, theta1, alpha)
        for elbow_of in range(count):
            bend = 1.0 - 2.0 * elbow_of
            theta2, theta3 = bent(wrist, two, cosine, bend)
            theta2 = signs[0] * q[1] if centred else theta2
            row = rows[k]
            row[0], row[1], row[2] = theta1, signs[0] * theta2, signs[1] * theta3
            row[3], row[4], row[BACK], row[BEND] = signs[2] * (alpha - theta2 - theta3), theta5, back, bend
            k += 1
    return rows[:k], goal, np.array([turned, over, folded])
