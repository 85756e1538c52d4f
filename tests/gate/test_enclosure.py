"""Planes that are given, found, loaded and taken away: they stop at the arm, and what is wrong changes nothing."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.confinement import planes_of
from helicoide.confinement.plane_file import encode_planes
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.readout import plane_distances
from helicoide.state import FittedCloud, State, Update, initial_state
from helicoide.text import untranslated

CRITICAL = 0.080


def kept(before: State, after_it: State) -> bool:
    """Whether nothing changed but the notice."""
    return after_it.problem is before.problem and after_it.notice is not None and after_it.arm.q is before.arm.q


def test_a_plane_by_its_coefficients_confines_at_once(state: State) -> None:
    state = gate.remove_plane(0)(state)
    confined = gate.add_plane([0, 0, -2, -1.3])(state)
    assert confined.problem.planes.names == ("+y", "-y", "-z", "p1")
    np.testing.assert_allclose(confined.problem.planes.normals[-1], [0, 0, -1])
    assert confined.problem.planes.offsets[-1] == pytest.approx(-0.65)
    up = after(gate.set_target([0.5, 0.0, 0.9], [1, 0, 0, 0])(confined), 4.0)
    assert plane_distances(up).min() >= CRITICAL - 1e-9


def test_a_plane_through_the_arm_is_moved_back_from_it(state: State) -> None:
    elbow = state.monitored_points[2]
    through = gate.add_plane_through(elbow + np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))(state)
    assert plane_distances(through)[:, -1].min() == pytest.approx(CRITICAL, abs=1e-9)
    assert through.notice is not None
    assert "p1" in through.notice.pt_BR


def test_an_arm_without_planes_may_be_given_some() -> None:
    state = gate.add_plane([0, 0, -1, -1.0])(initial_state(load_robot("puma560")))
    assert state.problem.planes.names == ("p1",)
    assert state.problem.planes.panes[0].movable
    moved = gate.drag_plane("seat", "start", 0, state.problem.planes.centres[0], [0, 1, 0, 0])(state)
    assert moved.request.drag is not None


def test_a_box_takes_the_place_of_what_may_be_moved_and_leaves_the_bench(state: State) -> None:
    boxed = gate.set_box([0.2, -0.4, 0.0], [0.9, 0.4, 0.7])(gate.add_plane([0, 1, 0, 0.5])(state))
    planes = boxed.problem.planes
    assert set(planes.names) == {"+z", "+y", "-y", "-z"}
    assert not planes.panes[planes.names.index("-z")].movable
    assert planes.offsets[planes.names.index("+z")] == pytest.approx(-0.7)
    assert planes.panes[planes.names.index("+z")].size == pytest.approx((0.8, 0.7))


def test_planes_go_to_a_file_and_come_back(state: State, robot: Robot) -> None:
    text = encode_planes(state.problem.planes.names, state.problem.planes)
    back = gate.take_planes_of(text.encode(), "planes.toml")(gate.clear_planes()(state))
    order = [back.problem.planes.names.index(name) for name in state.problem.planes.names]
    np.testing.assert_array_equal(back.problem.planes.normals[order], planes_of(robot.panes).normals)
    np.testing.assert_allclose(back.problem.planes.centres[order], planes_of(robot.panes).centres, atol=1e-15)


def test_what_was_measured_is_restored(state: State, robot: Robot) -> None:
    restored = gate.restore_planes()(gate.add_plane([0, 1, 0, 0.5])(gate.clear_planes()(state)))
    np.testing.assert_allclose(restored.problem.planes.normals, planes_of(robot.panes).normals, atol=1e-15)


def test_a_reading_takes_the_place_of_the_plane_of_its_name(state: State) -> None:
    pane = state.problem.planes.panes[0]
    seen = FittedCloud(np.zeros((3, 3)), np.ones(3, dtype=bool), untranslated("found"))
    read = gate.show_cloud(pane.name, seen, pane)(state)
    assert read.problem.planes.names.count(pane.name) == 1
    assert read.clouds[pane.name] is seen
    none = gate.show_cloud(pane.name, seen, None)(state)
    assert none.problem is state.problem
    assert none.notice == seen.words


def test_there_are_twelve_at_most(state: State) -> None:
    for k in range(8):
        state = gate.add_plane([0, 0, -1, -1 - 0.1 * k])(state)
    assert len(state.problem.planes.panes) == 12
    assert kept(state, gate.add_plane([0, 0, -1, -2])(state))


def test_zones_are_set_within_their_bounds(state: State) -> None:
    wide = gate.set_zones(0.1, 0.15)(state)
    assert (wide.problem.zones.critical, wide.problem.zones.warning) == (0.1, 0.15)
    held = after(gate.set_target([0.5, 0.0, 0.9], [1, 0, 0, 0])(wide), 4.0)
    assert plane_distances(held).min() >= 0.1 - 1e-9
    for near, far in ((0.05, 0.11), (0.2, 0.25), (0.08, 0.081), (np.nan, 0.1), (0.08, np.inf)):
        assert kept(state, gate.set_zones(near, far)(state))


WRONG: dict[str, Callable[[], Update]] = {
    "zero normal": lambda: gate.add_plane([0, 0, 0, 1]),
    "NaN": lambda: gate.add_plane([0, np.nan, 0, 1]),
    "three numbers": lambda: gate.add_plane([0, 0, 1]),
    "words": lambda: gate.add_plane("up"),
    "collinear": lambda: gate.add_plane_through([[0, 0, 0], [1, 0, 0], [2, 0, 0]]),
    "two points": lambda: gate.add_plane_through([[0, 0, 0], [1, 0, 0]]),
    "box upside down": lambda: gate.set_box([1, 1, 1], [0, 0, 0]),
    "fixed": lambda: gate.remove_plane(3),
    "no such plane": lambda: gate.remove_plane(9),
    "half a plane": lambda: gate.remove_plane(0.5),  # type: ignore[arg-type]
    "no file": lambda: gate.take_planes_of(b"", "x.toml"),
    "not text": lambda: gate.take_planes_of(b"\xff\xfe", "x.toml"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong_changes_nothing(state: State, wrong: str) -> None:
    assert kept(state, WRONG[wrong]()(state))
