"""An ellipsoidal obstacle: a Gaussian cost around its centre, evaluated at the tool or at points along the links."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler
from helicoide.ik import Problem
from helicoide.ik.arm_points import PER_LINK, WATCHED, coordinate, watched
from helicoide.ik.method import Quantity
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="ellipsoidal obstacle", pt_BR="obstáculo elipsoidal")
SOURCE = "Vargas 2013, eq. 4.74"
EQUATION = r"f = \alpha \sum_j e^{-(p_j - \mu)^T M_f (p_j - \mu)}, \quad M_f = R_f D_f^{-1} R_f^T"
AUGMENTS = True

_TURN = 3.1416


@dataclass(frozen=True)
class Options:
    """weight: α; x, y, z: μ, ℓ, base frame; yaw, pitch, roll: R_f = R_z R_y R_x, rad.

    a, b, c: semi-axes, ℓ, D_f = diag(a², b², c²). where: which points p_j of the arm count; per_link: how many on each
    link. Small obstacles need many.
    """

    weight: Annotated[float, Quantity(Text(en="weight α", pt_BR="peso α"), 0.0, 50.0, "1/s")] = 5.0
    x: Annotated[float, coordinate("x")] = 0.5
    y: Annotated[float, coordinate("y")] = 0.3
    z: Annotated[float, coordinate("z")] = 0.5
    a: Annotated[float, Quantity(Text(en="semi-axis a", pt_BR="semieixo a"), 0.01, 1.0, "mm", 1)] = 0.1
    b: Annotated[float, Quantity(Text(en="semi-axis b", pt_BR="semieixo b"), 0.01, 1.0, "mm", 1)] = 0.1
    c: Annotated[float, Quantity(Text(en="semi-axis c", pt_BR="semieixo c"), 0.01, 1.0, "mm", 1)] = 0.1
    yaw: Annotated[
        float, Quantity(Text(en="rotation about z", pt_BR="rotação em torno de z"), -_TURN, _TURN, "rad")
    ] = 0.0
    pitch: Annotated[
        float, Quantity(Text(en="rotation about y", pt_BR="rotação em torno de y"), -_TURN, _TURN, "rad")
    ] = 0.0
    roll: Annotated[
        float, Quantity(Text(en="rotation about x", pt_BR="rotação em torno de x"), -_TURN, _TURN, "rad")
    ] = 0.0
    where: Annotated[str, WATCHED] = "links"
    per_link: Annotated[int, PER_LINK] = 8


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = α Σⱼ exp(−Δpⱼᵀ M Δpⱼ), ∂f/∂q = −2α Σⱼ exp(−Δpⱼᵀ M Δpⱼ) Δpⱼᵀ M J_pj, Δpⱼ = pⱼ − μ."""
    points, J = watched(problem.robot, options.where, round(options.per_link)).moving(problem, posture.poses)
    offsets, M = points - (options.x, options.y, options.z), shape(options)
    hills = options.weight * np.exp(-np.einsum("ja,ab,jb->j", offsets, M, offsets))
    return Cost(float(hills.sum()), -2 * np.einsum("j,jb,jbn->n", hills, offsets @ M, J))


@lru_cache(maxsize=64)
def shape(options: Options) -> Array:
    """M_f = R_f D_f⁻¹ R_fᵀ, (3, 3), 1/ℓ²."""
    R = euler.euler_matrix((options.yaw, options.pitch, options.roll), "zyx")
    return frozen(R / np.square((options.a, options.b, options.c)) @ R.T)
