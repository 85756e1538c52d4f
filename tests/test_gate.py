"""The gate: an invalid request changes only the notice; stop, drags, parking."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields

import numpy as np
import pytest
from tests.driving import after, beside, turning_z_to, with_joints

from helicoide import gate
from helicoide.command import GetReady, HoldPosition, MoveToPose, Park
from helicoide.foresight import advance_with_search, search_posture, wants_search
from helicoide.kinematics.library import load_robot
from helicoide.readout import plane_distances
from helicoide.state import State, Update, initial_state

NAN, INF = float("nan"), float("inf")
UP = [1.0, 0.0, 0.0, 0.0]
HERE = [0.4, 0.1, 0.3]
Wrong = Callable[[], Update]

BAD_POSES: dict[str, tuple[object, object]] = {
    "NaN position": ([NAN, 0, 0.3], UP),
    "infinite position": ([0.4, INF, 0.3], UP),
    "two coordinates": ([0.4, 0.1], UP),
    "four coordinates": ([0.4, 0.1, 0.3, 0], UP),
    "a number": (0.4, UP),
    "a matrix": ([HERE, HERE], UP),
    "ragged": ([[0.4], [0.1, 0.3]], UP),
    "words": ("here", UP),
    "nothing": (None, UP),
    "an object": ({}, UP),
    "too far": ([0.4, 0.1, 3.1], UP),
    "huge": ([1e300, 0.1, 0.3], UP),
    "NaN quaternion": (HERE, [NAN, 0, 0, 0]),
    "zero quaternion": (HERE, [0, 0, 0, 0]),
    "huge quaternion": (HERE, [1e200, 1e200, 1e200, 1e200]),
    "tiny quaternion": (HERE, [1e-320, 0, 0, 0]),
    "three numbers": (HERE, [1, 0, 0]),
}
OTHERS: dict[str, Wrong] = {
    "joint NaN": lambda: gate.set_joint(0, NAN),
    "joint infinite": lambda: gate.set_joint(0, INF),
    "joint beyond": lambda: gate.set_joint(2, 0.1),
    "joint below": lambda: gate.set_joint(0, -1.6),
    "joint of words": lambda: gate.set_joint(0, "far"),  # type: ignore[arg-type]
    "joint of two": lambda: gate.set_joint(0, [0.1, 0.2]),  # type: ignore[arg-type]
    "joint 6": lambda: gate.set_joint(5, 0.1),
    "joint 0": lambda: gate.set_joint(-1, 0.1),
    "joint and a half": lambda: gate.set_joint(0.5, 0.1),  # type: ignore[arg-type]
    "gripper NaN": lambda: gate.set_gripper(NAN),
    "gripper too open": lambda: gate.set_gripper(1.01),
    "gripper too closed": lambda: gate.set_gripper(-0.01),
    "unknown pose": lambda: gate.go_to("nowhere"),
    "path NaN": lambda: gate.scrub(NAN),
    "path too long": lambda: gate.scrub(1.01),
    "path before its start": lambda: gate.scrub(-0.1),
    "plane 9": lambda: gate.drag_plane("seat", "start", 9, HERE, UP),
    "plane -1": lambda: gate.drag_plane("seat", "start", -1, HERE, UP),
    "plane NaN": lambda: gate.drag_plane("seat", "start", NAN, HERE, UP),  # type: ignore[arg-type]
    "the bench": lambda: gate.drag_plane("seat", "start", 3, HERE, UP),
}


def unchanged(update: Update, state: State) -> State:
    """The state after a refused request: all fields unchanged except the notice, which is in both languages."""
    after_it = update(state)
    changed = [f.name for f in fields(State) if getattr(after_it, f.name) is not getattr(state, f.name)]
    assert changed == ["notice"]
    assert after_it.notice is not None
    assert after_it.notice.en != after_it.notice.pt_BR
    return after_it


@pytest.mark.parametrize("bad", BAD_POSES)
def test_a_pose_that_is_none_changes_nothing(state: State, bad: str) -> None:
    position, wxyz = BAD_POSES[bad]
    unchanged(gate.set_target(position, wxyz), state)  # type: ignore[arg-type]
    unchanged(gate.drag_target("seat", "start", position, wxyz), state)  # type: ignore[arg-type]
    unchanged(gate.drag_plane("seat", "start", 0, position, wxyz), state)  # type: ignore[arg-type]


@pytest.mark.parametrize("bad", OTHERS)
def test_a_value_out_of_place_changes_nothing(state: State, bad: str) -> None:
    unchanged(OTHERS[bad](), state)


def test_a_notice_goes_with_the_next_request(state: State) -> None:
    refused = gate.go_to("nowhere")(state)
    assert gate.set_target(HERE, UP)(refused).notice is None


def test_a_drag_is_held_by_one_seat(state: State) -> None:
    held = gate.drag_target("one", "start", HERE, UP)(state)
    assert gate.drag_target("two", "update", [0.3, 0, 0.3], UP)(held) is held
    assert gate.drag_plane("one", "update", 0, [0.5, 0, 0.7], UP)(held) is held
    assert gate.drag_target("one", "end", HERE, UP)(held).request.drag is None


def test_a_released_target_comes_to_the_nearest_point(state: State) -> None:
    """Beyond the reach, the target moves to the accepted goal."""
    held = gate.drag_target("one", "start", [0.9, 0, 0.4], UP)(state)
    released = gate.drag_target("one", "end", [0.9, 0, 0.4], UP)(held)
    assert wants_search(released)
    settled = search_posture(released)(released)
    assert isinstance(settled.request.command, MoveToPose)
    np.testing.assert_allclose(settled.request.command.T_world_target[:3, 3], [0.82, 0, 0.4], atol=2e-3)
    assert not wants_search(settled)


def test_what_a_search_finds_is_nothing_after_something_else_was_asked(state: State) -> None:
    held = gate.drag_target("one", "start", [0.9, 0, 0.4], UP)(state)
    released = gate.drag_target("one", "end", [0.9, 0, 0.4], UP)(held)
    found = search_posture(released)
    for meanwhile in (gate.stop(), gate.set_target([0.5, 0, 0.3], UP), gate.keep_orientation(False)):
        other = meanwhile(released)
        assert found(other) is other


REQUESTS: dict[str, Callable[[State], State]] = {
    "target": gate.set_target(HERE, UP),
    "joint": gate.set_joint(1, 0.1),
    "pose": gate.go_to("zero"),
    "path": gate.play(),
    "drag": gate.drag_target("seat", "start", HERE, UP),
    "ready": gate.get_ready(),
    "park": gate.park(),
}


@pytest.mark.parametrize("name", REQUESTS)
def test_nothing_moves_after_a_stop(state: State, name: str) -> None:
    moving = after(REQUESTS[name](gate.go_to("zero")(state)), 0.2)
    stopped = gate.stop()(moving)
    later = stopped
    for _ in range(200):
        later = advance_with_search(later, 0.01)
        assert later.arm.q is stopped.arm.q
        assert not later.arm.velocities.any()
    assert later.request.command == HoldPosition(stopped=True)


@pytest.mark.parametrize("moves", [True, False])
def test_a_stop_that_closes_something_stops_too_and_says_so_where_something_moved(state: State, moves: bool) -> None:
    asked = gate.set_target([0.6, 0.0, 0.2], UP)(gate.keep_orientation(False)(state))
    before = after(asked, 0.2 if moves else 10.0)
    assert before.arm.moving == moves
    stopped = gate.stop(closing=True)(before)
    assert stopped.request.command == HoldPosition(stopped=moves)
    assert after(stopped, 0.1).arm.q is stopped.arm.q
    assert gate.while_asked(before, gate.play())(stopped) is stopped


def test_a_stop_that_closes_something_leaves_an_earlier_stop_said(state: State) -> None:
    assert gate.stop(closing=True)(gate.stop()(state)).request.command == HoldPosition(stopped=True)


@pytest.mark.parametrize("phase", ["update", "end"])
def test_what_is_left_of_a_drag_does_nothing_after_a_stop(state: State, phase: gate.Phase) -> None:
    held = gate.drag_target("seat", "start", HERE, UP)(state)
    stopped = gate.stop()(after(held, 0.1))
    assert gate.drag_target("seat", phase, [0.5, 0, 0.3], UP)(stopped) is stopped
    plane = gate.drag_plane("seat", "start", 0, [0.5, 0, 0.7], [0, 1, 0, 0])(state)
    stopped = gate.stop()(plane)
    assert gate.drag_plane("seat", phase, 0, [0.5, 0, 0.6], [0, 1, 0, 0])(stopped) is stopped


@pytest.mark.parametrize("name", sorted(REQUESTS))
def test_a_new_press_works_at_once_after_a_stop(state: State, name: str) -> None:
    stopped = gate.stop()(after(gate.go_to("zero")(state), 0.3))
    again = after(REQUESTS[name](stopped), 0.1)
    assert again.arm.q is not stopped.arm.q


def parked(state: State) -> State:
    return after(gate.go_to("home")(state), 20)


def test_parking_passes_ready_and_ends_exactly_at_home(state: State) -> None:
    robot = state.robot
    state = after(gate.set_target([0.5, 0.15, 0.25], UP)(state), 3)
    state = gate.park()(state)
    assert isinstance(state.request.command, Park)
    clear_before = []
    while not state.arm.parked:
        clear_before.append(plane_distances(state).min())
        state = advance_with_search(state, 0.01)
    assert min(clear_before) >= 0.080 - 1e-9
    assert np.abs(state.arm.q - robot.poses["ready"]).max() < 0.02
    nearest = []
    while isinstance(state.request.command, Park):
        state = advance_with_search(state, 0.01)
        nearest.append(plane_distances(state).min())
        assert beside(robot, state.arm.q) < 1e-3
        assert (np.abs(state.arm.velocities) <= robot.speed + 1e-9).all()
    np.testing.assert_array_equal(state.arm.q, robot.poses["home"])
    assert state.request.command == HoldPosition()
    assert state.arm.parked
    # recomputed from Cerbaro 2022, §6.2.1: at home the elbow is 21.09 mm from the ceiling, and nearer on the way there
    assert nearest[-1] == pytest.approx(0.02109, abs=3e-5)
    assert min(nearest) < nearest[-1]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_parking_never_leads_through_a_plane(state: State, side: float) -> None:
    """The ceiling is at its critical distance from an arm 0.0009 rad beside `ready`; `ready` may be too near to it."""
    beside_ready = with_joints(state, state.arm.q + side * np.array([0, 0.9e-3, 0.9e-3, 0, 0]))
    ceiling = state.problem.planes
    wxyz = turning_z_to(ceiling.normals[0])
    down = gate.drag_plane("seat", "start", 0, ceiling.centres[0] + 0.5 * ceiling.normals[0], wxyz)(beside_ready)
    assert plane_distances(down).min() == pytest.approx(0.080, abs=1e-9)
    state = gate.get_ready()(after(gate.park()(down), 0.3))
    for _ in range(200):
        state = advance_with_search(state, 0.01)
        assert state.arm.parked or plane_distances(state).min() >= 0.080 - 1e-9
    assert not state.arm.parked


def test_ready_from_home_ends_exactly_at_ready_with_the_planes_on(state: State) -> None:
    state = gate.get_ready()(parked(state))
    assert isinstance(state.request.command, GetReady)
    state = after(state, 20)
    np.testing.assert_array_equal(state.arm.q, state.robot.poses["ready"])
    assert not state.arm.parked
    assert plane_distances(state).min() >= 0.080


DRIVING: dict[str, Update] = {
    "target": gate.set_target(HERE, UP),
    "drag": gate.drag_target("seat", "start", HERE, UP),
    "joint": gate.set_joint(1, 0.1),
    "pose": gate.go_to("zero"),
    "play": gate.play(),
    "pause": gate.pause(),
    "scrub": gate.scrub(0.1),
    "plane": gate.drag_plane("seat", "start", 0, [0.5, 0, 0.7], [0, 1, 0, 0]),
    "restored planes": gate.restore_planes(),
}


@pytest.mark.parametrize("name", DRIVING)
def test_a_parked_arm_refuses_to_be_driven(state: State, name: str) -> None:
    state = parked(state)
    refused = unchanged(DRIVING[name], state)
    assert refused.notice == gate.PARKED
    assert after(refused, 0.5).arm.q is state.arm.q


def test_a_stop_on_the_way_home_holds_there_and_ready_leads_back(state: State) -> None:
    state = gate.park()(state)
    state = gate.stop()(after(state, 0.5))
    assert state.arm.parked
    assert after(state, 1).arm.q is state.arm.q
    back = after(gate.get_ready()(state), 10)
    np.testing.assert_array_equal(back.arm.q, back.robot.poses["ready"])
    home = after(gate.park()(state), 10)
    np.testing.assert_array_equal(home.arm.q, home.robot.poses["home"])


def test_an_arm_without_planes_does_not_park() -> None:
    start = initial_state(load_robot("orca"))
    refused = gate.park()(start)
    assert refused.notice == gate.NO_PARKING
    assert refused.request.command is start.request.command
    assert not isinstance(gate.go_to("home")(start).request.command, Park)
