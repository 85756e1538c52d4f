"""The map in the scene: only what lies beyond the cut, in the colours of its values, and only while it is wanted."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.kinematics.urdfs import chain_of

from helicoide.arrays import Array, frozen
from helicoide.kinematics import workspace
from helicoide.kinematics.grid import WorkspaceGrid
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.workspace import MapKind, WorkspaceMap
from helicoide.seat import Seat
from helicoide.state import WorkspaceMaps, initial_state, points_on
from helicoide.text import LANGUAGES, Language
from helicoide.view import shapes
from helicoide.view.layers import Stage
from helicoide.view.layers import workspace as layer
from helicoide.view.rows import HtmlRow, Slider
from helicoide.view.window_view import View
from helicoide.view.workspace_rows import (
    ANCHORS,
    TITLES,
    colours,
    measure_title,
    scale,
    scale_of,
    values,
    workspace_rows,
)


@dataclass
class _Scene:
    """A scene that keeps the clouds that it is given."""

    clouds: list[Any] = field(default_factory=list)

    def add_point_cloud(self, name: str, points: Array, colors: Array, point_size: float, point_shape: str) -> Any:
        assert name == "/workspace"
        self.clouds.append(SimpleNamespace(points=points, colors=colors, size=point_size, visible=True))
        return self.clouds[-1]


@cache
def counted(name: str, kind: MapKind, samples: int = 1 << 18) -> WorkspaceMap:
    plan = workspace.plan_map(load_robot(name), kind, samples)
    return workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)


def seen(found: WorkspaceMap | None, name: str = "movemaster", cut: float = 0.0, shown: bool = True) -> View:
    state = replace(initial_state(load_robot(name)), workspace=WorkspaceMaps(map=found))
    return View(state, Seat("", "en", cut=cut).with_layer(layer.NAME, shown))


def staged(name: str = "movemaster") -> tuple[_Scene, layer.WorkspaceLayer]:
    scene, robot = _Scene(), load_robot(name)
    return scene, layer.build(Stage(scene, robot, shapes.load_shapes(robot), lambda request: None, ""))  # type: ignore[arg-type]


def drawn(found: WorkspaceMap, name: str = "movemaster", cut: float = 0.0) -> Any:
    """What is in the scene of a fresh window."""
    scene, one = staged(name)
    one.update(None, seen(found, name, cut))
    return scene.clouds[-1]


@pytest.mark.parametrize(
    ("name", "axis", "sign"), [("movemaster", 1, 1), ("puma560", 1, 1), ("dia10", 0, -1), ("dia10_rod", 0, -1)]
)
@pytest.mark.parametrize("cut", [-0.5, 0.0, 0.3])
def test_only_what_lies_beyond_the_cut_is_drawn(name: str, axis: int, sign: int, cut: float) -> None:
    """It lies on the far side of the arm, as that is first seen, and reaches up to the cut."""
    found = counted(name, "reachable")
    centre, reach = workspace.reach_sphere(load_robot(name))
    along = sign * (drawn(found, name, cut).points[:, axis] - centre[axis])
    assert along.min() >= cut * reach - 1e-6
    assert along.min() <= cut * reach + found.cells.size / (66 // found.cells.shape[0])
    assert along.max() > 0.5 * reach


def test_a_cut_before_it_all_shows_the_whole_map_and_one_beyond_it_nothing() -> None:
    found = counted("movemaster", "reachable")
    assert drawn(found, cut=-1.0).points[:, 1].min() < -0.5
    assert len(drawn(found, cut=1.0).points) == 0


@pytest.mark.parametrize("kind", workspace.MAP_KINDS)
def test_every_cell_that_can_be_seen_is_drawn_and_no_other(kind: MapKind) -> None:
    """A cell inside, with all six neighbours drawn, cannot be seen; coarse ones are drawn in parts."""
    found = counted("movemaster", kind)
    shape, size = np.array(found.cells.shape), found.cells.size
    parts = 66 // shape[0]
    inside = {tuple(at) for at in np.argwhere(found.reached.reshape(found.cells.shape)) if at[1] >= shape[1] // 2}
    fine = {
        tuple(int(n) for n in parts * np.array(at) + (i, j, k))
        for at in inside
        for i in range(parts)
        for j in range(parts)
        for k in range(parts)
    }
    ways = np.vstack([np.eye(3, dtype=int), -np.eye(3, dtype=int)])
    expected = {at for at in fine if any(tuple(int(n) for n in np.array(at) + way) not in fine for way in ways)}
    cloud = drawn(found)
    at = (cloud.points - found.cells.origin) / (size / parts) - 0.5
    np.testing.assert_allclose(at, at.round(), atol=1e-3)
    assert {tuple(int(n) for n in one) for one in at.round()} == expected
    assert len(cloud.points) == len(expected)
    assert size / parts <= cloud.size < 1.2 * size / parts


@pytest.mark.parametrize("kind", ["dexterous", "manipulability"])
def test_the_colours_follow_the_values(kind: MapKind) -> None:
    found = counted("movemaster", kind)
    cloud = drawn(found)
    at = np.floor((cloud.points - found.cells.origin) / found.cells.size).astype(int)
    there = found.values.reshape(found.cells.shape)[tuple(at.T)]
    reached = found.values[found.reached]
    shares = (there - reached.min()) / (reached.max() - reached.min())
    np.testing.assert_array_equal(cloud.colors, colours(shares))
    assert len(np.unique(cloud.colors, axis=0)) > 10


def test_the_colours_of_where_it_reaches_follow_the_height() -> None:
    cloud = drawn(counted("movemaster", "reachable"))
    order = np.argsort(cloud.points[:, 2])
    light = cloud.colors[order] @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(light) >= -1.0).all()
    assert light[-1] - light[0] > 100


def test_the_scale_grows_lighter_throughout_so_that_it_needs_no_eye_for_colours() -> None:
    light = colours(np.linspace(0, 1, 200)).astype(float) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(light) > -0.5).all()
    assert light[-1] - light[0] > 140
    np.testing.assert_array_equal(colours(np.array([0.0, 1.0])), ANCHORS[[0, -1]])
    np.testing.assert_array_equal(colours(np.array([-9.0, 9.0])), ANCHORS[[0, -1]])


def test_it_is_hidden_on_request_and_when_it_is_taken_away() -> None:
    found = counted("movemaster", "reachable")
    scene, one = staged()
    one.update(None, seen(found, shown=False))
    assert scene.clouds == []
    one.update(seen(found, shown=False), seen(found))
    (cloud,) = scene.clouds
    assert cloud.visible
    for hidden in (seen(found, shown=False), seen(None)):
        one.update(seen(found), hidden)
        assert not cloud.visible
        one.update(hidden, seen(found))
        assert cloud.visible
    assert scene.clouds == [cloud], "what is there is not sent again"


def test_it_is_sent_again_only_for_another_layer_of_cells_or_another_map() -> None:
    found = counted("movemaster", "reachable")
    scene, one = staged()
    step = 2 / (found.cells.shape[1] * (66 // found.cells.shape[1]))
    for cut in (0.0, 0.2 * step, 0.4 * step):
        one.update(None, seen(found, cut=cut))
    assert len(scene.clouds) == 1
    one.update(None, seen(found, cut=step))
    assert len(scene.clouds) == 2
    one.update(None, seen(counted("movemaster", "manipulability"), cut=step))
    assert len(scene.clouds) == 3


@pytest.mark.parametrize("name", ["planar2r", "planar3r", "orca", "polar_rp"])
def test_the_sheet_of_a_planar_arm_is_whole_and_lies_behind_all_that_moves(name: str) -> None:
    robot, found = load_robot(name), counted(name, "manipulability")
    cloud = drawn(found, name, cut=0.7)
    assert len(cloud.points) == found.reached.sum()
    heights = np.unique(cloud.points[:, 2])
    assert np.ptp(heights) < 1e-6
    moving = [
        (initial_state(robot).arm.poses[shape.link] @ shape.T_link_shape @ np.append(point, 1.0))[2]
        for shape in shapes.load_shapes(robot)
        if shape.link > 0
        for point in shape.edges.reshape(-1, 3)
    ]
    assert heights[0] <= min(moving) + 1e-6
    assert heights[0] > points_on(robot, initial_state(robot).arm.poses)[:, 2].min() - 0.25 * robot.reach


def test_no_map_is_more_than_a_browser_can_take() -> None:
    cells = WorkspaceGrid(frozen([-1, -1, 0]), frozen(np.eye(3)[:2]), 2 / 400, (400, 400))
    found = WorkspaceMap("reachable", 10**6, cells, np.ones(400 * 400, dtype=np.int64), frozen(np.ones(400 * 400)))
    points = drawn(found, "planar2r").points
    assert 25_000 < len(points) <= 30_000
    assert np.abs(points[:, :2]).max(axis=0) == pytest.approx([1, 1], abs=0.01)


@pytest.mark.parametrize(
    ("name", "edge", "words"),
    [("movemaster", 0.1, "1.00 L"), ("movemaster", 0.5, "125 L"), ("movemaster", 1.3, "2.20 m³"),
     ("planar2r", 0.2, "400 cm²"), ("planar2r", 1.5, "2.25 m²")],
)  # fmt: skip
def test_volumes_and_areas_are_said_in_a_fitting_unit(name: str, edge: float, words: str) -> None:
    d = 3 if name == "movemaster" else 2
    size, n = edge / 10, 12
    hits = np.zeros((n,) * d, dtype=np.int64)
    hits[(slice(1, 11),) * d] = 1
    cells = WorkspaceGrid(frozen(np.zeros(3)), frozen(np.eye(3)[:d]), size, (n,) * d)
    found = WorkspaceMap("reachable", 9, cells, hits.ravel(), frozen(hits.ravel() > 0))
    inner = 0.5 * (10**d + 8**d) * size**d  # what is touched, and what lies wholly inside
    found = replace(found, cells=replace(cells, size=size * (edge**d / inner) ** (1 / d)))
    assert measure_title(found).en == words
    assert measure_title(found).pt_BR == words.replace(".", ",")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", workspace.MAP_KINDS)
def test_the_words_give_measure_postures_and_the_bounds_of_the_scale(kind: MapKind, language: Any) -> None:
    found = counted("movemaster", kind)
    view = seen(found)
    view = replace(view, seat=replace(view.seat, language=language))
    rows = workspace_rows(load_robot("movemaster")).rows
    html = "".join(row.html(view) for row in rows if isinstance(row, HtmlRow))  # type: ignore[union-attr]
    said = scale_of(load_robot("movemaster"), found)
    assert measure_title(found)[language] in html
    assert "262\u202f144" in html
    assert said.title[language] in html
    assert all(f"rgb({r} {g} {b})" in html for r, g, b in ANCHORS.astype(int))
    there = values(found, np.argwhere(found.reached.reshape(found.cells.shape)))
    assert (said.least, said.greatest) == (there.min(), there.max())


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", workspace.MAP_KINDS)
def test_of_a_tool_that_only_turns_no_volume_is_told(tmp_path: Path, language: Language, kind: MapKind) -> None:
    text = chain_of(["base", "plate"]).replace('xyz="0.1 0 0"', 'xyz="0 0 0.3"')
    (path := tmp_path / "plate.urdf").write_text(f'<robot name="plate">{text}</robot>', "utf-8")
    robot = load_robot(str(path))
    plan = workspace.plan_map(robot, kind, 1000)
    found = workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)
    view = View(replace(initial_state(robot), workspace=WorkspaceMaps(map=found)), Seat("", language))
    html = "".join(row.html(view) for row in workspace_rows(robot).rows if isinstance(row, HtmlRow))  # type: ignore[union-attr]
    assert workspace.fixed_tool_text(robot, TITLES[kind])[language] in html
    assert measure_title(found)[language] not in html


def test_manipulability_has_a_unit_only_where_all_joints_turn() -> None:
    found = counted("movemaster", "manipulability")
    assert "m³" in scale(found, slides=False).title.en
    assert "m³" not in scale(found, slides=True).title.en


@pytest.mark.parametrize(("name", "cuts"), [("movemaster", 1), ("planar3r", 0)])
def test_only_maps_in_space_are_cut(name: str, cuts: int) -> None:
    assert sum(isinstance(row, Slider) for row in workspace_rows(load_robot(name)).rows) == cuts  # type: ignore[union-attr]
