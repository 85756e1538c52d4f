"""Arms like the Movemaster in the plane of the arm, and all their postures: kernels.

A vector in that plane is a complex number ζ = x − i z: a rotation by θ about y multiplies it by e^(iθ).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import atan2, cos, pi, sin

import numpy as np
from numpy import empty

from helicoide.arrays import Array
from helicoide.ik.families.elbow import EDGE, Annulus
from helicoide.ik.families.frames import Tool, first_four, pose_rows
from helicoide.ik.families.pointing import into_plane
from helicoide.ik.families.turret import Turret, normal_of, turret
from helicoide.ik.families.two_links import bent, elbows, two_links
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import Rows, Triple, dot, tool_row

# Links are longer than this, m; a rotation with a smaller sine is rounding.
NO_LINK, STILL = 1e-9, 1e-15

# Rows of the packed arm: three of T_base_world, m, and three of the tool rotation at q = 0 in the base; the last axis
# in the tool, and in the base at q = 0; ±1, the senses of axes 2, 3 and 4 along y of the base, and the distance from
# the first axis below which the tool is over it, m; complex numbers, m, in the plane of the arm: to the shoulder, and
# from the wrist to the tool; upper arm and forearm as `TwoLinks`.
BASE, HOME, HAND, POINTING, SIGNS, ENDS, LINKS, ROWS = 0, 3, 6, 7, 8, 9, 10, 11
OVER, TO_TOOL = 3, 2
# Columns of a posture after its q: whether the waist is turned back, and the sign of the bend.
BACK, BEND = 5, 6
# Columns of row NOTED after the postures: the rotation into the plane, rad, and whether θ₁ and θ₂ are free.
TURNED, FREE_WAIST, FREE_SHOULDER, NOTED = 0, 1, 2, 4


@dataclass(frozen=True, eq=False)
class Side:
    """An arm like the Movemaster: its turret, and its packed table (11, 4), with the rows above."""

    turret: Turret
    packed: Array

    @property
    def links(self) -> Annulus:
        """The upper arm and the forearm."""
        return Annulus(*self.packed[LINKS, :2].tolist())


@lru_cache(maxsize=64)
def side_of(robot: Robot) -> Side | None:
    """The robot as a `Side`, or None."""
    if (arm := turret(robot)) is None:
        return None
    R, tool = arm.T_world_base[:3, :3], robot.T_world_tool_0
    points = np.array([*robot.points[1:4], tool[:3, 3]]) - arm.T_world_base[:3, 3]
    shoulder, elbow_0, wrist, tip = (points @ R[:, 0] - 1j * points @ R[:, 2]).tolist()
    if min(abs(elbow_0 - shoulder), abs(wrist - elbow_0)) < NO_LINK:
        return None
    packed = np.zeros((ROWS, 4))
    packed[BASE:HOME], packed[HOME:HAND, :3] = np.linalg.inv(arm.T_world_base)[:3], R.T @ tool[:3, :3]
    packed[HAND, :3], packed[POINTING, :3] = arm.hand, R.T @ robot.directions[4]
    packed[SIGNS] = *np.sign(robot.directions[1:4] @ R[:, 1]), arm.over
    packed[ENDS] = shoulder.real, shoulder.imag, (tip - wrist).real, (tip - wrist).imag
    packed[LINKS] = two_links(elbow_0 - shoulder, wrist - elbow_0)
    return Side(arm, packed)


@kernel_into
def three(a: Array) -> Triple:
    """The first three numbers of a row."""
    return a[0], a[1], a[2]


@kernel_into
def seen(arm: Array, tool: Tool, theta1: float) -> tuple[complex, float, complex]:
    """A tool, given in the base, in the plane of θ₁: ζ_P, m; the rotation α of its hand from q = 0, rad; and ζ_W, m.

    ζ_P is the tool point from the base, ζ_W the wrist from the shoulder.
    """
    (x, y, z), c, s = tool, cos(theta1), sin(theta1)
    hand, ends = three(arm[HAND]), arm[ENDS]
    zeta = c * x[3] + s * y[3] - 1j * z[3]
    there = c * dot(x, hand) + s * dot(y, hand) - 1j * dot(z, hand)
    turn = there / (arm[POINTING, 0] - 1j * arm[POINTING, 2])
    alpha = atan2(turn.imag, turn.real)
    to_tool, shoulder = complex(ends[TO_TOOL], ends[TO_TOOL + 1]), complex(ends[0], ends[1])
    return zeta, alpha, zeta - to_tool * (cos(alpha) + 1j * sin(alpha)) - shoulder


@kernel_into
def roll(arm: Array, tool: Tool, theta1: float, alpha: float) -> float:
    """θ₅, rad, of R_ẑ(θ₅) = R_y(α)ᵀ R_z(θ₁)ᵀ R R₀ᵀ: from the antisymmetric part along ẑ and the trace."""
    c, s, ca, sa, axis = cos(theta1), sin(theta1), cos(alpha), sin(alpha), three(arm[POINTING])
    x, y, z = turn_of(arm, tool)
    x, y = mixed(x, c, y, s), mixed(y, c, x, -s)
    x, z = mixed(x, ca, z, -sa), mixed(x, sa, z, ca)
    sine = axis[0] * (z[1] - y[2]) + axis[1] * (x[2] - z[0]) + axis[2] * (y[0] - x[1])
    return atan2(sine, x[0] + y[1] + z[2] - 1.0)


@kernel_into
def turn_of(arm: Array, tool: Tool) -> Rows:
    """R R₀ᵀ: the rotation of the tool from its orientation at q = 0."""
    (x, y, z), a, b, c = tool, three(arm[HOME]), three(arm[HOME + 1]), three(arm[HOME + 2])
    return (
        (dot(x, a), dot(x, b), dot(x, c)),
        (dot(y, a), dot(y, b), dot(y, c)),
        (dot(z, a), dot(z, b), dot(z, c)),
    )


@kernel_into
def mixed(a: Triple, c: float, b: Triple, s: float) -> Triple:
    """c a + s b."""
    return c * a[0] + s * b[0], c * a[1] + s * b[1], c * a[2] + s * b[2]


def movemaster_joint_values(arm: Array, T_world_tool: Array, q: Array) -> tuple[Array, Array, Array]:
    """Every posture for a tool pose (4, 4), m, whose hand is first rotated into the plane of the arm.

    Args: arm: `Side.packed`; q (5,), rad: where θ₁ or θ₂ is free, it is kept. Returns rows (k, 7): q, rad, whether the
    waist is turned back and the sign of the bend; the pose solved for, (4, 4), m; and the row NOTED.
    """
    rows, goal = empty((NOTED + 1, 7)), T_world_tool.copy()
    return rows[: movemaster_joint_values_into(arm, T_world_tool, q, rows, goal)], goal, rows[NOTED]


@kernel_into
def movemaster_joint_values_into(arm: Array, T_world_tool: Array, q: Array, rows: Array, goal: Array) -> int:
    """Write the results of `movemaster_joint_values` into rows (5, 7), the last NOTED, and goal; returns the number."""
    x, y, z = pose_rows(arm[BASE:])
    world = pose_rows(T_world_tool)
    tool = tool_row(x, world), tool_row(y, world), tool_row(z, world)
    hand, two, signs, noted, k = three(arm[HAND]), first_four(arm[LINKS]), arm[SIGNS], rows[NOTED], 0
    M, _ = normal_of(tool, hand, signs[OVER], q[0])
    _, _, cosine, sine, tool = into_plane(tool, hand, M)
    for i in range(3 if abs(sine) > STILL else 0):
        for j in range(3):
            goal[i, j] = x[i] * tool[0][j] + y[i] * tool[1][j] + z[i] * tool[2][j]
    M, over = normal_of(tool, hand, signs[OVER], q[0])
    noted[TURNED], noted[FREE_WAIST], noted[FREE_SHOULDER] = abs(atan2(sine, cosine)), over, 0.0
    for back in range(2):
        theta1 = atan2(-M[0], M[1]) + back * pi
        _, alpha, wrist = seen(arm, tool, theta1)
        count, cosine, centred = elbows(wrist, two, EDGE)
        noted[FREE_SHOULDER] = max(noted[FREE_SHOULDER], centred)
        middle, aside, fold = bent(wrist, two, cosine)
        theta5 = roll(arm, tool, theta1, alpha) if count else 0.0
        for elbow_of in range(count):
            bend = 1.0 - 2.0 * elbow_of
            theta2 = signs[0] * q[1] if centred else middle - bend * aside
            theta3, row = bend * fold - two[3], rows[k]
            row[0], row[1], row[2] = theta1, signs[0] * theta2, signs[1] * theta3
            row[3], row[4], row[BACK], row[BEND] = signs[2] * (alpha - theta2 - theta3), theta5, back, bend
            k += 1
    return k
