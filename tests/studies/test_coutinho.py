"""Coutinho's studies: their law changed turns them red, and their numbers are those of his formulas."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.ik.rcm.runs import START
from tests.studies.coutinho_numbers import CIRCLED, FOUND, SAMPLED, at, digits

from helicoide import studies
from helicoide.geometry import rotation
from helicoide.ik.method import ConfiguredMethod, settings
from helicoide.ik.rcm import constrained, follow, older, passage
from helicoide.studies import (
    _coutinho_rows,
    coutinho_e1,
    coutinho_e3,
    coutinho_loop,
    coutinho_older,
    coutinho_s1,
    coutinho_s2,
    coutinho_s3,
    coutinho_s4,
)
from helicoide.studies._coutinho_circle import rod_arm, run_circle_once
from helicoide.studies._coutinho_hand import PERIOD, SAMPLE, HapticDevice, dragging_hand, steering_hand
from helicoide.studies._coutinho_runs import DLS, INVERSES, PSEUDOINVERSE, Run, RunStart, run_path, source_control
from helicoide.studies.study import Row, Statement, Verdict
from helicoide.text import LANGUAGES

NAMES = tuple(name for name in studies.study_names() if name.startswith("coutinho_"))
COARSE = 0.1  # s
FINE = 0.02  # s
STATED: dict[str, tuple[Callable[[Run, float], Sequence[Row]], float]] = {
    "S1": (coutinho_s1.s1_rows, COARSE),
    "S2": (coutinho_s2.s2_rows, COARSE),
    "S4": (coutinho_s4.s4_rows, FINE),
}


def red(rows: Sequence[Row]) -> list[str]:
    """What is not as printed."""
    return [row.quantity.en for row in rows if isinstance(row.source, Statement) and not row.source.holds(row.computed)]


def test_all_are_there() -> None:
    names = ("e1", "e2", "e3", "inverses", "loop", "older", "rod", "s1", "s2", "s3", "s4", "wrists")
    assert tuple(f"coutinho_{name}" for name in names) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_words_and_settings(name: str) -> None:
    study = studies.study_named(name)
    assert study.SOURCE.startswith("Coutinho 2015, ")
    assert 1 <= len(settings(study.Options)) <= 2
    for language in LANGUAGES:
        assert 2 <= study.ABOUT[language].count(". ") + 1 <= 4


@pytest.mark.parametrize("path", STATED)
def test_what_is_printed_of_a_simulation_holds(path: str) -> None:
    stated, dt = STATED[path]
    assert red(stated(run_path(path, source_control(), dt), dt)) == []


def test_a_wrong_lever_moves_the_entry_point(monkeypatch: pytest.MonkeyPatch) -> None:
    """Λ# with twice l_a: the shaft no longer keeps its entry point."""
    right = constrained.null_basis
    monkeypatch.setattr(constrained, "null_basis", lambda place, basis: right(_deeper(place), basis))
    found = red(coutinho_s2.s2_rows(run_path("S2", source_control(), COARSE, seconds=20.0), COARSE))
    assert "how fast the shaft leaves" in found[0]


def _deeper(place: passage.Insertion) -> passage.Insertion:
    return passage.Insertion(2 * place.outside, place.inside, place.forbidden, place.lateral)


def test_without_the_velocity_of_the_target_the_tool_lags(monkeypatch: pytest.MonkeyPatch) -> None:
    """ν without v_d: S1 misses its path near l_b = 0."""
    right = follow.body_velocity
    monkeypatch.setattr(follow, "body_velocity", lambda R, ahead, *others: right(R, 0 * ahead, *others))
    assert any(
        "error of the tip" in quantity
        for quantity in red(coutinho_s1.s1_rows(run_path("S1", source_control(), COARSE), COARSE))
    )


def test_without_its_term_the_entry_point_is_not_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """V_i = Λ# v without Λ† v_rd: the shaft stays where S4 moves its entry point."""
    push = property(lambda self: np.zeros((6, 2)))
    monkeypatch.setattr(constrained.Constrained, "push", push)
    assert len(red(coutinho_s4.s4_rows(run_path("S4", source_control(), FINE, seconds=20.0), FINE))) == 2


def test_joints_that_race_carry_the_shaft_away_between_the_instants() -> None:
    """E1: by the plain inverse the shaft leaves its entry point over steps, by the bounded ones it does not."""
    rows = coutinho_e1.run(coutinho_e1.Options(), True, lambda share: None).rows
    plain, *bounded = (row.computed for row in rows if "the shaft leaves" in row.quantity.en)
    assert plain > 1000 > 0.1 > max(bounded)


def test_only_with_the_arm_damped_is_the_entry_point_disturbed() -> None:
    """The reading of fig. 4.17 by table 4.1: without it nothing is disturbed."""
    wrist, both = (run_path("S3", source_control(of_tool=DLS, of_arm=arm), COARSE) for arm in (PSEUDOINVERSE, DLS))
    assert red(coutinho_s3.s3_rows(wrist, both)) == []
    assert "share" in red(coutinho_s3.s3_rows(wrist, wrist))[0]


def test_a_second_task_that_does_not_yield_is_no_stack(monkeypatch: pytest.MonkeyPatch) -> None:
    """Eq. 1.1 without I − J_e† J_e."""

    def unyielding(first, rate, second, second_rate, share=1.0):
        return np.linalg.pinv(first) @ rate + share * np.linalg.pinv(second) @ second_rate

    monkeypatch.setattr(older, "by_priority", unyielding)
    rows = coutinho_older.run(coutinho_older.Options(), True, lambda share: None).rows
    assert red(rows) == [rows[0].quantity.en]


