"""Every method, on every robot that it applies to, is held to what it says of itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.driving import Worst, watch

from helicoide import gate
from helicoide.advance import advance
from helicoide.arrays import Array, frozen
from helicoide.command import MoveToPose
from helicoide.contributions.methods import Pair, description_faults, pairs
from helicoide.contributions.promises import DTS, HELD, answers
from helicoide.contributions.trials import bare_state, controller_step
from helicoide.geometry import rotation
from helicoide.ik.controller import Controller
from helicoide.ik.method import OneOf, Promise, Quantity, YesNo, changed, settings
from helicoide.ik.methods import named, names
from helicoide.kinematics import library
from helicoide.state import State, initial_state
from helicoide.text import HelicoideError

every_method = pytest.mark.parametrize("name", names())
APPLYING = [pytest.param(name, pair, id=f"{name}-{pair.title}") for name in names() for pair in pairs(name)[0]]
PROMISED = [
    pytest.param(name, promise, pair, id=f"{name}-{promise.name}-{pair.title}")
    for name in names()
    for promise in Promise
    if promise in named(name).PROMISES
    for pair in pairs(name)[0]
]


@every_method
def test_a_method_says_all_of_itself(name: str) -> None:
    assert [fault.en for fault in description_faults(name)] == []


@every_method
def test_every_arm_and_task_is_tried_or_refused(name: str) -> None:
    """Those that are refused make no tests; together they are all there are."""
    applying, refused = pairs(name)
    assert len(applying) + len(refused) == 2 * len(library.robot_titles())
    assert set(applying).isdisjoint(refused)
    assert applying


def test_every_promise_is_held_by_a_test() -> None:
    assert set(HELD) == set(Promise)


@pytest.mark.parametrize(("name", "pair"), APPLYING)
def test_answers_are_finite_and_not_nothing_whatever_is_asked(name: str, pair: Pair) -> None:
    assert answers(name, pair.robot, pair.with_orientation) is None


@pytest.mark.parametrize(("name", "promise", "pair"), PROMISED)
def test_a_promise_is_kept(name: str, promise: Promise, pair: Pair) -> None:
    assert HELD[promise](name, pair.robot, pair.with_orientation) is None


@every_method
def test_every_setting_can_be_set_and_refuses_what_is_not_valid(name: str) -> None:
    options = named(name).Options()
    for field, setting in settings(type(options)).items():
        default = getattr(options, field)
        assert changed(options, field, default) == options
        match setting:
            case Quantity(_, lower, upper):
                assert lower <= default <= upper
                assert getattr(changed(options, field, upper), field) == upper
                wrong = [lower - 1e-9 - 1e-3 * abs(lower), np.nan, np.inf, "1", None, True]
            case OneOf(_, choices):
                assert {getattr(changed(options, field, key), field) for key in choices} == set(choices)
                wrong = ["", None, 1.0]
            case YesNo():
                wrong = ["yes", 1, None]
        for value in wrong:
            with pytest.raises(HelicoideError):
                changed(options, field, value)
    with pytest.raises(HelicoideError, match="nonsense"):
        changed(options, "nonsense", 1.0)


@pytest.mark.parametrize("robot_name", ["movemaster", "planar3r", "scara", "puma560", "dia10"])
def test_under_the_guard_no_method_breaks_a_promise_and_switching_never_jumps(robot_name: str) -> None:
    """Targets near and far, another method or setting every few ticks, another arm beside it: q moves by q̇ dt only."""
    rng, state, worst = np.random.default_rng(8), initial_state(library.load_robot(robot_name)), Worst()
    for _ in range(60):
        state = gate.choose_method(str(rng.choice(names())))(state)
        state = gate.compare_with(rng.choice([None, *names()]))(state)
        state = gate.keep_orientation(bool(rng.random() < 0.5))(state)
        far = state.robot.reach * rng.choice([0.3, 1.0, 3.0]) * rng.normal(size=3)
        state = replace(state, request=replace(state.request, command=MoveToPose(tool_moved(state, far, rng))))
        dt = float(rng.choice(DTS))
        for _ in range(int(rng.integers(1, 15))):
            new = advance(state, dt)
            watch(worst, state, new, dt)
            if new.compared_state is not None and state.compared_state is not None:
                watch(worst, state.compared_state, new.compared_state, dt)
            state = new


def tool_moved(state: State, way: Array, rng: np.random.Generator) -> Array:
    T = state.T_world_tool.copy()
    T[:3, :3] = T[:3, :3] @ rotation.to_matrix(rotation.from_rotation_vector(rng.normal(size=3)))
    T[:3, 3] = T[:3, 3] + way
    return frozen(T)


def test_an_unknown_method_is_refused_in_words(state: State) -> None:
    refused = gate.choose_method("magic")(state)
    assert refused.request.controller is state.request.controller
    assert refused.notice is not None
    assert all(name in refused.notice.en for name in names())


@every_method
def test_what_is_remembered_fits_any_task(name: str) -> None:
    """Orientation on and off in the middle of a motion changes the shape of the task."""
    state, drive = bare_state("puma560"), Controller().with_method(name)
    for k in range(20):
        T = tool_moved(state, np.full(3, 0.1), np.random.default_rng(k))
        if Pair("puma560", k % 3 > 0) not in pairs(name)[0]:
            continue
        _, drive = controller_step(state, T, k % 3 > 0, drive)
        assert drive.solution is not None
        assert np.isfinite(drive.solution.rates).all()
