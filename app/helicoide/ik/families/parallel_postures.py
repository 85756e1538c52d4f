"""Every posture of an arm with three parallel axes, as in the UR family: kernels."""

from __future__ import annotations

from math import atan2, sqrt

from numpy import empty

from helicoide.arrays import Array
from helicoide.ik.families.frames import first_four
from helicoide.ik.families.parallel_arm import (
    AHEAD,
    AHEAD_TOOL,
    ALONG,
    ALONG_TOOL,
    ASIDE,
    CENTRE,
    FIFTH,
    FOOT,
    FOURTH,
    HAND,
    LINKS,
    POLISHER,
    SETTING,
    SHOULDER,
    SIXTH,
    THIRD,
    WAIST,
    ending,
)
from helicoide.ik.families.polish import FREE, ROUNDING, is_known, linear, polished
from helicoide.ik.families.two_links import bent, elbows
from helicoide.ik.postures.measure import stand_of
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import Triple, cross, dot
from helicoide.kinematics.trigonometry import cosine_and_sine

ACCEPTED = 1e-9  # the largest error of a posture, m and rad
SLACK = 1e-6  # how far beyond its edge, relative to the reach, an elbow is tried: axes may be only nearly parallel
# Columns of a posture after its q: whether the shoulder is to the left, the elbow up, the wrist flipped; and the free
# joints, as the sum of the three numbers below.
LEFT, UP, FLIPPED, LOOSE = range(6, 10)
FREE_WAIST, FREE_SHOULDER, FREE_WRIST = 1, 2, 4


@kernel_into
def triple(row: Array) -> Triple:
    """The first three numbers of a row."""
    return row[0], row[1], row[2]


@kernel_into
def rotated(axis: Triple, turn: tuple[float, float], v: Triple) -> Triple:
    """v rotated about a unit axis (Rodrigues). Args: turn: cosine and sine of the angle."""
    c, s = turn
    w = cross(axis, v)
    along = (1.0 - c) * dot(axis, v)
    return (
        c * v[0] + s * w[0] + along * axis[0],
        c * v[1] + s * w[1] + along * axis[1],
        c * v[2] + s * w[2] + along * axis[2],
    )


@kernel_into
def back(theta: float) -> tuple[float, float]:
    """Cosine and sine of −θ, rad."""
    c, s = cosine_and_sine(theta)
    return c, -s


@kernel_into
def out_of(T: Array, v: Triple) -> Triple:
    """R v, for the R of a pose (4, 4)."""
    return dot(triple(T[0]), v), dot(triple(T[1]), v), dot(triple(T[2]), v)


@kernel_into
def into(T: Array, v: Triple) -> Triple:
    """Rᵀ v, for the R of a pose (4, 4)."""
    return (
        T[0, 0] * v[0] + T[1, 0] * v[1] + T[2, 0] * v[2],
        T[0, 1] * v[0] + T[1, 1] * v[1] + T[2, 1] * v[2],
        T[0, 2] * v[0] + T[1, 2] * v[1] + T[2, 2] * v[2],
    )


@kernel_into
def centre_from_waist(arm: Array, T: Array) -> Triple:
    """v = T W − p₁, m: the point where axes 5 and 6 meet, from a point of the waist axis."""
    w, foot = out_of(T, triple(arm[CENTRE])), triple(arm[FOOT])
    return w[0] + T[0, 3] - foot[0], w[1] + T[1, 3] - foot[1], w[2] + T[2, 3] - foot[2]


@kernel_into
def waist_angles(arm: Array, v: Triple, kept: float) -> tuple[int, float, float]:
    """The number of θ₁ of h · R₁ᵀ v = h · (W − p₁), and both, rad.

    Joints 2 to 4 move W in a plane normal to h, which the waist rotates.
    """
    s, h, aside = triple(arm[WAIST]), triple(arm[ALONG]), arm[SETTING, ASIDE]
    lean, height = dot(s, h), dot(s, v)
    return linear(dot(h, v) - lean * height, dot(cross(s, h), v), aside - lean * height, kept)


@kernel_into
def fifth_angles(arm: Array, u: Triple) -> tuple[bool, float, float]:
    """Whether there is a θ₅ of h · R₅ ŝ₆ = ŝ₆ · u, and both, rad; u = Rᵀ R₁ h is h in the tool frame.

    The radicand is that of A cos θ + B sin θ = C, in a form without cancellation where ŝ₆ is nearly along h.
    """
    s5, s6, h = triple(arm[FIFTH]), triple(arm[SIXTH]), triple(arm[ALONG_TOOL])
    a, b, x, n = dot(s5, h), dot(s5, s6), dot(u, s6), cross(u, s6)
    radicand = dot(n, n) - a * a - b * b + 2 * a * b * x
    middle, aside = atan2(dot(h, cross(s5, s6)), dot(h, s6) - a * b), atan2(sqrt(max(radicand, 0.0)), x - a * b)
    return bool(radicand > -ROUNDING), middle + aside, middle - aside


