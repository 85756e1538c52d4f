"""The constraint Λ of a shaft in its entry point, and a basis Λ# of the motions that remain free.

Source: Coutinho 2015, §3.1–3.3.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik.rcm.passage import Insertion

# The source's basis contains 1/l_a. The scaled one has angular velocities instead of the linear ones of joint i.
Basis = Literal["source", "scaled"]
ALONG = frozen([0.0, 1.0, 0.0])
ALONG_CROSS = frozen(rotation.skew(ALONG))


def constraint(place: Insertion) -> Array:
    """Λ = H Ad_ri = N [I, −[p_ir]ₓ], (r, 6), p_ir = (0, l_a, 0).

    Λ V_i is the velocity, along the forbidden directions, of the point of the shaft at the entry.
    Source: Coutinho 2015, eqs. 3.2, 3.6, with the sign of v_r = v_i + ω × p_ir.
    """
    N = place.forbidden
    return np.hstack([N, -place.outside * N @ ALONG_CROSS])


def null_basis(place: Insertion, basis: Basis) -> Array:
    """Λ# (6, 6 − r), whose columns are the free motions of the shaft: Λ Λ# = 0.

    source: v = (v_x, v_y, v_z, ω_y) for a trocar, ω_x = −v_z/l_a, ω_z = v_x/l_a, and (v_x, v_y, v_z, ω_x, ω_y) for a
    slit; infinite at l_a = 0. scaled: first the free velocities at the entry point, then (ω_x, ω_y, ω_z), so that
    v = A s − ω × p_ir with N A = 0; no 1/l_a. Source: Coutinho 2015, eqs. 3.7, 3.23, 3.27.
    """
    N, l_a, r = place.forbidden, place.outside, len(place.forbidden)
    null = np.zeros((6, 6 - r))
    if basis == "scaled":
        null[:3, : 3 - r] = _free_directions(N)
        null[:3, 3 - r :] = l_a * ALONG_CROSS
        null[3:, 3 - r :] = np.eye(3)
        return null
    turn, free_turns = _rotations(N)
    null[:3, :3] = np.eye(3)
    null[3:, :3] = turn / l_a
    null[3:, 3:] = free_turns
    return null


def _free_directions(N: Array) -> Array:
    """A, orthonormal, N A = 0, (3, 3 − r): y and z of the shaft where x is forbidden."""
    if len(N) == 2:
        return ALONG[:, None]
    inward = ALONG - (ALONG @ N[0]) * N[0]
    inward /= np.linalg.norm(inward)
    return np.column_stack([inward, np.cross(N[0], inward)])


def _rotations(N: Array) -> tuple[Array, Array]:
    """The matrix (3, 3) from v to l_a ω, and the free angular velocities, (3, 3 − r), of which y is the last."""
    if len(N) == 2:
        return -ALONG_CROSS, ALONG[:, None]
    lever = np.cross(N[0], ALONG)
    lever /= lever @ lever
    inward = np.cross(ALONG, lever)
    return np.outer(lever, N[0]), np.column_stack([inward / np.linalg.norm(inward), ALONG])
