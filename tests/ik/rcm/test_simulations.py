"""The source's simulations at 20 ms: what tip, shaft and joints do, row by row; the rows at 2 ms are in the soak."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from tests.ik.rcm.runs import DLS, E1_START, FILTERED, VARIABLE, as_printed, control, run

from helicoide.ik.rcm import wrists
from helicoide.ik.rcm.follow import Inverse
from helicoide.kinematics.chain import Array

DT = 0.02
Run = Mapping[str, Array]


@pytest.fixture(scope="module")
def s1() -> Run:
    return run("S1", control(), DT)


@pytest.fixture(scope="module")
def s1_fed_back() -> Run:
    return run("S1", control(entry=5.0), DT)


@pytest.fixture(scope="module")
def s2() -> Run:
    return run("S2", control(), DT)


@pytest.fixture(scope="module")
def s2_fed_back() -> Run:
    return run("S2", control(entry=5.0), DT)


@pytest.fixture(scope="module")
def s3() -> Run:
    return run("S3", control(), DT)


@pytest.fixture(scope="module")
def s3_damped() -> Run:
    return run("S3", control(of_tool=DLS), DT)


@pytest.mark.parametrize(
    ("name", "tip", "angle", "lateral", "q7", "outside", "w_r", "rate"),
    [
        ("s1", "0.0028", "0.0003", "0.191", ("-1.430", "-0.571"), ("0.147", "0.240"), "0.539", "0.0462"),
        ("s1_fed_back", "0.0028", "0.0003", "0.0009", None, ("0.147", "0.240"), "0.539", "0.0463"),
        ("s2", "0.0037", "0.0004", "0.471", ("-1.344", "-0.556"), ("0.142", "0.235"), "0.157", "0.0530"),
    ],
)
def test_rows_of_the_simulations(request, name, tip, angle, lateral, q7, outside, w_r, rate) -> None:
    got: Run = request.getfixturevalue(name)
    assert as_printed(got["tip_mm"].max(), tip)
    assert as_printed(got["angle_deg"].max(), angle)
    assert as_printed(got["lateral_mm"].max(), lateral)
    assert got["slip_mm_s"].max() < 1e-12
    if q7 is not None:
        assert as_printed(got["q7"].min(), q7[0])
        assert as_printed(got["q7"].max(), q7[1])
    assert as_printed(got["outside"].min(), outside[0])
    assert as_printed(got["outside"].max(), outside[1])
    assert as_printed(got["w_r"].min(), w_r)
    assert as_printed(got["rate"].max(), rate)


def test_without_damping_the_joints_race_at_the_singularity(s3: Run) -> None:
    """S3 by the pseudoinverse: rates of 10⁴ rad/s, θ₇ comes out on the other side, yet the entry point is kept."""
    assert s3["rate"].max() > 1000
    assert s3["q7"].max() == pytest.approx(1.17, abs=0.01)
    assert as_printed(s3["lateral_mm"].max(), "0.042")
    assert s3["slip_mm_s"].max() < 1e-7


def test_damping_tames_it_at_the_cost_of_the_tip_alone(s3: Run, s3_damped: Run) -> None:
    """§9: at most 0.035 rad/s against more than 1000; the entry point is kept as well as before."""
    assert s3_damped["rate"].max() == pytest.approx(0.0351, abs=1e-4)
    assert s3_damped["tip_mm"].max() < 0.08
    assert s3_damped["lateral_mm"].max() == pytest.approx(s3["lateral_mm"].max(), rel=0.01)
    assert s3_damped["slip_mm_s"].max() < 1e-12
    assert as_printed(s3_damped["q7"].min(), "-1.169")
    assert as_printed(s3_damped["q7"].max(), "0.269")
    assert as_printed(s3_damped["outside"].min(), "0.063")
    assert as_printed(s3_damped["outside"].max(), "0.163")


@pytest.mark.parametrize("of_tool", [VARIABLE, FILTERED], ids=["variably damped", "filtered"])
def test_other_inverses_cross_it_too(of_tool: Inverse) -> None:
    """§9, S3 over its first crossing: rates of 0.035 rad/s, the tip within 0.06 mm, nothing to the entry point."""
    got = run("S3", control(of_tool=of_tool), DT, seconds=30.0)
    assert got["q7"].min() < 0 < got["q7"].max()
    assert got["rate"].max() < 0.038
    assert got["tip_mm"].max() < 0.06
    assert got["slip_mm_s"].max() < 1e-12


def test_the_experiment_begins() -> None:
    """E1 for 4 s at 2 ms, with the source's gains: the tip within a micrometre while the entry point moves."""
    got = run("E1", control(position=270, orientation=1500), 0.002, E1_START, seconds=4.0)
    assert got["tip_mm"].max() < 1e-3
    assert got["slip_mm_s"].max() < 1e-11
    assert got["lateral_mm"].max() < 0.072


