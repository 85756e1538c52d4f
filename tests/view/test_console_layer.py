"""The console's geometry stands where its numbers say, and its rows show what was typed as text."""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
import viser
from tests.console.lines import fuzzed, numbers, value
from tests.console.test_scene_names import moved
from tests.hostile import HARMLESS, NAMES, Page

from helicoide.arrays import Array
from helicoide.console import kind_of
from helicoide.geometry import incidence, rigid
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.seat import Seat
from helicoide.sheet import Sheet, SheetLine, with_chosen_line, with_entered_line, with_entry_text, with_shown
from helicoide.state import State, initial_state
from helicoide.text import LANGUAGES, HelicoideError, Language
from helicoide.view import layers
from helicoide.view.console_rows import console_rows
from helicoide.view.console_words import entry_help, result_list
from helicoide.view.layers import Stage
from helicoide.view.layers import console as layer
from helicoide.view.placed_rows import FAILED, place_rows
from helicoide.view.window_view import View

SHOWS = MappingProxyType({one.NAME: bool(one.SHOWN) for one in layers.optional()})
LINES = (
    "p = M_tool >> point(0, 0, 0.1)",
    "L1",
    "ell = 3*join(tool, point(0.1, 0.2, 0.3))",
    "wall = plane(1, 2, 3, 0.4)",
    "-2*wall",
    "M_tool",
    "modern(L1)",
    "modern_motor(M_tool)",
    "modern(wall)",
)


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield server
    server.stop()


def sheet_of(*lines: str) -> Sheet:
    return Sheet(tuple(SheetLine(line) for line in lines))


def view_of(state: State, sheet: Sheet, language: Language = "en") -> View:
    return View(state, Seat("", language, visible_layers=SHOWS, sheet=sheet))


def built(server: viser.ViserServer, state: State) -> layer.ConsoleResults:
    server.scene.reset()
    return layer.build(Stage(server.scene, state.robot, [], lambda _: None, ""))


@pytest.mark.parametrize("name", robot_titles())
def test_what_is_drawn_lies_on_the_element_of_the_numbers(name: str) -> None:
    """A line's shape is its z axis, a plane's shape is its xy plane: points of them lie on the element to 1e-9."""
    state = moved(initial_state(load_robot(name)), 11)
    middle = rigid.point([0.0, 0.0, 0.5])
    for line in LINES:
        X = value("wall = plane(1, 2, 3, 0.4)", line, state=state)
        assert isinstance(X, Multivector)
        kind = kind_of(X).name
        T = layer.shape_pose(kind, X, middle)
        np.testing.assert_allclose(T[:3, :3].T @ T[:3, :3], np.eye(3), atol=1e-12)
        of_sources = numbers("wall = plane(1, 2, 3, 0.4)", line.replace("modern_motor", "").replace("modern", ""),
                             state=state)  # fmt: skip
        on_shape(kind, T, of_sources)


def on_shape(kind: str, T: Array, X: Array) -> None:
    """Points of the shape, in its own frame, lie on X."""
    ahead = {"point": np.zeros((1, 3)), "line": np.outer([-1.0, 2.0], [0, 0, 1]), "plane": np.eye(3)[:2]}
    if kind == "motor":
        np.testing.assert_allclose(rigid.pose_from_motor(X), T, atol=1e-9)
        return
    for here in ahead[kind]:
        p = rigid.point(T[:3, :3] @ here + T[:3, 3])
        if kind == "point":
            np.testing.assert_allclose(p, X / X[11], atol=1e-9)
        elif kind == "line":
            direction, _ = rigid.direction_and_moment(X)
            assert incidence.point_line_distance(X / np.linalg.norm(direction), p) < 1e-9
        else:
            assert abs(rigid.point_plane_distance(X / np.linalg.norm(X[1:4]), p)) < 1e-9


def test_the_drawing_follows_the_arm_and_the_eye(server: viser.ViserServer, state: State) -> None:
    drawn, sheet = built(server, state), sheet_of("p = tool", "M_tool", "1 + ")
    first, second = view_of(state, sheet), view_of(moved(state, 5), sheet)
    drawn.update(None, first)
    point, motor = drawn.nodes[0]["point"], drawn.nodes[1]["motor"]
    np.testing.assert_allclose(point.position, first.state.T_world_tool[:3, 3])
    drawn.update(first, second)
    np.testing.assert_allclose(point.position, second.state.T_world_tool[:3, 3])
    np.testing.assert_allclose(motor.position, second.state.T_world_tool[:3, 3])
    assert [label.text for label in drawn.names.labels] == ["p · 2"]
    np.testing.assert_allclose(drawn.names.labels[0].position, second.state.T_world_tool[:3, 3])
    third = view_of(second.state, with_shown(sheet, False, 0))
    drawn.update(second, third)  # the motor is the first that is drawn now
    assert not point.visible
    assert drawn.nodes[0]["motor"].visible
    assert [label.text for label in drawn.names.labels if label.visible] == ["2"]
    hidden = replace(third, seat=third.seat.with_layer(layer.NAME, False))
    drawn.update(third, hidden)
    shapes = [node for nodes in drawn.nodes for node in nodes.values()]
    assert not [node for node in (*shapes, *drawn.names.labels) if node.visible]


