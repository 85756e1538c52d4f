"""Spheres in the way: the arm stops at them, they stop at the arm, and what is wrong changes nothing."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from tests.driving import after, apart

from helicoide import content, gate
from helicoide.confinement import Obstacles
from helicoide.foresight import foreseen
from helicoide.ik import ObstacleContact
from helicoide.kinematics.library import load_robot
from helicoide.readout import limited_by, limiting, status
from helicoide.state import State, Update, initial_state

UP = [1.0, 0.0, 0.0, 0.0]
PLACE = [0.42, 0.3, 0.3]


@pytest.fixture
def beside_it(state: State) -> State:
    """A sphere of 49 mm inside the planes of the Movemaster, where its tool can come to it."""
    return gate.set_obstacle(0, PLACE)(gate.add_obstacle()(state))


def obstacles(state: State) -> Obstacles:
    return state.problem.obstacles


def drag(state: State, to: object, phases: tuple[gate.Phase, ...] = ("start", "update", "end")) -> State:
    for phase in phases:
        state = gate.drag_obstacle("seat", phase, 0, to)(state)  # type: ignore[arg-type]
    return state


@pytest.mark.parametrize("name", sorted(content.content_folders("robots")))
def test_spheres_are_put_beside_any_arm_and_touch_neither_it_nor_each_other(name: str) -> None:
    state = initial_state(load_robot(name))
    for count in range(1, 4):
        state = gate.add_obstacle()(state)
        assert state.notice is None
        assert len(obstacles(state).radii) == count
        assert apart(state) >= -1e-9
    centres, radii = obstacles(state).ends[:, 0], obstacles(state).radii
    for i in range(3):
        for j in range(i):
            assert np.linalg.norm(centres[i] - centres[j]) > radii[i] + radii[j]


def test_there_are_six_at_most(state: State) -> None:
    for _ in range(6):
        state = gate.add_obstacle()(state)
    full = gate.add_obstacle()(state)
    assert obstacles(full) is obstacles(state)
    assert full.notice is not None


def test_the_arm_stops_at_a_sphere_and_says_so() -> None:
    state = gate.add_obstacle()(gate.keep_orientation(False)(initial_state(load_robot("puma560"))))
    centre = obstacles(state).ends[0, 0]
    state = gate.set_target(centre, UP)(state)
    assert "obstacle 1" in status(foreseen(state)).text.en
    least = np.inf
    for _ in range(400):
        state = after(state, 0.01)
        least = min(least, apart(state))
    assert least >= -1e-9
    assert apart(state) < 1e-3
    assert any(isinstance(reason, ObstacleContact) for reason in limited_by(state))
    assert np.linalg.norm(state.T_world_tool[:3, 3] - centre) > obstacles(state).radii[0]


@pytest.mark.parametrize("method", ["pseudoinverse", "filtered", "transpose"])
def test_no_method_drives_the_arm_into_a_sphere(beside_it: State, method: str) -> None:
    state = gate.choose_method(method)(gate.keep_orientation(False)(beside_it))
    state = gate.set_target(obstacles(state).ends[0, 0], UP)(state)
    for _ in range(300):
        state = after(state, 0.01)
        assert apart(state) >= -1e-9
    assert apart(state) < 1e-3
    assert "obstáculo 1" in " ".join(text.pt_BR for text in limiting(state))


def test_a_dragged_sphere_stops_at_the_arm_and_goes_around_it(beside_it: State) -> None:
    start = obstacles(beside_it).ends[0, 0]
    elbow = beside_it.monitored_points[2]
    state = drag(beside_it, elbow, ("start", "update"))
    assert 0 <= apart(state) < 2e-3
    assert state.notice is not None
    assert state.request.drag is not None
    away = drag(state, start + (start - elbow), ("update", "end"))
    np.testing.assert_array_equal(obstacles(away).ends[0, 0], start + (start - elbow))
    assert away.request.drag is None
    assert away.notice is None


def test_a_sphere_that_runs_through_the_arm_in_one_step_stops_before_it(beside_it: State) -> None:
    start, elbow = obstacles(beside_it).ends[0, 0], beside_it.monitored_points[2]
    through = drag(beside_it, elbow + (elbow - start))
    assert apart(through) >= 0
    assert np.linalg.norm(obstacles(through).ends[0, 0] - elbow) < np.linalg.norm(start - elbow)
    assert (obstacles(through).ends[0, 0] - elbow) @ (start - elbow) > 0


def test_only_the_hand_that_holds_a_sphere_moves_it(beside_it: State) -> None:
    held = gate.drag_obstacle("one", "start", 0, obstacles(beside_it).ends[0, 0])(beside_it)
    other = gate.drag_obstacle("other", "update", 0, [0.2, 0.6, 0.2])(held)
    np.testing.assert_array_equal(obstacles(other).ends, obstacles(held).ends)


def test_a_sphere_grows_as_far_as_the_arm_leaves_room(beside_it: State) -> None:
    near = drag(beside_it, beside_it.monitored_points[2])
    grown = gate.set_obstacle_radius(0, 0.2)(near)
    assert obstacles(grown).radii[0] < 0.2
    assert apart(grown) >= -1e-9
    assert grown.notice is not None
    small = gate.set_obstacle_radius(0, 0.03)(grown)
    assert obstacles(small).radii[0] == 0.03
    assert small.notice is None


def test_the_arm_beside_stops_a_sphere_too(beside_it: State) -> None:
    state = after(gate.set_joint(0, 0.6)(gate.keep_orientation(False)(beside_it)), 0.2)
    both = gate.compare_with("damped")(state)
    assert both.compared is not None
    state = after(gate.set_target([0.3, -0.3, 0.3], UP)(both), 0.3)
    other = state.compared_state
    assert other is not None
    pushed = drag(state, other.monitored_points[-1])
    beside = pushed.compared_state
    assert beside is not None
    assert apart(beside) >= 0


def test_an_arm_does_not_park_past_obstacles(beside_it: State) -> None:
    refused = gate.park()(beside_it)
    assert refused.request.command is beside_it.request.command
    assert refused.notice is not None
    assert after(gate.park()(gate.remove_obstacle(0)(beside_it)), 8.0).arm.parked


@pytest.mark.parametrize("index", [1, -1, 0.5, np.nan, None, "0"])
def test_a_sphere_that_is_not_there(beside_it: State, index: int) -> None:
    requests: list[Callable[[int], Update]] = [
        gate.remove_obstacle,
        lambda n: gate.set_obstacle(n, [0.5, 0.5, 0.5]),
        lambda n: gate.set_obstacle_radius(n, 0.05),
        lambda n: gate.drag_obstacle("seat", "start", n, [0.5, 0.5, 0.5]),
    ]
    for request in requests:
        refused = request(index)(beside_it)
        assert obstacles(refused) is obstacles(beside_it)
        assert refused.request.drag is None
        assert refused.notice is not None


@pytest.mark.parametrize("value", [np.nan, np.inf, -1.0, 0.0, 5.0, "one", None, [0.1, 0.1], {}])
def test_forged_numbers_change_nothing(beside_it: State, value: object) -> None:
    for refused in (
        gate.set_obstacle_radius(0, value)(beside_it),  # type: ignore[arg-type]
        gate.set_obstacle(0, [value, 0.4, 0.4] if isinstance(value, float) and abs(value) > 1 else value)(beside_it),  # type: ignore[arg-type,list-item]
    ):
        if isinstance(value, float) and value == -1.0:
            continue
        assert obstacles(refused) is obstacles(beside_it)
        assert refused.notice is not None


def test_an_objective_keeps_the_joints_away_from_spheres(state: State) -> None:
    """Vargas 2013, eq. 4.74, with the centres of the spheres for the points of the second arm."""
    state = gate.keep_orientation(False)(gate.choose_method("pseudoinverse")(state))
    state = drag(gate.add_obstacle()(state), state.monitored_points[2])
    state = gate.set_target(state.T_world_tool[:3, 3], UP)(state)
    pushed = after(gate.weigh_objective(1.0)(gate.choose_objective("second_arm")(state)), 3.0)
    before = np.linalg.norm(state.monitored_points - obstacles(state).ends[0, 0], axis=1).min()
    now = np.linalg.norm(pushed.monitored_points - obstacles(state).ends[0, 0], axis=1).min()
    assert now > before + 1e-3
    assert np.linalg.norm(pushed.T_world_tool[:3, 3] - state.T_world_tool[:3, 3]) < 1e-3
