"""Each optional layer on the page: pixels change where its geometry is projected, and nowhere else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import MappingProxyType, ModuleType

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from tests.browser.geometry import covered, seen_as_sent, world_points
from tests.browser.lab import Lab, box, pixels, press, tab, until
from tests.browser.sheet import THERE
from tests.browser.test_arms import canvas

from helicoide import gate
from helicoide.arrays import frozen
from helicoide.contributions.trials import with_joints
from helicoide.kinematics import workspace
from helicoide.seat import SeatUpdate, Selection
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures
from helicoide.sheet import Sheet, SheetLine
from helicoide.state import ComparedArm, FittedCloud, State, WorkspaceMaps, initial_state
from helicoide.text import Text
from helicoide.view import layers
from helicoide.view.window_view import View

DIFFERENT, FEWEST = 12, 20  # of 255 grey values, and pixels
MARGIN = 22.0  # px: half of a thick line or arrow head, and a pixel of the screen at a resolution of a quarter
TWO_FRAMES = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
HERE = Text(en="here", pt_BR="aqui")
Layer = ModuleType


def _running(state: State) -> State:
    velocities = frozen(np.full(len(state.arm.q), 0.3))
    return replace(state, arm=replace(state.arm, velocities=velocities))


def _with_cloud(state: State) -> State:
    points = frozen(np.random.default_rng(0).uniform([0.2, -0.6, 0.2], [0.6, -0.5, 0.8], (400, 3)))
    cloud = FittedCloud(points, np.arange(400) % 2 == 0, HERE)
    return replace(state, clouds=MappingProxyType({"wall": cloud}))


def _with_map(state: State) -> State:
    plan = workspace.plan_map(state.robot, "reachable", 4 * workspace.CHUNK)
    found = workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)
    return replace(state, workspace=WorkspaceMaps(map=found))


def _with_second_arm(state: State) -> State:
    away = with_joints(state, frozen(state.arm.q + 0.4))
    return replace(state, compared=ComparedArm(away.arm, state.request.controller))


def _with_plan(state: State) -> State:
    return plan_motion(state, gate.set_joint(0, float(state.arm.q[0]) + 0.6), HERE)(state)


PREPARED: dict[str, Callable[[State], State]] = {
    "twist": _running,
    "cloud": _with_cloud,
    "workspace": _with_map,
    "compared": _with_second_arm,
    "plan": _with_plan,
    "postures": lambda state: list_postures(state)(state),
    "singular": lambda state: with_joints(state, frozen(np.zeros(len(state.arm.q)))),
    "null": gate.keep_orientation(False),
    "distances": gate.add_obstacle(),
    "shaft": gate.enforce_entry(True),
}
SEATED: dict[str, SeatUpdate] = {
    "screw": lambda seat: seat.inspecting(Selection("tool")),
    "console": lambda seat: replace(seat, sheet=Sheet((SheetLine("M_tool"), SheetLine("L2")))),
}
OF_ANOTHER_ARM = {"shaft": "dia10_rod"}


@pytest.fixture(scope="module")
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    until(shared_page, lambda: bool(lab.windows))
    drawn(lab, shared_page, lab.session.view(lab.windows[-1]))  # the first pictures differ, until all is loaded
    return shared_page


def load(lab: Lab, page: Page, robot: str) -> None:
    """Load a robot, unless it is there, and wait until it is drawn whole."""
    if lab.state.robot.name != robot:
        lab.change(robot)
        until(page, lambda: lab.state.robot.name == robot and lab.display._drawn[0] is lab.state.robot)
        until(page, lambda: all(page.evaluate(THERE, f"/arm/{shape.name}/mesh") for shape in lab.shapes))
        loading = [canvas(page)]
        until(page, lambda: _is_loaded(page, loading))


def _is_loaded(page: Page, pictures: list[np.ndarray]) -> bool:
    """Whether the arm has looked the same for three seconds: its meshes arrive one after another."""
    page.wait_for_timeout(1000)
    pictures.append(_next_picture(page))
    return len(pictures) > 3 and all(bool((one == pictures[-1]).all()) for one in pictures[-4:-1])


def drawn(lab: Lab, page: Page, view: View) -> np.ndarray:
    """Draw a view in the window, and return the picture when it has come to rest."""
    window = lab.windows[-1]

    def draw() -> None:
        window.draw(view)
        window.client.flush()

    lab.session.loop.call_soon_threadsafe(draw)
    page.wait_for_timeout(300)
    until(page, lambda: seen_as_sent(page, window.client.scene))
    pictures = [_next_picture(page) for _ in range(2)]
    until(page, lambda: _rests(page, pictures))
    return pictures[-1]


def _next_picture(page: Page) -> np.ndarray:
    page.evaluate(TWO_FRAMES)
    return canvas(page)


def _rests(page: Page, pictures: list[np.ndarray]) -> bool:
    """Whether three pictures in a row are alike: a busy machine may draw nothing for a while."""
    pictures.append(_next_picture(page))
    return all(bool((one == pictures[-1]).all()) for one in pictures[-3:-1])


def only(view: View, name: str | None) -> View:
    """The view with one optional layer, or none."""
    seat = view.seat
    for layer in layers.optional():
        seat = seat.with_layer(layer.NAME, name == layer.NAME)
    return replace(view, seat=seat)


@pytest.mark.parametrize("layer", layers.optional(), ids=lambda layer: layer.NAME)
def test_pixels_change_where_the_layer_is_and_nowhere_else(lab: Lab, page: Page, layer: Layer) -> None:
    name = layer.NAME
    load(lab, page, OF_ANOTHER_ARM.get(name, "movemaster"))
    state = PREPARED.get(name, lambda state: state)(initial_state(lab.state.robot))
    view = replace(lab.session.view(lab.windows[-1]), state=state, time=0.0)
    view = replace(view, seat=SEATED.get(name, lambda seat: seat)(view.seat))
    without = drawn(lab, page, only(view, None))
    if name == "trail":
        for way in np.linspace(0.0, 0.5, 20):
            drawn_state = with_joints(state, frozen(state.arm.q + way))
            lab.session.loop.call_soon_threadsafe(lab.windows[-1].draw, only(replace(view, state=drawn_state), name))
    shown = drawn(lab, page, only(view, name))
    changed = abs(shown - without) > DIFFERENT
    scene = lab.windows[-1].client.scene
    expected = covered(page, scene, f"/{name}", MARGIN, changed.shape)
    assert changed.sum() >= FEWEST
    assert np.argwhere(changed & ~expected).tolist() == []
    assert not (abs(drawn(lab, page, only(view, None)) - without) > DIFFERENT).any()


def test_a_layer_is_shown_by_its_checkbox_and_says_what_is_seen(lab: Lab, page: Page) -> None:
    load(lab, page, "movemaster")
    tab(page, "Robot")
    page.get_by_role("button", name="Show", exact=True).click()
    line = page.get_by_text(layers.dh.SAID.en, exact=True)  # type: ignore[attr-defined]
    expect(line).to_have_count(0)
    page.get_by_label("DH frames and parameters").check()
    line.wait_for()
    until(page, lambda: page.evaluate("() => window.__viserMutable.nodeRefFromName['/dh/theta']?.visible === true"))
    page.get_by_label("DH frames and parameters").uncheck()
    until(page, lambda: page.evaluate("() => window.__viserMutable.nodeRefFromName['/dh']?.visible === false"))
    expect(line).to_have_count(0)
    page.get_by_role("button", name="Show", exact=True).click()


def test_a_click_on_a_ghost_goes_to_its_posture(lab: Lab, page: Page) -> None:
    """The list is computed without a button; the ghost that is clicked is one with a bar that nothing else covers."""
    load(lab, page, "planar2r")
    visitor = list(lab.session.visitors.values())[-1]
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: seat.with_layer("postures", True))
    until(page, lambda: lab.state.postures.listing is not None)
    scene = lab.windows[-1].client.scene
    until(page, lambda: "/postures/bars" in scene._handle_from_node_name)
    page.wait_for_timeout(1500)
    listing = lab.state.postures.listing
    assert listing is not None
    other = max(listing.rows, key=lambda row: float(np.abs(row.q - lab.state.arm.q).max()))
    layer = lab.windows[-1].layers.layers["postures"]  # type: ignore[union-attr]
    k = layer.places.index(listing.rows.index(other))  # type: ignore[attr-defined]
    place = np.asarray(scene._handle_from_node_name["/postures/bars"].batched_positions)[k]  # type: ignore[attr-defined]
    assert len(world_points(scene, "/postures/bars"))
    until(page, lambda: _clicked(lab, page, place, other.q))
    until(page, lambda: bool(np.abs(lab.state.arm.q - other.q).max() < 1e-3))
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: seat.with_layer("postures", False))


def _clicked(lab: Lab, page: Page, place: np.ndarray, q: np.ndarray) -> bool:
    """Click at a point of the scene; whether that asked for the posture. A slow page may miss a click."""
    page.mouse.click(*pixels(page, place))
    page.wait_for_timeout(500)
    asked = getattr(lab.state.request.command, "q", None)
    return asked is not None and bool((asked == q).all())


def test_a_motion_is_planned_shown_and_executed(lab: Lab, page: Page) -> None:
    load(lab, page, "movemaster")
    tab(page, "Robot")
    start = lab.state.arm.q
    box(page, 0, f"{np.degrees(start[0]) + 20:.1f}")
    until(page, lambda: lab.cell.resting and abs(lab.state.arm.q[0] - start[0]) > 0.3)
    away = lab.state.arm.q
    page.get_by_role("button", name="Planned motion", exact=True).click()
    page.get_by_label("Plan to").click()
    page.get_by_role("option", name=lab.state.robot.pose_titles["ready"].en, exact=True).click()
    until(page, lambda: lab.state.plan is not None)
    until(page, lambda: bool(page.evaluate("() => window.__viserMutable.nodeRefFromName['/plan/way']?.visible")))
    page.wait_for_timeout(1000)
    assert (lab.state.arm.q == away).all(), "nothing moves before the plan is executed"
    press(page, "Execute the planned motion")
    until(page, lambda: bool(np.abs(lab.state.arm.q - start).max() < 3e-3))
    assert lab.state.plan is None
    page.get_by_role("button", name="Planned motion", exact=True).click()
