"""The paths of the source: they start where the tool is, and their velocities are their derivatives."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.rcm.runs import E1_START, START
from tests.kinematics.arms import twist_by_differences

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.paths import PATHS
from helicoide.studies._coutinho_runs import dia10
from helicoide.trajectory import Path


@pytest.mark.parametrize("name", PATHS)
def test_velocities_are_derivatives(name: str) -> None:
    reference = PATHS[name].task(tool_at(dia10(), START))

    def pose(t: Array) -> Array:
        return reference(float(t[0])).T_world_target

    for t in np.linspace(0, PATHS[name].duration, 23):
        expected = twist_by_differences(pose, np.array([t]))[:, 0]
        np.testing.assert_allclose(reference(t).feedforward, expected, atol=1e-12)


@pytest.mark.parametrize("name", PATHS)
def test_they_start_at_the_tool(name: str) -> None:
    T = tool_at(dia10(), START)
    np.testing.assert_allclose(PATHS[name].task(T)(0.0).T_world_target, T, atol=1e-15)


@pytest.mark.parametrize("name", ["S1", "S2", "S3", "S4"])
def test_simulations_take_one_period(name: str) -> None:
    reference, duration = PATHS[name].task(tool_at(dia10(), START)), PATHS[name].duration
    np.testing.assert_allclose(reference(duration).T_world_target, reference(0.0).T_world_target, atol=1e-15)
    assert duration == 200.0


def test_how_far_the_tool_goes() -> None:
    """§4.1: S1 withdraws 4.4 A = 132 mm, S2 4 A = 120 mm; S3 goes 1.8 A = 54 mm in and turns by 22.5°."""
    times = np.linspace(0, 200, 401)
    d = {name: np.array([PATHS[name].way(t).d for t in times]) for name in ("S1", "S2", "S3")}
    assert np.ptp(d["S1"][:, 1]) == pytest.approx(0.132)
    assert np.ptp(d["S2"][:, 1]) == pytest.approx(0.120, rel=1e-3)
    assert np.ptp(d["S3"][:, 1]) == pytest.approx(0.054)
    turns = [PATHS["S3"].way(t).turn for t in times]
    assert (min(turns), max(turns)) == (pytest.approx(-np.pi / 8), pytest.approx(np.pi / 8))


def test_how_far_the_entry_point_of_s4_goes() -> None:
    """0 to 106 mm along each axis of the shaft: ∫ 5 sin 3ωt dt."""
    times = np.linspace(0, 200, 20_001)
    rates = np.array([PATHS["S4"].way(t).entry_rate for t in times])
    excursion = np.cumsum(rates, axis=0) * 0.01
    assert excursion[:, 0].max() == pytest.approx(0.1061, abs=1e-4)
    assert excursion[:, 0].min() == pytest.approx(0.0, abs=1e-4)
    np.testing.assert_array_equal(rates[:, 1], -rates[:, 0])


def test_the_experiment() -> None:
    """§4.2.1: 5000 samples in 45 s of a period of 7000; from θ₇ = π/4, θ₈ = −π/2."""
    assert PATHS["E1"].duration == 45.0
    way = PATHS["E1"].way(45.0)
    phase = 2 * np.pi * 5000 / 7000
    np.testing.assert_allclose(way.d, [0.03 * np.sin(phase), 0, 0], atol=1e-15)
    assert way.turn == pytest.approx(np.pi / 18 * np.cos(phase) - np.pi / 18)
    np.testing.assert_allclose(way.entry_rate, [0.01 * np.sin(8 * phase), 0], atol=1e-15)
    np.testing.assert_allclose(tool_at(dia10(), E1_START)[:3, 3], [-0.0407, 1.0388, 0.8243], atol=6e-5)


def test_the_turn_is_about_the_tool_s_own_x() -> None:
    """R_d = R_0 Rot(x, φ)."""
    T = tool_at(dia10(), START)
    R = T[:3, :3].T @ PATHS["S3"].task(T)(50.0).T_world_target[:3, :3]
    np.testing.assert_allclose(rotation.logarithm(R), [-np.pi / 8, 0, 0], atol=1e-12)


@pytest.mark.parametrize("name", PATHS)
def test_they_are_paths_of_the_target(name: str) -> None:
    T, source = tool_at(dia10(), START), PATHS[name]
    path: Path = source.of(T)
    assert path.duration == source.duration
    assert path.is_closed == (name != "E1")
    np.testing.assert_array_equal(path.pose(0.3 * path.duration), source.task(T)(0.3 * path.duration).T_world_target)
    expected = twist_by_differences(lambda t: path.pose(float(t[0])), np.array([17.0]))[:, 0]
    np.testing.assert_allclose(path.twist(17.0), expected, atol=1e-12)
