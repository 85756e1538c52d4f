"""Whatever a name holds, a page shows it as text: no panel makes a tag of it, fails on it, or joins it with others."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
import viser
from tests.hostile import HARMLESS, NAMES, Page, renamed, result_named, study_named

from helicoide import gate, lesson, studies
from helicoide.confinement import plane_file
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat, Selection
from helicoide.state import FittedCloud, State, initial_state
from helicoide.studies.panel_state import CompletedRun, StudyPanelState
from helicoide.text import LANGUAGES, Language, Text, untranslated
from helicoide.trajectory.waypoints import Waypoint
from helicoide.view import layers, open_step, panels
from helicoide.view.docked import lesson_rows
from helicoide.view.panels import robot as robot_panel
from helicoide.view.placed_rows import FAILED, place_rows
from helicoide.view.window_view import View

SHOWS = MappingProxyType({layer.NAME: bool(layer.SHOWN) for layer in layers.optional()})


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield server
    server.stop()


def state_named(robot: Robot, name: str) -> State:
    """A scene in which the robot, its planes, its waypoints, what was read and what is said have that name."""
    hostile = renamed(robot, name)
    file = plane_file.encode_planes([name, ""], robot_planes(robot))
    state = gate.take_planes_of(file.encode(), name)(initial_state(hostile))
    assert state.problem.planes.names[-2:] == (name, "")
    waypoints = (Waypoint(name, state.arm.q), Waypoint("", state.arm.q))
    seen = FittedCloud(np.zeros((1, 3)), np.ones(1, bool), untranslated(name))
    return replace(
        state,
        taught=replace(state.taught, waypoints=waypoints),
        clouds=MappingProxyType({name: seen}),
        notice=untranslated(name),
    )


def robot_planes(robot: Robot) -> Any:
    planes = initial_state(robot).problem.planes
    return replace(planes, normals=planes.normals[:2], centres=planes.centres[:2])


def panel_named(name: str) -> StudyPanelState:
    run = CompletedRun("a study", None, True, result_named(name))
    return StudyPanelState("a study", last=run, previous=run, failure=untranslated(name))


@pytest.fixture
def named(monkeypatch: pytest.MonkeyPatch, robot: Robot, request: pytest.FixtureRequest) -> State:
    """A scene, a lesson and a study, all of that name."""
    name = request.param
    guided = renamed(lesson.load_lesson("drive_the_arm"), name)
    monkeypatch.setattr(open_step, "load_lesson", lambda _: guided)
    monkeypatch.setattr(robot_panel, "robot_titles", dict)
    monkeypatch.setattr(studies, "study_named", lambda _: study_named(name))
    monkeypatch.setattr(studies, "study_names", lambda: ["a study"])
    return state_named(robot, name)


def elements(gui: viser.GuiApi) -> list[Any]:
    """Everything that stands in a panel."""
    containers = list(gui._container_handle_from_uuid.values())
    return [handle for container in containers for handle in container._children.values()]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("named", NAMES, indirect=True)
def test_every_panel_shows_a_name_as_it_is(server: viser.ViserServer, named: State, language: Language) -> None:
    (seen,) = named.clouds
    seat = Seat(
        "", language, lesson="drive_the_arm", hint_open=True, selected=Selection("plane", 1), visible_layers=SHOWS
    )
    view = View(named, seat, panel_named(seen))
    server.gui.reset()
    placed = [
        row for panel in panels.all_panels() for row in place_rows(server.gui, panel.rows(named.robot), view, print)
    ]
    placed += place_rows(server.gui, lesson_rows(named.robot, seat), view, print)
    for now in (view, replace(view, seat=replace(seat, selected=Selection("point", 0)))):
        for row in placed:
            row.refresh(now)
    shown = elements(server.gui)
    pages = [handle.content for handle in shown if isinstance(handle, viser.GuiHtmlHandle) and handle.visible]
    assert not [page for page in pages if FAILED[language] in page]
    read = Page("".join(pages))
    assert read.tags <= HARMLESS
    assert not read.active
    assert said(read.text).count(said(seen)) > 20
    labels = {getattr(handle, "label", None) for handle in shown}
    for label in (AWAY.format(name=seen), AGAIN.format(name=seen), AWAY.format(name=""), AGAIN.format(name="")):
        assert label[language] in labels


AWAY = Text(en="Remove plane {name}", pt_BR="Remover o plano {name}")
AGAIN = Text(en="{name}: use current posture", pt_BR="{name}: usar a postura atual")


def said(words: str) -> str:
    """Words without the blanks that Markdown and HTML take as one."""
    return "".join(words.split())