@kernel_into
def sixth_angle(arm: Array, u: Triple, there: Triple, kept: float) -> tuple[float, bool]:
    """θ₆ of R₆ u = R₅ᵀ h, rad, and whether it is free and kept."""
    s6 = triple(arm[SIXTH])
    n = cross(s6, there)
    if dot(n, n) < FREE * FREE:
        return kept, True
    return atan2(dot(s6, cross(u, there)), dot(u, there) - dot(s6, u) * dot(s6, there)), False


@kernel_into
def parallel_axes_postures(arm: Array, T: Array, q: Array, rows: Array) -> int:
    """Write every posture for a tool pose (4, 4), m, into rows (8, 10): q, rad, and the columns above.

    Args: arm of `parallel_arm`; q (6,), rad: kept where a joint is free. Returns the number of postures.
    """
    k = 0
    s1, s5, s6, v = triple(arm[WAIST]), triple(arm[FIFTH]), triple(arm[SIXTH]), centre_from_waist(arm, T)
    shoulder, hand, two = ending(arm, SHOULDER), ending(arm, HAND), first_four(arm[LINKS])
    waists, first, second = waist_angles(arm, v, q[0])
    for waist in range(waists):
        theta1 = first if waist == 0 else second
        turn = cosine_and_sine(theta1)
        h, x = rotated(s1, turn, triple(arm[ALONG])), rotated(s1, turn, triple(arm[AHEAD]))
        y, u = cross(h, x), into(T, h)
        centre = dot(x, v) + 1j * dot(y, v)
        is_there, one, other = fifth_angles(arm, u)
        for flipped in range(2 if is_there else 0):
            theta5 = one if flipped == 0 else other
            turn = back(theta5)
            theta6, loose = sixth_angle(arm, u, rotated(s5, turn, triple(arm[ALONG_TOOL])), q[5])
            ahead = out_of(T, rotated(s6, back(theta6), rotated(s5, turn, triple(arm[AHEAD_TOOL]))))
            c, s = dot(x, ahead), dot(y, ahead)
            size, phi = sqrt(c * c + s * s), atan2(s, c)
            wrist = centre - shoulder - hand * ((c + 1j * s) / size)
            count, cosine, folded = elbows(wrist, two, SLACK)
            middle, aside, fold = bent(wrist, two, cosine)
            for elbow in range(count):
                bend = 1.0 - 2.0 * elbow
                theta2 = q[1] if folded else middle - bend * aside
                theta3 = bend * fold - two[3]
                row, setting = rows[k], arm[SETTING]
                row[0], row[1], row[2] = theta1, theta2, setting[THIRD] * theta3
                row[3], row[4], row[5] = setting[FOURTH] * (phi - theta2 - theta3), theta5, theta6
                row[LEFT] = (centre.real >= 0.0) == (setting[ASIDE] >= 0.0)
                row[UP], row[FLIPPED] = (bend > 0.0) == (wrist.real >= 0.0), flipped
                row[LOOSE] = FREE_WAIST * (waists == 1) + FREE_SHOULDER * folded + FREE_WRIST * loose
                k += 1
    return k


def parallel_joint_values(arm: Array, T_world_tool: Array, q: Array) -> Array:
    """The rows of `parallel_axes_postures`, polished and verified, each once. Args as there."""
    rows = empty((9, 10))
    return rows[: verify(arm, T_world_tool, q, rows)]


@kernel_into
def verify(arm: Array, T_world_tool: Array, q: Array, rows: Array) -> int:
    """Write the rows of `parallel_joint_values` into rows (9, 10), the last temporary; returns their number."""
    goal, there, k = stand_of(T_world_tool), rows[8], 0
    for found in range(parallel_axes_postures(arm, T_world_tool, q, rows)):
        for i in range(LOOSE + 1):
            there[i] = rows[found, i]
        left = polished(arm[POLISHER:], T_world_tool, goal, there[:6])
        if left < ACCEPTED and not is_known(rows, k, there[:6]):
            for i in range(LOOSE + 1):
                rows[k, i] = there[i]
            k += 1
    return k