def test_the_printed_error_of_orientation_does_not_arrive() -> None:
    """Eqs. 2.62–2.63; with a gain of half the size the arm falls too slowly."""
    assert coutinho_loop.body_rotation_errors(coutinho_loop.printed_error)[-1] == pytest.approx(179.9, abs=0.1)
    rows = studies.run_study("coutinho_loop", coutinho_loop.Options(position=2.5), True, lambda share: None).rows
    assert {row.verdict for row in rows} == {Verdict.OURS}
    assert rows[0].computed == pytest.approx(-2.5, abs=0.02)


@pytest.mark.parametrize(("path", "of"), [("S1", 0.0), ("S1", 5.0), ("S2", 0.0), ("S2", 5.0), ("S3", "damped")])
def test_numbers_at_20_ms(path: str, of: float | str) -> None:
    """Those at 2 ms are in the soak."""
    found = compare(path, 20, of)
    if (path, of) in (("S2", 5.0), ("S3", "damped")):
        for t, expected in SAMPLED[path].items():
            np.testing.assert_allclose(at(found, t, 0.02), expected, atol=5.5e-5, rtol=1e-5)


def compare(path: str, step: int, of: float | str) -> Run:
    """A run from the start of the numbers, which it meets; of: a gain Kr, 1/s, or an inverse."""
    chosen = source_control(of_tool=INVERSES[of][1]) if isinstance(of, str) else source_control(of)
    found = run_path(path, chosen, step / 1000, RunStart(START))
    for name, written in FOUND.get((path, step, of), {}).items():
        assert _coutinho_rows.MEASURES[name].of(found) == digits(written), name
    assert found["slip_mm_s"].max() < 1e-6
    return found


@pytest.mark.parametrize(("of_arm", "gain", "drift"), [(DLS, 0.0, 16.9), (DLS, 5.0, 0.15)])
def test_a_damped_arm_lets_the_shaft_drift(of_arm: ConfiguredMethod, gain: float, drift: float) -> None:
    """κ = 0.05 on J_i too, at 20 ms, mm."""
    found = run_path("S3", source_control(gain, of_tool=DLS, of_arm=of_arm), 0.02, RunStart(START))
    assert found["lateral_mm"].max() == pytest.approx(drift, rel=0.05)


@pytest.mark.parametrize("gain", [0.0, 5.0])
def test_the_rod_at_20_ms(gain: float) -> None:
    circled(20, gain)


def circled(step: int, gain: float) -> None:
    """One turn of the rod meets its numbers."""
    got = run_circle_once(gain, step / 1000)
    tip, lateral = got["tip_mm"], got["lateral_mm"]
    found = (tip.max(), np.sqrt(np.mean(tip**2)), lateral.max(), lateral[-1])
    assert list(found) == [digits(written) for written in CIRCLED[step, gain]]
    assert got["rate"].max() == pytest.approx(0.287, abs=5.5e-4)
    assert got["closure"][-1] == pytest.approx(0.22, abs=5.5e-3)
    assert (got["depth"].min(), got["depth"].max()) == (digits("0.1500"), digits("0.1616"))


@given(t=st.floats(0, PERIOD))
def test_the_device_tells_the_newest_sample_and_differences(t: float) -> None:
    """§4.2: velocity (p_k − p_{k−1}) / T_s, of the hand's turn too."""
    T, hand = np.eye(4), steering_hand(0.027, 0.015, 0.4)
    T[:3, :3] = rotation.exponential([0.3, -1.1, 0.6])
    reference = HapticDevice(hand, T, 0.01).reference(t)
    number = np.floor(t / SAMPLE + 1e-6)
    d, angle = hand(number * SAMPLE)
    np.testing.assert_allclose(reference.T_world_target[:3, 3], T[:3, :3] @ d, atol=1e-15)
    before, angle_before = hand(max(number - 1, 0) * SAMPLE)
    np.testing.assert_allclose(reference.feedforward[:3], T[:3, :3] @ (d - before) / SAMPLE, atol=1e-9)
    np.testing.assert_allclose(reference.feedforward[3:], T[:3, 0] * (angle - angle_before) / SAMPLE, atol=1e-9)
    assert HapticDevice(hand, T).reference(t).entry_rate.tolist() == [0.0, 0.0]
    assert abs(reference.entry_rate[0]) <= 0.01


def test_the_hand_starts_where_the_tool_is() -> None:
    d, angle = steering_hand(0.027, 0.015, 0.4)(0.0)
    assert not d.any()
    assert angle == 0
    np.testing.assert_array_equal(dragging_hand(np.array([1.0, 2, 3]))(2.0)[0], [2, 4, 6])


def test_coming_near_counts_once_until_it_is_left() -> None:
    assert coutinho_e3.singular_approaches(np.array([0.5, 0.09, 0.12, 0.05, 0.3, 0.02, 0.4])) == 2
    assert coutinho_e3.singular_approaches(np.array([0.5, 0.11])) == 0


def test_peaks_of_a_curve_stay() -> None:
    x = np.linspace(0, 1, 20_001)
    y = np.zeros_like(x)
    y[12_345] = -7.0
    fewer = _coutinho_rows.peaks(x, y)
    assert len(fewer[0]) == _coutinho_rows.POINTS
    assert fewer[1].min() == -7.0
    assert fewer[0][np.argmin(fewer[1])] == x[12_345]


def test_motions_have_a_few_hundred_poses() -> None:
    long = {"t_w": np.arange(1000.0), "q": np.zeros((1000, 8))}
    (motion,) = _coutinho_rows.run_motions({_coutinho_rows.NO_FEEDBACK: long})
    assert len(motion.times) == len(motion.q) <= _coutinho_rows.POSES


def test_the_rod_s_arm_has_seven_joints() -> None:
    assert len(rod_arm().variables) == 7
