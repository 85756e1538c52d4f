"""All rows of the simulations of Vargas 2013 at their full length and step. Run with `make soak`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.ik.vargas import (
    DAMPED,
    DAMPED_PLANAR,
    FEEDBACK,
    REACH,
    arm_sim,
    dips,
    effector,
    largest,
    left_at,
    manipulability,
    path_8,
    planar_sim,
    re_entry,
    rms,
    sizes,
    unreachable,
    weighted_sim,
    wrist_sim,
)

pytestmark = pytest.mark.soak

SQUARED = {**DAMPED, "exponent": "2"}
MANIPULABILITY = "damped_by_manipulability"


def printed(digits: str) -> Any:
    """The number, to little more than half a unit of its last digit."""
    mantissa, _, power = digits.partition("e")
    unit = 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))
    return pytest.approx(float(digits), abs=0.6 * unit)


@pytest.mark.parametrize(
    ("sim", "name", "options", "fastest", "error"),
    [
        (4, "pseudoinverse", {}, "0.0469", "1.1e-4"),
        (4, MANIPULABILITY, DAMPED_PLANAR, "0.0469", "1.1e-4"),
        (4, "feedback", FEEDBACK, "0.0469", "2.3e-4"),
        (4, "filtered", {"gain": 5.0}, "0.0470", "9.7e-5"),
        (4, "filtered_modified", {"gain": 5.0}, "0.0470", "1.1e-4"),
        (5, "pseudoinverse", {}, "1.84", "7e-5"),
        (5, MANIPULABILITY, DAMPED_PLANAR, "0.93", "0.187"),
        (5, "feedback", FEEDBACK, "1.40", "0.086"),
        (5, "filtered", {"gain": 5.0}, "1.19", "0.310"),
        (5, "filtered_modified", {"gain": 5.0}, "1.73", "0.443"),
        (7, "pseudoinverse", {}, "726", "0.10"),
        (7, MANIPULABILITY, DAMPED_PLANAR, "0.795", "0.184"),
        (7, "feedback", FEEDBACK, "4.59", "0.189"),
        (7, "filtered", {"gain": 5.0}, "1.37", "0.530"),
        (7, "filtered", {"gain": 50.0}, "1.38", "0.162"),
        (7, "filtered", {"gain": 500.0}, "2.02", "0.075"),
        (7, "filtered_modified", {"gain": 5.0}, "1.99", "0.634"),
        (7, "filtered_modified", {"gain": 50.0}, "2.25", "0.242"),
        (7, "filtered_modified", {"gain": 500.0}, "3.03", "0.111"),
    ],
)
def test_planar_simulations(sim: int, name: str, options: dict[str, Any], fastest: str, error: str) -> None:
    t, _, e, rates = planar_sim(sim, name, options, 1e-3, 40)
    later = t >= 5
    print(f"{largest(rates, later):.5g} {largest(sizes(e), later):.5g}")
    assert largest(rates, later) == printed(fastest)
    assert largest(sizes(e), later) == printed(error)


@pytest.mark.parametrize(
    ("name", "options", "when"),
    [
        ("feedback", FEEDBACK, 0.66),
        ("filtered", {"gain": 5.0, "start": "ones"}, 0.65),
        ("filtered_modified", {"gain": 5.0}, np.inf),
        ("filtered_modified", {"gain": 5.0, "start": "ones"}, np.inf),
    ],
)
def test_singular_start(name: str, options: dict[str, Any], when: float) -> None:
    t, q, _, _ = planar_sim(6, name, options, 1e-3, 40)
    print(left_at(q, t))
    assert left_at(q, t) == pytest.approx(when, abs=0.006)


@pytest.mark.parametrize(
    ("name", "options"),
    [
        (MANIPULABILITY, DAMPED_PLANAR),
        ("feedback", {**FEEDBACK, "coupling": 0.0}),
        ("filtered", {"gain": 5.0}),
    ],
)
def test_rounding_alone_leaves_a_singular_start_late(name: str, options: dict[str, Any]) -> None:
    """In exact arithmetic never; 5.3, 3.1 and 10.3 s in one arithmetic, other orders of adding differ by seconds."""
    t, q, _, _ = planar_sim(6, name, options, 1e-3, 15)
    print(left_at(q, t))
    assert left_at(q, t) > 2


@pytest.mark.parametrize(
    ("sim", "name", "options", "fastest", "later_fastest", "error", "mean"),
    [
        ("10", "filtered", {"gain": 1.0}, "0.761", "0.133", None, "8.3e-4"),
        ("10", MANIPULABILITY, DAMPED, "0.842", "0.133", None, "7.5e-4"),
        ("10", "pseudoinverse", {}, "0.842", "0.133", None, "7.5e-4"),
        ("11", "filtered", {"gain": 1.0}, "2.76", "0.134", "0.0246", "0.0046"),
        ("11", "filtered_modified", {"gain": 1.0}, "2.75", "0.134", "0.0054", "0.0011"),
        ("11", MANIPULABILITY, DAMPED, "2.82", "0.139", "0.260", "0.056"),
        ("11", MANIPULABILITY, SQUARED, "2.82", "0.131", "0.189", "0.039"),
        ("11b", "filtered", {"gain": 1.0}, "4.33", "0.134", "0.0016", "4.7e-4"),
        ("11b", "filtered_modified", {"gain": 1.0}, "5.88", "0.134", "0.0008", "4.8e-4"),
        ("11b", MANIPULABILITY, DAMPED, "9.30", "9.30", "5.07", "2.54"),
    ],
)
def test_singular_crossing(
    sim: str, name: str, options: dict[str, Any], fastest: str, later_fastest: str, error: str | None, mean: str
) -> None:
    """Sim. 10 at 2 ms, of which every tenth step counts: its first peak, 0.824 rad/s, falls between."""
    run = arm_sim(sim, name, options, 2e-3 if sim == "10" else 1e-3, 40 if sim == "11b" else 20)
    t, _, e, rates = (column[:: 10 if sim == "10" else 1] for column in run)
    later = t >= 5
    print(f"{largest(rates):.5g} {largest(rates, later):.5g} {largest(sizes(e), later):.5g} {rms(sizes(e[later])):.5g}")
    assert largest(rates) == printed(fastest)
    assert largest(rates, later) == printed(later_fastest)
    assert error is None or largest(sizes(e), later) == printed(error)
    assert rms(sizes(e[later])) == printed(mean)


@pytest.mark.parametrize(("sim", "lower_bound", "error"), [("11", 10_710, 0.011), ("11b", 898, 0.0029)])
def test_the_pseudoinverse_peaks(sim: str, lower_bound: float, error: float) -> None:
    """Undamped peaks at an exact singularity depend on the step."""
    t, _, e, rates = arm_sim(sim, "pseudoinverse", {}, 1e-3, 40 if sim == "11b" else 20)
    print(f"{largest(rates):.5g} {largest(sizes(e), t >= 5):.5g}")
    assert largest(rates, t >= 5) > 0.5 * lower_bound
    assert largest(sizes(e), t >= 5) < 3 * error


@pytest.mark.parametrize(
    ("name", "gain", "fastest", "error", "mean", "after", "w", "jerky"),
    [
        ("filtered", 1.0, "1.07", "0.137", "0.030", ("0.13", "0.10", "0.04"), "1.2", "10"),
        ("filtered", 25.0, "2.21", "0.320", "0.046", ("0.20", "0.12", "0.05"), "1.1", "89"),
        ("filtered_modified", 1.0, "4.91", "1.156", "0.155", ("0.57", "1.15", "0.10"), "0.04", "111"),
        ("filtered_modified", 25.0, "5.71", "0.099", "0.007", ("0.017", "0.013", "0.006"), "0", "397"),
    ],
)
def test_unreachable_reference(
    name: str, gain: float, fastest: str, error: str, mean: str, after: tuple[str, ...], w: str, jerky: str
) -> None:
    t, q, e, rates = arm_sim("12", name, {"gain": gain}, 1e-3, 20)
    later = t >= 5
    reachable = later & ~unreachable(t)
    push = np.abs(np.diff(rates, axis=0)).max(axis=1) / 1e-3
    found = largest(rates, later), largest(sizes(e), reachable), rms(sizes(e[reachable])), list(re_entry(t, e))
    print(found, manipulability(q[later]).min(), push[later[1:]].max())
    assert list(found) == [printed(fastest), printed(error), printed(mean), [printed(one) for one in after]]
    assert manipulability(q[later]).min() == printed(w)
    assert push[later[1:]].max() == printed(jerky)


def test_unreachable_reference_with_damping() -> None:
    """The peak depends on the step: 45.0 rad/s at 1 ms, 50.7 at 2 ms."""
    t, _, e, rates = arm_sim("12", MANIPULABILITY, DAMPED, 1e-3, 20)
    later = t >= 5
    print(largest(rates, later), largest(sizes(e), later & ~unreachable(t)), re_entry(t, e))
    assert largest(rates, later) == printed("45.0")
    assert largest(sizes(e), later & ~unreachable(t)) == printed("3.74")
    assert list(re_entry(t, e)) == [printed("0.57"), printed("1.21"), printed("2.66")]


def test_unreachable_reference_without_damping() -> None:
    """Rounding decides how near to the singularity the pseudoinverse steps: the peak is of the order of 1281 rad/s."""
    t, _, e, rates = arm_sim("12", "pseudoinverse", {}, 1e-3, 20)
    later = t >= 5
    print(largest(rates, later), largest(sizes(e), later & ~unreachable(t)), re_entry(t, e))
    assert 400 < largest(rates, later) < 4000
    assert largest(sizes(e), later & ~unreachable(t)) == pytest.approx(0.33, rel=0.2)


@pytest.mark.parametrize(("gain", "dip", "hertz"), [(1.0, 0.135, 1.3), (5.0, 0.056, 2.9), (25.0, 0.024, 6.6)])
def test_oscillation_at_the_border_of_the_workspace(gain: float, dip: float, hertz: float) -> None:
    """Larger γ: smaller and faster, frequency ∝ √γ; the elbow passes the stretched arm twice in a period."""
    t, q, _, _ = arm_sim("12", "filtered", {"gain": gain}, 1e-3, 14)
    times, depths = dips(t, q)
    print(depths[:4], 0.5 / np.diff(times[:4]).mean())
    assert depths[0] == pytest.approx(dip, rel=0.04)
    assert 0.5 / np.diff(times[:4]).mean() == pytest.approx(hertz, rel=0.1)


def test_the_modified_law_rests_on_the_border() -> None:
    t, q, _, _ = arm_sim("12", "filtered_modified", {"gain": 25.0}, 1e-3, 20)
    outside = (t > 11.6) & (t < 13.6)
    wished = np.array([path_8(now)[0] for now in t[outside]])
    off = sizes(effector(q[outside]) - REACH * wished / sizes(wished)[:, None])
    print(off.max())
    assert not dips(t, q)[0].size
    assert off.max() <= 0.0135


@pytest.mark.parametrize(
    ("name", "options", "arm", "wrist", "position", "turned"),
    [
        ("inverse", {}, "1.56", "14.1", "3e-4", "0.10"),
        (MANIPULABILITY, {"damping": 0.01, "threshold": 1e3}, "1.40", "6.67", "0.260", "26.1"),
        (MANIPULABILITY, {"damping": 0.1, "threshold": 1e3}, "1.35", "1.29", "0.093", "11.4"),
        (MANIPULABILITY, {"damping": 1.0, "threshold": 1e3}, "1.19", "0.95", "0.409", "20.6"),
        ("filtered", {"gain": 1.0}, "1.53", "1.47", "0.178", "67.1"),
        ("filtered", {"gain": 10.0}, "1.49", "2.19", "0.283", "45.8"),
        ("filtered_modified", {"gain": 1.0}, "1.59", "1.48", "0.196", "16.4"),
        ("filtered_modified", {"gain": 10.0}, "1.49", "1.42", "0.045", "19.7"),
    ],
)
def test_passage_near_the_shoulder_singularity(
    name: str, options: dict[str, Any], arm: str, wrist: str, position: str, turned: str
) -> None:
    t, _, e, rates = wrist_sim(name, options, 1e-3, 31.5)
    later = t > 3
    angle = 2 * np.degrees(np.arcsin(np.minimum(1, sizes(e[:, 3:]))))
    found = largest(rates[:, :3], later), largest(rates[:, 3:], later), largest(sizes(e[:, :3]), later)
    print(found, largest(angle, later), largest(sizes(e[:, :3]), t > 29), largest(sizes(e[:, 3:]), t > 29))
    assert found == (printed(arm), printed(wrist), printed(position))
    assert largest(angle, later) == printed(turned)
    if name == "filtered_modified" and options["gain"] == 10:
        assert largest(sizes(e[:, :3]), t > 29) < 1.2e-4
        assert largest(sizes(e[:, 3:]), t > 29) < 1.2e-3


@pytest.mark.parametrize(
    ("name", "options", "arm", "wrist"),
    [
        ("inverse", {}, "3.89", "35.5"),
        ("filtered", {"gain": 1.0}, "3.46", "3.14"),
        ("filtered_modified", {"gain": 1.0}, "3.77", "3.08"),
    ],
)
def test_the_passage_at_speed(name: str, options: dict[str, Any], arm: str, wrist: str) -> None:
    t, _, _, rates = wrist_sim(name, options, 5e-4, 12.6, 2.5)
    later = t > 3
    print(largest(rates[:, :3], later), largest(rates[:, 3:], later))
    assert largest(rates[:, :3], later) == printed(arm)
    assert largest(rates[:, 3:], later) == printed(wrist)


@pytest.mark.parametrize(
    ("of_position", "of_turn", "position", "turn", "at_half"),
    [
        ((100, 100, 100), 10, 0.15, 0.240, (0.0151, 0.2402)),
        ((10, 10, 10), 10, 1.31, 0.204, (0.1310, 0.2044)),
        ((100, 100, 100), 100, 1.31, 0.205, (0.1310, 0.2044)),
        ((10, 10, 10), 100, 5.25, 0.073, (0.5246, 0.0734)),
        ((100, 10, 10), 100, 5.10, 0.126, None),
        ((10, 10, 100), 100, 5.43, 0.106, None),
    ],
)
def test_gains_set_priorities(
    of_position: tuple[float, ...], of_turn: float, position: float, turn: float, at_half: tuple[float, float] | None
) -> None:
    t, _, e, rates = weighted_sim([*of_position, *[of_turn] * 3], 5e-4, 32)
    lost = (t >= 6) & (t <= 10)
    e_p, e_o = sizes(e[:, :3]), sizes(e[:, 3:])
    now = round(7.854 / 5e-4)
    print(10 * e_p[lost].max(), e_o[lost].max(), e_p[now], e_o[now], 10 * np.abs(e[now, :3]), largest(rates, t > 1))
    assert 10 * e_p[lost].max() == pytest.approx(position, abs=0.006)
    assert e_o[lost].max() == pytest.approx(turn, abs=6e-4)
    if at_half:
        assert (e_p[now], e_o[now]) == pytest.approx(at_half, abs=3e-4)
    back = (t >= 20) & (t <= 27)
    assert e_p[back].max() < 5e-5
    assert e_o[back].max() < 6e-5
    assert 0.9 < largest(rates, t > 1) < 2.6
    assert largest(rates) < 19
