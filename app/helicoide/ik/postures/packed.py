"""An arm packed for the search of its postures: one table of numbers.

One array is passed to a kernel in a tenth of the time of many arguments. Lengths are divided by the reach ℓ. Every
joint frame has z along the axis: its rotation then changes two columns instead of three.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot

# The first rows; from FIRST on the joints, then the variables.
SETTING, BASE, HAND, FIRST = range(4)
# Columns of the setting: the numbers of joints and variables; ℓ, m; the weight of orientation, for lengths divided by
# ℓ; the largest accepted errors, m and rad; the largest numbers of steps in a search and of searches.
JOINTS, VARIABLES, REACH, TURNING, WITHIN, WITHIN_TURN, STEPS, SEARCHES = range(8)
# Columns of the base and of the hand: a rotation row by row, of the base in the first frame and of the tool in the last
# one; of the hand then the position of the tool there, divided by ℓ.
PLACE = 9
# Columns of a joint: its offset and the twist α of its axis, cos and sin, in the frame before; the number of its
# variable q; its angle is TURN q + TURN_SHIFT, its slide SLIDE q + SLIDE_SHIFT, divided by ℓ; TURNS and SLIDES are
# their changes for one unit of the variable.
WAY, TILT, DRIVER, TURN, TURN_SHIFT, SLIDE, SLIDE_SHIFT, TURNS, SLIDES = 0, 3, 5, 6, 7, 8, 9, 10, 11
# Columns of a variable: its limits; its period, 2π, or 0 without one; whether a search keeps its limits; its `strides`;
# and its unit, 1 for angles, ℓ for slides.
LOWER, UPPER, PERIOD, HELD, STRIDE, UNIT = range(6)
WIDTH = 12
# The length of a row of angles is a multiple of this, for vector instructions in their cosines and sines.
LANES = 8
PARALLEL = 1e-15  # below this sine two axes have no common normal


class Search(NamedTuple):
    """A table (3 + m + n, 12) with the rows and columns above, and the shapes of the arrays `answer` and `room`."""

    table: Array
    answer: int
    buffers: tuple[int, int]


@kernel_into
def behind_joints(table: Array) -> int:
    """The first row of the variables."""
    return FIRST + int(table[SETTING, JOINTS])


def search_of(
    robot: Robot, ranges: Array, turning: float, within: tuple[float, float], steps: int, searches: int
) -> Search:
    """A robot packed for a search. Args: ranges (n, 6) of `limited`; the others are those of the setting."""
    m, n = len(robot.joints), len(robot.variables)
    table, frames = np.zeros((FIRST + m + n, WIDTH)), _frames(robot)
    table[SETTING, : SEARCHES + 1] = m, n, robot.reach, turning, *within, steps, searches
    table[BASE, :PLACE] = frames[0].T.ravel()
    table[HAND, :PLACE] = (frames[-1].T @ robot.T_world_tool_0[:3, :3]).ravel()
    table[HAND, PLACE:] = frames[-1].T @ (robot.T_world_tool_0[:3, 3] - robot.points[-1]) / robot.reach
    _write_joints(robot, frames, ranges[:, UNIT], table[FIRST : FIRST + m])
    table[FIRST + m :, : UNIT + 1] = ranges
    return Search(table, n + 4, buffer_sizes(m, n))


def buffer_sizes(m: int, n: int) -> tuple[int, int]:
    """The shape of `room`: three rows for the angles of m joints, and a row for each of n variables."""
    return 3 + n, -(-m // LANES) * LANES


def limited(robot: Robot) -> Array:
    """The variables of a robot, (n, 6); limits are kept unless the joint is periodic and its range is a full turn."""
    n, turns = len(robot.variables), robot.periodic
    ranges = np.empty((n, UNIT + 1))
    ranges[:, LOWER], ranges[:, UPPER] = robot.lower, robot.upper
    ranges[:, PERIOD] = np.where(turns, 2 * np.pi, 0.0)
    ranges[:, HELD] = ~turns | (robot.upper - robot.lower < 2 * np.pi)
    ranges[:, STRIDE] = strides(n)
    ranges[:, UNIT] = [robot.reach if joint.is_prismatic else 1.0 for joint in robot.variables]
    return ranges


def wide(robot: Robot) -> Array:
    """The variables without limits, (n, 6): a periodic joint is searched over a full turn, and no limits are kept."""
    ranges, turns = limited(robot), robot.periodic
    ranges[turns, LOWER], ranges[turns, UPPER], ranges[:, HELD] = -np.pi, np.pi, 0.0
    return ranges


def strides(n: int) -> Array:
    """The increments of n joints between draws, in fractions of their ranges: φ⁻¹, φ⁻², …, with φⁿ⁺¹ = φ + 1.

    Source: Roberts 2018, The unreasonable effectiveness of quasirandom sequences.
    """
    phi = 2.0
    for _ in range(60):
        phi = (1.0 + phi) ** (1.0 / (n + 1))
    return phi ** -np.arange(1.0, n + 1)


def _frames(robot: Robot) -> Array:
    """The frames of the base and of each joint at q = 0, (m + 1, 3, 3): z along the axis, x normal to it and the next.

    x is computed from the difference of the two axes, which is accurate also where they are nearly parallel.
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
    """Write the rows of the joints: Tr(way) Rx(α) Rz(θ) Tr(x z) takes one frame to the next."""
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
