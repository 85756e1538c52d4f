"""A typed coefficient moves the object that has it; what cannot be moved is refused, and nothing else changes."""

from __future__ import annotations

import numpy as np
import pytest
from tests.readout.scenes import scene

from helicoide import gate, readout
from helicoide.command import MoveToPose
from helicoide.geometry.clifford import CL031
from helicoide.seat import Selection, SelectionKind
from helicoide.state import State

SAID = "This object cannot be moved by itself"


def coefficient(state: State, selection: Selection, blade: str) -> float:
    element = readout.element_of(state, selection)
    assert element is not None
    place, sign = CL031.parse_blade(blade)
    return float(sign * element.values(state)[place])


@pytest.mark.parametrize("kind", ["tool", "target"])
@pytest.mark.parametrize(("blade", "value"), [("1", 0.6), ("e2e3", 0.25), ("e1e", 0.2), ("e1e2e3e", 0.01)])
def test_a_typed_coefficient_moves_the_target(kind: SelectionKind, blade: str, value: float) -> None:
    state = scene("puma560", 1)
    moved = gate.set_coefficient(Selection(kind), blade, value)(state)
    assert moved.notice is None
    assert isinstance(moved.request.command, MoveToPose)
    assert coefficient(moved, Selection("target"), blade) == pytest.approx(value, abs=1e-9)
    assert moved.arm is state.arm


@pytest.mark.parametrize(("blade", "value"), [("e1", 0.3), ("e3", -0.4), ("e", -0.9)])
def test_a_typed_coefficient_moves_a_plane(blade: str, value: float) -> None:
    state = scene("puma560", 1)
    plane = Selection("plane", len(state.problem.planes.panes) - 1)
    moved = gate.set_coefficient(plane, blade, value)(state)
    stopped = moved.notice is not None  # at the critical distance from the arm
    assert stopped or coefficient(moved, plane, blade) == pytest.approx(value, abs=1e-9)
    if blade != "e":
        assert coefficient(moved, plane, blade) == pytest.approx(value, abs=1e-9)
    assert (readout.plane_distances(moved)[:, -1] >= moved.problem.zones.critical - 1e-9).all()


def test_a_typed_coefficient_moves_the_entry_point() -> None:
    state = scene("dia10_rod", 0)
    assert state.problem.entry is not None
    x, y, z = state.problem.entry.point
    moved = gate.set_coefficient(Selection("entry"), "e3e1e", y + 0.01)(state)
    assert moved.problem.entry is not None
    np.testing.assert_allclose(moved.problem.entry.point, [x, y + 0.01, z], atol=1e-12)
    assert "coordinates" in refused(state, Selection("entry"), "e1e2e3", 2.0)


def refused(state: State, selection: Selection, blade: str, value: float) -> str:
    moved = gate.set_coefficient(selection, blade, value)(state)
    assert moved.notice is not None
    assert moved.problem is state.problem
    assert moved.request is state.request
    assert moved.arm is state.arm
    return moved.notice.en


@pytest.mark.parametrize("kind", ["link", "joint", "point", "frame", "path"])
def test_what_follows_the_joints_is_refused(kind: SelectionKind) -> None:
    assert SAID in refused(scene("puma560", 0), Selection(kind), "e1e", 0.1)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("kind", ["tool", "plane", "entry"])
def test_what_is_no_number_is_refused(kind: SelectionKind, value: float) -> None:
    assert refused(scene("dia10_rod", 0), Selection(kind), "e", value)


def test_huge_numbers_and_blades_of_another_kind_are_refused() -> None:
    state = scene("puma560", 0)
    assert refused(state, Selection("tool"), "e1e", 1e300)
    assert refused(state, Selection("tool"), "1", 2.0)
    assert refused(state, Selection("tool"), "e1", 0.5)
    assert refused(state, Selection("plane", 0), "e", 1e200)
    assert refused(state, Selection("plane", 99), "e", 0.1)
    assert refused(scene("puma560", 0), Selection("entry"), "e2e3e", 0.1)


def test_a_fixed_plane_stays() -> None:
    state = scene("movemaster", 0)
    fixed = next(k for k, pane in enumerate(state.problem.planes.panes) if not pane.movable)
    assert "fixed" in refused(state, Selection("plane", fixed), "e", 0.1)


def test_a_plane_set_by_normal_and_distance_has_them_and_keeps_its_centre_near() -> None:
    state = scene("puma560", 0)
    k = len(state.problem.planes.panes) - 1
    far = -3.5 * state.robot.reach
    moved = gate.set_plane(k, [0.0, 0.0, 2.0], far)(state)
    assert moved.notice is None, moved.notice
    np.testing.assert_allclose(moved.problem.planes.normals[k], [0, 0, 1])
    assert moved.problem.planes.offsets[k] == pytest.approx(far)
    np.testing.assert_allclose(moved.problem.planes.centres[k][:2], state.problem.planes.centres[k][:2], atol=1e-12)