def test_whatever_is_typed_is_drawn_or_left_out(server: viser.ViserServer, state: State) -> None:
    drawn, source, old = built(server, state), random.Random(8), None
    huge = ("1e+200*M_tool", "1e+200*L1", "point(1e+300, 0, 0)", "1e-11*L1", "1e+160*(e12 + e1e)", "e12/1e+100 + e3e")
    for line in (*huge, *(fuzzed(source) for _ in range(400))):
        with suppress(HelicoideError):
            view = view_of(state, sheet_of(line))
            drawn.update(old, view)
            assert result_list(view)
            old = view
    assert len(drawn.nodes) == 1


def test_nothing_is_drawn_before_the_kernels_are_ready(server: viser.ViserServer, state: State) -> None:
    drawn, view = built(server, state), replace(view_of(state, sheet_of("tool")), ready=False)
    drawn.update(None, view)
    assert drawn.nodes == []
    drawn.update(view, replace(view, ready=True))
    assert len(drawn.nodes) == 1


def test_an_unmoved_arm_writes_nothing(
    server: viser.ViserServer, state: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn, view = built(server, state), view_of(state, sheet_of("tool", "L1"))
    drawn.update(None, view)
    calls: list[object] = []
    monkeypatch.setattr(layer, "place_node", lambda node, pose: calls.append(node))
    drawn.update(view, replace(view, state=replace(state, t=1.0)))
    assert calls == []
    drawn.update(view, view_of(moved(state, 5), view.seat.sheet))
    assert len(calls) == 2


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_what_was_typed_is_shown_as_text(
    server: viser.ViserServer, state: State, name: str, language: Language
) -> None:
    server.gui.reset()
    sheet = with_chosen_line(with_entered_line(sheet_of("a = join(elbow, wrist)*b"), name), 1)
    view = view_of(state, sheet, language)
    placed = place_rows(server.gui, [console_rows()], view, lambda _: None)
    for row in placed:
        row.refresh(view)
    containers = list(server.gui._container_handle_from_uuid.values())
    handles: list[Any] = [handle for container in containers for handle in container._children.values()]
    pages = [handle.content for handle in handles if isinstance(handle, viser.GuiHtmlHandle) and handle.visible]
    assert not [page for page in pages if FAILED[language] in page]
    read = Page("".join(pages))
    assert read.tags <= HARMLESS | {"ol", "msub", "mtext", "mrow"}
    assert not read.active
    for line in name.splitlines():
        assert "".join(line.split()) in "".join(read.text.split())


def test_lines_are_added_changed_hidden_and_removed() -> None:
    sheet = with_entered_line(with_entered_line(Sheet(), "a = 1"), "b = 2")
    assert [line.text for line in sheet.lines] == ["a = 1", "b = 2"]
    chosen = with_chosen_line(with_shown(sheet, False, 0), 0)
    assert chosen.entry.text == "a = 1"
    changed = with_entered_line(with_entry_text(chosen, "a = 3"), "a = 3")
    assert [(line.text, line.shown) for line in changed.lines] == [("a = 3", False), ("b = 2", True)]
    assert changed.entry.text == ""
    assert changed.entry.past == ("a = 1", "b = 2", "a = 3")
    removed = with_entered_line(with_chosen_line(changed, 1), "")
    assert [line.text for line in removed.lines] == ["a = 3"]
    assert with_entered_line(removed, "") == removed  # pressed twice, the button removes one line
    assert with_entered_line(changed, "slider c = 2 from 0 to 5").slider("c").upper == 5


def test_the_help_lists_what_begins_as_the_last_word(state: State) -> None:
    view = view_of(state, with_entry_text(Sheet(), "1 + dis"))
    assert "distance(A, B)" in entry_help(view)
    assert "ceiling" in entry_help(view_of(state, with_entry_text(Sheet(), "join(cei")))
    assert entry_help(view_of(state, with_entry_text(Sheet(), "1 + "))) == ""


def test_results_are_written_with_a_decimal_comma_in_portuguese(state: State) -> None:
    assert "0,5" in result_list(view_of(state, sheet_of("1/2"), "pt_BR"))
    assert "0.5" in result_list(view_of(state, sheet_of("1/2"), "en"))
