"""What a way of inverse kinematics finds, and the answer to a person: numbers first, words when they are read."""

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


class Told(Protocol):
    """What is to be said of postures, in the order in which they were found."""

    @property
    def names(self) -> Sequence[Text]:
        """Of each."""

    @property
    def words(self) -> Text:
        """Of all."""

    @property
    def values(self) -> Sequence[Mapping[str, float]]:
        """What the form worked out on the way, by symbol, for one posture after another; once, where there is none."""

    @property
    def free(self) -> tuple[int, ...]:
        """Joints that may take any value here; the current one was kept."""


@dataclass(frozen=True)
class Said:
    """The same, said beforehand."""

    names: Sequence[Text]
    words: Text
    values: Sequence[Mapping[str, float]] = field(default=(NO_VALUES,))
    free: tuple[int, ...] = ()


class Found(NamedTuple):
    """Postures as a way finds them: q (k, n) and what else that way notes behind it, and what was solved for in them.

    T_world_goal (4, 4), m: the asked pose or, for an arm that cannot take every pose, the nearest one of its subspace;
    moved, m, and turned, rad: from the one to the other; short: how far the goal lies beyond the edge of the workspace,
    m, 0 inside.
    """

    q: Array
    T_world_goal: Array
    told: Told
    moved: float = 0.0
    turned: float = 0.0
    short: float = 0.0


@dataclass(eq=False)  # frozen, it would take three times as long to make, which is felt
class Answer:
    """Every posture for a goal: `rows` (k, n + 7) with the columns of `listing`, and what was found for them."""

    rows: Array
    found: Found

    @property
    def q(self) -> Array:
        """The postures, (k, n), rad or m."""
        return self.rows[:, : -1 - listing.COST]

    @property
    def within(self) -> NDArray[np.bool_]:
        """Whether every joint of a posture keeps its limits, (k,)."""
        return listing.column(self.rows, listing.WITHIN) > 0

    @property
    def left(self) -> tuple[float, float] | None:
        """What the first posture leaves of what was solved for, m and rad; None where there is none."""
        if not len(self.rows):
            return None
        missed, turned = self.rows[0, listing.LEFT - 1 - listing.COST :][:2].tolist()
        return missed, turned

    @property
    def T_world_goal(self) -> Array:
        """What was solved for, (4, 4), m."""
        goal = self.found.T_world_goal.view()
        goal.setflags(write=False)
        return goal

    @property
    def moved(self) -> float:
        """From the asked pose to what was solved for, m."""
        return self.found.moved

    @property
    def turned(self) -> float:
        """From the asked pose to what was solved for, rad."""
        return self.found.turned

    @property
    def short(self) -> float:
        """How far the goal lies beyond the edge of the workspace, m, 0 inside."""
        return self.found.short

    @property
    def free(self) -> tuple[int, ...]:
        """Joints that may take any value here; the current one was kept."""
        return self.found.told.free

    @cached_property
    def words(self) -> Text:
        """What is to be said."""
        return self.found.told.words

    @cached_property
    def branches(self) -> tuple[Branch, ...]:
        """The postures with their names."""
        names, said = self.found.told.names, self.rows[:, -1 - listing.COST :]
        return tuple(
            Branch(names[int(row[listing.NUMBER])], frozen(q), float(row[0]), float(row[1]), bool(row[listing.WITHIN]))
            for q, row in zip(self.q, said, strict=True)
        )

    @cached_property
    def values(self) -> tuple[Mapping[str, float], ...]:
        """What the form worked out on the way, by symbol, for one posture after another; once, where there is none."""
        values = tuple(self.found.told.values)
        if len(values) != len(self.found.q):
            return values
        return tuple(values[int(number)] for number in listing.column(self.rows, listing.NUMBER))

    @property
    def is_solved(self) -> bool:
        """Whether the first posture reaches what was solved for and keeps the limits."""
        if not len(self.rows):
            return False
        first, said = self.rows.item, -1 - listing.COST
        kept = first(0, said + listing.WITHIN) > 0
        reached = first(0, said + listing.LEFT) <= listing.REACHED
        return kept and reached and first(0, said + listing.LEFT_TURNED) <= listing.REACHED

    @property
    def nearest(self) -> Answer:
        """The answer with its first posture alone."""
        return Answer(self.rows[:1], self.found)

    def only(self, places: Sequence[int]) -> Answer:
        """The answer with no postures but those in these places."""
        return Answer(self.rows[list(places)], self.found)


def in_order(robot: Robot, found: Found, T_world_tool: Array, q: Array, with_orientation: bool = True) -> Answer:
    """The answer with the postures in the order of `listing.in_order`, measured against the asked pose (4, 4), m."""
    return Answer(listing.in_order(robot, found.q, T_world_tool, found.T_world_goal, q, with_orientation), found)


def as_found(robot: Robot, found: Found, T_world_tool: Array, with_orientation: bool = True) -> Answer:
    """The answer with the postures in the order in which they were found."""
    T = check_pose(T_world_tool)
    return Answer(listing.as_found(robot, found.q, T, found.T_world_goal, with_orientation), found)


def rows_of(postures: Sequence[Array], n: int) -> Array:
    """Postures (n,) as rows (k, n), also where there are none."""
    return np.array(postures, dtype=np.float64).reshape(len(postures), n)


class Form(Protocol):
    """A module of `ik/closed/`: a closed form for a family of arms.

    RANK: of several that apply to an arm the lowest is chosen: 0 for the form of one arm, 1 for that of every arm with
    a spherical wrist or three parallel axes, then the families of methods, which solve again what these solve.
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
