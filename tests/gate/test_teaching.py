"""A path that is taught: recorded, put in order, gone through again within a millimetre, and refused in words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after, turning_z_to

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToJoints, Replay
from helicoide.foresight import advance_with_search
from helicoide.gate.running import replay_through
from helicoide.kinematics.library import load_robot
from helicoide.readout import plane_distances
from helicoide.state import State, initial_state
from helicoide.text import untranslated
from helicoide.trajectory.joints import tool_pose_in
from helicoide.trajectory.waypoint_file import encode_waypoints

UP = [1.0, 0.0, 0.0, 0.0]


@pytest.fixture
def taught() -> State:
    """Three points of the PUMA, the last reached along a line."""
    state = gate.record()(gate.keep_orientation(False)(initial_state(load_robot("puma560"))))
    start = state.T_world_tool[:3, 3]
    for way, move in (("joints", [0.05, 0.15, 0.05]), ("line", [0.05, -0.1, -0.05])):
        state = gate.record(way)(after(gate.set_target(start + move, UP)(state), 4.0))
    assert [waypoint.move_type for waypoint in state.taught.waypoints] == ["joints", "joints", "line"]
    return state


def test_the_taught_path_is_gone_through_within_a_millimetre(taught: State) -> None:
    state = replay_through(taught)(taught)
    assert isinstance(state.request.command, Replay)
    path, worst, passed = state.request.command.path, 0.0, [np.inf] * 3
    for _ in range(3000):
        command = state.request.command
        if not isinstance(command, Replay):
            break
        state = advance_with_search(state, 0.01)
        if command.arrived and isinstance(state.request.command, Replay):
            desired = tool_pose_in(state.robot, path.q(state.request.command.s))[:3, 3]
            worst = max(worst, float(np.linalg.norm(state.T_world_tool[:3, 3] - desired)))
        passed = [
            min(p, float(abs(state.arm.q - w.q).max())) for p, w in zip(passed, taught.taught.waypoints, strict=True)
        ]
    assert isinstance(state.request.command, MoveToJoints)
    assert worst < 1e-3
    assert max(passed) < 2e-3
    rest = after(state, 1.0)
    np.testing.assert_allclose(rest.arm.q, taught.taught.waypoints[-1].q, atol=1e-5)


def test_a_plane_in_the_way_slows_the_replay_and_is_never_crossed(state: State) -> None:
    state = gate.record()(gate.keep_orientation(False)(state))
    state = gate.record()(after(gate.set_target([0.5, 0.15, 0.3], UP)(state), 5.0))
    state = replay_through(replace(state, arm=replace(state.arm, q=state.robot.poses["ready"])))(
        after(gate.get_ready()(state), 6.0)
    )
    ceiling = state.problem.planes.centres[0] - [0, 0, 0.05]
    state = gate.drag_plane("one", "start", 0, ceiling, _facing(state))(state)
    state = gate.drag_plane("one", "end", 0, ceiling, _facing(state))(state)
    for _ in range(1500):
        state = advance_with_search(state, 0.01)
        assert plane_distances(state).min() >= 0.080 - 1e-9
    assert not isinstance(state.request.command, Replay), "it ends, beside its path if need be"


def _facing(state: State) -> Array:
    return turning_z_to(state.problem.planes.normals[0])


def test_points_are_named_ordered_and_taken_away(taught: State) -> None:
    state = gate.rename_waypoint("P2", "over the box")(taught)
    state = gate.move_waypoint("P3", 0)(state)
    assert [w.name for w in state.taught.waypoints] == ["P3", "P1", "over the box"]
    state = gate.delete_waypoint("P1")(state)
    assert [w.name for w in state.taught.waypoints] == ["P3", "over the box"]
    again = gate.record()(state)
    assert again.taught.waypoints[-1].name == "P1"


def test_points_go_to_a_file_and_come_back(taught: State) -> None:
    content = encode_waypoints(taught.taught)
    back = gate.take_waypoints(content)(gate.delete_waypoint("P2")(taught))
    assert [w.name for w in back.taught.waypoints] == ["P1", "P2", "P3"]
    for one, other in zip(back.taught.waypoints, taught.taught.waypoints, strict=True):
        np.testing.assert_array_equal(one.q, other.q)


def test_the_way_the_stay_and_the_posture_of_a_point_can_be_changed(taught: State) -> None:
    state = gate.set_dwell("P2", 1.5)(gate.set_move_type("P2", "screw")(taught))
    state = gate.teach_again("P1")(gate.go_to("zero")(state))
    first, second, third = state.taught.waypoints
    assert (second.move_type, second.dwell, third) == ("screw", 1.5, taught.taught.waypoints[2])
    np.testing.assert_array_equal(second.q, taught.taught.waypoints[1].q)
    np.testing.assert_array_equal(first.q, taught.arm.q)
    slow = replay_through(gate.choose_leg_shape("minimum jerk")(state))(state).request.command
    fast = replay_through(state)(state).request.command
    assert isinstance(slow, Replay)
    assert isinstance(fast, Replay)
    assert slow.path.duration > fast.path.duration + 0.1


def test_what_is_wrong_changes_nothing(taught: State, state: State) -> None:
    requests = [
        gate.record("jump"),
        gate.rename_waypoint("P9", "x"),
        gate.rename_waypoint("P1", "P2"),
        gate.rename_waypoint("P1", "  "),
        gate.move_waypoint("P1", 7),
        gate.set_move_type("P1", "jump"),
        gate.set_dwell("P1", -1.0),
        gate.set_dwell("P1", float("nan")),
        gate.teach_again("P9"),
        gate.choose_leg_shape("sudden"),  # type: ignore[arg-type]
        gate.delete_waypoint("nothing"),
        gate.take_waypoints(b"\xff"),
        gate.take_waypoints(encode_waypoints(state.taught)),
    ]
    for request in requests:
        refused = request(taught)
        assert refused.taught.waypoints is taught.taught.waypoints
        assert refused.notice is not None
    nothing = replay_through(state)(state)
    assert nothing.request.command is state.request.command
    assert nothing.notice is not None


@pytest.mark.parametrize(
    ("times", "q"),
    [
        ([0.0], [[0.0] * 5]),
        ([0.0, 1.0], [[0.0] * 4] * 2),
        ([0.0, np.nan], [[0.0] * 5] * 2),
        ([0.0, 1.0], [[np.inf] * 5] * 2),
        ([1.0, 0.0], [[0.0] * 5] * 2),
        ("now", "here"),
        (None, None),
    ],
)
def test_a_motion_that_is_none_moves_nothing(state: State, times: object, q: object) -> None:
    refused = gate.replay_motion(times, q, untranslated("run"))(state)  # type: ignore[arg-type]
    assert refused.request.command is state.request.command
    assert refused.notice is not None


def test_a_motion_beyond_the_limits_lags_and_keeps_them(state: State) -> None:
    ready, far = state.arm.q, state.arm.q.copy()
    far[2] = -3.0
    played = gate.replay_motion([0.0, 4.0], [ready, far], untranslated("run"))(state)
    for _ in range(900):
        played = advance_with_search(played, 0.01)
        assert (played.arm.q >= played.problem.limits.lower - 1e-9).all()
    assert not isinstance(played.request.command, Replay)
