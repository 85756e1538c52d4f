"""Maps of the workspace as requests: one arm's map is never another's, nothing comes that is not waited for."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide import gate
from helicoide.arrays import frozen
from helicoide.kinematics.grid import WorkspaceGrid
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MAP_KINDS, MapKind, WorkspaceMap
from helicoide.seat import Seat
from helicoide.state import MapProgress, State, Update
from helicoide.text import untranslated

SEAT = Seat("", "en", cut=0.25)


@pytest.fixture
def found() -> WorkspaceMap:
    cells = WorkspaceGrid(frozen([-1, -1, -1]), frozen(np.eye(3)), 1.0, (2, 2, 2))
    return WorkspaceMap("reachable", 8, cells, np.ones(8, dtype=np.int64), frozen(np.ones(8)))


def reports(robot: Robot, found: WorkspaceMap) -> list[Update]:
    """All that a counting process can have said of an arm."""
    return [gate.tell_map(robot, 0.5), gate.show_map(robot, found), gate.fail_map(robot, untranslated("it broke"))]


def test_a_map_is_counted_and_shown(state: State, found: WorkspaceMap) -> None:
    state = gate.start_map(state.robot, "manipulability")(state)
    assert state.workspace.progress == MapProgress("manipulability", 0.0)
    state = gate.tell_map(state.robot, 0.5)(state)
    assert state.workspace.progress == MapProgress("manipulability", 0.5)
    state = gate.show_map(state.robot, found)(state)
    assert (state.workspace.progress, state.workspace.map) == (None, found)
    state = gate.clear_map()(state)
    assert state.workspace.map is None


def test_nothing_comes_that_is_not_waited_for(state: State, found: WorkspaceMap) -> None:
    ended = gate.end_map()(gate.start_map(state.robot, "reachable")(state))
    for request in (
        gate.tell_map(state.robot, 0.5),
        gate.show_map(state.robot, found),
        gate.fail_map(state.robot, untranslated("?")),
    ):
        assert request(ended) is ended


def test_another_arm_does_not_get_the_map(state: State, found: WorkspaceMap) -> None:
    counting, other = gate.start_map(state.robot, "reachable")(state), load_robot("puma560")
    for request in (
        gate.start_map(other, "reachable"),
        gate.tell_map(other, 0.5),
        gate.show_map(other, found),
        gate.fail_map(other, untranslated("?")),
    ):
        assert request(counting) is counting


def test_another_map_takes_the_place_of_the_one_that_is_counted_and_leaves_the_one_that_is_shown(
    state: State, found: WorkspaceMap
) -> None:
    state = gate.show_map(state.robot, found)(gate.start_map(state.robot, "reachable")(state))
    state = gate.start_map(state.robot, "dexterous")(gate.start_map(state.robot, "reachable")(state))
    assert (state.workspace.progress, state.workspace.map) == (MapProgress("dexterous"), found)


def test_a_failure_is_said_and_ends_the_counting(state: State) -> None:
    state = gate.fail_map(state.robot, untranslated("it broke"))(gate.start_map(state.robot, "reachable")(state))
    assert (state.workspace.progress, state.notice) == (None, untranslated("it broke"))


@pytest.mark.parametrize("kind", MAP_KINDS)
def test_the_kind_is_chosen_by_each_person(kind: MapKind) -> None:
    assert gate.choose_map(kind)(SEAT).map_kind == kind


@pytest.mark.parametrize("junk", ["no such kind", None, [], {"kind": "dexterous"}])
def test_an_unknown_kind_leaves_the_one_that_is_chosen(junk: object) -> None:
    assert gate.choose_map(junk)(SEAT) == SEAT  # type: ignore[arg-type]


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_the_cut_stays_within_the_reach(share: float) -> None:
    cut = gate.cut_map(share)(SEAT).cut
    assert cut == (np.clip(share, -1.0, 1.0) if math.isfinite(share) else SEAT.cut)


@pytest.mark.parametrize("junk", ["abc", None, [], [0.1], {"x": 1}])
def test_a_cut_that_is_no_number_changes_nothing(junk: object) -> None:
    assert gate.cut_map(junk)(SEAT) is SEAT  # type: ignore[arg-type]
