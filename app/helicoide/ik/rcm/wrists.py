"""The constrained Jacobians of the source's wrists in closed form, and their manipulability.

The axes of joints 4 to 6 meet at the start of the restricted link, those of joints 7 and 8 at its end. l_a + l_b is its
length; l_8 is the distance from joint 8 to the tool. "zy": joint 7 rotates about z, joint 8 about y; "zx": about x.
Source: Coutinho 2015, §3.2, §3.3, §3.5.
"""

from __future__ import annotations

from math import cos, sin

import numpy as np

from helicoide.arrays import Array


def zy_slit(l_a: float, l_b: float, l_8: float, q7: float, q8: float) -> Array:
    """J^r (6, 7) of a zy wrist beyond a slit; columns v_x, v_y, v_z, ω_x, ω_y, θ̇₇, θ̇₈.

    Source: Coutinho 2015, eq. 3.24.
    """
    c7, s7, c8, s8 = cos(q7), sin(q7), cos(q8), sin(q8)
    tip, whole = (l_8 + l_b * c7) / l_a, l_a + l_b + l_8 * c7
    return np.array(
        [
            [-c8 * tip, c8 * s7, -s8, -s8 * whole, -l_8 * s7 * s8, -l_8 * c8, 0],
            [l_b * s7 / l_a, c7, 0, 0, 0, 0, 0],
            [-s8 * tip, s7 * s8, c8, c8 * whole, l_8 * c8 * s7, -l_8 * s8, 0],
            [-s8 / l_a, 0, 0, c7 * c8, c8 * s7, -s8, 0],
            [0, 0, 0, -s7, c7, 0, 1],
            [c8 / l_a, 0, 0, c7 * s8, s7 * s8, c8, 0],
        ]
    )


def zy_trocar(l_a: float, l_b: float, l_8: float, q7: float, q8: float) -> Array:
    """J^r (6, 6) of a zy wrist beyond a trocar; columns v_x, v_y, v_z, ω_y, θ̇₇, θ̇₈. Source: Coutinho 2015, eq. 3.28."""
    c7, s7, c8, s8 = cos(q7), sin(q7), cos(q8), sin(q8)
    tip, arm = (l_8 + l_b * c7) / l_a, (l_b + l_8 * c7) / l_a
    return np.array(
        [
            [-c8 * tip, c8 * s7, s8 * arm, -l_8 * s7 * s8, -l_8 * c8, 0],
            [l_b * s7 / l_a, c7, 0, 0, 0, 0],
            [-s8 * tip, s7 * s8, -c8 * arm, l_8 * c8 * s7, -l_8 * s8, 0],
            [-s8 / l_a, 0, -c7 * c8 / l_a, c8 * s7, -s8, 0],
            [0, 0, s7 / l_a, c7, 0, 1],
            [c8 / l_a, 0, -c7 * s8 / l_a, s7 * s8, c8, 0],
        ]
    )


def zx_trocar(l_a: float, l_b: float, l_8: float, q7: float, q8: float) -> Array:
    """J^r (6, 6) of a zx wrist beyond a trocar; columns v_x, v_y, v_z, ω_y, θ̇₇, θ̇₈.

    Source: Coutinho 2015, eq. 3.29, in one frame: the printed one rotates by −θ₈ and leaves out l_8.
    """
    c7, s7, c8, s8 = cos(q7), sin(q7), cos(q8), sin(q8)
    return np.array(
        [
            [-(l_8 * c8 + l_b * c7) / l_a, s7, l_8 * s7 * s8 / l_a, l_8 * s8 * c7, -l_8 * c8, 0],
            [l_b * s7 * c8 / l_a, c7 * c8, -l_b * s8 / l_a, 0, 0, 0],
            [-l_b * s7 * s8 / l_a, -s8 * c7, -(l_8 * c7 + l_b * c8) / l_a, l_8 * s7, 0, l_8],
            [0, 0, -c7 / l_a, s7, 0, 1],
            [s8 / l_a, 0, s7 * c8 / l_a, c7 * c8, s8, 0],
            [c8 / l_a, 0, -s7 * s8 / l_a, -s8 * c7, c8, 0],
        ]
    )


def w_zy_slit(l_a: float, l_b: float, q7: float) -> float:
    """w_r = (l_b/l_a) √((l_a + l_b)² sin²θ₇ + 2): singular at l_b = 0.

    Source: Coutinho 2015, eq. 3.40, which prints w_r².
    """
    return abs(l_b / l_a) * float(np.sqrt(((l_a + l_b) * sin(q7)) ** 2 + 2))


def w_zy_trocar(l_a: float, l_b: float, q7: float) -> float:
    """w_r = l_b² |sin θ₇| / l_a²: singular where axes 6 and 8 align, and at l_b = 0.

    Source: Coutinho 2015, eq. 3.42.
    """
    return (l_b / l_a) ** 2 * abs(sin(q7))


def w_zx_trocar(l_a: float, l_b: float, q7: float) -> float:
    """w_r = l_b² |cos θ₇| / l_a²: singular at θ₇ = π/2 + kπ, and at l_b = 0. Source: Coutinho 2015, eq. 3.41."""
    return (l_b / l_a) ** 2 * abs(cos(q7))