SAMPLES = [
    ("s2_fed_back", 0, "0.1500", "-0.6164", "0.8325", "0.02828"),
    ("s2_fed_back", 25, "0.2299", "-1.1107", "0.1698", "0.04441"),
    ("s2_fed_back", 50, "0.1936", "-0.8802", "0.3825", "0.04012"),
    ("s2_fed_back", 100, "0.2225", "-1.3181", "0.2258", "0.04622"),
    ("s2_fed_back", 150, "0.1936", "-0.8802", "0.3825", "0.03940"),
    ("s2_fed_back", 200, "0.1500", "-0.6164", "0.8325", "0.02828"),
    ("s3_damped", 0, "0.1500", "-0.6164", "0.8325", "0.02828"),
    ("s3_damped", 25, "0.1607", "-0.0009", "0.0010", "0.02483"),
    ("s3_damped", 50, "0.1387", "0.2685", "0.5051", "0.02334"),
    ("s3_damped", 100, "0.1038", "-0.4778", "2.1849", "0.02028"),
    ("s3_damped", 150, "0.0653", "-1.1636", "15.0794", "0.01793"),
    ("s3_damped", 200, "0.1500", "-0.6170", "0.8332", "0.02829"),
]


@pytest.mark.parametrize(("name", "t", "outside", "q7", "w_r", "w_i"), SAMPLES)
def test_samples_on_the_way(request, name: str, t: int, outside: str, q7: str, w_r: str, w_i: str) -> None:
    got: Run = request.getfixturevalue(name)
    at = round(t / DT)
    assert as_printed(got["outside"][at], outside)
    assert as_printed(got["q7"][at], q7)
    assert as_printed(got["w_r"][2 * t], w_r)
    assert as_printed(got["w_i"][2 * t], w_i)


def test_drift_feedback_holds_the_shaft(s2_fed_back: Run) -> None:
    """§9: at most 0.002 mm with Kr = 5, the tip within 0.01 mm."""
    assert s2_fed_back["lateral_mm"].max() < 0.002
    assert s2_fed_back["tip_mm"].max() < 0.01


def test_the_index_of_the_tool_is_its_formula_all_along(s1: Run, s2: Run) -> None:
    """w_r as displayed equals eqs. 3.40 and 3.42 at every depth and bend on the way."""
    for got, w in ((s1, wrists.w_zy_slit), (s2, wrists.w_zy_trocar)):
        places = (got[key][:: round(0.5 / DT)] for key in ("outside", "inside", "q7"))
        expected = [w(*place) for place in zip(*places, strict=True)]
        np.testing.assert_allclose(got["w_r"], expected, rtol=1e-9)


def test_a_moving_entry_point_is_followed() -> None:
    """§9, S4 with Kr = 5 at 20 ms for its first 50 s: within 0.01 mm of an entry point that has moved by 53 mm."""
    got = run("S4", control(entry=5.0), DT, seconds=50.0)
    assert got["lateral_mm"].max() < 0.01
    assert got["slip_mm_s"].max() < 1e-11
    assert got["tip_mm"].max() < 0.02
