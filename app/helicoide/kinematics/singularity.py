"""How near a posture is to a singularity: factors of det J where they exist, rank of J, and lost velocities."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.generic_rank import counted_rows, generic_rank, largest_singular_value, singular_value
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.spherical_wrist import DeterminantFactor, determinant_factors, spherical_wrist
from helicoide.text import Text, join_texts

NEAR_SINGULAR = 0.05  # fraction of the largest value below which people are warned
NONE_NEAR = Text(en="none nearby", pt_BR="nenhuma por perto")
SINGULAR = Text(
    en="{what} moves in {rank} of its {usual} independent directions",
    pt_BR="{what} se move em {rank} das suas {usual} direções independentes",
)
ALMOST = Text(
    en="in its slowest direction {what} has {part:.1f} % of its best speed",
    pt_BR="na direção mais lenta, {what} tem {part:.1f} % da sua melhor velocidade",
)
TOOL = Text(en="the end effector", pt_BR="o efetuador")
POINT = Text(en="the end-effector point", pt_BR="o ponto do efetuador")


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

    factors: of det J, for six joints with a spherical wrist; empty for other arms. tool: rank of its J, of the position
    rows alone where only they count; point: rank of the position rows, which an arm with few joints may lose while the
    tool still rotates. lost_velocities: columns y (6, 6 − rank) with yᵀ J = 0: velocities (v, ω) that no q̇ gives; (3,
    3 − rank) where only the position counts. An arm with fewer than six joints, or a planar arm, has a usual rank below
    6 and so always loses some; at a singularity it loses more.
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


def singularity(robot: Robot, q: ArrayLike, with_orientation: bool = True) -> Singularity:
    """How near a posture is to a singularity: factors of det J for a spherical wrist; rank and lost velocities.

    Without orientation, or where the arm cannot choose it, the position of the tool counts alone.
    Args: q (n,), rad or m. Raises HelicoideError for a wrong q. Source: Vargas 2013, §3.2, eqs. 3.8–3.9.
    """
    J = frame_jacobian(robot, q)
    point = _motion_rank(robot, POINT, J[:3])
    if not counted_rows(robot, with_orientation)[3:].any():
        return Singularity((), point, point, analyse_jacobian(J[:3]).lost_velocities)
    wrist = spherical_wrist(robot)
    return Singularity(
        () if wrist is None else determinant_factors(robot, q, wrist),
        _motion_rank(robot, TOOL, J),
        point,
        analyse_jacobian(J).lost_velocities,
    )


def _motion_rank(robot: Robot, what: Text, J: Array) -> MotionRank:
    usual = generic_rank(robot, len(J))
    relative = singular_value(robot, J, usual) / largest_singular_value(robot, len(J))
    return MotionRank(what, analyse_jacobian(J).rank, usual, relative)
