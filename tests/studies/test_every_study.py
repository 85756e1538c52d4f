"""What every study holds to, whoever wrote it: found by its file, run in its short form."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from helicoide import studies
from helicoide.ik.method import OneOf, Quantity, changed, settings
from helicoide.kinematics.library import load
from helicoide.studies.study import Result, Verdict
from helicoide.text import HelicoideError, Text

NAMES = studies.names()


@cache
def short(name: str) -> tuple[Result, tuple[float, ...]]:
    """The result of the short form, and the shares that it told."""
    shares: list[float] = []
    study = studies.named(name)
    return study.run(study.Options(), True, shares.append), tuple(shares)


def texts(result: Result) -> list[Text]:
    charts = [text for c in result.charts for text in (c.title, c.across, c.up, *(line.title for line in c.lines))]
    return [*(row.quantity for row in result.rows), *charts]


def test_there_are_studies() -> None:
    assert len([name for name in NAMES if name.startswith("cerbaro_")]) == 11


def test_an_unknown_study_is_refused_with_the_names() -> None:
    with pytest.raises(HelicoideError, match=r"'nothing'.*cerbaro_redundancy"):
        studies.named("nothing")


@pytest.mark.parametrize("name", NAMES)
def test_a_study_says_what_it_is_in_both_languages(name: str) -> None:
    study = studies.named(name)
    assert study.TITLE.en.strip()
    assert study.TITLE.pt_BR.strip()
    assert study.ABOUT.en != study.ABOUT.pt_BR
    assert min(study.ABOUT.en.count("."), study.ABOUT.pt_BR.count(".")) >= 2
    assert any(year in study.SOURCE for year in ("1998", "2013", "2015", "2022"))
    assert load(study.ROBOT).name == study.ROBOT


@pytest.mark.parametrize("name", NAMES)
def test_its_options_are_settings_whose_defaults_are_valid(name: str) -> None:
    options = studies.named(name).Options()
    for field, setting in settings(type(options)).items():
        assert changed(options, field, getattr(options, field)) == options
        assert setting.title.en
        assert setting.title.pt_BR
        if isinstance(setting, Quantity | OneOf):
            with pytest.raises(HelicoideError):
                changed(options, field, "nothing of the kind")


@pytest.mark.parametrize("name", NAMES)
def test_its_short_form_differs_nowhere_without_excuse(name: str) -> None:
    result, _ = short(name)
    assert result.rows
    assert [(row.quantity.en, row.ours, row.digest) for row in result.rows if row.verdict is Verdict.DIFFERS] == []
    assert any(row.digest is not None for row in result.rows)


@pytest.mark.parametrize("name", NAMES)
def test_its_rows_are_numbers_and_named_once(name: str) -> None:
    result, _ = short(name)
    assert not np.isnan([row.ours for row in result.rows]).any()
    named = [(row.quantity, row.relation, row.digest) for row in result.rows]
    assert len(named) == len(set(named))
    for text in texts(result):
        assert text.en.strip()
        assert text.pt_BR.strip()
    assert any(text.en != text.pt_BR for text in texts(result))


@pytest.mark.parametrize("name", NAMES)
def test_its_charts_have_data(name: str) -> None:
    result, _ = short(name)
    assert result.charts
    for line in (line for chart in result.charts for line in chart.lines):
        assert line.x.shape == line.y.shape
        assert line.x.ndim == 1
        assert len(line.x) >= 2
        assert np.isfinite([line.x, line.y]).all()


@pytest.mark.parametrize("name", NAMES)
def test_its_motion_is_one_of_its_robot(name: str) -> None:
    motion = short(name)[0].motion
    if motion is not None:
        robot = load(motion.robot, None, motion.parameters)
        assert motion.q.shape == (len(motion.times), len(robot.variables))
        assert np.isfinite(motion.q).all()
        assert (np.diff(motion.times) > 0).all()


@pytest.mark.parametrize("name", NAMES)
def test_its_progress_goes_on(name: str) -> None:
    shares = np.array(short(name)[1])
    assert (shares >= 0).all()
    assert (shares <= 1).all()
    assert (np.diff(shares) >= 0).all()
