"""The studies of Campos' slides: what the slides print holds, but for the first rows of a table; and it can fail."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from tests.studies.test_every_study import short

from helicoide import studies
from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import dual_quaternions, motoman_l3, puma560, screws
from helicoide.ik.families import elbow, paden_kahan
from helicoide.ik.method import settings
from helicoide.ik.postures import choice, numeric, subspace
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.library import load_robot
from helicoide.studies import campos_dexterous, campos_table
from helicoide.studies.study import Result, Statement, Verdict
from helicoide.text import LANGUAGES

NAMES = tuple(name for name in studies.study_names() if name.startswith("campos_"))
# Whole forms that take ten seconds at most; the others are in the soak.
QUICK = ("campos_dexterous", "campos_projection")
ERRATA = {"campos_table": ["campos-1", "campos-2", "campos-1"]}
# How many sentences of the slides each study holds against a number.
STATED = {
    "campos_dexterous": 3,
    "campos_families": 4,
    "campos_l3": 1,
    "campos_planar3r": 6,
    "campos_projection": 9,
    "campos_puma": 6,
    "campos_table": 5,
    "campos_workspaces": 12,
}


def held(name: str, result: Result) -> None:
    """Every statement is as printed, but for those of which the page of the sources says that they do not hold."""
    stated = [row for row in result.rows if isinstance(row.source, Statement)]
    assert len(stated) == STATED[name]
    assert [row.erratum for row in stated if row.verdict is Verdict.ERRATUM] == ERRATA.get(name, [])
    met = (Verdict.PRINTED, Verdict.FITTED, Verdict.ERRATUM)
    others = [row for row in stated if row.given is None and row.verdict not in met]
    assert others == []


def ran(name: str, short: bool, **options: Any) -> Result:
    """A study's result; it has told its progress to the end."""
    study = studies.study_named(name)
    shares: list[float] = []
    result = studies.run_study(name, study.Options(**options), short, shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    return result


def test_all_are_there() -> None:
    assert tuple(STATED) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_what_the_slides_print_holds_in_the_short_form(name: str) -> None:
    held(name, short(name)[0])


@pytest.mark.parametrize("name", QUICK)
def test_what_the_slides_print_holds_in_the_whole_form(name: str) -> None:
    held(name, ran(name, short=False))


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("campos_workspaces", {"l1": 0.7, "l2": 1.0}),
        ("campos_workspaces", {"l1": 0.8, "l2": 0.8}),
        ("campos_dexterous", {"l3": 0.4}),
        ("campos_projection", {"goals": 300}),
    ],
    ids=str,
)
def test_with_other_settings_every_number_stands_alone(name: str, options: dict[str, Any]) -> None:
    assert {row.verdict for row in ran(name, short=True, **options).rows} == {Verdict.OURS}


@pytest.mark.parametrize("name", NAMES)
def test_words_and_settings(name: str) -> None:
    study = studies.study_named(name)
    assert study.SOURCE.startswith("Campos 1998")
    assert 1 <= len(settings(study.Options)) <= 2
    for language in LANGUAGES:
        assert 2 <= study.ABOUT[language].count(". ") + 1 <= 3


def test_the_hand_of_the_dexterous_arm_stays_at_one_metre() -> None:
    (motion,) = short("campos_dexterous")[0].motions
    robot = load_robot(campos_dexterous.ROBOT, settings=motion.parameters)
    points = np.array([tool_at(robot, q)[:3, 3] for q in motion.q])
    np.testing.assert_allclose(points, np.tile([1.0, 0, 0], (len(points), 1)), atol=1e-12)
    assert motion.q.sum(axis=1)[-1] - motion.q.sum(axis=1)[0] == pytest.approx(2 * np.pi)


@pytest.mark.parametrize(("zeros", "bound"), campos_table.ROWS)
def test_the_arm_that_is_known_is_of_its_row_and_its_postures_are_real(zeros: tuple[int, ...], bound: int) -> None:
    robot = campos_table.known_arm(zeros)
    goal = np.ascontiguousarray(tool_at(robot, campos_table.POSTURE))
    found, _ = numeric.distinct_postures(robot, goal, np.zeros(6), True, campos_table.ENDLESS)
    assert len(found) == 16 >= bound
    assert max(float(np.abs(tool_at(robot, q) - goal).max()) for q in found) < 1e-8
    apart = [np.abs(wrap(one - other)).max() for i, one in enumerate(found) for other in found[:i]]
    assert min(apart) > 0.01
    assert [a == 0 for a in (row.a for row in robot.dh.rows[1:])] == [i in zeros for i in range(1, 6)]


# A change of the law under study turns a row red.


@cache
def red(name: str) -> frozenset[str]:
    """The quantities that are not as printed, as the code is."""
    return frozenset(
        row.quantity.en for row in short(name)[0].rows if row.verdict in (Verdict.DIFFERS, Verdict.ERRATUM)
    )


