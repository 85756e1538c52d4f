"""Planned motions: nothing moves before they are executed, and then the arm comes to where the ghost ended."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after
from tests.kinematics.arms import arm

from helicoide import content, gate
from helicoide.arrays import frozen
from helicoide.command import HoldPosition, Replay
from helicoide.contributions.trials import with_joints
from helicoide.gate import planning
from helicoide.session.planning import MOVING, NO_MOTION, TOO_LONG, plan_motion
from helicoide.state import State, initial_state
from helicoide.text import Text

TITLE = Text(en="there", pt_BR="lá")
NAMES = sorted(content.content_folders("robots"))


def planned(state: State, joint: int = 0, way: float = 0.2) -> State:
    """The state with a plan that moves one joint."""
    value = float(np.clip(state.arm.q[joint] + way, state.robot.lower[joint], state.robot.upper[joint]))
    return plan_motion(state, gate.set_joint(joint, value), TITLE)(state)


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_moves_nothing_and_its_execution_ends_where_it_ends(name: str) -> None:
    state = planned(initial_state(arm(name)))
    assert state.plan is not None
    assert state.request.command == HoldPosition()
    waited = after(state, 1.0)
    np.testing.assert_array_equal(waited.arm.q, state.arm.q)
    np.testing.assert_array_equal(state.plan.q[0], state.arm.q)
    begun = gate.execute_plan()(waited)
    assert isinstance(begun.request.command, Replay)
    assert begun.plan is None
    done = after(begun, float(state.plan.times[-1]) + 4.0)
    np.testing.assert_allclose(done.arm.q, state.plan.q[-1], rtol=0, atol=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_keeps_the_speed_limits(name: str) -> None:
    plan = planned(initial_state(arm(name))).plan
    assert plan is not None
    speeds = np.abs(np.diff(plan.q, axis=0)) / np.diff(plan.times)[:, None]
    assert (speeds <= arm(name).speed * (1 + 1e-9)).all()


def test_a_plan_is_refused_elsewhere_after_a_change_and_without_one() -> None:
    state = planned(initial_state(arm("movemaster")))
    moved = with_joints(state, frozen(state.arm.q + 0.01))
    changed = gate.add_obstacle()(state)
    for refused, why in (
        (gate.clear_plan()(state), planning.NO_PLAN),
        (moved, planning.ELSEWHERE),
        (changed, planning.OUTDATED),
        (replace(state, arm=replace(state.arm, parked=True)), gate.PARKED),
    ):
        after_request = gate.execute_plan()(refused)
        assert after_request.notice == why
        assert after_request.request.command is refused.request.command


def test_what_cannot_be_planned_is_said() -> None:
    state = initial_state(arm("movemaster"))
    running = replace(state, arm=replace(state.arm, velocities=frozen(np.ones(5))))
    parked = replace(state, arm=replace(state.arm, parked=True))
    nowhere = gate.go_to_posture(99)(state)
    assert plan_motion(running, gate.get_ready(), TITLE)(running).notice == MOVING
    assert plan_motion(parked, gate.get_ready(), TITLE)(parked).notice == gate.PARKED
    assert plan_motion(state, lambda state: state, TITLE)(state).notice == NO_MOTION
    assert plan_motion(state, gate.go_to_posture(99), TITLE)(state).notice == nowhere.notice
    forever = plan_motion(state, gate.play(), TITLE)(state)
    assert forever.plan is not None or forever.notice == TOO_LONG.format(seconds=60.0)


def test_stop_keeps_the_arm_where_it_is_and_the_plan_can_be_refused_then() -> None:
    state = planned(initial_state(arm("movemaster")), way=0.5)
    half = after(gate.execute_plan()(state), 0.4)
    stopped = after(gate.stop()(half), 3.0)
    assert np.abs(stopped.arm.q - state.arm.q).max() > 0.01
    assert gate.execute_plan()(stopped).notice == planning.NO_PLAN
