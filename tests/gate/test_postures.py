"""The postures of a goal: listed, put in order, gone to; what is not in the list is refused in words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate, readout
from helicoide.command import MoveToJoints
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.postures.choice import OUT_OF_LIMITS, barrier
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.session.postures import list_postures
from helicoide.state import PostureList, State, initial_state


def listed(state: State) -> PostureList:
    found = list_postures(state)(state).postures.listing
    assert found is not None
    return found


def puma() -> State:
    state = initial_state(load_robot("puma560"))
    return list_postures(state)(state)


def test_every_posture_has_the_tool_at_the_target_and_the_one_that_the_arm_has_is_first() -> None:
    state = puma()
    rows = listed(state).rows
    assert len({row.branch.name.en for row in rows}) == len(rows) == 8
    np.testing.assert_allclose(rows[0].q, state.arm.q, atol=1e-9)
    for row in rows:
        np.testing.assert_allclose(tool_at(state.robot, row.q), state.T_world_tool, atol=1e-9)
        outside = bool(((row.q < state.robot.lower) | (row.q > state.robot.upper)).any())
        assert (row.dropped is OUT_OF_LIMITS) == outside


def test_the_arm_goes_to_a_posture_of_the_list_and_has_the_same_pose_there() -> None:
    state = puma()
    q_target = listed(state).rows[1].q
    gone = after(gate.go_to_posture(1)(state), 12.0)
    assert isinstance(gone.request.command, MoveToJoints)
    np.testing.assert_allclose(gone.arm.q, q_target, atol=2e-3)
    np.testing.assert_allclose(gone.T_world_tool, state.T_world_tool, atol=5e-3)


def test_a_posture_outside_the_limits_or_of_no_list_is_refused(state: State) -> None:
    assert gate.go_to_posture(0)(state).notice is not None
    shown = list_postures(state)(state)
    place = next(k for k, row in enumerate(listed(state).rows) if row.dropped is OUT_OF_LIMITS)
    for refused in (gate.go_to_posture(place)(shown), gate.go_to_posture(9)(shown), gate.go_to_posture(-1)(shown)):
        assert refused.notice is not None
        assert refused.request is shown.request
    assert "fora dos limites" in gate.go_to_posture(place)(shown).notice.pt_BR  # type: ignore[union-attr]


def test_the_goal_is_the_target_where_there_is_one(state: State) -> None:
    there = gate.set_target(state.T_world_tool[:3, 3] + [0.0, 0.0, 0.1], [1.0, 0.0, 0.0, 0.0])(state)
    np.testing.assert_array_equal(listed(there).T_world_goal, readout.target_pose(there))
    assert listed(there).T_world_goal[2, 3] == pytest.approx(state.T_world_tool[2, 3] + 0.1)


def test_weights_put_the_list_in_another_order() -> None:
    """With the shoulder's way for nothing the other shoulder comes before its flipped wrist."""
    state = puma()
    before = [row.cost for row in listed(state).rows if row.dropped is None]
    assert before == sorted(before)
    weighed = gate.weigh_joint(0, 0.0)(state)
    assert weighed.postures.listing is not None
    for row, found in zip(weighed.postures.listing.rows, listed(weighed).rows, strict=True):
        assert row.cost == pytest.approx(float(np.abs(row.change[1:]).sum()))
        assert row.branch.name == found.branch.name
    for wrong in (-1.0, 11.0, np.nan):
        assert gate.weigh_joint(0, wrong)(state).postures is state.postures


def test_what_is_too_near_stands_last_and_is_named() -> None:
    state = puma()
    other = listed(state).rows[1].q
    assert readout.too_near(state.problem, other) is None
    elbow = link_poses(state.robot.chain, other)[3, :3, 3]
    blocked = gate.set_obstacle(0, elbow)(gate.add_obstacle()(state))
    words = readout.too_near(blocked.problem, other)
    assert words is not None
    assert "obstacle 1" in words.en
    assert "obstáculo 1" in words.pt_BR
    rows = listed(blocked).rows
    clear = [row.dropped is None and barrier(blocked.problem, row.q) is None for row in rows]
    assert clear == sorted(clear, reverse=True)


def test_a_list_is_for_the_arm_that_stands_there(state: State) -> None:
    other = initial_state(load_robot("planar2r"))
    assert gate.while_there(state, list_postures(state))(other) is other
    assert replace(other).postures.listing is None
