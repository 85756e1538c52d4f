"""The studies of Vargas 2013: that their rows see the laws that they are about, and the whole forms that take no time;
the rest of the whole forms is in tests/soak.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from helicoide.ik import clik, filtered_inverse, scalar_filter
from helicoide.ik.method import Task
from helicoide.ik.methods import damped_by_manipulability, feedback, filtered, filtered_modified
from helicoide.ik.objectives import ellipsoid, joint_barrier
from helicoide.studies import run_study, study_named, study_names
from helicoide.studies.study import Result, Row, Verdict

STUDIES = [name for name in study_names() if name.startswith("vargas_")]
QUICK = ["vargas_08", "vargas_09", "vargas_matrix", "vargas_scalar"]


def differing(result: Result) -> list[Row]:
    """The rows that are not as they are printed."""
    return [row for row in result.rows if row.verdict in (Verdict.DIFFERS, Verdict.ERRATUM)]


def short(name: str) -> Result:
    """A quick run."""
    study = study_named(name)
    return study.run(study.Options(), True, lambda share: None)


def test_every_simulation_is_there() -> None:
    numbers = ["01", "02", "03", "04", "05", "06", "07", "08", "09", "10", "11", "11b", "12", "13", "14", "15", "16"]
    assert {f"vargas_{number}" for number in [*numbers, "links", "matrix", "scalar", "slab", "two_arms"]} == set(
        STUDIES
    )


# Recomputed from the formulas of the source by another integrator: parts of titles, and numbers.
RECOMPUTED = {
    "vargas_08": {"θ after 10 s: k = 0.5": 2.0, "θ after 10 s: k = 2": 3.8321, "θ after 60 s": 3.963},
    "vargas_09": {
        "largest error: u = θν, β = 10": 1.363,
        "largest error: u = θν, β = 1000": 0.1496,
        "largest u: u = θν, β = 100": 7.67,
        "largest θ: u = θν, β = 1000": 8.715,
        "largest error: u = θ²kν, β = 10": 0.368,
        "largest u: u = θ²kν, β = 1000": 7.427,
    },
    "vargas_scalar": {
        "θ at 1000 s": 50.0,
        "θ at k = 0": 0.9389,
        "largest |θ²k|": 0.5124,
        "least S": -1.427,
        "greatest S": 0.0774,
    },
}


@pytest.mark.parametrize("name", RECOMPUTED)
def test_its_numbers_are_those_of_another_integrator(name: str) -> None:
    study = study_named(name)
    rows = study.run(study.Options(), False, lambda share: None).rows
    for title, number in RECOMPUTED[name].items():
        assert next(row.computed for row in rows if row.quantity.en.startswith(title)) == pytest.approx(
            number, rel=1e-3
        )


@pytest.mark.parametrize("name", QUICK)
def test_the_whole_form(name: str) -> None:
    study, told = study_named(name), list[float]()
    result = study.run(study.Options(), False, told.append)
    assert differing(result) == []
    assert told[-1] == 1
    assert sorted(told) == told


def test_other_settings_leave_nothing_to_compare_with() -> None:
    result = run_study("vargas_08", replace(study_named("vargas_08").Options(), beta=7.0), True, lambda share: None)
    assert {row.source for row in result.rows} == {None}


# Each law changed: a term dropped, a sign turned, a gain doubled.


def twice_the_error(aim: clik.TaskError, gains: Any, q: Any, dt: float) -> Task:
    return Task(q, aim.J, aim.feedforward + 2 * gains * aim.error, dt)


def one_gain_for_all(aim: clik.TaskError, gains: Any, q: Any, dt: float) -> Task:
    return Task(q, aim.J, aim.feedforward + 10 * aim.error, dt)


def dropped(cost: Callable[..., Any]) -> Callable[..., Any]:
    """A cost that nothing has."""
    return lambda *given: replace(found := cost(*given), value=0.0, gradient=0 * found.gradient)


def turned(cost: Callable[..., Any]) -> Callable[..., Any]:
    """A cost whose gradient has the wrong sign."""
    return lambda *given: replace(found := cost(*given), gradient=-found.gradient)


def without_left(J: Any, Theta: Any, gain: Any, update: Any = "composite") -> Any:
    return -np.dot(gain, J.T @ (J @ Theta - np.eye(len(J))))


SCALED, SLOPE = scalar_filter.scalar_step, scalar_filter.scalar_slope
EXACT = filtered_inverse.filter_step
# study, what is changed in which module, and what it becomes
MUTATIONS: dict[str, tuple[Any, str, Callable[..., Any]]] = {
    "vargas_08": (scalar_filter, "scalar_slope", lambda k, theta, beta: SLOPE(k, theta, 2 * beta)),
    "vargas_scalar": (scalar_filter, "scalar_step", lambda k, theta, beta, dt: SCALED(k, theta, 2 * beta, dt)),
    "vargas_matrix": (filtered_inverse, "filter_slope", without_left),
    "vargas_05": (damped_by_manipulability, "damping", lambda w, options: 0.0),
    "vargas_14": (clik, "task_from", one_gain_for_all),
    "vargas_15": (joint_barrier, "cost", dropped(joint_barrier.cost)),
}
SLOW_MUTATIONS: dict[str, tuple[Any, str, Callable[..., Any]]] = {
    "vargas_01": (clik, "task_from", twice_the_error),
    "vargas_02": (clik, "task_from", twice_the_error),
    "vargas_03": (clik, "task_from", twice_the_error),
    "vargas_04": (damped_by_manipulability, "damping", lambda w, options: 0.1),
    "vargas_06": (feedback, "compensator", lambda rows, options: options.gain * np.eye(rows)),
    "vargas_07": (damped_by_manipulability, "damping", lambda w, options: 0.0),
    "vargas_09": (scalar_filter, "scalar_slope", lambda k, theta, beta: SLOPE(k, theta, 1e3 / beta)),
    "vargas_10": (filtered_inverse, "filter_step", lambda J, Theta, gain, *more: EXACT(J, Theta, gain / 1e4, *more)),
    "vargas_11": (filtered_inverse, "filter_step", lambda J, Theta, gain, *more: EXACT(J, Theta, gain / 1e4, *more)),
    "vargas_11b": (damped_by_manipulability, "damping", lambda w, options: 0.0),
    "vargas_12": (filtered, "step", filtered_modified.step),
    "vargas_13": (filtered_modified, "step", filtered.step),
    "vargas_16": (ellipsoid, "cost", turned(ellipsoid.cost)),
    "vargas_links": (ellipsoid, "cost", turned(ellipsoid.cost)),
}


def turns_red(name: str, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The statements that do not hold any more with the law of a study changed."""
    module, law, other = (MUTATIONS | SLOW_MUTATIONS)[name]
    monkeypatch.setattr(module, law, other)
    with np.errstate(all="ignore"):
        rows = short(name).rows
    return [row.quantity.en for row in rows if row.verdict is Verdict.DIFFERS]


@pytest.mark.parametrize("name", MUTATIONS)
def test_a_changed_law_turns_a_row_red(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert turns_red(name, monkeypatch)


def test_every_study_with_a_statement_has_a_law_to_change() -> None:
    assert set(STUDIES) - set(MUTATIONS | SLOW_MUTATIONS) == {"vargas_slab", "vargas_two_arms"}
