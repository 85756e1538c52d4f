"""The studies of Campos' slides: counts, workspaces, the table with its doubt, projections."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helicoide import studies
from helicoide.ik.method import settings
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.library import load
from helicoide.studies import campos_dexterous, campos_table
from helicoide.studies.study import Result, Verdict
from helicoide.text import LANGUAGES

NAMES = tuple(name for name in studies.names() if name.startswith("campos_"))
# Whole forms that take ten seconds at most; the others are in the soak.
QUICK = ("campos_dexterous", "campos_projection")
DOUBTS = {"campos_table": 2}


def ran(name: str, short: bool, **options: Any) -> Result:
    """A study's result; it has told its progress to the end, and every row agrees but those that are doubted."""
    study = studies.named(name)
    shares: list[float] = []
    result = study.run(study.Options(**options), short, shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    verdicts = [row.verdict for row in result.rows]
    others = [(row.quantity.en, row.ours, row.digest) for row in result.rows if row.verdict is not Verdict.AGREES]
    assert verdicts.count(Verdict.DOUBT) == DOUBTS.get(name, 0), others
    assert verdicts.count(Verdict.AGREES) == len(verdicts) - DOUBTS.get(name, 0), others
    return result


def test_all_are_there() -> None:
    names = ("dexterous", "l3", "planar3r", "projection", "puma", "table", "workspaces")
    assert tuple(f"campos_{name}" for name in names) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_short_forms_agree(name: str) -> None:
    result = ran(name, short=True)
    assert all(row.digest is not None for row in result.rows)
    assert result.charts
    if result.motion is not None:
        robot = load(result.motion.robot, settings=result.motion.parameters)
        assert result.motion.q.shape == (len(result.motion.times), len(robot.variables))
        assert (np.diff(result.motion.times) > 0).all()


@pytest.mark.parametrize("name", QUICK)
def test_whole_forms_agree(name: str) -> None:
    ran(name, short=False)


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("campos_planar3r", {"weights": "alike"}),
        ("campos_workspaces", {"l1": 0.7, "l2": 1.0}),
        ("campos_workspaces", {"l1": 0.8, "l2": 0.8}),
        ("campos_dexterous", {"l3": 0.4}),
    ],
    ids=str,
)
def test_other_settings_agree_too(name: str, options: dict[str, Any]) -> None:
    ran(name, short=True, **options)


@pytest.mark.parametrize("name", NAMES)
def test_words_and_settings(name: str) -> None:
    study = studies.named(name)
    assert study.SOURCE.startswith("Campos 1998")
    assert load(study.ROBOT).name == study.ROBOT
    assert 1 <= len(settings(study.Options)) <= 2
    for language in LANGUAGES:
        assert 2 <= study.ABOUT[language].count(". ") + 1 <= 3


def test_the_table_is_doubted_where_it_fails() -> None:
    """s.22 prints at most 4 for a1 = a3 = a5 = 0; there are arms with 8 and with 16."""
    doubted = [row for row in ran("campos_table", short=True).rows if row.verdict is Verdict.DOUBT]
    assert [(row.digest, row.ours) for row in doubted] == [(4, 8), (4, 16)]


def test_postures_are_counted_once_and_only_at_the_pose() -> None:
    robot, postures = campos_table.sixteen()
    assert campos_table.distinct(robot, np.concatenate([postures, postures[:3] + 2 * np.pi, postures[:2] + 0.1])) == 16


def test_the_hand_of_the_dexterous_arm_stays_at_one_metre() -> None:
    result = ran("campos_dexterous", short=True)
    assert result.motion is not None
    robot = load(campos_dexterous.ROBOT, settings=result.motion.parameters)
    points = np.array([tool_at(robot, q)[:3, 3] for q in result.motion.q])
    np.testing.assert_allclose(points, np.tile([1.0, 0, 0], (len(points), 1)), atol=1e-12)
    assert result.motion.q.sum(axis=1)[-1] - result.motion.q.sum(axis=1)[0] == pytest.approx(2 * np.pi)
