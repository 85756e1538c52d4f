"""The contract of every study, found by its file and run as a quick run."""

from __future__ import annotations

import json
import re
from functools import cache

import numpy as np
import pytest
from tests.studies.record import numbers, recorded

from helicoide import studies
from helicoide.export import errata
from helicoide.export.study_json import described
from helicoide.export.study_report import Record
from helicoide.ik.method import OneOf, Quantity, changed, settings
from helicoide.kinematics.library import load
from helicoide.studies.study import Fitted, Result, Statement, Verdict
from helicoide.text import LANGUAGES, HelicoideError, Language, Text

NAMES = studies.names()
BOUND = re.compile(r"(?P<sign>[<≤>≥])\s*(?P<number>[-−]?\d+(?:\.\d+)?)(?:\s.*)?")


@cache
def short(name: str) -> tuple[Result, tuple[float, ...]]:
    """The result of a quick run, and the progress that it reported."""
    shares: list[float] = []
    study = studies.named(name)
    return study.run(study.Options(), True, shares.append), tuple(shares)


def texts(result: Result) -> list[Text]:
    charts = [text for c in result.charts for text in (c.title, c.across, c.up, *(line.title for line in c.lines))]
    return [*(row.quantity for row in result.rows), *charts]


def test_there_are_studies() -> None:
    assert len([name for name in NAMES if name.startswith("cerbaro_")]) >= 12


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
def test_its_numbers_are_those_that_were_recorded(name: str) -> None:
    assert numbers(short(name)[0]) == pytest.approx(recorded(name), rel=5e-3, abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_what_differs_says_why_and_what_is_fitted_holds_around_its_value(name: str) -> None:
    result, _ = short(name)
    assert result.rows
    assert [row.quantity.en for row in result.rows if row.verdict is Verdict.DIFFERS and row.why is None] == []
    for value in (chosen for chosen in result.fitted if isinstance(chosen, Fitted)):
        assert min(value.least, value.most) <= value.value - 0.05 * abs(value.value), value
        assert max(value.least, value.most) >= value.value + 0.05 * abs(value.value), value


@pytest.mark.parametrize("name", NAMES)
def test_no_number_is_as_printed_against_the_bound_that_is_printed(name: str) -> None:
    """By the words themselves: "< 1.2", "≥ 80", "0.0246"."""
    for row in short(name)[0].rows:
        if isinstance(row.source, Statement) and (read := BOUND.fullmatch(row.source.words.en)):
            bound = float(read["number"].replace("−", "-"))
            breaks = {"<": row.ours >= bound, "≤": row.ours > bound, ">": row.ours <= bound, "≥": row.ours < bound}
            assert not (row.verdict in (Verdict.PRINTED, Verdict.FITTED) and breaks[read["sign"]]), row


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_every_erratum_that_it_names_is_on_the_page(name: str, language: Language) -> None:
    for row in short(name)[0].rows:
        if row.erratum:
            assert f'id="{row.erratum}"' in errata.page(language)


@pytest.mark.parametrize("name", NAMES)
def test_its_rows_are_numbers_and_named_once(name: str) -> None:
    result, _ = short(name)
    assert not np.isnan([row.ours for row in result.rows]).any()
    named = [(row.quantity, row.unit) for row in result.rows]
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
def test_its_motions_are_of_a_robot_and_have_names_of_their_own(name: str) -> None:
    motions = short(name)[0].motions
    assert len({motion.title for motion in motions}) == len(motions)
    for motion in motions:
        robot = load(motion.robot, None, motion.parameters)
        assert motion.q.shape == (len(motion.times), len(robot.variables))
        assert np.isfinite(motion.q).all()
        assert (np.diff(motion.times) > 0).all()


@pytest.mark.parametrize("name", NAMES)
def test_it_can_be_written_as_json(name: str) -> None:
    study = studies.named(name)
    record = Record(name, study, study.Options(), True, short(name)[0], None, 1.0)
    assert json.loads(json.dumps(described(record), allow_nan=False))["rows"]


@pytest.mark.parametrize("name", NAMES)
def test_its_progress_goes_on(name: str) -> None:
    shares = np.array(short(name)[1])
    assert (shares >= 0).all()
    assert (shares <= 1).all()
    assert (np.diff(shares) >= 0).all()
