"""The studies of Vargas 2013: the short form of all, the whole form of those that take a few seconds; the rest of the
whole forms is in tests/soak.
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from helicoide.ik.method import OneOf, Quantity, changed, settings
from helicoide.kinematics.library import load
from helicoide.studies import named, names
from helicoide.studies.study import Result, Row, Verdict

STUDIES = [name for name in names() if name.startswith("vargas_")]
QUICK = ["vargas_01", "vargas_02", "vargas_08", "vargas_09", "vargas_10", "vargas_13", "vargas_scalar"]


def off(result: Result) -> list[Row]:
    """The rows that are not as the digest has them, whatever would excuse it."""
    return [row for row in result.rows if row.verdict is not Verdict.AGREES]


def is_done(told: list[float]) -> bool:
    """Whether progress went from near 0 to 1, and never back."""
    return told[-1] == 1 and sorted(told) == told and told[0] <= 0.5


def test_every_simulation_is_there() -> None:
    numbers = ["01", "02", "03", "04", "05", "06", "07", "08", "09", "10", "11", "11b", "12", "13", "14", "15", "16"]
    assert {f"vargas_{number}" for number in [*numbers, "links", "scalar", "slab", "two_arms"]} <= set(STUDIES)


@pytest.mark.parametrize("name", STUDIES)
def test_the_short_form(name: str) -> None:
    study, told = named(name), list[float]()
    result = study.run(study.Options(), True, told.append)
    assert off(result) == []
    assert sum(row.digest is not None for row in result.rows) >= 2
    assert is_done(told)
    assert result.charts
    for chart in result.charts:
        for line in chart.lines:
            assert line.x.shape == line.y.shape
            assert 2 < line.x.size < 5000
            assert np.isfinite(line.x).all()
            assert np.isfinite(line.y).all()
    if result.motion is not None:
        motion = result.motion
        assert motion.robot == study.ROBOT
        robot = load(motion.robot, settings=motion.parameters)
        assert motion.q.shape == (motion.times.size, len(robot.variables))
        assert (np.diff(motion.times) > 0).all()


@pytest.mark.parametrize("name", QUICK)
def test_the_whole_form(name: str) -> None:
    study, told = named(name), list[float]()
    result = study.run(study.Options(), False, told.append)
    assert off(result) == []
    assert sum(row.digest is not None for row in result.rows) >= 4
    assert is_done(told)


@pytest.mark.parametrize("name", STUDIES)
def test_the_settings_can_be_set(name: str) -> None:
    """Each default lies within its setting, and each choice of what the arm shows is a run."""
    options = named(name).Options()
    for one in fields(options):
        assert changed(options, one.name, getattr(options, one.name)) == options
    for setting in settings(type(options)).values():
        assert isinstance(setting, Quantity | OneOf)


def test_other_settings_leave_nothing_to_compare_with() -> None:
    study = named("vargas_02")
    result = study.run(study.Options(gain=7.0), True, lambda share: None)
    assert {row.digest for row in result.rows} == {None}
    assert {row.source for row in result.rows} == {""}


def test_what_the_arm_shows_changes_nothing_else() -> None:
    study = named("vargas_15")
    options = study.Options()
    usual, other = (study.run(replace(options, shown=key), True, lambda share: None) for key in ("0.5", "0.2"))
    assert [(row.ours, row.digest) for row in usual.rows] == [(row.ours, row.digest) for row in other.rows]
    assert usual.motion is not None
    assert other.motion is not None
    assert np.abs(usual.motion.q - other.motion.q).max() > 0.1
