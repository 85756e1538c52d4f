"""The kernels that count postures into the cells of a workspace map."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Chain
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.grid import Cells, Counts, cell_index
from helicoide.kinematics.jacobian import geometric_jacobian, joint_axes

Flags = NDArray[np.uint8]
# Bins of orientation. In a plane: the angle about the normal. In space: bands of equal area around the vertical,
# headings within a band, and rolls about the pointing axis; a random orientation falls into each bin equally likely.
PLANAR_BINS, BANDS, HEADINGS, ROLLS = 64, 4, 8, 4


class MapPart(NamedTuple):
    """The result of some postures: hits (count,), orientations (count, orientation bins), best (count,).

    best: the largest manipulability in a cell. The last two may be empty.
    """

    hits: Counts
    orientations: Flags
    best: Array


@kernel
def angle_bin(y: float, x: float, parts: int) -> int:
    """Number of the bin that holds the angle Atan2(y, x); parts: number of equal bins in 2π."""
    part = int(np.floor((np.arctan2(y, x) / (2 * np.pi) + 0.5) * parts))
    return min(part, parts - 1)


@kernel
def orientation_bin(R: Array, axes: Array) -> int:
    """Number of the orientation bin of a rotation. Args: R (3, 3); axes (d, 3) of the cells.

    In a plane with normal n: by the angle φ = Atan2(n·vee(R − Rᵀ), tr R − nᵀ R n). In space: by the band and heading of
    the z axis and the roll of the x axis from the horizontal. Source for φ: Campos 1998, s.29.
    """
    if axes.shape[0] == 2:
        n = np.cross(axes[0], axes[1])
        sine = n[0] * (R[2, 1] - R[1, 2]) + n[1] * (R[0, 2] - R[2, 0]) + n[2] * (R[1, 0] - R[0, 1])
        cosine = R[0, 0] + R[1, 1] + R[2, 2] - n @ (R @ n)
        return angle_bin(sine, cosine, PLANAR_BINS)
    x, y, z = R[0, 2], R[1, 2], R[2, 2]
    band = min(int((z + 1) / 2 * BANDS), BANDS - 1)
    heading = angle_bin(y, x, HEADINGS)
    # along (−y, x, 0), which is horizontal, and along (−x z, −y z, x² + y²), its cross product with z, equally long
    level, upward = R[1, 0] * x - R[0, 0] * y, R[2, 0] * (x * x + y * y) - z * (R[0, 0] * x + R[1, 0] * y)
    return (band * HEADINGS + heading) * ROLLS + angle_bin(upward, level, ROLLS)


@kernel
def row_volume(J: Array) -> float:
    """Manipulability w = √det(J Jᵀ), or √det(Jᵀ J) if n < d: the volume that the rows span, by Gram-Schmidt.

    Args: J (d, n). Source: Yoshikawa 1985; Coutinho 2015, eq. 3.36.
    """
    rows = J.copy() if J.shape[0] <= J.shape[1] else J.T.copy()
    w = 1.0
    for i in range(rows.shape[0]):
        size = np.sqrt(np.sum(rows[i] ** 2))
        w *= size
        if size == 0.0:
            return 0.0
        for j in range(i + 1, rows.shape[0]):
            rows[j] -= rows[i] * (np.sum(rows[i] * rows[j]) / (size * size))
    return w


@kernel
def count_into_cells(chain: Chain, T_link_tool: Array, postures: Array, cells: Cells, part: MapPart) -> None:
    """Count postures into the cells that hold their tool points: hits, and optionally orientation bins or the best w.

    Args: postures (k, n), rad or m; part: what was counted so far, its arrays are changed; orientations and best are
    empty if not wanted. The orientation is that of the last link, from which the tool's differs by a constant rotation.
    """
    hits, orientations, best = part
    for k in range(postures.shape[0]):
        poses = link_poses(chain, postures[k])
        T = poses[-1] @ T_link_tool
        point = T[:3, 3].copy()
        cell = cell_index(point, cells)
        if cell < 0:
            continue
        hits[cell] += 1
        if orientations.shape[0] > 0:
            orientations[cell, orientation_bin(poses[-1, :3, :3].copy(), cells.axes)] = 1
        if best.shape[0] > 0:
            J = geometric_jacobian(poses, chain, joint_axes(poses, chain), point, chain.shape[0])
            best[cell] = max(best[cell], row_volume(cells.axes @ J[:3].copy()))
