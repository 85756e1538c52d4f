"""An arm as searches for its postures take it: one table of numbers.

A kernel takes one array in a tenth of the time of many arguments. Lengths are counted in the reach ℓ, and every joint
has frames with z along its axis: a turn then mixes two columns, where one about any axis mixes three.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot

# The first rows; from FIRST on the joints, then the variables.
SETTING, BASE, HAND, FIRST = range(4)
# Of the setting: how many joints and variables; ℓ, m; the weight of orientation, for lengths in ℓ; what may be left,
# m and rad; how many steps a search may take, and how many searches there may be.
JOINTS, VARIABLES, REACH, TURNING, WITHIN, WITHIN_TURN, STEPS, SEARCHES = range(8)
# Of the base and of the hand: a rotation row by row, of the base in the first frame and of the tool in the last one; of
# the hand then the place of the tool there, in ℓ.
PLACE = 9
# Of a joint: the way to it and the twist α of its axis, cos and sin, seen from the frame before; the number of the
# variable q that drives it, where it turns by TURN q + TURN_SHIFT and slides by SLIDE q + SLIDE_SHIFT, in ℓ; and by
# how much for a change of that variable by its own unit.
WAY, TILT, DRIVER, TURN, TURN_SHIFT, SLIDE, SLIDE_SHIFT, TURNS, SLIDES = 0, 3, 5, 6, 7, 8, 9, 10, 11
# Of a variable: its limits; after how much it stands alike, 2π or 0 for never; whether its limits hold it during a
# search; by how much draws differ; and its own unit, 1 for angles, ℓ for slides.
LOWER, UPPER, PERIOD, HELD, STRIDE, UNIT = range(6)
WIDTH = 12
# Angles stand in rows of so many, that their cosines and sines be vector instructions.
LANES = 8
PARALLEL = 1e-15  # the sine of two axes that have no common normal


class Search(NamedTuple):
    """A table (3 + m + n, 12) as this file says, and the shapes of what a search writes: its answer, and its room."""

    table: Array
    answer: int
    room: tuple[int, int]


@kernel_into
def behind_joints(table: Array) -> int:
    """The row where the variables begin."""
    return FIRST + int(table[SETTING, JOINTS])


def search_of(
    robot: Robot, ranges: Array, turning: float, within: tuple[float, float], steps: int, searches: int
) -> Search:
    """A robot as a search takes it. Args: ranges (n, 6) of `limited`; the others as the setting has them."""
    m, n = len(robot.joints), len(robot.variables)
    table, frames = np.zeros((FIRST + m + n, WIDTH)), _frames(robot)
    table[SETTING, : SEARCHES + 1] = m, n, robot.reach, turning, *within, steps, searches
    table[BASE, :PLACE] = frames[0].T.ravel()
    table[HAND, :PLACE] = (frames[-1].T @ robot.T_world_tool_0[:3, :3]).ravel()
    table[HAND, PLACE:] = frames[-1].T @ (robot.T_world_tool_0[:3, 3] - robot.points[-1]) / robot.reach
    _write_joints(robot, frames, ranges[:, UNIT], table[FIRST : FIRST + m])
    table[FIRST + m :, : UNIT + 1] = ranges
    return Search(table, n + 4, room_for(m, n))


def room_for(m: int, n: int) -> tuple[int, int]:
    """The shape of the room of a search: three rows for the angles of m joints, and a row for each of n variables."""
    return 3 + n, -(-m // LANES) * LANES


def limited(robot: Robot) -> Array:
    """The variables of a robot with their limits, which hold them where they are not whole turns: (n, 6)."""
    n, turns = len(robot.variables), robot.periodic
    ranges = np.empty((n, UNIT + 1))
    ranges[:, LOWER], ranges[:, UPPER] = robot.lower, robot.upper
    ranges[:, PERIOD] = np.where(turns, 2 * np.pi, 0.0)
    ranges[:, HELD] = ~turns | (robot.upper - robot.lower < 2 * np.pi)
    ranges[:, STRIDE] = strides(n)
    ranges[:, UNIT] = [robot.reach if joint.is_prismatic else 1.0 for joint in robot.variables]
    return ranges


def wide(robot: Robot) -> Array:
    """The same without limits: a joint that turns is searched over a full turn, and none is held."""
    ranges, turns = limited(robot), robot.periodic
    ranges[turns, LOWER], ranges[turns, UPPER], ranges[:, HELD] = -np.pi, np.pi, 0.0
    return ranges


def strides(n: int) -> Array:
    """By how much the shares of n joints differ from one draw to the next: φ⁻¹, φ⁻², …, with φⁿ⁺¹ = φ + 1.

    Source: Roberts 2018, The unreasonable effectiveness of quasirandom sequences.
    """
    phi = 2.0
    for _ in range(60):
        phi = (1.0 + phi) ** (1.0 / (n + 1))
    return phi ** -np.arange(1.0, n + 1)


def _frames(robot: Robot) -> Array:
    """The frames of the base and of each joint at q = 0, (m + 1, 3, 3): z along the axis, x across it and the next.

    The common normal is that of an axis and of what the next one differs by, which rounding does not spoil where they
    are nearly parallel.
    """
    axes, frames = np.array([[0.0, 0.0, 1.0], *robot.directions]), []
    for z, following in zip(axes, [*axes[1:], axes[-1]], strict=True):
        x = np.cross(z, following - (z if z @ following > 0 else -z))
        if np.linalg.norm(x) < PARALLEL:
            x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
        x /= np.linalg.norm(x)
        frames.append(np.column_stack([x, np.cross(z, x), z]))
    return np.array(frames)


def _write_joints(robot: Robot, frames: Array, units: Array, rows: Array) -> None:
    """Write the rows of the joints: Tr(way) Rx(α) Rz(θ) Tr(x z) leads from one frame to the next."""
    chain, turns = robot.chain, ~robot.chain["slides"]
    for row, offset, before, here in zip(rows, chain["offset"], frames, frames[1:], strict=False):
        x, y, z = before.T
        row[WAY:TILT] = before.T @ offset / robot.reach
        row[TILT : TILT + 2] = z @ here[:, 2], -y @ here[:, 2]
        row[TURN_SHIFT] = np.arctan2(np.cross(x, here[:, 0]) @ here[:, 2], x @ here[:, 0])
    rows[:, DRIVER], unit = chain["driver"], units[chain["driver"]]
    rows[:, TURN], rows[:, SLIDE] = turns * chain["ratio"], ~turns * chain["ratio"] / robot.reach
    rows[:, TURN_SHIFT] += turns * chain["shift"]
    rows[:, SLIDE_SHIFT] = ~turns * chain["shift"] / robot.reach
    rows[:, TURNS], rows[:, SLIDES] = unit * rows[:, TURN], unit * rows[:, SLIDE]
