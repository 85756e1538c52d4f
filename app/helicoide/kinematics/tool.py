"""The tool's pose and Jacobian in one call, for one posture or many: kernels for scripts, which the page leaves alone.

Each takes the arm as the one array of `packed`. Those named `_into` write into an array of the caller's: as each array
that goes in costs as much as half the mathematics, and one that comes out more than all of it, they are for loops.
A frame is held as three rows (R, p) of four numbers, which stay in registers; of many postures `BLOCK` are taken at a
time, and each of the twelve numbers then stands in a row of its own, which the compiler turns into vector instructions.
"""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array
from helicoide.kinematics.robot import Robot

Triple = tuple[float, float, float]
Row = tuple[float, float, float, float]

# Columns of a joint: its axis (three), the way from the axis point before (three), the variable q that drives it, and
# the two motions along its axis, a turn by θ = TURN q + TURN_SHIFT and a slide by x = SLIDE q + SLIDE_SHIFT.
AXIS, WAY, DRIVER, TURN, TURN_SHIFT, SLIDE, SLIDE_SHIFT = 0, 3, 6, 7, 8, 9, 10
COLUMNS = 12  # as many as the rows (R, p) of the tool, which stand in the last row
BLOCK = 64

# π/2 in three parts; j times one of the first two has no rounding error for |j| < 2²⁰. Source: fdlibm, e_rem_pio2.c.
HALF_PI = (1.57079632673412561417, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
# A sum with it has no binary places left: the nearest whole number stands in its last bits.
TO_WHOLE = 1.5 * 2.0**52


def packed(robot: Robot) -> Array:
    """An arm as the kernels here take it: m joints and the tool on the last link, (m + 1, 12), base frame, rad and m.

    It is not read-only as other arrays are: Numba takes twice as long to recognise one that is.
    """
    chain, arm = robot.chain, np.zeros((len(robot.joints) + 1, COLUMNS))
    joints, turns = arm[:-1], ~chain["slides"]
    joints[:, AXIS : AXIS + 3], joints[:, WAY : WAY + 3] = chain["direction"], chain["offset"]
    joints[:, DRIVER] = chain["driver"]
    joints[:, TURN], joints[:, TURN_SHIFT] = turns * chain["ratio"], turns * chain["shift"]
    joints[:, SLIDE], joints[:, SLIDE_SHIFT] = ~turns * chain["ratio"], ~turns * chain["shift"]
    arm[-1] = robot.T_link_tool[:3].ravel()
    return arm


@kernel
def cosine_and_sine(x: float) -> tuple[float, float]:
    """cos x and sin x without a branch: x = j π/2 + r, |r| ≤ π/4, and minimax polynomials of r.

    Args: x, rad, |x| < 10⁶; the error is below 2 units in the last place. Source: fdlibm, k_sin.c and k_cos.c (Sun
    Microsystems 1993), for the polynomials; Cody and Waite 1980, ch. 8, for the reduction.
    """
    j = (x * (2 / np.pi) + TO_WHOLE) - TO_WHOLE
    r = ((x - j * HALF_PI[0]) - j * HALF_PI[1]) - j * HALF_PI[2]
    z = r * r
    s = 2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
    s = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * s)
    s = r + r * z * (-1.66666666666666324348e-01 + z * s)
    c = -2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)
    c = z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * c)))
    w = 1.0 - 0.5 * z
    c = w + (((1.0 - w) - 0.5 * z) + z * c)
    quadrant = j - 4.0 * ((0.25 * j + TO_WHOLE) - TO_WHOLE)  # -2 to 2; -2 and 2 are one
    odd = quadrant * quadrant == 1.0
    cosine, sine = (s, c) if odd else (c, s)
    return (
        -cosine if quadrant * (quadrant - 1.0) == 0.0 else cosine,
        sine,
    )
