"""How near a posture is to a singularity: factors of det J where they exist, rank of J, and lost velocities."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.spherical_wrist import DeterminantFactor, determinant_factors, spherical_wrist
from helicoide.text import Text, join_texts

NEAR_SINGULAR = 0.05  # fraction of the largest value below which people are warned
SAMPLED_POSTURES = 64  # random postures in which the usual rank and the largest singular value are determined
NONE_NEAR = Text(en="none near", pt_BR="nenhuma por perto")
SINGULAR = Text(
    en="{what} moves in {rank} of its {usual} independent directions",
    pt_BR="{what} se move em {rank} das suas {usual} direções independentes",
)
ALMOST = Text(
    en="in its slowest direction {what} has {part:.1f} % of its best speed",
    pt_BR="na direção mais lenta, {what} tem {part:.1f} % da sua melhor velocidade",
)
TOOL = Text(en="the tool", pt_BR="o efetuador")
POINT = Text(en="the tool's point", pt_BR="o ponto do efetuador")


@dataclass(frozen=True)
class MotionRank:
    """Rank of a Jacobian in this posture, and its usual rank, that in almost every posture.

    relative_singular_value: the smallest of its `generic_rank` largest singular values, divided by the largest such
    value of any sampled posture; 0 at a singularity, 1 if no joint moves it.
    """

    what: Text
    rank: int
    generic_rank: int
    relative_singular_value: float

    def description(self, within: float) -> Text | None:
        """A sentence on lost or slow directions; None if relative > within and no direction is lost."""
        if self.rank < self.generic_rank:
            return SINGULAR.format(what=self.what, rank=self.rank, usual=self.generic_rank)
        if self.relative_singular_value <= within:
            return ALMOST.format(what=self.what, part=100 * self.relative_singular_value)
        return None


@dataclass(frozen=True, eq=False)
class Singularity:
    """How near a posture is to a singularity.

    factors: of det J, for six joints with a spherical wrist; empty for other arms. tool: rank of its J; point: rank of
    the position rows alone, which an arm with few joints may lose while the tool still rotates. lost_velocities:
    columns y (6, 6 − rank) with yᵀ J = 0: velocities (v, ω) that no q̇ gives. An arm with fewer than six joints, or a
    planar arm, has a usual rank below 6 and so always loses some; at a singularity it loses more.
    """

    factors: tuple[DeterminantFactor, ...]
    tool: MotionRank
    point: MotionRank
    lost_velocities: Array

    @property
    def rank(self) -> int:
        """Rank of the tool's J in this posture."""
        return self.tool.rank

    @property
    def generic_rank(self) -> int:
        """Rank of the tool's J in almost every posture."""
        return self.tool.generic_rank

    @property
    def singular(self) -> bool:
        """Whether the rank is lower than usual."""
        return self.rank < self.generic_rank

    def near_factors(self, within: float) -> tuple[DeterminantFactor, ...]:
        """The factors whose relative size is at most `within`, the nearest to zero first."""
        close = (factor for factor in self.factors if abs(factor.relative) <= within)
        return tuple(sorted(close, key=lambda factor: abs(factor.relative)))

    def description(self, within: float) -> Text:
        """A sentence on what is singular, or nearer to it than `within`."""
        return self.warning(within) or NONE_NEAR

    def warning(self, within: float = NEAR_SINGULAR) -> Text | None:
        """The same sentence; None if nothing is near a singularity."""
        if close := [factor.description for factor in self.near_factors(within)]:
            return join_texts(close)
        return self.tool.description(within) or self.point.description(within)


def singularity(robot: Robot, q: ArrayLike) -> Singularity:
    """How near a posture is to a singularity: factors of det J for a spherical wrist; rank and lost velocities.

    Args: q (n,), rad or m. Raises HelicoideError for a wrong q. Source: Vargas 2013, §3.2, eqs. 3.8–3.9.
    """
    wrist, J = spherical_wrist(robot), frame_jacobian(robot, q)
    tool, point = (
        MotionRank(what, analyse_jacobian(rows).rank, usual, _value(robot, rows, usual) / best)
        for what, rows, (usual, best) in zip((TOOL, POINT), (J, J[:3]), _generic(robot), strict=True)
    )
    return Singularity(
        () if wrist is None else determinant_factors(robot, q, wrist), tool, point, analyse_jacobian(J).lost_velocities
    )


def generic_rank(robot: Robot, rows: int = 6) -> int:
    """Rank of the tool's Jacobian in almost every posture: of all six rows, or of the three of its position."""
    return dict(zip((6, 3), _generic(robot), strict=True))[rows][0]


@lru_cache(maxsize=32)
def _generic(robot: Robot) -> tuple[tuple[int, float], ...]:
    """For the tool and for its point: the rank r in a random posture, and the largest σᵣ of all sampled postures."""
    postures = np.random.default_rng(0).uniform(robot.lower, robot.upper, (SAMPLED_POSTURES, len(robot.lower)))
    tried = [frame_jacobian(robot, q) for q in postures]
    ranks = [analyse_jacobian(tried[0][:rows]).rank for rows in (6, 3)]
    return tuple(
        (rank, max(_value(robot, J[:rows], rank) for J in tried)) for rank, rows in zip(ranks, (6, 3), strict=True)
    )


def _value(robot: Robot, J: Array, number: int) -> float:
    """Singular value σ of that number of J (6, n), or of its first three rows (3, n), with lengths in reaches."""
    if number == 0:
        return 1.0
    scaled = J * np.where([joint.is_prismatic for joint in robot.variables], robot.reach, 1.0)
    scaled[:3] /= robot.reach
    return float(np.linalg.svd(scaled, compute_uv=False)[number - 1])
