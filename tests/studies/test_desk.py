"""What a person has before them of the studies: choosing, setting, running, comparing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helicoide.studies import desk as desks
from helicoide.studies import names
from helicoide.studies.desk import EMPTY, Desk, Run
from helicoide.studies.study import Result, Row
from helicoide.text import HelicoideError, Text, same


def ended(name: str, ours: float) -> Run:
    return Run(name, None, True, Result((Row(same("x"), ours),)))


@pytest.fixture
def chosen() -> Desk:
    return desks.choose(names()[0])(EMPTY)


def test_an_unknown_study_is_refused_with_those_there_are() -> None:
    with pytest.raises(HelicoideError, match=names()[0]):
        desks.choose("magic")


def test_nothing_runs_without_a_study() -> None:
    assert desks.start(EMPTY) is EMPTY


def test_a_run_begins_tells_and_ends(chosen: Desk) -> None:
    running = desks.start(chosen)
    assert running.progress == 0.0
    assert desks.start(running) is running
    assert desks.told(0.5)(running).progress == 0.5
    run = ended(chosen.study, 1.0)
    done = desks.done(run)(running)
    assert done.progress is None
    assert done.shown == (run,)
    assert desks.told(0.7)(done).progress is None, "what comes late is not heard"


def test_two_runs_of_one_study_are_compared(chosen: Desk) -> None:
    first, second = ended(chosen.study, 1.0), ended(chosen.study, 2.0)
    both = replace(desks.done(second)(desks.done(first)(chosen)), compared=True)
    assert both.shown == (second, first)
    other = desks.choose(names()[1])(both)
    assert other.shown == ()


def test_a_failure_is_kept_until_the_next_start(chosen: Desk) -> None:
    failed = desks.failed(Text(en="no", pt_BR="não"))(desks.start(chosen))
    assert failed.progress is None
    assert failed.failure is not None
    assert desks.start(failed).failure is None


def test_settings_are_kept_for_each_study_and_refused_in_words() -> None:
    desk = desks.choose("cerbaro_confined_ellipse")(EMPTY)
    name = next(iter(type(desk.chosen()).__dataclass_fields__))
    with pytest.raises(HelicoideError):
        desks.set_option(name, np.nan)(desk)
    with pytest.raises(HelicoideError):
        desks.set_option("nonsense", 1)(desk)
    away = desks.choose("cerbaro_confined_ellipse")(desks.choose(names()[0])(desk))
    assert away.chosen() == desk.chosen()
