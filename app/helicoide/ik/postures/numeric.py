"""Numerical inverse kinematics of any arm: searches with restarts, for one posture within the limits or for all.

A goal out of reach is approached by least squares, ‖Δp‖² + (w ℓ θ)² with w ≪ 1: position outweighs orientation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.ik.postures import listing
from helicoide.ik.postures.answer import NO_VALUES, Answer, Found, Words, answer_in_order
from helicoide.ik.postures.branch import check_pose
from helicoide.ik.postures.measure import left
from helicoide.ik.postures.packed import PERIOD, UNIT, Search, behind_joints, limited, search_of, wide
from helicoide.ik.postures.restarts import approach, draw, search
from helicoide.ik.task import ORIENTATION_LENGTH
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import arm_array, tool_jacobian
from helicoide.text import Text

TITLE = Text(en="numerical search with restarts", pt_BR="busca numérica com reinícios")
SOURCE = "Chan and Lawrence 1988; Sugihara 2011; Marquardt 1963"

WITHIN, FINE = (1e-6, 1e-6), (1e-9, 1e-9)  # largest errors of one posture, and of those in a list, m and rad
STEPS, SEARCHES = 30, 400  # at most; usually 10 steps in 1 or 2 searches; the worst of 160,000 poses took 185 searches
FINE_STEPS, MOST_SEARCHES, PATIENCE = 60, 1000, 150
APPROACH_STEPS, APPROACHES = 300, 20
APART = 1e-3  # two postures differ by this in a joint, rad or ℓ; a double one is only accurate to √FINE
MOST = 16  # the largest number of listed postures
WALK, LOST = 0.05, 1e-4  # a step in the null space, rad or ℓ; σ counts as zero below this fraction of the largest

POSTURE = Text(en="posture {n}", pt_BR="postura {n}")
FOUND = Text(en="{n} posture{s} found in {searches} searches.", pt_BR="{n} postura{s} em {searches} buscas.")
ENDLESS = Text(
    en="The arm reaches the goal in infinitely many postures; {n} of them, found in {searches} searches.",
    pt_BR="O braço alcança o alvo em infinitas posturas; {n} delas, encontradas em {searches} buscas.",
)
REACHED = Text(en="Reached, in {searches} search{es}.", pt_BR="Alcançado, em {searches} busca{s}.")
MISSED = Text(
    en="The closest posture found is {mm:.3f} mm and {degrees:.3f}° from the goal.",
    pt_BR="A postura mais próxima encontrada fica a {mm:.3f} mm e {degrees:.3f}° do alvo.",
)
LIMITED = Text(
    en="Only postures outside the joint limits reach the goal; the closest within them is {mm:.3f} mm and "
    "{degrees:.3f}° from it.",
    pt_BR="Só posturas fora dos limites das juntas alcançam o alvo; a mais próxima dentro deles fica a {mm:.3f} mm e "
    "{degrees:.3f}°.",
)


@lru_cache(maxsize=32)
def _within_limits(robot: Robot, with_orientation: bool) -> Search:
    """The search for one posture within the limits."""
    return search_of(robot, limited(robot), float(with_orientation), WITHIN, STEPS, SEARCHES)


@lru_cache(maxsize=32)
def _anywhere(robot: Robot, with_orientation: bool) -> Search:
    """A single search for a posture, within the limits or not."""
    return search_of(robot, wide(robot), float(with_orientation), FINE, FINE_STEPS, 1)


@lru_cache(maxsize=32)
def _towards(robot: Robot, with_orientation: bool) -> Search:
    """The search for the posture within the limits that is nearest to a goal."""
    weight = ORIENTATION_LENGTH * with_orientation
    return search_of(robot, limited(robot), weight, WITHIN, APPROACH_STEPS, APPROACHES)


def first_posture(robot: Robot, T_world_tool: Array, q: Array, with_orientation: bool = True) -> Array:
    """The first posture found within the limits, to 10⁻⁶ m and rad; the first search starts at q.

    Args: T_world_tool (4, 4), m; q (n,), rad or m; both unchecked. Returns (n + 4,), as `restarts.search` writes it.
    """
    of = _within_limits(robot, with_orientation)
    answer = np.empty(of.answer)
    # numba would compile the kernel again for arrays that are not contiguous
    search(of.table, np.ascontiguousarray(T_world_tool), np.ascontiguousarray(q), np.zeros(of.buffers), answer)
    return answer


def solve_numerically(robot: Robot, T_world_tool: ArrayLike, q: ArrayLike, with_orientation: bool = True) -> Answer:
    """One posture within the limits; the nearest that was found where none reaches the goal.

    Args: T_world_tool (4, 4), m; q (n,), rad or m: the start of the first search; with_orientation: False for the
    position alone. Raises HelicoideError for an invalid pose, or unless q has n finite values.
    """
    goal, start = check_pose(T_world_tool), robot.check_joints(q)
    return answer_in_order(robot, one(robot, goal, start, with_orientation), goal, start, with_orientation)


def branches(robot: Robot, T_world_tool: ArrayLike, q: ArrayLike, with_orientation: bool = True) -> Answer:
    """Every posture that restarts find, within the limits or not, to 10⁻⁹ m and rad, the nearest first.

    Some of them where there are infinitely many; the nearest one within the limits where none is found.
    Arguments and errors as in `solve_numerically`.
    """
    goal, start = check_pose(T_world_tool), robot.check_joints(q)
    return answer_in_order(robot, every(robot, goal, start, with_orientation), goal, start, with_orientation)


def one(robot: Robot, goal: Array, start: Array, with_orientation: bool) -> Found:
    """`solve_numerically` as a `Found`; arguments are not checked."""
    found = first_posture(robot, goal, start, with_orientation)
    if found[-4] == np.inf:
        return _nearest(robot, goal, start, with_orientation)
    return Found(found[None], goal, Reached(int(found[-1])))


def every(robot: Robot, goal: Array, start: Array, with_orientation: bool) -> Found:
    """`branches` as a `Found`; arguments are not checked."""
    rows, searches = distinct_postures(robot, goal, start, with_orientation, MOST)
    if not len(rows):
        return _nearest(robot, goal, start, with_orientation)
    endless = any(_is_endless(robot, row, goal, with_orientation) for row in rows)
    words = (ENDLESS if endless else FOUND).format(n=len(rows), s="s"[: len(rows) > 1], searches=searches)
    ordered = listing.listed_in_order(robot, rows, goal, goal, start, with_orientation)
    rows = rows[listing.column(ordered, listing.NUMBER).astype(int)]
    return Found(rows, goal, Words([POSTURE.format(n=n + 1) for n in range(len(rows))], words))


@dataclass(frozen=True)
class Reached:
    """The texts for one posture, found in this number of searches."""

    searches: int
    values: Sequence[Mapping[str, float]] = (NO_VALUES,)
    free: tuple[int, ...] = ()

    @cached_property
    def names(self) -> Sequence[Text]:
        """The name of the one posture."""
        return (POSTURE.format(n=1),)

    @cached_property
    def words(self) -> Text:
        """The number of searches, in a sentence."""
        more = self.searches > 1
        return REACHED.format(searches=self.searches, es="es"[: 2 * more], s="s"[:more])


def distinct_postures(robot: Robot, goal: Array, start: Array, with_orientation: bool, most: int) -> tuple[Array, int]:
    """Different postures (k, n), within the limits or not, and the number of searches; arguments are not checked.

    The search ends with `most` postures, after `MOST_SEARCHES`, or after `PATIENCE` repeated ones since the last new.
    """
    of, found, again, number = _anywhere(robot, with_orientation), np.empty((0, start.size)), 0, 0
    q = start.copy()
    while number < MOST_SEARCHES and len(found) < most and again < PATIENCE:
        reached = _fine(of, goal, q)
        if reached is not None and _is_known(of, reached, found):
            again += 1
        elif reached is not None:
            found, again = np.vstack([found, reached]), 0
        number += 1
        draw(of.table, number, q)
    return found, number


def _fine(of: Search, goal: Array, q: Array) -> Array | None:
    """The posture that one search from q finds, within the limits or not; None after a failure."""
    found = np.empty(of.answer)
    search(of.table, goal, q, np.zeros(of.buffers), found)
    return found[:-4] if found[-4] < np.inf else None


def _is_known(of: Search, q: Array, found: Array, difference: float = APART) -> bool:
    """Whether q is a row of found (k, n): every joint differs by less than `apart`, rad or ℓ, full turns removed."""
    ranges, ways = of.table[behind_joints(of.table) :], found - q
    ways -= ranges[:, PERIOD] * np.round(ways / np.where(ranges[:, PERIOD] > 0, ranges[:, PERIOD], np.inf))
    return bool((np.abs(ways) < difference * ranges[:, UNIT]).all(axis=1).any())


def _nearest(robot: Robot, goal: Array, start: Array, with_orientation: bool) -> Found:
    """The nearest posture within the limits; the words say whether others reach the goal."""
    q = approached(_towards(robot, with_orientation), goal, start)
    missed, turned = left(robot, q, goal, with_orientation)
    beyond_limits = len(distinct_postures(robot, goal, start, with_orientation, 1)[0]) > 0
    words = (LIMITED if beyond_limits else MISSED).format(mm=1000 * missed, degrees=np.degrees(turned))
    return Found(q[None], goal, Words((POSTURE.format(n=1),), words), short=missed)


def approached(of: Search, goal: Array, start: Array) -> Array:
    """The posture (n,) of `restarts.approach`."""
    answer = np.empty((3, start.size))
    approach(of.table, goal, start, np.zeros(of.buffers), answer)
    return np.asarray(answer[0])


def _is_endless(robot: Robot, q: Array, goal: Array, with_orientation: bool) -> bool:
    """Whether a posture (n,) is one of infinitely many: a step in the null space of J leads to another solution."""
    of = _anywhere(robot, with_orientation)
    units = of.table[behind_joints(of.table) :, UNIT]
    J = tool_jacobian(arm_array(robot), q)[: 6 if with_orientation else 3] * units
    J[:3] /= robot.reach
    _, sigma, Vt = np.linalg.svd(J)
    for way in Vt[np.count_nonzero(sigma > LOST * sigma[0]) :] * units:
        walked = _fine(of, goal, q + WALK * way)
        if walked is not None and not _is_known(of, walked, q[None], WALK / 4):
            return True
    return False
