"""Undo and redo: they restore what was there, never move an arm, and give way where the arm is now."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.driving import after

from helicoide import gate
from helicoide.advance import advance
from helicoide.command import HoldPosition, MoveToPose
from helicoide.gate.undoing import CONNECTED, NOTHING_TO_REDO, NOTHING_TO_UNDO
from helicoide.history import MOST_CHANGES, Undoable
from helicoide.ik import objectives
from helicoide.kinematics.library import load_robot
from helicoide.readout import plane_distances
from helicoide.state import Drag, State, Update, initial_state

DOWN = [0.0, 1.0, 0.0, 0.0]


def do(state: State, *updates: Update) -> State:
    """The state after updates as the workcell applies them; each is a change of its own."""
    for update in updates:
        state = gate.finish_change()(gate.recorded(state, update(state)))
    return state


def same(a: Undoable, b: Undoable) -> bool:
    """Whether two scenes have the same numbers, to rounding."""
    arrays = [
        (a.planes.normals, b.planes.normals),
        (a.planes.centres, b.planes.centres),
        (a.obstacles.ends, b.obstacles.ends),
        (a.obstacles.radii, b.obstacles.radii),
        *([(a.entry.point, b.entry.point)] if a.entry is not None and b.entry is not None else []),
    ]
    alike = all(x.shape == y.shape and np.allclose(x, y, rtol=0, atol=1e-8) for x, y in arrays)
    names, zones = a.planes.names == b.planes.names, a.zones == b.zones
    taught = a.taught.waypoints == b.taught.waypoints and a.taught.shape == b.taught.shape
    one, other = a.controller, b.controller
    method = (one.method, one.gains, one.changed) == (other.method, other.gains, other.changed)
    goals = [drive.secondary and (drive.secondary.objective, drive.secondary.weight) for drive in (one, other)]
    return (
        alike
        and names
        and zones
        and taught
        and method
        and goals[0] == goals[1]
        and (a.entry is None) == (b.entry is None)
    )


small = st.floats(-0.3, 0.3)
numbers = st.integers(0, 5)
waypoints = st.sampled_from(["P1", "P2", "P3"])
requests = st.one_of(
    st.builds(lambda x, y, z, d: gate.add_plane([x, y, z, d]), small, small, small, small),
    st.builds(gate.remove_plane, numbers),
    st.just(gate.clear_planes()),
    st.just(gate.restore_planes()),
    st.builds(lambda d: gate.set_box([0.1 - d, -0.5, 0.0], [1.0, 0.5, 0.9 + d]), st.floats(0.0, 0.3)),
    st.builds(gate.set_zones, st.floats(0.07, 0.15), st.floats(0.1, 0.25)),
    st.just(gate.add_obstacle()),
    st.builds(lambda k, x, y, z: gate.set_obstacle(k, [0.6 + x, y, 0.4 + z]), numbers, small, small, small),
    st.builds(gate.set_obstacle_radius, numbers, st.floats(0.01, 0.25)),
    st.builds(gate.remove_obstacle, numbers),
    st.just(gate.record()),
    st.builds(gate.delete_waypoint, waypoints),
    st.builds(gate.set_dwell, waypoints, st.floats(0, 5)),
    st.builds(gate.move_waypoint, waypoints, numbers),
    st.just(gate.choose_leg_shape("trapezoid")),
    st.builds(gate.choose_method, st.sampled_from(["guarded", "pseudoinverse", "damped"])),
    st.builds(gate.set_gain, numbers, st.floats(0.5, 50)),
    st.builds(gate.choose_objective, st.sampled_from([None, *objectives.names()])),
    st.builds(gate.weigh_objective, st.floats(0, 1000)),
    st.builds(gate.set_gain, numbers, st.just(np.nan)),
)


@settings(max_examples=60)
@given(asked=st.lists(requests, max_size=12))
def test_undo_returns_and_redo_makes_it_again_and_no_joint_moves(asked: list[Update]) -> None:
    state = initial_state(load_robot("movemaster"))
    scenes = [gate.undoable_of(state)]
    for update in asked:
        before, state = state, do(state, update)
        if len(state.history.undo) > len(before.history.undo):
            scenes.append(gate.undoable_of(state))
        assert same(gate.undoable_of(state), scenes[-1]), "what changes is recorded"
    q = state.arm.q
    for scene in reversed(scenes[:-1]):
        state = do(state, gate.undo_change())
        assert same(gate.undoable_of(state), scene)
    assert not state.history.undo
    for scene in scenes[1:]:
        state = do(state, gate.redo_change())
        assert same(gate.undoable_of(state), scene)
    assert not state.history.redo
    assert state.arm.q is q


def test_undo_lets_no_arm_go_on_that_a_plane_had_stopped(state: State) -> None:
    lowered = do(state, gate.set_box([0.0, -0.6, 0.0], [1.0, 0.6, 0.6]))
    blocked = after(gate.set_target([0.5, 0.0, 0.9], DOWN)(lowered), 4.0)
    undone = do(blocked, gate.undo_change())
    assert isinstance(undone.request.command, HoldPosition)
    assert undone.problem.planes.names == state.problem.planes.names
    assert undone.notice is not None
    assert "holds" in undone.notice.en
    assert (after(undone, 1.0).arm.q == blocked.arm.q).all()


def test_undo_in_the_middle_of_a_motion_is_not_a_motion(state: State) -> None:
    state = do(state, gate.set_gain(0, 20.0))
    moving = gate.set_target([0.4, 0.2, 0.4], DOWN)(state)
    for _ in range(20):
        moving = advance(moving, 0.01)
    assert moving.arm.moving
    undone = do(moving, gate.undo_change())
    assert (after(undone, 0.5).arm.q == moving.arm.q).all()


def test_waypoints_are_undone_without_a_stop(state: State) -> None:
    state = gate.set_target([0.4, 0.2, 0.4], DOWN)(do(state, gate.record()))
    undone = do(state, gate.undo_change())
    assert isinstance(undone.request.command, MoveToPose)
    assert undone.taught.waypoints == ()


def test_a_plane_that_returns_gives_way_to_the_arm(state: State) -> None:
    high = do(state, gate.set_box([0.0, -0.6, 0.0], [1.2, 0.6, 1.3]))
    there = after(gate.set_target([0.45, 0.0, 0.85], DOWN)(high), 6.0)
    undone = do(there, gate.undo_change())
    assert undone.arm.q is there.arm.q
    assert plane_distances(undone).min() >= state.problem.zones.critical - 1e-9
    assert undone.notice is not None
    assert "+z" in undone.notice.en
    assert "+z" in undone.notice.pt_BR


def test_an_obstacle_that_returns_gives_way_to_the_arm(state: State) -> None:
    state = do(state, gate.clear_planes(), gate.add_obstacle())
    centre = state.problem.obstacles.ends[0, 0]
    gone = do(state, gate.remove_obstacle(0))
    there = after(gate.set_target(centre, DOWN)(gone), 6.0)
    refused = do(there, gate.undo_change())
    assert not len(refused.problem.obstacles.radii)
    assert len(refused.history.undo) == len(there.history.undo), "it can be undone later"
    assert refused.notice is not None
    assert "obstacle 1" in refused.notice.en
    free = do(replace(refused, arm=state.arm), gate.undo_change())
    assert (free.problem.obstacles.ends[0, 0] == centre).all()


def test_a_moved_obstacle_returns_as_far_as_the_arm_lets_it(state: State) -> None:
    state = do(state, gate.clear_planes(), gate.add_obstacle())
    here = state.problem.obstacles.ends[0, 0]
    away = do(state, gate.set_obstacle(0, here + np.array([0.0, 0.4, 0.3])))
    there = after(gate.set_target(here, DOWN)(away), 6.0)
    undone = do(there, gate.undo_change())
    assert undone.notice is not None
    assert "obstacle 1" in undone.notice.en.lower()
    moved = undone.problem.obstacles.ends[0, 0]
    assert np.linalg.norm(moved - away.problem.obstacles.ends[0, 0]) > 0.01
    assert np.linalg.norm(moved - here) > 0.01


def test_a_real_arm_keeps_its_planes_and_limits(state: State) -> None:
    changed = do(state, gate.set_gain(0, 20.0), gate.set_zones(0.1, 0.15))
    refused = gate.undo_change(connected=True)(changed)
    assert refused.problem is changed.problem
    assert refused.notice is not None
    assert refused.notice.pt_BR == CONNECTED.format(what=changed.history.undo[-1].title).pt_BR
    free = do(changed, gate.undo_change())
    assert gate.undo_change(connected=True)(free).request.controller.gains == state.request.controller.gains


def test_a_parked_arm_keeps_its_planes(state: State) -> None:
    changed = do(state, gate.record(), gate.set_zones(0.1, 0.15))
    parked = replace(changed, arm=replace(changed.arm, parked=True))
    assert gate.undo_change()(parked).problem is changed.problem
    taught = do(state, gate.record())
    assert gate.undo_change()(replace(taught, arm=replace(taught.arm, parked=True))).taught.waypoints == ()


def test_a_drag_is_one_change_and_the_next_drag_another(state: State) -> None:
    start = state.problem.planes
    for k in (1, 2):
        for phase, d in (("start", 0.0), ("update", 0.01), ("update", 0.02), ("end", 0.03)):
            centre = start.centres[0] + k * d * start.normals[0]
            state = gate.recorded(state, gate.drag_plane("a", phase, 0, centre, [0, 1, 0, 0])(state))  # type: ignore[arg-type]
    assert [change.title.en for change in state.history.undo] == ["plane +z moved"] * 2
    once = do(state, gate.undo_change())
    assert once.problem.planes.centres[0] == pytest.approx(start.centres[0] + 0.03 * start.normals[0])
    assert do(once, gate.undo_change()).problem.planes.centres[0] == pytest.approx(start.centres[0])


def test_a_drag_that_another_user_undoes_ends(state: State) -> None:
    state = do(state, gate.record())
    state = gate.recorded(state, gate.drag_plane("a", "start", 0, state.problem.planes.centres[0], [0, 1, 0, 0])(state))
    assert state.request.drag == Drag("a", "plane 0")
    assert do(state, gate.undo_change()).request.drag is None


def test_a_slider_that_is_held_makes_one_change(state: State) -> None:
    for gain in (10.0, 12.0, 14.0):
        state = gate.recorded(state, gate.set_gain(1, gain)(state))
    assert len(state.history.undo) == 1
    state = gate.recorded(state, gate.set_gain(2, 10.0)(state))
    assert len(state.history.undo) == 2, "another slider"
    state = gate.finish_change()(state)
    state = gate.recorded(state, gate.set_gain(2, 11.0)(state))
    assert len(state.history.undo) == 3, "after a release"


def test_the_history_is_bounded_and_a_new_change_ends_what_can_be_redone(state: State) -> None:
    for k in range(MOST_CHANGES + 20):
        state = do(state, gate.set_gain(0, 1.0 + 0.1 * k))
    assert len(state.history.undo) == MOST_CHANGES
    for _ in range(MOST_CHANGES):
        state = do(state, gate.undo_change())
    assert state.request.controller.gains[0] == pytest.approx(1.0 + 0.1 * 19)
    assert len(state.history.redo) == MOST_CHANGES
    state = do(state, gate.set_gain(0, 3.3))
    assert not state.history.redo


def test_nothing_to_undo_is_said(state: State) -> None:
    assert gate.undo_change()(state).notice == NOTHING_TO_UNDO
    assert gate.redo_change()(state).notice == NOTHING_TO_REDO


def test_another_arm_begins_without_a_history(state: State) -> None:
    changed = do(state, gate.set_gain(0, 20.0))
    other = initial_state(load_robot("puma560"))
    assert gate.recorded(changed, other) is other
    assert not other.history.undo


def test_a_change_of_the_entry_point_is_undone() -> None:
    state = initial_state(load_robot("dia10_rod"))
    on = do(state, gate.enforce_entry(True))
    assert on.problem.entry is not None
    moved = do(on, gate.set_entry(on.problem.entry.point + 0.01))
    assert [change.title.en for change in moved.history.undo] == ["entry point set", "entry point moved"]
    back = do(moved, gate.undo_change())
    assert back.problem.entry is on.problem.entry
    assert do(back, gate.undo_change()).problem.entry is None


def test_a_second_arm_gets_the_settings_and_keeps_its_method(state: State) -> None:
    state = gate.compare_with("damped")(gate.choose_method("pseudoinverse")(state))
    changed = do(state, gate.set_gain(0, 20.0))
    undone = do(changed, gate.undo_change())
    assert undone.compared is not None
    assert undone.compared.controller.gains == state.request.controller.gains
    assert undone.compared.controller.method == "damped"
