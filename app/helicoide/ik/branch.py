"""The postures for one tool pose, each with its name, and what is said where there are none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Protocol

from helicoide.kinematics.chain import Array
from helicoide.kinematics.robot import Robot
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class Branch:
    """One posture: its name, q (n,), rad or m, and how far its tool is from the goal: missed, m, and turned, rad.

    within: whether every joint keeps its limits.
    """

    name: Text
    q: Array
    missed: float
    turned: float
    within: bool


@dataclass(frozen=True, eq=False)
class Answer:
    """Every posture for a goal.

    T_world_goal (4, 4), m: what was solved for, the asked pose or, for an arm that cannot take every pose, the nearest
    one of its subspace; moved, m, and turned, rad: from the one to the other. short: how far the goal lies beyond the
    edge of the workspace, m, 0 inside. free: joints that may take any value here (the current one was kept). words:
    what is to be said. values: what the form worked out on the way, by symbol, for one branch after another.
    """

    branches: tuple[Branch, ...]
    T_world_goal: Array
    words: Text
    moved: float = 0.0
    turned: float = 0.0
    short: float = 0.0
    free: tuple[int, ...] = ()
    values: tuple[Mapping[str, float], ...] = field(default=(MappingProxyType({}),))


class Form(Protocol):
    """A module of `ik/closed/`: a closed form for a family of arms. EQUATIONS: its steps, in TeX, in order."""

    TITLE: Text
    SOURCE: str
    EQUATIONS: tuple[str, ...]

    def applies(self, robot: Robot) -> Text | None:
        """Why the form does not apply to a robot; None where it does."""

    def solve(self, robot: Robot, T_world_tool: Array, q: Array) -> Answer:
        """Every posture for a tool pose (4, 4), m; q (n,), rad or m: kept where a joint is free."""
