"""The paths that an arm has ready: each is followed, in the time and with the scaling that is asked for."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after

from helicoide import gate
from helicoide.command import FollowPath, HoldPosition, MoveToJoints, PathChoice, Replay
from helicoide.foresight import advance_with_search, foreseen
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.readout import plane_distances
from helicoide.readout.status import FOLLOWING, status
from helicoide.session.replaying import along_fastest
from helicoide.state import State, Update, initial_state
from helicoide.text import untranslated
from helicoide.trajectory.joints import tool_pose_in

PRESETS = [(name, key) for name in robot_titles() for key in gate.presets(load_robot(name))]
FOLLOWED = {"line", "circle", "ellipse"}


@pytest.mark.parametrize(("name", "key"), PRESETS)
def test_every_path_is_smooth_and_its_twist_is_its_derivative(name: str, key: str) -> None:
    path, h = gate.presets(load_robot(name))[key].path, 1e-6
    for s in np.linspace(0.1, 0.9, 7) * path.duration:
        v = (path.pose(s + h)[:3, 3] - path.pose(s - h)[:3, 3]) / (2 * h)
        np.testing.assert_allclose(path.twist(s)[:3], v, atol=1e-6)


@pytest.mark.parametrize("name", robot_titles())
@pytest.mark.parametrize("key", sorted(FOLLOWED))
def test_every_arm_follows_the_paths_from_its_ready_posture(name: str, key: str) -> None:
    """Round once: the tool is on the path at every instant, and comes back."""
    state = gate.choose_path(key)(initial_state(load_robot(name)))
    state = gate.play()(gate.keep_orientation(False)(gate.set_duration(10.0)(state)))
    worst = 0.0
    for _ in range(1000):
        state = advance_with_search(state, 0.01)
        assert isinstance(state.request.command, FollowPath)
        if state.request.command.arrived:
            desired = state.request.command.path.pose(state.request.command.s)[:3, 3]
            worst = max(worst, float(np.linalg.norm(desired - state.T_world_tool[:3, 3])))
    assert worst < 2e-3 * state.robot.reach
    assert state.request.path_s < 0.5 or state.request.path_s > 9.5


@pytest.mark.parametrize("name", robot_titles())
def test_the_first_play_of_every_arm_is_followed_with_its_orientation_and_nothing_in_the_way(name: str) -> None:
    state = gate.play()(initial_state(load_robot(name)))
    assert isinstance(state.request.command, FollowPath)
    along = FOLLOWING.format(path=state.request.command.title)
    said = set()
    for _ in range(int(5 * state.request.command.path.duration)):
        state = after(state, 0.2)
        said.add((status(foreseen(state)).text, status(foreseen(state)).tone))
    assert said == {(along, "ok")}


def test_a_path_that_meets_the_planes_says_so_and_is_not_the_first() -> None:
    known = gate.presets(load_robot("movemaster"))
    assert next(iter(known)) == "ellipse"
    for key in ("eq33", "eq34", "eq35"):
        assert "planes" in known[key].title.en
        assert "planos" in known[key].title.pt_BR


def test_the_status_names_the_path_that_is_followed() -> None:
    state = gate.choose_path("circle")(initial_state(load_robot("puma560")))
    playing = foreseen(after(gate.play()(state), 2.0))
    assert (status(playing).text.en, status(playing).text.pt_BR) == ("Following: circle.", "Seguindo: círculo.")


def test_a_time_scaling_starts_at_rest_and_takes_as_long(state: State) -> None:
    state = gate.choose_path("eq33")(state)
    even = gate.path_of(state.robot, PathChoice("eq33"))
    for shape in ("trapezoid", "minimum jerk"):
        path = gate.path_of(state.robot, gate.choose_scaling(shape)(state).request.path_choice)
        assert path.duration == even.duration
        assert np.linalg.norm(path.twist(0.0)) < 1e-9 < np.linalg.norm(even.twist(0.0))
        np.testing.assert_allclose(path.pose(15.0), even.pose(15.0), atol=1e-12)


def test_another_duration_goes_on_from_the_same_place(state: State) -> None:
    playing = after(gate.play()(gate.keep_orientation(False)(state)), 4.0)
    slower = gate.set_duration(60.0)(playing)
    assert isinstance(slower.request.command, FollowPath)
    assert slower.request.command.arrived
    assert isinstance(playing.request.command, FollowPath)
    here, before = slower.request.command, playing.request.command
    np.testing.assert_allclose(here.path.pose(here.s), before.path.pose(before.s), atol=1e-12)
    assert after(slower, 1.0).request.path_s == pytest.approx(slower.request.path_s + 1.0, abs=0.011)


def test_another_path_stops_the_one_that_plays(state: State) -> None:
    playing = after(gate.play()(state), 1.0)
    for request in (gate.choose_path("eq35"), gate.choose_scaling("trapezoid")):
        changed = request(playing)
        assert changed.request.command == HoldPosition()
        assert changed.request.path_s == 0.0


def test_an_open_path_that_has_ended_begins_again() -> None:
    state = gate.choose_path("vargas4")(initial_state(load_robot("planar3r")))
    state = gate.play()(gate.scrub(1.0)(state))
    assert isinstance(state.request.command, FollowPath)
    assert state.request.command.s == 0.0


def test_the_least_time_keeps_the_limits_and_the_path() -> None:
    state = gate.choose_scaling("minimum jerk")(gate.choose_path("circle")(initial_state(load_robot("puma560"))))
    played = along_fastest(state)(state)
    assert isinstance(played.request.command, Replay)
    path, robot = played.request.command.path, state.robot
    assert path.duration < gate.path_of(robot, state.request.path_choice).duration
    instants = np.linspace(0, path.duration, 4001)
    speeds = np.array([np.abs(path.rates(float(s))) / robot.speed for s in instants])
    assert 0.5 < speeds.max() <= 1.0
    circle = gate.presets(robot)["circle"].path
    centre = (circle.pose(0.0)[:3, 3] + circle.pose(circle.duration / 2)[:3, 3]) / 2
    radii = [np.linalg.norm(tool_pose_in(robot, path.q(float(s)))[:3, 3] - centre) for s in instants[::40]]
    np.testing.assert_allclose(radii, 0.05 * robot.reach, atol=5e-4)


def test_the_least_time_keeps_clear_of_planes_and_says_how_far_the_path_is_left(state: State) -> None:
    """Eq. 33 leads out of the enclosure; the most that the tool is beside it is said, in both languages."""
    state = gate.choose_path("eq33")(state)
    played = along_fastest(state)(gate.keep_orientation(False)(state))
    assert isinstance(played.request.command, Replay)
    said = float(re.search(r"([\d.]+) mm", played.request.command.title.en)[1]) / 1000  # type: ignore[index]
    assert untranslated("{said:.1f} mm").format(said=1000 * said).pt_BR in played.request.command.title.pt_BR
    curve = np.array([gate.presets(state.robot)["eq33"].path.pose(s)[:3, 3] for s in np.linspace(0, 30, 3001)])
    beside = 0.0
    for _ in range(6000):
        played = advance_with_search(played, 0.01)
        assert plane_distances(played).min() >= 0.080 - 1e-9
        if not isinstance(played.request.command, Replay):
            break
        if played.request.command.arrived:
            away = np.linalg.norm(curve - played.T_world_tool[:3, 3], axis=1).min()
            beside = max(beside, float(away))
    assert isinstance(played.request.command, MoveToJoints)
    assert 0.02 < beside < said + 0.005


def test_a_parked_arm_is_told_to_get_ready_first(state: State) -> None:
    parked = replace(state, arm=replace(state.arm, parked=True))
    refused = along_fastest(parked)(parked)
    assert refused.request.command is state.request.command
    assert refused.notice == gate.PARKED


WRONG: dict[str, Callable[[], Update]] = {
    "path": lambda: gate.choose_path("vargas1"),
    "words": lambda: gate.choose_scaling("sudden"),  # type: ignore[arg-type]
    "too short": lambda: gate.set_duration(0.0),
    "too long": lambda: gate.set_duration(1e6),
    "NaN": lambda: gate.set_duration(math.nan),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong_changes_nothing(state: State, wrong: str) -> None:
    refused = WRONG[wrong]()(state)
    assert refused.request.path_choice is state.request.path_choice
    assert refused.request.command is state.request.command
    assert refused.notice is not None
