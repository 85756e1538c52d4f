"""The studies of Coutinho's runs: every number of the digest, at 20 ms each day and at 2 ms in the soak."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide import studies
from helicoide.geometry import rotation
from helicoide.ik.method import settings
from helicoide.kinematics.library import load
from helicoide.studies import _coutinho_rows as rows
from helicoide.studies import coutinho_hand
from helicoide.studies._coutinho_circle import rod_arm
from helicoide.studies._coutinho_hand import PERIOD, SAMPLE, Device, dragging, steering
from helicoide.studies.study import Result, Verdict
from helicoide.text import LANGUAGES

NAMES = tuple(name for name in studies.names() if name.startswith("coutinho_"))


@cache
def ran(name: str, short: bool, **options: Any) -> Result:
    """A study's result; it has told its progress to the end, and every row agrees."""
    study = studies.named(name)
    shares: list[float] = []
    result = study.run(study.Options(**options), short, shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    others = [(row.quantity.en, row.ours, row.digest) for row in result.rows if row.verdict is not Verdict.AGREES]
    assert others == []
    return result


def held(result: Result) -> int:
    """How many rows stand beside a number of the digest."""
    return sum(row.digest is not None for row in result.rows)


def value(result: Result, quantity: str) -> float:
    (found,) = [row.ours for row in result.rows if row.quantity.en == quantity]
    return found


def test_all_are_there() -> None:
    names = ("e1", "hand", "inverses", "older", "rod", "s1", "s2", "s3", "s4")
    assert tuple(f"coutinho_{name}" for name in names) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_short_forms_agree(name: str) -> None:
    result = ran(name, short=True)
    assert held(result) > 0
    assert result.charts
    assert result.motion is not None
    assert result.motion.q.shape == (len(result.motion.times), len(load(result.motion.robot).variables))
    assert (np.diff(result.motion.times) > 0).all()
    assert all(np.isfinite(line.y).all() and len(line.x) == len(line.y) > 1 for c in result.charts for line in c.lines)


@pytest.mark.parametrize("name", NAMES)
def test_words_and_settings(name: str) -> None:
    study = studies.named(name)
    assert study.SOURCE.startswith(("Coutinho 2015", "cf. Coutinho 2015"))
    assert load(study.ROBOT).name == study.ROBOT
    assert 1 <= len(settings(study.Options)) <= 2
    for language in LANGUAGES:
        assert 2 <= study.ABOUT[language].count(". ") + 1 <= 3


@pytest.mark.parametrize(
    ("name", "options", "least"),
    [
        ("coutinho_s1", {}, 19),
        ("coutinho_s2", {}, 36),
        ("coutinho_s3", {"inverse": "plain"}, 4),
        ("coutinho_s3", {"inverse": "damped"}, 32),
        ("coutinho_rod", {}, 20),
    ],
    ids=str,
)
def test_whole_forms_at_20_ms(name: str, options: dict[str, str], least: int) -> None:
    """Each row of the digest at 20 ms; the rows at 2 ms are in the soak."""
    assert held(ran(name, short=False, step="20", **options)) >= least


def test_the_singularity_is_where_the_hand_s_errors_are_made() -> None:
    """§4.2.3 and the digest's §9: calm joints while w_r → 0; without a bound they are faster and the tip truer."""
    calm, plain = (ran("coutinho_hand", short=True, inverse=inverse) for inverse in ("filtered", "plain"))
    near, far = coutinho_hand.TIP_NEAR.en, coutinho_hand.TIP_FAR.en
    assert value(calm, near) > value(calm, far)
    assert value(calm, coutinho_hand.NEAREST.en) < 1e-3
    assert value(plain, "largest joint rate") > 5 * value(calm, "largest joint rate")
    assert value(plain, near) < value(calm, near)


def test_damping_costs_the_tip_and_spares_the_joints() -> None:
    result = ran("coutinho_inverses", short=True)
    rate = {which: value(result, f"largest joint rate, {which}") for which in ("plain inverse", "damped, κ = 0.05")}
    assert rate["plain inverse"] > 1e4 * rate["damped, κ = 0.05"]


@given(t=st.floats(0, PERIOD))
def test_the_device_tells_the_newest_sample_and_differences(t: float) -> None:
    """§4.2: velocity (p_k − p_{k−1}) / T_s, of the hand's turn too."""
    T = np.eye(4)
    T[:3, :3] = rotation.exponential([0.3, -1.1, 0.6])
    wish = Device(steering, T).wished(t)
    number = np.floor(t / SAMPLE + 1e-6)
    d, turn = steering(number * SAMPLE)
    np.testing.assert_allclose(wish.T_world_target[:3, 3], T[:3, :3] @ d, atol=1e-15)
    before, turn_before = steering(max(number - 1, 0) * SAMPLE)
    np.testing.assert_allclose(wish.ahead[:3], T[:3, :3] @ (d - before) / SAMPLE, atol=1e-9)
    np.testing.assert_allclose(wish.ahead[3:], T[:3, 0] * (turn - turn_before) / SAMPLE, atol=1e-9)


def test_the_hand_starts_where_the_tool_is() -> None:
    d, turn = steering(0.0)
    assert not d.any()
    assert turn == 0
    np.testing.assert_array_equal(dragging(np.array([1.0, 2, 3]))(2.0)[0], [2, 4, 6])


@pytest.mark.parametrize(
    ("printed", "inside", "outside"),
    [
        ("0.191", (0.1905, 0.1915), (0.1904, 0.1916)),
        ("≤1e-12", (0.0, 1e-12), (1.1e-12, 1.0)),
        ("≥1000", (1000.0, 2104.0), (999.0, -5.0)),
        ("0.0351 ± 0.0002", (0.0349, 0.0353), (0.0348, 0.0354)),
        ("-1.430", (-1.4305, -1.4295), (-1.431, 1.43)),
    ],
)
def test_what_is_printed_bounds_what_agrees(
    printed: str, inside: tuple[float, ...], outside: tuple[float, ...]
) -> None:
    title = rows.FIGURES["tip"][0]
    assert all(rows.row(title, ours, printed).agrees for ours in inside)
    assert not any(rows.row(title, ours, printed).agrees for ours in outside)


def test_peaks_of_a_curve_stay() -> None:
    x = np.linspace(0, 1, 20_001)
    y = np.zeros_like(x)
    y[12_345] = -7.0
    fewer = rows.thinned(x, y)
    assert len(fewer[0]) == rows.POINTS
    assert fewer[1].min() == -7.0
    assert fewer[0][np.argmin(fewer[1])] == x[12_345]


def test_the_rod_s_arm_has_seven_joints() -> None:
    assert len(rod_arm().variables) == 7
