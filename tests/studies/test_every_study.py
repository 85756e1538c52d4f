"""The contract of every study, found by its file and run as a quick run."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest
from tests.studies.record import FOLDER, numbers, recorded

from helicoide import studies
from helicoide.contributions.studies import result_faults
from helicoide.contributions.studies import study_description_faults as described_faults
from helicoide.export.study_json import study_json
from helicoide.export.study_report import Record
from helicoide.studies.study import Result
from helicoide.text import HelicoideError

NAMES = studies.study_names()
RECORDED = sorted(file.stem for file in FOLDER.glob("*.json"))  # a study that was added may not be recorded yet


@cache
def short(name: str) -> tuple[Result, tuple[float, ...]]:
    """The result of a quick run, and the progress that it reported."""
    shares: list[float] = []
    study = studies.study_named(name)
    return study.run(study.Options(), True, shares.append), tuple(shares)


def test_there_are_studies() -> None:
    assert len([name for name in NAMES if name.startswith("cerbaro_")]) >= 12


def test_an_unknown_study_is_refused_with_the_names() -> None:
    with pytest.raises(HelicoideError, match=r"'nothing'.*cerbaro_redundancy"):
        studies.study_named("nothing")


@pytest.mark.parametrize("name", NAMES)
def test_a_study_says_what_it_is_in_both_languages(name: str) -> None:
    assert [fault.en for fault in described_faults(studies.study_named(name))] == []


@pytest.mark.parametrize("name", NAMES)
def test_what_comes_out_is_whole(name: str) -> None:
    """Rows, verdicts, charts and motions, as `helicoide check` asks."""
    assert [fault.en for fault in result_faults(short(name)[0])] == []


@pytest.mark.parametrize("name", RECORDED)
def test_its_numbers_are_those_that_were_recorded(name: str) -> None:
    assert numbers(short(name)[0]) == pytest.approx(recorded(name), rel=5e-3, abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_it_can_be_written_as_json(name: str) -> None:
    study = studies.study_named(name)
    record = Record(name, study, study.Options(), True, short(name)[0], None, 1.0)
    assert json.loads(json.dumps(study_json(record), allow_nan=False))["rows"]


@pytest.mark.parametrize("name", NAMES)
def test_its_progress_goes_on(name: str) -> None:
    shares = np.array(short(name)[1])
    assert (shares >= 0).all()
    assert (shares <= 1).all()
    assert (np.diff(shares) >= 0).all()
