"""Lists of taught waypoints: what can be put in, renamed, moved and taken out, and what is refused in words."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import arm
from tests.trajectory.taught import taught

from helicoide.text import HelicoideError
from helicoide.trajectory.waypoints import (
    WaypointList,
    waypoint,
    with_waypoint,
    with_waypoint_at,
    with_waypoint_name,
    without_waypoint,
)

ROBOT = arm("movemaster")
READY = ROBOT.poses["ready"]


def test_a_waypoint_goes_in_at_every_place() -> None:
    three, new = taught("movemaster"), waypoint(ROBOT, "new", READY)
    for at in range(4):
        more = with_waypoint(three, at, new)
        assert more.names == (*"abc"[:at], "new", *"abc"[at:])
        assert more.waypoints[at] is new
        assert without_waypoint(more, "new").waypoints == three.waypoints
    assert three.names == ("a", "b", "c")
    assert with_waypoint(WaypointList(ROBOT), 0, new).names == ("new",)


@given(names=st.lists(st.sampled_from("abcdefg"), unique=True, min_size=1), data=st.data())
def test_a_waypoint_can_be_moved_and_moved_back(names: list[str], data: st.DataObject) -> None:
    here = taught("movemaster", names)
    i, to = (data.draw(st.integers(0, len(names) - 1)) for _ in range(2))
    there = with_waypoint_at(here, names[i], to)
    assert there.names[to] == names[i]
    assert [name for name in there.names if name != names[i]] == [name for name in names if name != names[i]]
    assert with_waypoint_at(there, names[i], i).waypoints == here.waypoints


def test_another_name_changes_nothing_else() -> None:
    here = taught("movemaster")
    there = with_waypoint_name(here, "b", "above the ball")
    assert there.names == ("a", "above the ball", "c")
    assert there.waypoints[1].q is here.waypoints[1].q
    assert (there.waypoints[1].move_type, there.waypoints[1].dwell) == ("line", 0.5)
    assert with_waypoint_name(there, "above the ball", "b").names == here.names
    assert with_waypoint_name(here, "b", "b").names == here.names


def test_the_posture_cannot_be_changed_from_outside() -> None:
    q = READY.copy()
    new = waypoint(ROBOT, "new", q)
    q[0] = 1.0
    np.testing.assert_array_equal(new.q, READY)
    assert not new.q.flags.writeable


def test_home_can_be_taught_although_it_lies_outside_the_limits() -> None:
    assert (ROBOT.poses["home"] > ROBOT.upper).any()
    np.testing.assert_array_equal(waypoint(ROBOT, "home", ROBOT.poses["home"]).q, ROBOT.poses["home"])


HERE = taught("movemaster")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: without_waypoint(HERE, "d"), "no waypoint 'd'; waypoints: a, b, c"),
        (lambda: with_waypoint_at(HERE, "d", 0), "no waypoint 'd'"),
        (lambda: with_waypoint_name(HERE, "d", "e"), "no waypoint 'd'"),
        (lambda: with_waypoint_name(HERE, "a", "b"), "already a waypoint 'b'; names in use: a, b, c"),
        (lambda: with_waypoint(HERE, 0, HERE.waypoints[1]), "already a waypoint 'b'"),
        (
            lambda: with_waypoint(HERE, 4, waypoint(ROBOT, "d", READY)),
            "no position 4 in the list; the positions are 0 to 3",
        ),
        (lambda: with_waypoint(HERE, -1, waypoint(ROBOT, "d", READY)), "no position -1"),
        (lambda: with_waypoint_at(HERE, "a", 3), "no position 3 in the list; the positions are 0 to 2"),
        (lambda: without_waypoint(WaypointList(ROBOT), "a"), "waypoints: none yet"),
        (
            lambda: waypoint(ROBOT, "x", READY, "jump"),
            "joints (joint move), line (linear move), screw (screw move)",
        ),
        (lambda: waypoint(ROBOT, "x", READY, "line", -1.0), "must be 0 to 3600 s, not -1"),
        (lambda: waypoint(ROBOT, "x", READY, "line", float("nan")), "must be 0 to 3600 s, not nan"),
        (lambda: waypoint(ROBOT, "x", READY[:4]), "takes 5 finite joint values"),
        (lambda: waypoint(ROBOT, "x", [np.nan] * 5), "takes 5 finite joint values"),
        (lambda: waypoint(ROBOT, "x", [0, 0, 9, 0, 0]), "sets J3 to 9 rad; the range is -2.148 to"),
    ],
)
def test_what_cannot_be_is_refused_in_words(call: Callable[[], object], words: str) -> None:
    with pytest.raises(HelicoideError) as refused:
        call()
    assert words in refused.value.text.en
    assert refused.value.text.pt_BR != refused.value.text.en
    assert HERE.names == ("a", "b", "c")


@pytest.mark.parametrize("name", ["", " a", "a ", "two\nlines", "\x7f", "\ud800", "a" * 61])
def test_a_name_is_visible(name: str) -> None:
    with pytest.raises(HelicoideError, match="1 to 60 visible characters"):
        waypoint(ROBOT, name, READY)
    with pytest.raises(HelicoideError, match="1 to 60 visible characters"):
        with_waypoint_name(HERE, "a", name)
