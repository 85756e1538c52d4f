"""What a person has before them of the studies: choosing, setting, running, comparing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helicoide.studies import panel_state, study_names
from helicoide.studies.panel_state import NO_STUDY, CompletedRun, StudyPanelState
from helicoide.studies.study import Result, Row
from helicoide.text import HelicoideError, Text, untranslated


def ended(name: str, ours: float) -> CompletedRun:
    return CompletedRun(name, None, True, Result((Row(untranslated("x"), ours),)))


@pytest.fixture
def chosen() -> StudyPanelState:
    return panel_state.with_study(study_names()[0])(NO_STUDY)


def test_an_unknown_study_is_refused_with_those_there_are() -> None:
    with pytest.raises(HelicoideError, match=study_names()[0]):
        panel_state.with_study("magic")


def test_nothing_runs_without_a_study() -> None:
    assert panel_state.with_run_started(NO_STUDY) is NO_STUDY


def test_a_run_begins_tells_and_ends(chosen: StudyPanelState) -> None:
    running = panel_state.with_run_started(chosen)
    assert running.progress == 0.0
    assert panel_state.with_run_started(running) is running
    assert panel_state.with_progress(0.5)(running).progress == 0.5
    run = ended(chosen.study, 1.0)
    done = panel_state.with_result(run)(running)
    assert done.progress is None
    assert done.shown_runs == (run,)
    assert panel_state.with_progress(0.7)(done).progress is None, "what comes late is not heard"


def test_two_runs_of_one_study_are_compared(chosen: StudyPanelState) -> None:
    first, second = ended(chosen.study, 1.0), ended(chosen.study, 2.0)
    both = replace(panel_state.with_result(second)(panel_state.with_result(first)(chosen)), compares_previous=True)
    assert both.shown_runs == (second, first)
    other = panel_state.with_study(study_names()[1])(both)
    assert other.shown_runs == ()


def test_a_failure_is_kept_until_the_next_start(chosen: StudyPanelState) -> None:
    failed = panel_state.with_failure(Text(en="no", pt_BR="não"))(panel_state.with_run_started(chosen))
    assert failed.progress is None
    assert failed.failure is not None
    assert panel_state.with_run_started(failed).failure is None


def test_settings_are_kept_for_each_study_and_refused_in_words() -> None:
    desk = panel_state.with_study("cerbaro_confined_ellipse")(NO_STUDY)
    name = next(iter(type(desk.current_options()).__dataclass_fields__))
    with pytest.raises(HelicoideError):
        panel_state.with_study_option(name, np.nan)(desk)
    with pytest.raises(HelicoideError):
        panel_state.with_study_option("nonsense", 1)(desk)
    away = panel_state.with_study("cerbaro_confined_ellipse")(panel_state.with_study(study_names()[0])(desk))
    assert away.current_options() == desk.current_options()
