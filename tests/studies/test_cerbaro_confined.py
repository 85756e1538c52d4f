"""Chapter 6 of Cerbaro 2022: its paths, its rules in both readings, and what becomes of its sentences without them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.ik import adaptation, limit_gains
from helicoide.studies.cerbaro_runs import confined, setups
from helicoide.studies.cerbaro_runs.chapter6_rows import (
    limit_margin_gain,
    number_rows,
    sentence_rows,
    tool_wall_clearance,
)
from helicoide.studies.cerbaro_runs.chapter6_runs import SHORT, ConfinedRuns, Options, RuleKind, gains_of, rule_of
from helicoide.studies.cerbaro_runs.confined import (
    CIRCLE,
    ELLIPSE,
    LINE,
    SAMPLES_SHORT,
    Gains,
    limit_margins,
    run_constrained,
)
from helicoide.studies.study import Row, Verdict
from helicoide.trajectory import Ellipse

USUAL = Options()


def nothing(share: float) -> None:
    pass


def runs(path: Ellipse, asked: tuple[tuple[RuleKind, int], ...] = SHORT, options: Options = USUAL) -> ConfinedRuns:
    """Those that were asked for, and the first of them in place of the constrained step."""
    courses = {
        run: confined.run_by_rule(
            path, run[1], gains_of(run[0], options), rule_of(run[0], options), SAMPLES_SHORT, nothing
        )
        for run in asked
    }
    return ConfinedRuns(courses, courses[asked[0]], path.period)


def said(path: Ellipse, options: Options = USUAL) -> dict[str, Row]:
    """The sentences of the source by the words of their quantity."""
    return {row.quantity.en: row for row in sentence_rows(runs(path, SHORT, options), path, options)}


BORDER = "case 3: share of the path with a point at 80 to 88 mm"
MORE = "mean deviation of case 1 less the larger of cases 2 and 3"
FARTHER = "least margin of case 3 less that of case 2"
CEILING = "cases 2 and 3: least distance to the ceiling"


def test_where_the_three_paths_begin_and_turn() -> None:
    """Cerbaro 2022, §6.1, eqs. 33–35; the last radius of eq. 34 is 50 mm, and the circle is level."""
    for path, start in ((ELLIPSE, (460, 0, 230)), (LINE, (550, 0, 230)), (CIRCLE, (260, 100, 200))):
        np.testing.assert_allclose(1000 * path.point(0.0), start, atol=1e-9)
    np.testing.assert_allclose(1000 * LINE.point(LINE.period / 4), (550, 250, 280), atol=1e-9)
    np.testing.assert_allclose(1000 * LINE.point(3 * LINE.period / 4), (550, -250, 180), atol=1e-9)
    planes, ends = confined.confined_problem().planes, np.array([LINE.point(s * LINE.period) for s in (0.25, 0.75)])
    to_walls = 1000 * (ends @ planes.normals[1:3].T - planes.offsets[1:3])
    np.testing.assert_allclose(to_walls.min(axis=1), (54.3, 77.2), atol=0.05)
    turn = np.array([CIRCLE.point(s) for s in np.linspace(0, 30, 7)])
    np.testing.assert_allclose(np.linalg.norm(turn - CIRCLE.centre, axis=1), 0.22, rtol=1e-12)
    np.testing.assert_allclose(turn[:, 2], 0.2, atol=1e-12)


def test_with_the_wanted_path_in_eq_37_the_sentences_hold_on_the_ellipse_and_with_the_target_they_do_not() -> None:
    wanted, adapted = said(ELLIPSE), said(ELLIPSE, Options(former="adapted"))
    assert {row.verdict for row in wanted.values()} == {Verdict.FITTED, Verdict.OURS}
    assert {name for name, row in adapted.items() if row.verdict is Verdict.DIFFERS} == {BORDER}
    assert adapted[MORE].computed < wanted[MORE].computed


def test_what_is_said_of_the_ellipse_is_asked_of_it_alone() -> None:
    """§6.2.2 is about the ellipse."""
    assert said(LINE)[BORDER].verdict is Verdict.OURS


def test_what_differs_on_the_line_and_the_circle() -> None:
    """Held, the line is trimmed at the walls alone; the circle is partly beyond reach."""
    for path, other in ((LINE, {MORE}), (CIRCLE, {"case 1: largest position error"})):
        assert {name for name, row in said(path).items() if row.verdict is Verdict.DIFFERS} == other


def test_without_eq_36_the_arm_comes_too_near(monkeypatch: pytest.MonkeyPatch) -> None:
    def unmoved(target: Array, distance: float, normal: Array, critical: float, corrected: bool) -> Array:
        return np.asarray(target + 1e-6 * normal)

    monkeypatch.setattr(adaptation, "moved_away", unmoved)
    assert said(LINE)[CEILING].computed < 79


def test_with_eq_36_as_printed_it_rests_at_72_7_mm_and_the_row_names_the_erratum() -> None:
    row = number_rows(runs(LINE, (*SHORT, (RuleKind.PRINTED, 3), (RuleKind.OTHER, 3))))
    printed = next(each for each in row if "normal turned inward: least distance" in each.quantity.en)
    assert printed.computed == pytest.approx(80 / 1.1, abs=0.1)
    assert (printed.verdict, printed.erratum) == (Verdict.ERRATUM, "cerbaro-23")


def test_without_clips_algorithm_1_keeps_no_joint_farther_from_its_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limit_gains, "clipped", lambda q, lower, upper, gains, growth: (q, gains))
    assert said(LINE)[FARTHER].verdict is Verdict.DIFFERS


def test_what_keeps_joints_farther_from_their_limits_is_the_clip_not_the_growth() -> None:
    found = runs(CIRCLE, (*SHORT, (RuleKind.STEADY, 3)))
    grown, steady = (
        limit_margin_gain(found.runs[kind, 3], found.cases[2]) for kind in (RuleKind.SOURCE, RuleKind.STEADY)
    )
    assert grown > steady > 0.9 * grown
    assert (found.runs[RuleKind.STEADY, 3].gains == USUAL.gain).all()


def test_the_tool_keeps_its_distance_from_walls_and_bench_where_the_wrist_does_not() -> None:
    course = runs(CIRCLE).cases[3]
    assert tool_wall_clearance(course) > 109
    assert course.least_distances[1:].min() < 40


@pytest.mark.parametrize("path", [ELLIPSE, LINE, CIRCLE], ids=["ellipse", "line", "circle"])
def test_the_guarded_step_keeps_every_distance_and_every_joint_limit(path: Ellipse) -> None:
    """Cases 2 and 3: no joint is ever beyond its limit, so that Algorithm 1 has nothing to clip."""
    course = run_constrained(path, 500.0, path.period, nothing)
    assert course.least_distances.min() >= 80 - 1e-6
    assert limit_margins(confined.confined_problem(), course.q).min() >= 0
    assert course.deviation < 25
    travelled = np.linalg.norm(np.diff(course.desired, axis=0), axis=1).sum()
    round_once = np.linalg.norm(np.diff(confined.path_samples(path, 3001), axis=0), axis=1).sum()
    assert travelled == pytest.approx(round_once, rel=1e-2)


def test_with_a_small_gain_algorithm_1_turns_the_margin_of_j3() -> None:
    """Circle, k₀ = 500, recomputed from the source's formulas: −10.2° with one gain, +8.0° with gains that grow."""
    small, by = Gains(500.0, 0.5, 1e-3), replace(confined.source_rule(), ratchets=True)
    courses = [confined.run_by_rule(CIRCLE, case, small, by, 601, nothing) for case in (2, 3)]
    j3 = [limit_margins(confined.confined_problem(), course.q)[2] for course in courses]
    assert j3 == pytest.approx([-10.2, 8.0], abs=0.06)
    np.testing.assert_array_equal(courses[0].gains, 500)
    assert courses[1].gains[2] > 500
    np.testing.assert_array_equal(courses[1].gains[[0, 3, 4]], 500)
    assert min(course.least_distances[0] for course in courses) >= 80
    assert [course.least_distances[1] for course in courses] == pytest.approx([40.9, 35.3], abs=0.06)


def test_case_1_holds_its_pitch_and_roll() -> None:
    course = confined.run_by_rule(LINE, 1, Options().gains, confined.source_rule(), SAMPLES_SHORT, nothing)
    assert np.abs(course.q[:, 1:4].sum(axis=1) - LINE.pitch).max() <= 0.01
    assert np.abs(course.q[:, 4] - LINE.roll).max() <= 0.01
    assert np.degrees(course.q[:, 3].max()) == pytest.approx(110.3, abs=0.1)


def test_the_tool_is_where_the_arm_says() -> None:
    here = setups.movemaster()
    np.testing.assert_allclose(setups.tool_position(here, here.robot.poses["zero"]), [0.82, 0, 0.4], atol=1e-12)
