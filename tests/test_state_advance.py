"""One tick: the promises of the guarded step, and that the arm reaches its targets."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after, beyond, clear_goal, clear_posture, misses, rough_ride, with_joints

from helicoide import gate
from helicoide.arrays import frozen
from helicoide.command import FollowPath
from helicoide.foresight import advance_with_search
from helicoide.ik import Limits
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.readout import plane_distances
from helicoide.state import State, initial_state, with_command
from helicoide.trajectory.pose_paths import LinePath

RIDES = 6
TICKS = 5_000
GOALS = 300


@pytest.mark.parametrize("seed", range(RIDES))
def test_no_promise_is_broken_in_a_rough_ride(state: State, seed: int) -> None:
    """Six rides of 5,000 ticks; tests/soak runs a million."""
    worst = rough_ride(state, np.random.default_rng(seed), TICKS)
    assert worst.ticks >= TICKS
    assert worst.clearance < 1e-3, "the ride never came near a plane: it shows nothing"
    assert worst.too_fast > -1e-3, "the ride was never fast: it shows nothing"


@pytest.mark.parametrize("with_orientation", [True, False])
def test_the_arm_gets_where_the_way_is_clear(robot: Robot, with_orientation: bool) -> None:
    """At least 99 % of goals with a clear posture and a clear straight path are reached to 1 mm within 12 s."""
    rng = np.random.default_rng(7)
    left = [misses(*clear_goal(rng, initial_state(robot)), with_orientation) for _ in range(GOALS)]
    assert np.mean(np.array(left) < 1e-3) >= 0.99


def test_the_poses_are_those_of_the_joints(state: State) -> None:
    state = after(gate.set_target([0.4, 0.15, 0.3], [1, 0, 0, 0])(state), 0.5)
    poses = link_poses(state.robot.chain, state.arm.q)
    np.testing.assert_allclose(state.arm.poses, poses, rtol=0, atol=1e-12)


def test_time_and_only_time_goes_on_at_rest(state: State) -> None:
    later = after(state, 1.0)
    assert later.t == pytest.approx(1.0)
    assert later.arm.q is state.arm.q
    assert later.arm.poses is state.arm.poses


def test_the_old_state_is_left_as_it_was(state: State) -> None:
    asked = gate.set_target([0.4, 0.15, 0.3], [1, 0, 0, 0])(state)
    before = asked.arm.q.copy()
    assert advance_with_search(asked, 0.01).arm.q is not asked.arm.q
    np.testing.assert_array_equal(asked.arm.q, before)


@pytest.mark.parametrize("dt", [0.001, 0.01, 0.05])
def test_joints_are_brought_to_their_values(robot: Robot, dt: float) -> None:
    rng = np.random.default_rng(3)
    state = initial_state(robot)
    for _ in range(20):
        q_target = clear_posture(rng, state, 0.11)
        state = with_joints(state, clear_posture(rng, state, 0.11))
        reached = gate.go_to("zero")(state)
        command = reached.request.command.__class__(q_target)
        reached = after(replace(reached, request=replace(reached.request, command=command)), 8, dt)
        assert np.abs(reached.arm.q - q_target).max() < 1e-3 or plane_distances(reached).min() < 0.081


def test_a_joint_outside_its_limits_comes_back_in_and_never_goes_further(robot: Robot, state: State) -> None:
    narrow = Limits(frozen(robot.lower * 0.2), frozen(robot.upper * 0.2), robot.speed)
    state = replace(state, problem=replace(state.problem, limits=narrow))
    assert beyond(state, state.arm.q).max() > 0.1
    state = gate.set_target(state.T_world_tool[:3, 3] - [0.2, 0, 0], [1, 0, 0, 0])(state)
    outside = beyond(state, state.arm.q)
    for _ in range(500):
        state = advance_with_search(state, 0.01)
        assert (beyond(state, state.arm.q) <= outside + 1e-12).all()
        outside = beyond(state, state.arm.q)


def test_a_target_out_of_reach_brings_the_arm_to_rest(state: State) -> None:
    """The stretched arm is singular and still far from the target: it must not oscillate."""
    state = after(gate.set_target([0.9, 0.0, 0.4], [1, 0, 0, 0])(state), 8)
    assert not state.arm.moving
    np.testing.assert_allclose(state.T_world_tool[:3, 3], [0.82, 0, 0.4], atol=2e-3)


def test_the_path_is_followed_from_where_the_arm_stands(state: State) -> None:
    """Ellipse of eq. 33: once the tool is on it, the tool stays on it where no plane limits the arm."""
    state = after(gate.keep_orientation(False)(gate.play()(gate.choose_path("eq33")(state))), 1.2)
    assert state.request.command.arrived
    apart = []
    for _ in range(150):
        state = advance_with_search(state, 0.01)
        apart.append(
            np.linalg.norm(state.T_world_tool[:3, 3] - state.request.command.path.point(state.request.command.s))
        )
    assert max(apart) < 2e-4
    assert state.request.path_s == state.request.command.s


def test_a_paused_path_stays_and_plays_on(state: State) -> None:
    state = after(gate.play()(state), 4)
    paused = after(gate.pause()(state), 2)
    assert paused.request.path_s == pytest.approx(state.request.path_s, abs=0.011)
    assert not paused.arm.moving
    assert after(gate.play()(paused), 1).request.path_s > paused.request.path_s + 0.4


@pytest.mark.parametrize("method", ["guarded", "pseudoinverse"])
def test_a_path_that_begins_out_of_reach_is_followed_all_the_same(state: State, method: str) -> None:
    """The target moves on once the arm can come no nearer to the start of the path."""
    far = state.T_world_tool.copy()
    far[:3, 3] += [0.5, 0.0, 0.3]
    path = LinePath(far, state.T_world_tool, 2.0)
    state = gate.choose_method(method)(gate.keep_orientation(False)(state))
    ended = after(replace(state, request=replace(state.request, command=FollowPath(path, 0.0, playing=True))), 15.0)
    assert (ended.request.path_s, ended.request.command.playing) == (2.0, False)
    np.testing.assert_allclose(ended.T_world_tool[:3, 3], state.T_world_tool[:3, 3], atol=2e-3)


def test_an_open_path_is_followed_to_its_end(state: State) -> None:
    """At the end the arm stops; the feedforward does not drive it on."""
    end = state.T_world_tool.copy()
    end[:3, 3] += [-0.05, 0.08, 0.04]
    path = LinePath(state.T_world_tool, end, 2.0)
    state = with_command(gate.keep_orientation(False)(state), FollowPath(path, 0.0, playing=True))
    halfway, ended = after(state, 1.0), after(state, 3.0)
    assert 0.9 < halfway.request.path_s < 1.1
    assert halfway.request.command.playing
    assert np.linalg.norm(halfway.T_world_tool[:3, 3] - path.pose(halfway.request.path_s)[:3, 3]) < 2e-4
    assert (ended.request.path_s, ended.request.command.playing, ended.arm.moving) == (2.0, False, False)
    np.testing.assert_allclose(ended.T_world_tool[:3, 3], end[:3, 3], atol=1e-4)


def test_the_gripper_moves_at_its_own_speed(state: State) -> None:
    state = gate.set_gripper(1.0)(state)
    assert after(state, 0.25).arm.gripper == pytest.approx(0.5)
    assert after(state, 1.0).arm.gripper == 1.0
    assert after(gate.stop()(after(state, 0.25)), 1.0).arm.gripper == pytest.approx(0.5)
