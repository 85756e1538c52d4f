"""The source's simulations at 2 ms, its experiment and the rod's circle: every row that is too long for each day."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.rcm.runs import DLS, E1_START, FILTERED, VARIABLE, as_printed, control, run
from tests.ik.rcm.turns import turn

from helicoide.ik.rcm.follow import PSEUDOINVERSE, Inverse, inverse

pytestmark = pytest.mark.soak

DT = 0.002


@pytest.mark.parametrize(
    ("path", "entry", "tip", "angle", "lateral", "q7", "outside", "w_r", "rate"),
    [
        ("S1", 0.0, "0.0003", "0.0000", "0.023", None, ("0.147", "0.240"), "0.539", "0.0463"),
        ("S2", 0.0, "0.0004", "0.0000", "0.047", ("-1.346", "-0.558"), ("0.142", "0.235"), "0.157", "0.0531"),
        ("S2", 5.0, "0.0004", "0.0000", "0.00016", ("-1.347", "-0.558"), ("0.142", "0.235"), "0.157", "0.0531"),
        ("S4", 0.0, "0.0014", "0.0001", "0.233", ("-2.075", "-0.600"), ("0.146", "0.205"), "0.374", "0.115"),
        ("S4", 5.0, "0.0014", "0.0001", "0.0005", ("-2.075", "-0.601"), ("0.146", "0.205"), "0.374", "0.115"),
    ],
)
def test_rows_of_the_simulations(path, entry, tip, angle, lateral, q7, outside, w_r, rate) -> None:
    got = run(path, control(entry=entry), DT)
    print({key: (float(column.min()), float(column.max())) for key, column in got.items()})
    assert as_printed(got["tip_mm"].max(), tip)
    assert as_printed(got["angle_deg"].max(), angle)
    assert as_printed(got["lateral_mm"].max(), lateral)
    assert got["slip_mm_s"].max() < 1e-11
    if q7 is not None:
        assert as_printed(got["q7"].min(), q7[0])
        assert as_printed(got["q7"].max(), q7[1])
    assert as_printed(got["outside"].min(), outside[0])
    assert as_printed(got["outside"].max(), outside[1])
    assert as_printed(got["w_r"].min(), w_r)
    assert as_printed(got["rate"].max(), rate)


@pytest.mark.parametrize(
    ("of_tool", "tip", "angle"),
    [(DLS, "0.0784", "0.0016"), (VARIABLE, "0.0541", "0.0012"), (FILTERED, "0.0503", "0.0010")],
    ids=["damped", "variably damped", "filtered"],
)
def test_the_singularity_crossed(of_tool: Inverse, tip: str, angle: str) -> None:
    """S3, θ₇ = 0: three inverses that bear it, and none disturbs the entry point.

    The filtered row is of another integration of Θ: within three units of its last digit.
    """
    last = 3.0 if of_tool is FILTERED else 0.55
    got = run("S3", control(of_tool=of_tool), DT)
    print({key: (float(column.min()), float(column.max())) for key, column in got.items()})
    assert as_printed(got["tip_mm"].max(), tip, last)
    assert as_printed(got["angle_deg"].max(), angle, last)
    assert as_printed(got["lateral_mm"].max(), "0.0042")
    assert as_printed(got["q7"].min(), "-1.169")
    assert as_printed(got["q7"].max(), "0.269")
    assert as_printed(got["outside"].min(), "0.063")
    assert as_printed(got["outside"].max(), "0.163")
    assert got["rate"].max() == pytest.approx(0.0351, abs=2e-4)
    assert got["slip_mm_s"].max() < 1e-12


def test_the_singularity_undamped() -> None:
    """S3 by the pseudoinverse: thousands of radians a second."""
    got = run("S3", control(), DT)
    print({key: (float(column.min()), float(column.max())) for key, column in got.items()})
    assert got["rate"].max() > 1000
    assert as_printed(got["tip_mm"].max(), "0.0135")
    assert as_printed(got["angle_deg"].max(), "0.0037")
    assert as_printed(got["lateral_mm"].max(), "0.0042")
    assert got["slip_mm_s"].max() < 1e-8


@pytest.mark.parametrize(("entry", "lateral"), [(0.0, "16.9"), (5.0, "0.15")])
def test_damping_of_the_arm_itself_leaks_into_the_entry_point(entry: float, lateral: str) -> None:
    """S3 with κ = 0.05 on J_i as well as on J^r: 16.9 mm of drift, cut to 0.15 mm by Kr = 5."""
    got = run("S3", control(entry=entry, of_tool=DLS, of_arm=DLS), 0.02)
    assert as_printed(got["lateral_mm"].max(), lateral)
    assert got["slip_mm_s"].max() > 0.1


E1 = [
    (PSEUDOINVERSE, 5, 10, "0.0043", ("0.010", "0.785"), "0.072", "2.38"),
    (inverse("damped", damping=0.01), 5, 10, "5.31", ("-0.346", "0.785"), "0.012", "0.861"),
    (DLS, 5, 10, "12.8", ("-0.374", "0.785"), "0.036", "0.305"),
    (FILTERED, 5, 10, "25.5", ("-0.303", "0.785"), "0.055", "0.256"),
    (PSEUDOINVERSE, 270, 1500, "0.0001", ("0.010", "0.785"), "0.072", "2.38"),
    (inverse("damped", damping=0.01), 270, 1500, "0.92", ("0.009", "0.785"), "0.072", "2.35"),
    (DLS, 270, 1500, "7.4", ("-0.002", "0.785"), "0.021", "2.49"),
    (FILTERED, 270, 1500, "10.6", ("-0.352", "0.785"), "0.012", "0.761"),
]


@pytest.mark.parametrize(("of_tool", "Kp", "Ko", "tip", "q7", "lateral", "rate"), E1)
def test_rows_of_the_experiment(of_tool: Inverse, Kp: float, Ko: float, tip, q7, lateral, rate) -> None:
    """E1: near the singularity the inverses trade tip for rates; the entry point is kept by all.

    The filtered rows are of another integration of Θ, and within one unit of their last digit.
    """
    last = 1.2 if of_tool is FILTERED else 0.55
    got = run("E1", control(of_tool=of_tool, position=Kp, orientation=Ko), DT, E1_START)
    print({key: (float(column.min()), float(column.max())) for key, column in got.items()})
    assert as_printed(got["tip_mm"].max(), tip, last)
    assert as_printed(got["q7"].min(), q7[0], last)
    assert as_printed(got["q7"].max(), q7[1], last)
    assert as_printed(got["lateral_mm"].max(), lateral, last)
    assert as_printed(got["rate"].max(), rate, last)


@pytest.mark.parametrize(("entry", "lateral", "at_end"), [(0.0, "0.047", "0.039"), (5.0, "0.0028", "0.0007")])
def test_rows_of_the_circle(entry: float, lateral: str, at_end: str) -> None:
    got = turn(entry, DT)
    assert as_printed(got["tip_mm"].max(), "0.0047")
    assert as_printed(np.sqrt(np.mean(got["tip_mm"] ** 2)), "0.0021")
    assert as_printed(got["lateral_mm"].max(), lateral)
    assert as_printed(got["lateral_mm"][-1], at_end, 0.6)
    assert as_printed(got["depth"].min(), "0.1500")
    assert as_printed(got["depth"].max(), "0.1616")
    assert as_printed(got["rate"].max(), "0.287")
