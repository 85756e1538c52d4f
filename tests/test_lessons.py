"""Every lesson, played on its own robot; and what the goals of the first one accept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache

import numpy as np
import pytest

from helicoide import content, gate, lesson
from helicoide.contributions import lesson_playing, lessons
from helicoide.contributions.lesson_playing import TICK, played
from helicoide.foresight import advance_with_search
from helicoide.geometry import rotation
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Step
from helicoide.seat import Seat
from helicoide.state import State, Update, initial_state

PHASES: tuple[gate.Phase, ...] = ("start", "end")
NAMES = sorted(content.content_folders("lessons"))


@pytest.mark.parametrize("name", NAMES)
def test_a_lesson_is_what_is_asked_of_one(name: str) -> None:
    """Texts, setups from several starts, goals and solutions, on its own robot."""
    assert [fault.en for fault in lessons.faults(name)] == []


@pytest.mark.parametrize("name", [name for name in NAMES if lesson.load_lesson(name).sources])
def test_a_lesson_is_long_enough_and_asks_enough(name: str) -> None:
    """A lesson of the course, which names its sources: six steps, two predictions, an open task, three wrong paths."""
    found = lesson.load_lesson(name)
    assert len(found.steps) >= 6
    assert sum(step.prediction is not None for step in found.steps) >= 2
    assert any(step.is_open for step in found.steps)
    assert sum(len(step.diagnoses) for step in found.steps) >= 3
    assert found.about.en


# Lesson "Drive the arm": its starts, the drags that its goals accept, and those that they must not accept.

FIRST = "drive_the_arm"
STEPS = [step.id for step in lesson.load_lesson(FIRST).steps]


def settled(state: State) -> State:
    """The state after a setup: the arm is at rest and has no command."""
    rested = lesson_playing.settled(state)
    assert rested is not None, f"the setup never came to rest: {state.request.command}"
    return rested


def step_of(name: str, step_id: str) -> Step:
    return next(step for step in lesson.load_lesson(name).steps if step.id == step_id)


@cache
def robot() -> Robot:
    return load_robot(lesson.load_lesson(FIRST).robot)


@pytest.fixture
def seat() -> Seat:
    return Seat(token="", language="en")


@pytest.mark.parametrize("step_id", STEPS)
def test_a_step_starts_from_anywhere(step_id: str, seat: Seat) -> None:
    step = step_of(FIRST, step_id)
    parked = settled_at_home()
    crowded = played(gate.set_target([0.6, 0.0, 0.7], [1.0, 0, 0, 0])(initial_state(robot())), 2.0)
    for state in (initial_state(robot()), parked, crowded, gate.stop()(crowded), under_a_raised_ceiling()):
        begun = settled(step.setup(state))
        assert not begun.arm.parked
        assert begun.request.with_orientation
        assert begun.notice is None
        assert np.allclose(begun.arm.q, robot().poses["ready"], atol=2e-3)
        assert not lesson.is_goal_met(step, begun, seat)
        assert lesson.mistake_made(step, begun, seat) is None


@cache
def settled_at_home() -> State:
    state = settled(gate.park()(initial_state(robot())))
    assert state.arm.parked
    return state


@cache
def under_a_raised_ceiling() -> State:
    """The arm higher than the measured ceiling allows."""
    state = initial_state(robot())
    pose = state.problem.planes.centres[0] + [0, 0, 0.3], [0.0, 1.0, 0.0, 0.0]
    for phase in PHASES:
        state = gate.drag_plane("hand", phase, 0, *pose)(state)
    state = played(gate.set_target([0.6, 0.0, 0.75], [1.0, 0, 0, 0])(state), 3.0)
    assert state.T_world_tool[2, 3] > 0.7
    return state


def drive(step_id: str) -> Callable[[Update, float], bool]:
    step = step_of("drive_the_arm", step_id)

    def reached(request: Update, seconds: float) -> bool:
        state = played(request(settled(step.setup(initial_state(robot())))), seconds)
        return lesson.is_goal_met(step, state, Seat(token="", language="en"))

    return reached


def dragged(position: Sequence[float], axis: Sequence[float] = (0, 0, 1), degrees: float = 0.0) -> Update:
    """A drag of the target that is not released, with a rotation about an axis of the tool."""

    def request(state: State) -> State:
        T = state.T_world_tool
        quat = rotation.from_matrix(T[:3, :3])
        state = gate.drag_target("hand", "start", T[:3, 3], quat)(state)
        turned = rotation.multiply(quat, rotation.from_axis_angle(axis, np.radians(degrees)))
        return gate.drag_target("hand", "update", position, turned)(state)

    return request


@pytest.mark.parametrize("degrees", [-20.0, 17.0, 0.0])
def test_another_angle_of_the_waist_does_not_count(degrees: float) -> None:
    assert not drive("circle")(gate.set_joint(0, np.radians(degrees)), 3.0)


def test_the_marked_point_is_where_the_tool_goes(seat: Seat) -> None:
    step = step_of(FIRST, "circle")
    assert step.prediction is not None
    begun = settled(step.setup(initial_state(robot())))
    expected = lesson.right_answer(step.prediction, begun, seat)
    turned = played(gate.set_joint(0, np.radians(20.0))(begun), 3.0)
    assert np.allclose(expected, turned.T_world_tool[:3, 3], atol=1e-3)
    assert lesson.right_answer(step.prediction, turned, seat) == expected


HERE = (0.6029, 0.0, 0.1671)


@pytest.mark.parametrize("degrees", [-75.0, -87.5, -97.5, -102.5, -120.0])
def test_another_angle_of_the_elbow_does_not_count(degrees: float) -> None:
    assert not drive("joint")(gate.set_joint(2, np.radians(degrees)), 3.0)


def test_passing_by_the_angle_does_not_count(seat: Seat) -> None:
    step = step_of("drive_the_arm", "joint")
    state = gate.set_joint(2, np.radians(-120.0))(initial_state(robot()))
    for _ in range(200):
        state = advance_with_search(state, TICK)
        assert not lesson.is_goal_met(step, state, seat)


@pytest.mark.parametrize("position", [(0.6, 0.16, 0.11), (0.6029, 0.125, 0.125), (0.45, 0.2, 0.1), (0.6, 0.4, 0.1)])
def test_the_target_dragged_low_to_the_left_counts(position: Sequence[float]) -> None:
    assert drive("target")(dragged(position), 3.0)


@pytest.mark.parametrize("position", [HERE, (0.6, 0.06, 0.14), (0.6, 0.16, 0.167), (0.6, -0.16, 0.11)])
def test_the_target_elsewhere_does_not_count(position: Sequence[float]) -> None:
    assert not drive("target")(dragged(position), 3.0)


@pytest.mark.parametrize("degrees", [-60.0, -30.0, 30.0, 60.0])
def test_only_the_blue_arc_is_refused(degrees: float) -> None:
    reached = drive("orientation")
    assert reached(dragged(HERE, (0, 0, 1), degrees), 1.0)
    assert not reached(dragged(HERE, (0, 1, 0), degrees), 2.0)
    assert not reached(dragged(HERE, (1, 0, 0), degrees), 2.0)


def test_a_small_turn_or_an_unheld_orientation_does_not_count() -> None:
    reached = drive("orientation")
    assert not reached(dragged(HERE, (0, 0, 1), 15.0), 1.0)
    assert not reached(lambda state: gate.keep_orientation(False)(dragged(HERE, (0, 0, 1), 40.0)(state)), 1.0)
    assert not reached(dragged((0.6, 0.18, 0.15)), 2.0)


@pytest.mark.parametrize("position", [(0.6, 0.0, 0.65), (0.6, 0.0, 0.8), (0.35, 0.0, 0.7), (0.5, 0.15, 0.7)])
def test_the_target_pulled_through_the_ceiling_counts(position: Sequence[float]) -> None:
    assert drive("plane")(dragged(position), 3.0)


def test_below_the_ceiling_does_not_count() -> None:
    reached = drive("plane")
    assert not reached(dragged((0.6, 0.0, 0.35)), 3.0)
    assert not reached(dragged((0.6, 0.0, 0.50)), 3.0)
    assert not reached(dragged((0.6, 0.0, 0.70)), 0.02)


def test_a_stop_before_the_ellipse_does_not_count(seat: Seat) -> None:
    step = step_of("drive_the_arm", "stop")
    state = settled(step.setup(initial_state(robot())))
    assert not lesson.is_goal_met(step, gate.stop()(state), seat)
    playing = gate.play()(state)
    assert not lesson.is_goal_met(step, gate.stop()(played(playing, 0.5)), seat)
    assert not lesson.is_goal_met(step, gate.pause()(played(playing, 5.0)), seat)
    for seconds in (4.0, 10.0, 19.0, 24.0):
        assert lesson.is_goal_met(step, gate.stop()(played(playing, seconds)), seat), seconds


def test_the_ellipse_starts_over_with_the_step(seat: Seat) -> None:
    step = step_of("drive_the_arm", "stop")
    before = gate.stop()(played(gate.play()(initial_state(robot())), 6.0))
    again = settled(step.setup(before))
    assert not lesson.is_goal_met(step, gate.stop()(played(gate.play()(again), 1.0)), seat)
