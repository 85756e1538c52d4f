"""The nearest orientation of a tool that can only point within the vertical plane of its arm."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.frames import Tool, pose_rows
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import Triple, cross, dot, tool_row

# A hand points along the normal of the plane where the sine between the two is below this.
ACROSS = 1e-8


@dataclass(frozen=True, eq=False)
class Pointing:
    """The rotation of a hand into the plane of the arm; vectors (3,) and R (3, 3) in one frame.

    M: normal of the plane; K: axis of the rotation; Z: the direction of the hand after it; cosine and sine of its
    angle; R: the orientation after it.
    """

    M: Array
    K: Array
    Z: Array
    cosine: float
    sine: float
    R: Array

    @property
    def angle(self) -> float:
        """The angle of the rotation about K, rad: |θ| = asin|M·Ẑ|."""
        return float(np.arctan2(self.sine, self.cosine))


def turned_into_plane(T: Array, hand: Array, M: Array) -> Pointing:
    """The rotation of a tool (4, 4), m, base frame, into the plane normal to M (3,), horizontal and unit.

    hand: the pointing direction in the frame of the tool, (3,), unit.
    """
    K, Z, cosine, sine, R = into_plane(pose_rows(np.ascontiguousarray(T)), tuple(hand.tolist()), tuple(M.tolist()))
    return Pointing(M, np.array(K), np.array(Z), cosine, sine, np.array(R)[:, :3])


@kernel_into
def into_plane(tool: Tool, hand: Triple, M: Triple) -> tuple[Triple, Triple, float, float, Tool]:
    """The smallest rotation of Ẑ = R·hand into the plane normal to M: K = M × Ẑ / |M × Ẑ|, Ẑ' = K × M.

    cos θ = Ẑ·Ẑ', sin θ = (Ẑ × Ẑ')·K; each axis v' = cos θ v + sin θ K × v + (1 − cos θ)(K·v) K (Rodrigues).
    Where Ẑ lies along M, all directions in the plane are equally near; the horizontal one is used, with K down.
    Returns K, Ẑ', cos θ, sin θ and the tool, rotated about its own point.
    Source: Campos 1998, s.36 and s.55; Craig, Introduction to Robotics, ch. 4.
    """
    x, y, z = tool
    pointing = dot(x, hand), dot(y, hand), dot(z, hand)
    K = cross(M, pointing)
    size = sqrt(K[0] * K[0] + K[1] * K[1] + K[2] * K[2])
    K = (0.0, 0.0, -1.0) if size < ACROSS else (K[0] / size, K[1] / size, K[2] / size)
    Z = cross(K, M)
    c, s = dot(pointing, Z), dot(K, cross(pointing, Z))
    # the rows of cos θ + sin θ [K] + (1 − cos θ) K Kᵀ
    a, b, d = (1.0 - c) * K[0], (1.0 - c) * K[1], (1.0 - c) * K[2]
    turn = (
        (c + a * K[0], a * K[1] - s * K[2], a * K[2] + s * K[1], 0.0),
        (b * K[0] + s * K[2], c + b * K[1], b * K[2] - s * K[0], 0.0),
        (d * K[0] - s * K[1], d * K[1] + s * K[0], c + d * K[2], 0.0),
    )
    p, q, r = tool_row(turn[0], tool), tool_row(turn[1], tool), tool_row(turn[2], tool)
    return K, Z, c, s, ((p[0], p[1], p[2], x[3]), (q[0], q[1], q[2], y[3]), (r[0], r[1], r[2], z[3]))
