"""The ball: gripped, carried and let go; taken from stand to stand by points that are taught; refused in words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
import viser
from tests.driving import after

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import Replay
from helicoide.foresight import advance_with_search
from helicoide.gate.running import replay_through
from helicoide.kinematics.ball import BALL_RADIUS, GRASP_DISTANCE, holding_opening
from helicoide.kinematics.library import load_robot
from helicoide.readout import plane_distances
from helicoide.seat import Seat
from helicoide.state import State, initial_state
from helicoide.view.layers import Stage, ball
from helicoide.view.window_view import View


@pytest.fixture
def holding(state: State) -> State:
    """The Movemaster with its fingers closed on a ball that was put between them."""
    open_ = after(gate.set_gripper(1.0)(state), 0.6)
    there = gate.put_ball(open_.T_world_tool[:3, 3])(open_)
    return after(gate.set_gripper(0.0)(there), 0.6)


def centre(state: State) -> Array:
    assert state.ball is not None
    return state.ball.centre


def test_the_ball_stops_the_fingers_and_follows_the_tool(holding: State) -> None:
    gripper = holding.robot.gripper
    assert gripper is not None
    assert gripper.opening * holding.arm.gripper == pytest.approx(2 * BALL_RADIUS)
    assert holding_opening(gripper) == pytest.approx(0.0427 / 0.060)
    moved = after(gate.set_joint(0, 0.3)(holding), 2.0)
    assert np.linalg.norm(centre(moved) - centre(holding)) > 0.1
    np.testing.assert_allclose(centre(moved), moved.T_world_tool[:3, 3], atol=1e-12)


def test_it_stays_where_it_is_let_go(holding: State) -> None:
    open_ = after(gate.set_gripper(1.0)(holding), 0.6)
    there = centre(open_)
    away = after(gate.set_joint(0, 0.3)(open_), 2.0)
    np.testing.assert_array_equal(centre(away), there)
    closed = after(gate.set_gripper(0.0)(away), 0.6)
    assert closed.arm.gripper == 0.0


@pytest.mark.parametrize("sideways", [0.9 * GRASP_DISTANCE, 1.1 * GRASP_DISTANCE])
def test_only_what_is_between_the_fingers_is_taken(state: State, sideways: float) -> None:
    open_ = after(gate.set_gripper(1.0)(state), 0.6)
    beside = gate.put_ball(open_.T_world_tool[:3, 3] + [0, sideways, 0])(open_)
    closed = after(gate.set_gripper(0.0)(beside), 0.6)
    assert closed.ball is not None
    assert (closed.ball.grasp_offset is not None) == (sideways < GRASP_DISTANCE) == (closed.arm.gripper > 0)
    np.testing.assert_array_equal(centre(closed), centre(beside))


def test_fingers_that_are_closed_take_nothing(state: State) -> None:
    there = after(gate.put_ball(state.T_world_tool[:3, 3])(state), 0.6)
    assert there.arm.gripper == 0.0
    assert there.ball is not None
    assert there.ball.grasp_offset is None


def test_stop_keeps_hold_of_it(holding: State) -> None:
    stopped = after(gate.stop()(holding), 0.5)
    assert stopped.ball is not None
    assert stopped.ball.grasp_offset is not None
    assert stopped.arm.gripper == holding.arm.gripper


def test_the_golf_ball_is_taken_from_stand_to_stand(state: State) -> None:
    """Cerbaro 2022, §3.2, fig. 21: known postures, gripper opened and closed, the object moved; planes keep 80 mm."""
    state = gate.pick_and_place()(state)
    assert state.ball is not None
    first, second = state.ball.supports + np.array([0, 0, BALL_RADIUS])
    np.testing.assert_array_equal(centre(state), first)
    state, highest, nearest = replay_through(state)(state), 0.0, np.inf
    assert isinstance(state.request.command, Replay)
    for _ in range(4000):
        if not isinstance(state.request.command, Replay):
            break
        state = advance_with_search(state, 0.01)
        highest, nearest = max(highest, centre(state)[2]), min(nearest, plane_distances(state).min())
    state = after(state, 1.0)
    assert state.ball is not None
    assert state.ball.grasp_offset is None
    np.testing.assert_allclose(centre(state), second, atol=1e-3)
    assert highest > first[2] + 0.05
    assert nearest >= 0.080 - 1e-9
    assert state.arm.gripper == 1.0


def test_without_the_gripper_in_the_points_the_ball_stays(state: State) -> None:
    state = gate.pick_and_place()(state)
    first = centre(state)
    for name in state.taught.names:
        state = gate.set_grip(name, "")(state)
    state = after(replay_through(state)(state), 12.0)
    np.testing.assert_array_equal(centre(state), first)


def test_what_cannot_be_is_refused_in_words(state: State) -> None:
    for request, words in (
        (gate.put_ball([np.nan, 0, 0]), "not a finite number"),
        (gate.put_ball([90, 0, 0]), "within"),
        (gate.set_grip("A1", "ajar"), "it may be: open, closed"),
    ):
        taught = gate.pick_and_place()(state)
        refused = request(taught)
        assert refused.notice is not None
        assert words in refused.notice.en
        assert refused.ball is taught.ball
    other = initial_state(load_robot("orca"))
    for request, words in (
        (gate.put_ball([0.1, 0, 0]), "no gripper that opens wide enough"),
        (gate.pick_and_place(), "movemaster"),
    ):
        refused = request(other)
        assert refused.notice is not None
        assert words in refused.notice.en
    assert gate.take_ball_away()(gate.pick_and_place()(state)).ball is None


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield server
    server.stop()


def test_the_ball_and_its_stands_are_drawn_where_they_are(server: viser.ViserServer, state: State) -> None:
    layer = ball.build(Stage(server.scene, state.robot, [], lambda request: None, ""))
    seat = Seat(token="", language="en")
    none, some = View(state, seat), View(gate.pick_and_place()(state), seat)
    layer.update(None, none)
    assert not layer.sphere.visible
    layer.update(none, some)
    assert layer.sphere.visible
    np.testing.assert_allclose(layer.sphere.position, centre(some.state))
    assert some.state.ball is not None
    for column, top in zip(layer.columns, some.state.ball.supports, strict=True):
        assert column.position[2] + column.height / 2 == pytest.approx(top[2])
    alone = View(replace(some.state, ball=replace(some.state.ball, supports=some.state.ball.supports[:0])), seat)
    layer.update(some, alone)
    assert layer.columns == []
    layer.update(alone, none)
    assert not layer.sphere.visible
