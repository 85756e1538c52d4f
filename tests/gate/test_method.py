"""What may be requested of a method: names, settings, gains, objectives, a second arm; and what is refused in words."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.ik import methods, objectives
from helicoide.state import State, Update

FORGED = [np.nan, np.inf, -1.0, 1e9, "one", None, [1.0, 2.0], {}]


@pytest.fixture
def moving(state: State) -> State:
    """The arm on its way to a pose."""
    return after(gate.set_target([0.45, 0.15, 0.25], [1, 0, 0, 0])(state), 0.1)


def refused(state: State, request: Update) -> bool:
    """Whether nothing changed but the notice."""
    after_it = request(state)
    kept = (
        after_it.request.controller is state.request.controller
        and after_it.compared is state.compared
        and after_it.arm.q is state.arm.q
    )
    return kept and after_it.notice is not None and after_it.notice is not state.notice


@pytest.mark.parametrize("name", methods.names())
def test_a_method_takes_over_where_the_arm_is(moving: State, name: str) -> None:
    state = gate.choose_method(name)(moving)
    assert state.arm.q is moving.arm.q
    assert state.request.command is moving.request.command
    later = after(state, 0.05)
    assert later.request.controller.method == name
    assert (later.arm.q is state.arm.q) == (later.request.controller.refusal is not None)


@pytest.mark.parametrize("value", FORGED)
def test_forged_settings_gains_and_weights_change_nothing(moving: State, value: object) -> None:
    state = gate.choose_objective("limit_distance")(gate.choose_method("damped")(moving))
    assert refused(state, gate.set_option("damped", "damping", value))
    assert refused(state, gate.set_gain(0, value))  # type: ignore[arg-type]
    assert refused(state, gate.weigh_objective(value))  # type: ignore[arg-type]
    assert refused(state, gate.set_objective("nonsense", value))


@pytest.mark.parametrize(
    "ask",
    [
        lambda: gate.choose_method("magic"),
        lambda: gate.compare_with("magic"),
        lambda: gate.choose_objective("magic"),
        lambda: gate.set_option("magic", "damping", 0.1),
        lambda: gate.set_option("damped", "nonsense", 0.1),
        lambda: gate.set_gain(7, 5.0),
        lambda: gate.weigh_objective(5.0),
        lambda: gate.objective_as_row(True),
    ],
)
def test_what_does_not_exist_is_refused(moving: State, ask: Callable[[], Update]) -> None:
    assert refused(moving, ask())


def test_settings_outlive_a_change_of_method_and_hold_for_both_arms(moving: State) -> None:
    state = gate.compare_with("damped")(gate.choose_method("damped")(moving))
    state = gate.set_option("damped", "damping", 0.5)(state)
    assert state.compared is not None
    assert (
        state.request.controller.options("damped").damping == state.compared.controller.options("damped").damping == 0.5
    )
    state = gate.choose_method("damped")(gate.choose_method("pseudoinverse")(state))
    assert state.request.controller.options("damped").damping == 0.5


def test_a_gain_of_one_axis_makes_that_axis_faster(moving: State) -> None:
    state = gate.keep_orientation(False)(gate.choose_method("pseudoinverse")(moving))
    left = state.T_world_tool[:3, 3] - [0.45, 0.15, 0.25]
    slow = after(gate.set_gain(1, 0.5)(state), 0.2).T_world_tool[:3, 3] - [0.45, 0.15, 0.25]
    assert abs(slow[1]) > 0.8 * abs(left[1])
    assert abs(slow[0]) < 0.3 * abs(left[0])


@pytest.mark.parametrize("name", objectives.names())
def test_an_objective_that_cannot_be_a_row_is_not_made_one(moving: State, name: str) -> None:
    state = gate.choose_objective(name)(moving)
    assert refused(state, gate.objective_as_row(True)) != objectives.named(name).AUGMENTS


def test_an_objective_moves_the_joints_and_leaves_the_tool(state: State) -> None:
    """Middle of the limits in the null space: the posture changes while the tool stays on its target."""
    state = gate.keep_orientation(False)(gate.choose_method("pseudoinverse")(state))
    T = state.T_world_tool
    state = gate.set_target(T[:3, 3], [1, 0, 0, 0])(state)
    pushed = after(gate.weigh_objective(100.0)(gate.choose_objective("limit_distance")(state)), 2.0)
    assert np.abs(pushed.arm.q - state.arm.q).max() > 0.05
    assert np.linalg.norm(pushed.T_world_tool[:3, 3] - T[:3, 3]) < 1e-4


def test_weights_grow_where_a_joint_is_stopped(state: State) -> None:
    """Algorithm 1: towards a target that needs a joint beyond its limit, the weight of that joint grows."""
    state = gate.keep_orientation(False)(gate.choose_method("pseudoinverse")(state))
    state = gate.grow_weights(True)(gate.weigh_objective(10.0)(gate.choose_objective("limit_distance")(state)))
    state = after(gate.set_target([-0.3, 0.3, 0.3], [1, 0, 0, 0])(state), 3.0)
    assert state.request.controller.secondary is not None
    assert state.request.controller.secondary.weights is not None
    assert state.request.controller.secondary.weights.max() > 10.0 >= state.request.controller.secondary.weights.min()


def test_the_arm_beside_follows_the_same_target_and_comes_back(moving: State) -> None:
    state = gate.compare_with("damped")(gate.keep_orientation(False)(moving))
    assert state.compared is not None
    assert state.compared.arm.q is state.arm.q
    state = after(state, 4.0)
    other = state.compared_state
    assert other is not None
    np.testing.assert_allclose(other.T_world_tool[:3, 3], [0.45, 0.15, 0.25], atol=1e-3)
    home = after(gate.get_ready()(state), 6.0)
    assert home.compared is not None
    np.testing.assert_allclose(home.compared.arm.q, home.arm.q, atol=1e-2)
    assert gate.compare_with(None)(home).compared is None


def test_stop_stops_both_arms(moving: State) -> None:
    state = gate.stop()(after(gate.compare_with("damped")(moving), 0.1))
    stopped = after(state, 0.5)
    assert stopped.compared is not None
    assert state.compared is not None
    assert stopped.arm.q is state.arm.q
    assert stopped.compared.arm.q is state.compared.arm.q


def test_parking_takes_the_arm_beside_along(state: State) -> None:
    parked = after(gate.park()(gate.compare_with("pseudoinverse")(state)), 8.0)
    assert parked.arm.parked
    assert parked.compared is not None
    np.testing.assert_array_equal(parked.compared.arm.q, parked.arm.q)
