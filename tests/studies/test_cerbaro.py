"""The studies of Cerbaro 2022: those that take seconds run whole here, the others in the soak tests."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide import studies
from helicoide.ik.adaptation import nearest
from helicoide.studies import cerbaro_algorithm_1, cerbaro_confined_circle, cerbaro_movemaster_convergence
from helicoide.studies.cerbaro_runs import arms, confined, tracking
from helicoide.studies.cerbaro_runs.confined import CIRCLE, ELLIPSE, LINE, guarded, margins
from helicoide.studies.study import Result, Verdict
from helicoide.trajectory import Ellipse

QUICK = (
    "cerbaro_redundancy",
    "cerbaro_orca_convergence",
    "cerbaro_movemaster_convergence",
    "cerbaro_movemaster_ellipse",
)


def nothing(share: float) -> None:
    pass


def whole(name: str, **options: object) -> Result:
    study = studies.named(name)
    return study.run(study.Options(**options), False, nothing)


@pytest.mark.parametrize("name", QUICK)
def test_a_whole_study_agrees_in_every_row(name: str) -> None:
    result = whole(name)
    assert [(row.quantity.en, row.ours, row.digest) for row in result.rows if row.verdict is not Verdict.AGREES] == []


def test_the_count_of_iterations_does_not_depend_on_a_small_damping() -> None:
    """λ = 0 and 0.1 mm (digest §3.6); another step factor is excused, since the source gives none."""
    for damping in (0.0, 0.1):
        first, *_ = whole("cerbaro_movemaster_convergence", damping=damping).rows
        assert (first.ours, first.verdict) == (17, Verdict.AGREES)
    other, *_ = whole("cerbaro_movemaster_convergence", factor=0.6).rows
    assert other.verdict is Verdict.ASSUMED
    assert cerbaro_movemaster_convergence.Options().factor == 0.3


# Steps of 10 ms with the same Λ Δt: what of the digest's numbers for 1 ms grows, and by how much.


def test_the_error_of_the_closed_loop_grows_with_the_square_of_the_step() -> None:
    errors = [tracking.circle(dt, 0.8, 0.5, seconds=20.0).error.max() for dt in (0.02, 0.01)]
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)
    assert tracking.circle(0.01, 0.8, 0.5).error.max() == pytest.approx(1.1e-4, rel=0.1)


def test_the_drift_of_the_open_loop_grows_with_the_step() -> None:
    assert tracking.circle(0.01, 0.0, 0.0).error[-1] == pytest.approx(0.09, rel=0.05)


def test_the_first_motion_in_the_null_space_is_violent() -> None:
    """650 °/s at once, at an error of 0.007 mm (steps of 1 ms, as in the source)."""
    run = tracking.free_ellipse(tracking.start_of_ellipse(), 500.0, 1e-3, False, seconds=0.3)
    assert np.degrees(run.fastest.max()) == pytest.approx(650, abs=5)
    assert run.error.max() == pytest.approx(0.007, abs=2e-4)


def test_the_other_way_round_algorithm_1_differs_and_is_excused_by_its_gain() -> None:
    """With k₀ = 100 the first clip is followed by more; the digest's count is for 500."""
    options = cerbaro_algorithm_1.Options(gain=100.0)
    result = cerbaro_algorithm_1.run(options, True, nothing)
    clips = next(row for row in result.rows if row.quantity.en == "clips of J3")
    assert clips.ours > 5
    assert clips.verdict is Verdict.ASSUMED


# Chapter 6.


def test_where_the_three_paths_begin_and_turn() -> None:
    """Cerbaro 2022, §6.1, eqs. 33–35 (E14, E15)."""
    for path, start in ((ELLIPSE, (460, 0, 230)), (LINE, (550, 0, 230)), (CIRCLE, (260, 100, 200))):
        np.testing.assert_allclose(1000 * path.point(0.0), start, atol=1e-9)
    np.testing.assert_allclose(1000 * LINE.point(LINE.period / 4), (550, 250, 280), atol=1e-9)
    np.testing.assert_allclose(1000 * LINE.point(3 * LINE.period / 4), (550, -250, 180), atol=1e-9)
    radii = [np.linalg.norm(CIRCLE.point(s) - CIRCLE.centre) for s in np.linspace(0, 30, 7)]
    np.testing.assert_allclose(radii, 0.22, rtol=1e-12)


@pytest.mark.parametrize("path", [ELLIPSE, LINE, CIRCLE], ids=["ellipse", "line", "circle"])
def test_the_guarded_step_keeps_every_distance_and_every_joint_limit(path: Ellipse) -> None:
    """Cases 2 and 3: no joint is ever beyond its limit, so that Algorithm 1 has nothing to clip."""
    course = guarded(path, 500.0, path.period, nothing)
    assert course.least.min() >= 80 - 1e-6
    assert margins(confined.confined(), course.q).min() >= 0
    assert course.deviation < 25
    travelled = np.linalg.norm(np.diff(course.desired, axis=0), axis=1).sum()
    round_once = np.linalg.norm(np.diff(confined.desired(path, 3001), axis=0), axis=1).sum()
    assert travelled == pytest.approx(round_once, rel=1e-2)


def test_algorithm_1_turns_the_margin_of_j3() -> None:
    """Circle: −10.2° with one gain, +8.0° with gains that grow (digest §5.5), at the pace of the source."""
    gains, rule = cerbaro_confined_circle.Options().gains, confined.source_rule()
    courses = [confined.by_rule(CIRCLE, case, gains, rule, confined.SAMPLES, nothing) for case in (2, 3)]
    j3 = [margins(confined.confined(), course.q)[2] for course in courses]
    assert j3 == pytest.approx([-10.2, 8.0], abs=0.06)
    np.testing.assert_array_equal(courses[0].gains, 500)
    assert courses[1].gains[2] > 500
    np.testing.assert_array_equal(courses[1].gains[[0, 3, 4]], 500)
    assert min(course.least[0] for course in courses) >= 80
    assert [course.least[1] for course in courses] == pytest.approx([40.9, 35.3], abs=0.06)


@pytest.mark.parametrize(("rule", "least"), [("planes", 80.0), ("ceiling", 80.0), ("printed", 72.0)])
def test_the_rule_that_is_chosen_is_the_one_that_is_shown(rule: str, least: float) -> None:
    study = studies.named("cerbaro_confined_line")
    result = study.run(study.Options(rule=rule), True, nothing)
    here, motion = confined.confined(), result.motion
    assert motion is not None
    ceiling = 1000 * min(nearest(here, q)[0] for q in motion.q)
    assert least <= ceiling < least + 5
    chart = next(chart for chart in result.charts if "chosen" in chart.title.en)
    assert chart.lines[0].y.min() == pytest.approx(ceiling, abs=1e-6)


def test_case_1_holds_its_pitch_and_roll() -> None:
    gains = cerbaro_confined_circle.Options().gains
    course = confined.by_rule(LINE, 1, gains, confined.source_rule(), confined.SAMPLES_SHORT, nothing)
    assert np.abs(course.q[:, 1:4].sum(axis=1) - LINE.pitch).max() <= 0.01
    assert np.abs(course.q[:, 4] - LINE.roll).max() <= 0.01
    assert np.degrees(course.q[:, 3].max()) == pytest.approx(110.3, abs=0.1)


def test_the_tool_is_where_the_arm_says() -> None:
    here = arms.movemaster()
    np.testing.assert_allclose(arms.tool(here, here.robot.poses["zero"]), [0.82, 0, 0.4], atol=1e-12)
