"""The entry point: held where the instrument is, followed when it moves, refused where it cannot be."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.ik.rcm.passage import insertion
from helicoide.ik.rcm.tip_task import passage_of
from helicoide.kinematics.library import load_robot
from helicoide.readout import instruments, status
from helicoide.state import State, initial_state

UP = [1.0, 0.0, 0.0, 0.0]
METHODS = ["guarded", "pseudoinverse", "damped", "filtered", "filtered_modified", "damped_by_manipulability"]


def beside(state: State) -> float:
    """How far the entry point lies beside the shaft, m."""
    entry = state.problem.entry
    assert entry is not None
    passage = passage_of(state.robot, entry)
    place = insertion(passage, state.arm.poses[passage.link] @ passage.T_link_shaft, entry.point)
    return float(np.linalg.norm(place.lateral))


@pytest.fixture(params=["dia10", "dia10_rod"])
def held(request: pytest.FixtureRequest) -> State:
    """An arm that holds its instrument in the entry point where it is, and moves it by its position alone."""
    return gate.enforce_entry(True)(gate.keep_orientation(False)(initial_state(load_robot(request.param))))


def test_it_is_held_where_the_instrument_is(held: State) -> None:
    assert held.notice is None
    assert beside(held) < 1e-12
    loose = gate.enforce_entry(False)(held)
    assert loose.problem.entry is None


@pytest.mark.parametrize("method", METHODS)
def test_the_instrument_stays_in_it_while_the_tip_moves(held: State, method: str) -> None:
    state = gate.choose_method(method)(held)
    T = state.T_world_tool
    goal = T[:3, 3] + 0.04 * T[:3, 0] + 0.02 * T[:3, 2]
    state = gate.set_target(goal, UP)(state)
    worst = 0.0
    for _ in range(600):
        state = after(state, 0.01)
        worst = max(worst, beside(state))
    assert state.request.controller.refusal is None
    assert worst < 1e-5, "0.01 mm"
    assert np.linalg.norm(state.T_world_tool[:3, 3] - goal) < 2e-3


@pytest.mark.parametrize("method", METHODS)
def test_the_whole_pose_is_held_through_the_constrained_jacobian(method: str) -> None:
    """Coutinho 2015, fig. 3.3, on the arm with eight joints: n − r = 6."""
    state = gate.enforce_entry(True)(gate.choose_method(method)(initial_state(load_robot("dia10"))))
    T = state.T_world_tool
    goal = T[:3, 3] + 0.02 * T[:3, 0]
    quat = [np.cos(0.05), 0.0, np.sin(0.05), 0.0]
    state = gate.set_target(goal, quat)(state)
    worst = 0.0
    for _ in range(500):
        state = after(state, 0.01)
        worst = max(worst, beside(state))
    assert state.request.controller.refusal is None
    assert worst < 1e-5
    if method != "guarded":
        assert state.request.controller.solution is not None


def test_an_entry_point_that_moves_takes_the_instrument_along(held: State) -> None:
    state = gate.set_target(held.T_world_tool[:3, 3], UP)(held)
    entry = state.problem.entry
    assert entry is not None
    start = entry.point
    state = gate.drag_entry("seat", "start", start)(state)
    up = np.array([0.0, 0.0, 0.02])
    for share in np.linspace(0.0, 1.0, 50):
        state = after(gate.drag_entry("seat", "update", start + share * up)(state), 0.02)
    state = after(gate.drag_entry("seat", "end", start + up)(state), 2.0)
    assert state.request.drag is None
    assert beside(state) < 1e-5
    assert np.linalg.norm(state.T_world_tool[:3, 3] - held.T_world_tool[:3, 3]) < 2e-3


def test_seven_joints_are_too_few_for_a_held_orientation_and_the_page_says_so() -> None:
    """n − r = 5 (Coutinho 2015, §5.1)."""
    state = gate.enforce_entry(True)(gate.choose_method("pseudoinverse")(initial_state(load_robot("dia10_rod"))))
    state = after(gate.set_target(state.T_world_tool[:3, 3], UP)(state), 0.1)
    assert state.request.controller.refusal is not None
    assert "n − r = 5" in status(state).text.en
    assert "n − r = 5" in status(state).text.pt_BR
    free = after(gate.keep_orientation(False)(state), 0.1)
    assert free.request.controller.refusal is None


def test_an_objective_has_no_joint_left_where_all_six_ways_are_held() -> None:
    state = gate.choose_objective("limit_distance")(gate.choose_method("damped")(initial_state(load_robot("dia10"))))
    state = gate.enforce_entry(True)(state)
    state = after(gate.set_target(state.T_world_tool[:3, 3], UP)(state), 0.05)
    assert state.request.controller.refusal is not None
    assert "objective" in state.request.controller.refusal.en


def test_it_is_read_off(held: State) -> None:
    read = {instrument.symbol: instrument.value for instrument in instruments(held)}
    assert read["e_r"] < 1e-6
    assert read["l_a"] == pytest.approx(150, abs=1e-6) or held.robot.name == "dia10_rod"
    assert ("w_r" in read) == (held.robot.name == "dia10")


def test_an_arm_without_an_instrument_is_refused(state: State) -> None:
    refused = gate.enforce_entry(True)(state)
    assert refused.problem is state.problem
    assert refused.notice is not None
    assert "rcm" in refused.notice.en


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e9, "one", None, {}])
def test_forged_numbers_change_nothing(held: State, value: object) -> None:
    requests: list[Callable[[object], State]] = [
        lambda point: gate.set_entry(point)(held),  # type: ignore[arg-type]
        lambda point: gate.drag_entry("seat", "start", point)(held),  # type: ignore[arg-type]
    ]
    for request in requests:
        for point in (value, [value, 0.0, 0.0]):
            refused = request(point)
            assert refused.problem is held.problem
            assert refused.notice is not None


def test_nothing_is_dragged_where_nothing_is_held(state: State) -> None:
    for refused in (gate.set_entry([0.1, 0.2, 0.3])(state), gate.drag_entry("seat", "start", [0, 0, 0])(state)):
        assert refused.problem is state.problem
        assert refused.request.drag is None
        assert refused.notice is not None
