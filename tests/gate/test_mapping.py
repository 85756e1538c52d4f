"""Maps of the workspace as wishes: one arm's map is never another's, nothing comes that is not waited for."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide import gate
from helicoide.kinematics.cells import Cells
from helicoide.kinematics.chain import frozen
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import KINDS, Map
from helicoide.state import Seat, State, Update
from helicoide.text import same

SEAT = Seat("", "en", cut=0.25)


@pytest.fixture
def found() -> Map:
    cells = Cells(frozen([-1, -1, -1]), frozen(np.eye(3)), 1.0, (2, 2, 2))
    return Map("reachable", 8, cells, np.ones(8, dtype=np.int64), frozen(np.ones(8)))


def reports(robot: Robot, found: Map) -> list[Update]:
    """All that a counting process can have said of an arm."""
    return [gate.tell_map(robot, 0.5), gate.show_map(robot, found), gate.fail_map(robot, same("it broke"))]


def test_a_map_is_counted_and_shown(state: State, found: Map) -> None:
    state = gate.choose_map("manipulability")(state)
    assert state.workspace.kind == "manipulability"
    state = gate.start_map(state.robot)(state)
    assert state.workspace.progress == 0.0
    state = gate.tell_map(state.robot, 0.5)(state)
    assert state.workspace.progress == 0.5
    state = gate.show_map(state.robot, found)(state)
    assert (state.workspace.progress, state.workspace.map) == (None, found)
    state = gate.clear_map()(state)
    assert (state.workspace.kind, state.workspace.map) == ("manipulability", None)


def test_nothing_comes_that_is_not_waited_for(state: State, found: Map) -> None:
    ended = gate.end_map()(gate.start_map(state.robot)(state))
    for wish in (
        gate.tell_map(state.robot, 0.5),
        gate.show_map(state.robot, found),
        gate.fail_map(state.robot, same("?")),
    ):
        assert wish(ended) is ended


def test_another_arm_does_not_get_the_map(state: State, found: Map) -> None:
    counting, other = gate.start_map(state.robot)(state), load("puma560")
    for wish in (
        gate.start_map(other),
        gate.tell_map(other, 0.5),
        gate.show_map(other, found),
        gate.fail_map(other, same("?")),
    ):
        assert wish(counting) is counting


def test_another_kind_ends_what_is_counted_and_leaves_the_map(state: State, found: Map) -> None:
    state = gate.show_map(state.robot, found)(gate.start_map(state.robot)(state))
    state = gate.choose_map("dexterous")(gate.start_map(state.robot)(state))
    assert (state.workspace.kind, state.workspace.progress, state.workspace.map) == ("dexterous", None, found)


def test_a_failure_is_said_and_ends_the_counting(state: State) -> None:
    state = gate.fail_map(state.robot, same("it broke"))(gate.start_map(state.robot)(state))
    assert (state.workspace.progress, state.notice) == (None, same("it broke"))


def test_an_unknown_kind_is_refused_with_those_there_are(state: State) -> None:
    after = gate.choose_map("no such kind")(state)
    assert after.workspace is state.workspace
    assert after.notice is not None
    assert all(kind in after.notice.pt_BR for kind in KINDS)


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_the_cut_stays_within_the_reach(share: float) -> None:
    cut = gate.cut_map(share)(SEAT).cut
    assert cut == (np.clip(share, -1.0, 1.0) if math.isfinite(share) else SEAT.cut)


@pytest.mark.parametrize("junk", ["abc", None, [], [0.1], {"x": 1}])
def test_a_cut_that_is_no_number_changes_nothing(junk: object) -> None:
    assert gate.cut_map(junk)(SEAT) is SEAT  # type: ignore[arg-type]