def turns_red(name: str) -> set[str]:
    """The rows that differ by a law that is wrong; `red` has been asked with the right one."""
    study = studies.study_named(name)
    result = study.run(study.Options(), True, lambda share: None)
    return {row.quantity.en for row in result.rows if row.verdict in (Verdict.DIFFERS, Verdict.ERRATUM)} - red(name)


def other_sign(x: float, y: float, links: elbow.Annulus, sign: int, kept: float) -> elbow.Geometric:
    """θ₁ = β ∓ ψ for β ± ψ."""
    right = GEOMETRIC(x, y, links, sign, kept)
    return replace(right, psi=-right.psi, theta1=2 * right.beta - right.theta1)


def mirrored(axis: paden_kahan.Axis, p: Array, q: Array, kept: float) -> float:
    """Subproblem 1 with the sine turned."""
    return -TURN_TO(axis, p, q, kept)


def without_flip(*arm_and_goal: Any) -> Array:
    """The PUMA without θ₅' = −θ₅."""
    rows = POSTURES(*arm_and_goal)
    rows[rows[:, 6] % 2 == 1, 4] *= -1
    return rows


def unweighted(robot: Any, branches: Any, q: Array, weights: Any, collides: Any = lambda q: False) -> Any:
    return RANKED(robot, branches, q, np.ones(3), collides)


def no_projection(robot: Any, T: Array, q: Array) -> subspace.Projection:
    return subspace.Projection(frozen(T), 0.0, 0.0)


def one_sided(L: Array, measure: Callable[[Array], float], kept: float) -> list[float]:
    """Of the two roots of the quadratic form the first."""
    return HALVES(L, measure, kept)[:1]


def two_everywhere(links: elbow.Annulus, r: float) -> tuple[int, ...]:
    """Two postures on an edge, too."""
    return () if links.beyond(r) else (1, -1)


def short_of_two(r: float, l1: float, l2: float, turns: int) -> float:
    """A second link that is 1 % shorter."""
    return SHARE(r, l1, 0.99 * l2, turns)


def turned_further(robot: Any, T: Array, q: Array) -> Any:
    """A turn that goes as far again beyond the plane."""
    right = POINTED(robot, T, q)
    return replace(right, sine=np.sin(2 * right.angle), cosine=np.cos(2 * right.angle))


SHARE, POINTED = campos_dexterous.two_link_share, motoman_l3.pointed
GEOMETRIC, TURN_TO, POSTURES, RANKED = elbow.geometric, paden_kahan.turn_to, puma560.puma_joint_values, choice.ranked
HALVES = dual_quaternions.halves

MUTATIONS = [
    ("campos_planar3r", elbow, "geometric", other_sign, "largest difference of algebra and geometry"),
    ("campos_planar3r", choice, "ranked", unweighted, "how much less joint 1 turns"),
    ("campos_families", elbow, "geometric", other_sign, "PUMA, geometry: farthest posture"),
    (
        "campos_families",
        dual_quaternions,
        "halves",
        one_sided,
        "PUMA: postures for each goal by the family that finds the fewest",
    ),
    ("campos_puma", puma560, "puma_joint_values", without_flip, "postures of ten poses that only one"),
    (
        "campos_projection",
        subspace,
        "project_to_subspace",
        no_projection,
        "random goals that the arm takes as they are",
    ),
    ("campos_workspaces", elbow.Annulus, "elbows", two_everywhere, "postures on the outer edge"),
    ("campos_dexterous", campos_dexterous, "two_link_share", short_of_two, "dexterous points of two equal links"),
    ("campos_l3", motoman_l3, "pointed", turned_further, "how much farther the goal would be turned"),
]


@pytest.mark.parametrize(
    ("name", "module", "law", "wrong", "row"), MUTATIONS, ids=[f"{name}-{law}" for name, _, law, *_ in MUTATIONS]
)
def test_a_wrong_law_turns_a_row_red(
    monkeypatch: pytest.MonkeyPatch, name: str, module: Any, law: str, wrong: Any, row: str
) -> None:
    red(name)
    monkeypatch.setattr(module, law, wrong)
    assert any(quantity.startswith(row) for quantity in turns_red(name))


def test_a_search_that_ends_early_turns_the_table_right(monkeypatch: pytest.MonkeyPatch) -> None:
    """The counts are made, not looked up: with three postures at most no row would be exceeded."""
    monkeypatch.setattr(campos_table, "ENDLESS", 3)
    assert {row.computed for row in ran("campos_table", short=True).rows[:5]} == {3}


def test_a_wrong_subproblem_shows_in_the_residual_of_the_screws(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(screws, "turn_to", mirrored)
    robot = load_robot("puma560")
    T = tool_at(robot, frozen([0.3, -0.5, 0.7, 0.4, 0.9, -1.1]))
    branches = closed.solve_closed_form(closed.closed_forms()["screws"], robot, T, np.zeros(6)).branches
    assert max(branch.turned for branch in branches) > 0.1
