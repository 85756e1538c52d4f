"""The postures that a solver finds (`Found`) and the public `Answer`; words are computed only when they are read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.ik.postures import listing
from helicoide.ik.postures.branch import Branch, check_pose
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

NO_VALUES: Mapping[str, float] = MappingProxyType({})


class Explanation(Protocol):
    """Texts and values about postures, in the order in which these were found."""

    @property
    def names(self) -> Sequence[Text]:
        """The name of each posture."""

    @property
    def words(self) -> Text:
        """The sentences about all postures."""

    @property
    def values(self) -> Sequence[Mapping[str, float]]:
        """Intermediate values of the closed form by symbol: one mapping for each posture, or a single one."""

    @property
    def free(self) -> tuple[int, ...]:
        """Joints that may take any value here; the current one was kept."""


@dataclass(frozen=True)
class Words:
    """`Told` with all texts given at the start."""

    names: Sequence[Text]
    words: Text
    values: Sequence[Mapping[str, float]] = field(default=(NO_VALUES,))
    free: tuple[int, ...] = ()


class Found(NamedTuple):
    """The postures that a solver finds, and the pose that it solved for.

    q (k, ≥ n): one posture in each row, rad or m; further columns are ignored. T_world_goal (4, 4), m: the asked pose
    or, for an arm that cannot take every pose, the nearest one of its subspace; moved, m, and turned, rad: from the one
    to the other; short: how far the goal lies beyond the edge of the workspace, m, 0 inside.
    """

    q: Array
    T_world_goal: Array
    explanation: Explanation
    moved: float = 0.0
    turned: float = 0.0
    short: float = 0.0


@dataclass(eq=False)  # not frozen: construction would take three times as long
class Answer:
    """Every posture for a goal: `rows` (k, n + 7) with the columns of `listing`, and what the solver found."""

    rows: Array
    found: Found

    @property
    def q(self) -> Array:
        """The postures, (k, n), rad or m."""
        return self.rows[:, : -1 - listing.COST]

    @property
    def within(self) -> NDArray[np.bool_]:
        """Whether every joint of a posture is within its limits, (k,)."""
        return listing.column(self.rows, listing.WITHIN) > 0

    @property
    def left(self) -> tuple[float, float] | None:
        """The errors of the first posture against `T_world_goal`, m and rad; None without a posture."""
        if not len(self.rows):
            return None
        missed, turned = self.rows[0, listing.LEFT - 1 - listing.COST :][:2].tolist()
        return missed, turned

    @property
    def T_world_goal(self) -> Array:
        """The pose that was solved for, (4, 4), m."""
        goal = self.found.T_world_goal.view()
        goal.setflags(write=False)
        return goal

    @property
    def moved(self) -> float:
        """The distance from the asked pose to `T_world_goal`, m."""
        return self.found.moved

    @property
    def turned(self) -> float:
        """The rotation from the asked pose to `T_world_goal`, rad."""
        return self.found.turned

    @property
    def short(self) -> float:
        """How far the goal lies beyond the edge of the workspace, m, 0 inside."""
        return self.found.short

    @property
    def free(self) -> tuple[int, ...]:
        """Joints that may take any value here; the current one was kept."""
        return self.found.explanation.free

    @cached_property
    def words(self) -> Text:
        """The sentences about the postures."""
        return self.found.explanation.words

    @cached_property
    def branches(self) -> tuple[Branch, ...]:
        """The postures with their names."""
        names, said = self.found.explanation.names, self.rows[:, -1 - listing.COST :]
        return tuple(
            Branch(names[int(row[listing.NUMBER])], frozen(q), float(row[0]), float(row[1]), bool(row[listing.WITHIN]))
            for q, row in zip(self.q, said, strict=True)
        )

    @cached_property
    def values(self) -> tuple[Mapping[str, float], ...]:
        """Intermediate values of the closed form by symbol: one mapping for each posture, or a single one."""
        values = tuple(self.found.explanation.values)
        if len(values) != len(self.found.q):
            return values
        return tuple(values[int(number)] for number in listing.column(self.rows, listing.NUMBER))

    @property
    def is_solved(self) -> bool:
        """Whether the first posture reaches `T_world_goal` within the joint limits."""
        if not len(self.rows):
            return False
        first, said = self.rows.item, -1 - listing.COST
        kept = first(0, said + listing.WITHIN) > 0
        reached = first(0, said + listing.LEFT) <= listing.REACHED
        return kept and reached and first(0, said + listing.LEFT_TURNED) <= listing.REACHED

    @property
    def nearest(self) -> Answer:
        """The answer with only its first posture."""
        return Answer(self.rows[:1], self.found)

    def only(self, places: Sequence[int]) -> Answer:
        """The answer with only the postures at these indices."""
        return Answer(self.rows[list(places)], self.found)


def answer_in_order(robot: Robot, found: Found, T_world_tool: Array, q: Array, with_orientation: bool = True) -> Answer:
    """The answer in the order of `listing.listed_in_order`. Args: T_world_tool: the asked pose (4, 4), m."""
    return Answer(listing.listed_in_order(robot, found.q, T_world_tool, found.T_world_goal, q, with_orientation), found)


def answer_as_found(robot: Robot, found: Found, T_world_tool: Array, with_orientation: bool = True) -> Answer:
    """The answer with the postures in the order in which they were found."""
    T = check_pose(T_world_tool)
    return Answer(listing.listed_as_found(robot, found.q, T, found.T_world_goal, with_orientation), found)


def stacked_postures(postures: Sequence[Array], n: int) -> Array:
    """Postures (n,) as rows (k, n), also for k = 0."""
    return np.array(postures, dtype=np.float64).reshape(len(postures), n)


class Form(Protocol):
    """A module of `ik/closed/`: a closed form for a family of arms.

    RANK: of several forms that apply to an arm the lowest is used: 0 for the form of one arm, 1 for that of every arm
    with a spherical wrist or three parallel axes, more for other methods for the same arms.
    OF_POINTS: whether its goals are points.
    """

    TITLE: Text
    SOURCE: str
    RANK: int
    OF_POINTS: bool

    @property
    def EQUATIONS(self) -> tuple[str, ...]:
        """Its steps, in TeX, in order."""

    def applies(self, robot: Robot) -> Text | None:
        """Why the form does not apply to a robot; None where it does."""

    def find(self, robot: Robot, T_world_tool: Array, q: Array) -> Found:
        """Every posture for a tool pose (4, 4), m; q (n,), rad or m: kept where a joint is free. Both are checked."""
