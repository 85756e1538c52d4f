"""Comparison of two methods: the recorded values of both arms, and the motion to a singular posture."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate, readout
from helicoide.command import MoveToPose
from helicoide.comparison import SPACING, SPAN, Effort, Trace
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.ik.postures.singular import singular_posture
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.kinematics.singularity import NEAR_SINGULAR, singularity
from helicoide.seat import Seat
from helicoide.session.postures import to_singular_posture
from helicoide.state import State, initial_state
from helicoide.view.comparison import comparison_charts, largest_values
from helicoide.view.window_view import View

DT = 0.01


def test_a_trace_keeps_the_last_seconds_and_the_largest_of_all() -> None:
    trace = Trace().with_tick(Effort(900.0, 3.0, 0.5), Effort(1.0, 1.0, 0.4), DT)
    for k in range(3000):
        trace = trace.with_tick(Effort(k / 3000, 0.5, 0.1), Effort(0.2, 0.2, 0.0), DT)
    assert trace.seconds == pytest.approx(30.01)
    assert trace.times[-1] - trace.times[0] <= SPAN
    assert SPAN / SPACING - 2 <= len(trace.times) <= SPAN / SPACING + 1
    assert trace.efforts[:, 0, 0].max() < 1, "the peak has left the chart"
    np.testing.assert_allclose(trace.largest, [[900, 3, 0.5], [1, 1, 0.4]])


def compared(state: State, first: str, second: str) -> State:
    return gate.compare_with(second)(gate.choose_method(first)(state))


@pytest.mark.parametrize("with_orientation", [True, False])
@pytest.mark.parametrize("name", robot_titles())
def test_a_singular_posture_is_found_where_there_is_one(name: str, with_orientation: bool) -> None:
    """`polar_rp` has none: its slide cannot reach the axis of its first joint. Nor has `free_body` for its position."""
    problem = initial_state(load_robot(name)).problem
    q = singular_posture(problem, with_orientation)
    if name == "polar_rp" or (name == "free_body" and not with_orientation):
        assert q is None
        return
    assert q is not None
    assert ((problem.limits.lower <= q) & (q <= problem.limits.upper)).all()
    assert (clearances(packed(problem), q) > 0).all()
    there = singularity(problem.robot, q, with_orientation)
    assert there.tool.relative_singular_value < NEAR_SINGULAR
    assert there.warning() is not None


def test_at_a_singular_posture_the_pseudoinverse_asks_for_what_damping_does_not() -> None:
    state = compared(initial_state(load_robot("planar2r")), "pseudoinverse", "damped")
    state = to_singular_posture(state)(state)
    assert isinstance(state.request.command, MoveToPose)
    state = after(state, 4.0)
    assert state.compared is not None
    trace = state.compared.trace
    (asked, speed, _), (damped, *_) = trace.largest
    assert asked > 10 * damped
    assert speed <= np.linalg.norm(state.problem.limits.speed) + 1e-9, "the guard allows no more"
    np.testing.assert_array_less(trace.efforts.max(axis=0), trace.largest + 1e-12)
    view = View(state, Seat("student", "en"))
    charts = comparison_charts(view)
    assert [len(chart.lines) for chart in charts] == [2, 2]
    assert comparison_charts(view)[0] is charts[0], "drawn once"
    assert "damped least squares" in largest_values(view)


def test_two_arms_with_one_method_stay_together_on_a_path() -> None:
    """Both follow the point of the same instant, so that their errors can be compared."""
    state = compared(gate.keep_orientation(False)(initial_state(load_robot("planar3r"))), "damped", "damped")
    state = after(gate.play()(gate.set_duration(5.0)(gate.choose_path("circle")(state))), 4.0)
    assert state.compared is not None
    assert state.request.path_s > 1.0
    np.testing.assert_allclose(state.compared.arm.q, state.arm.q, atol=1e-12)


def test_what_is_recorded_stays_while_nothing_moves_and_is_new_for_another_method() -> None:
    state = compared(initial_state(load_robot("planar3r")), "pseudoinverse", "damped")
    T = state.T_world_tool
    state = after(gate.set_target(T[:3, 3] - [0.1, 0.0, 0.0], [1, 0, 0, 0])(state), 6.0)
    assert state.compared is not None
    later = after(state, 1.0)
    assert later.compared is not None
    assert later.compared.trace is state.compared.trace
    fresh = gate.choose_method("transpose")(state)
    assert fresh.compared is not None
    assert len(fresh.compared.trace.times) == 0
    again = gate.compare_with("filtered")(state)
    assert again.compared is not None
    assert len(again.compared.trace.times) == 0


def test_both_arms_go_to_the_singular_posture_from_one_place() -> None:
    state = compared(initial_state(load_robot("movemaster")), "pseudoinverse", "damped")
    state = after(gate.set_target(state.T_world_tool[:3, 3] + [0, 0.05, 0.05], [1, 0, 0, 0])(state), 0.5)
    started = to_singular_posture(state)(state)
    assert started.compared is not None
    assert (started.compared.arm.q == state.arm.q).all()
    assert started.compared.trace.seconds == 0.0


def test_an_arm_without_singular_posture_says_so() -> None:
    state = initial_state(load_robot("polar_rp"))
    refused = to_singular_posture(state)(state)
    assert "No singular posture" in readout.status(refused).text.en
    assert replace(refused, notice=None).request.command == state.request.command
