"""How near a posture is to a singularity: factors of det J where they exist, rank of J, and lost velocities."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.differential import geometric
from helicoide.kinematics.manipulability import analysed
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.spherical_wrist import Factor, factors, spherical_wrist
from helicoide.text import Text, joined

NEAR = 0.05  # fraction of the largest value below which people are warned
TRIED = 64  # random postures in which the usual rank and the largest singular value are determined
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
class Freedom:
    """Rank of a Jacobian in this posture, and its usual rank, that in almost every posture.

    relative: the smallest of its `usual` largest singular values, divided by the largest such value of any sampled
    posture; 0 at a singularity, 1 if no joint moves it.
    """

    what: Text
    rank: int
    usual: int
    relative: float

    def words(self, within: float) -> Text | None:
        """A sentence on lost or slow directions; None if relative > within and no direction is lost."""
        if self.rank < self.usual:
            return SINGULAR.format(what=self.what, rank=self.rank, usual=self.usual)
        if self.relative <= within:
            return ALMOST.format(what=self.what, part=100 * self.relative)
        return None


@dataclass(frozen=True, eq=False)
class Singularity:
    """How near a posture is to a singularity.

    factors: of det J, for six joints with a spherical wrist; empty for other arms. tool: rank of its J; point: rank of
    the position rows alone, which an arm with few joints may lose while the tool still rotates. lost: columns y
    (6, 6 − rank) with yᵀ J = 0: velocities (v, ω) that no q̇ gives. An arm with fewer than six joints, or a planar arm,
    has a usual rank below 6 and so always loses some; at a singularity it loses more.
    """

    factors: tuple[Factor, ...]
    tool: Freedom
    point: Freedom
    lost: Array

    @property
    def rank(self) -> int:
        """Rank of the tool's J in this posture."""
        return self.tool.rank

    @property
    def usual(self) -> int:
        """Rank of the tool's J in almost every posture."""
        return self.tool.usual

    @property
    def singular(self) -> bool:
        """Whether the rank is lower than usual."""
        return self.rank < self.usual

    def near(self, within: float) -> tuple[Factor, ...]:
        """The factors whose relative size is at most `within`, the nearest to zero first."""
        close = (factor for factor in self.factors if abs(factor.relative) <= within)
        return tuple(sorted(close, key=lambda factor: abs(factor.relative)))

    def words(self, within: float) -> Text:
        """A sentence on what is singular, or nearer to it than `within`."""
        return self.told(within) or NONE_NEAR

    def told(self, within: float = NEAR) -> Text | None:
        """The same sentence; None if nothing is near a singularity."""
        if close := [factor.words for factor in self.near(within)]:
            return joined(close)
        return self.tool.words(within) or self.point.words(within)


def singularity(robot: Robot, q: ArrayLike) -> Singularity:
    """How near a posture is to a singularity: factors of det J for a spherical wrist; rank and lost velocities.

    Args: q (n,), rad or m. Raises HelicoideError for a wrong q. Source: Vargas 2013, §3.2, eqs. 3.8–3.9.
    """
    wrist, J = spherical_wrist(robot), geometric(robot, q)
    tool, point = (
        Freedom(what, analysed(rows).rank, usual, _value(robot, rows, usual) / best)
        for what, rows, (usual, best) in zip((TOOL, POINT), (J, J[:3]), _usually(robot), strict=True)
    )
    return Singularity(() if wrist is None else factors(robot, q, wrist), tool, point, analysed(J).lost)


def usual_rank(robot: Robot) -> int:
    """The rank of the tool's Jacobian in almost every posture, such as a random one within the limits."""
    return _usually(robot)[0][0]


@lru_cache(maxsize=32)
def _usually(robot: Robot) -> tuple[tuple[int, float], ...]:
    """For the tool and for its point: the rank r in a random posture, and the largest σᵣ of all sampled postures."""
    postures = np.random.default_rng(0).uniform(robot.lower, robot.upper, (TRIED, len(robot.lower)))
    tried = [geometric(robot, q) for q in postures]
    ranks = [analysed(tried[0][:rows]).rank for rows in (6, 3)]
    return tuple(
        (rank, max(_value(robot, J[:rows], rank) for J in tried)) for rank, rows in zip(ranks, (6, 3), strict=True)
    )


def _value(robot: Robot, J: Array, number: int) -> float:
    """Singular value σ of that number of J (6, n), or of its first three rows (3, n), with lengths in reaches."""
    if number == 0:
        return 1.0
    scaled = J * np.where([joint.slides for joint in robot.variables], robot.reach, 1.0)
    scaled[:3] /= robot.reach
    return float(np.linalg.svd(scaled, compute_uv=False)[number - 1])
