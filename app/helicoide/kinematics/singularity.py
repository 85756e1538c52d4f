"""How singular a posture is: kinds by the factors of det J where there are any, the rank, and the lost velocities."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from helicoide.kinematics.chain import Array
from helicoide.kinematics.differential import geometric
from helicoide.kinematics.manipulability import analysed
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.spherical_wrist import Factor, factors, spherical_wrist
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class Singularity:
    """How singular a posture is.

    factors: of det J, for six joints with a spherical wrist, none for other arms. rank: of the tool's J here; usual: in
    almost every posture. lost: columns y (6, 6 − rank) with yᵀ J = 0, velocities (v, ω) that no q̇ gives. An arm with
    fewer than six joints, or in a plane, has a usual rank below 6 and always some of them; more where it is singular.
    """

    factors: tuple[Factor, ...]
    rank: int
    usual: int
    lost: Array

    @property
    def singular(self) -> bool:
        """Whether the rank is lower than usual."""
        return self.rank < self.usual

    def near(self, within: float) -> tuple[Factor, ...]:
        """The factors whose relative size is at most `within`, the nearest to zero first."""
        close = (factor for factor in self.factors if abs(factor.relative) <= within)
        return tuple(sorted(close, key=lambda factor: abs(factor.relative)))

    def words(self, within: float) -> Text:
        """What is singular, or nearer to it than `within`, in words."""
        if close := [factor.words for factor in self.near(within)]:
            return Text(en="; ".join(text.en for text in close), pt_BR="; ".join(text.pt_BR for text in close))
        if self.singular:
            return Text(
                en="singular: the tool moves in {rank} independent directions instead of {usual}",
                pt_BR="singular: o efetuador se move em {rank} direções independentes em vez de {usual}",
            ).format(rank=self.rank, usual=self.usual)
        return Text(en="not singular", pt_BR="não singular")


def singularity(robot: Robot, q: ArrayLike) -> Singularity:
    """How singular a posture is: factors of the determinant where the wrist is spherical; rank and lost velocities.

    Args: q (n,), rad or m. Raises HelicoideError for a wrong q. Source: Vargas 2013, §3.2, eqs. 3.8–3.9.
    """
    here, wrist = analysed(geometric(robot, q)), spherical_wrist(robot)
    return Singularity(() if wrist is None else factors(robot, q, wrist), here.rank, usual_rank(robot), here.lost)


@lru_cache(maxsize=32)
def usual_rank(robot: Robot) -> int:
    """The rank of the tool's Jacobian in almost every posture, such as a random one within the limits."""
    return analysed(geometric(robot, np.random.default_rng(0).uniform(robot.lower, robot.upper))).rank
