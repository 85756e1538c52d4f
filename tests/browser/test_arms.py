"""Every shipped arm on the page: chosen from the list, drawn, moved by a number box and by the gizmo."""

from __future__ import annotations

import io
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page
from tests.browser import sheet
from tests.browser.lab import Lab, box, grab, pixels, status, tab, until

from helicoide import content, gate
from helicoide.arrays import Array, frozen
from helicoide.ik.goal import goal_at_pose
from helicoide.kinematics.library import robot_titles
from helicoide.state import State
from helicoide.view.layers import DRAWN_FOR
from helicoide.view.layers.arm import ArmLayer

ARROW = 0.22  # m, from the centre of the target gizmo to a point on its arrow, for an arm with reach DRAWN_FOR
DRAWN = 1500  # pixels that even the thinnest arm covers
NAMES = sorted(content.content_folders("robots"))


@pytest.fixture(scope="module")
def page(shared_page: Page) -> Page:
    tab(shared_page, "Robot")
    return shared_page


@pytest.fixture(scope="module", params=NAMES)
def arm(request: pytest.FixtureRequest, lab: Lab, page: Page) -> State:
    """Choose an arm of the list on the page; the state at `ready`, from which its tests start in turn."""
    name: str = request.param
    page.get_by_label("Arm", exact=True).click()
    page.get_by_role("option", name=robot_titles()[name].en, exact=True).click()
    until(page, lambda: lab.state.robot.name == name)
    lab.furnished(page)
    until(page, lambda: all(page.evaluate("(n) => !!window.__viserMutable.nodeRefFromName[n]", n) for n in nodes(lab)))
    page.wait_for_timeout(1000)
    return lab.state


def nodes(lab: Lab) -> list[str]:
    return [f"/arm/{shape.name}/mesh" for shape in lab.shapes]


def canvas(page: Page) -> Array:
    """The drawn scene as grey values."""
    picture = Image.open(io.BytesIO(page.locator("canvas").first.screenshot())).convert("L")
    return np.asarray(picture, dtype=np.float64)


def arm_layer(lab: Lab) -> ArmLayer:
    scene = lab.display._scene
    assert scene is not None
    layer = scene.layers.layers["arm"]
    assert isinstance(layer, ArmLayer)
    return layer


def position(page: Page, node: str) -> list[float]:
    """The position of a node in the browser, m."""
    return list(page.evaluate("(n) => window.__viserMutable.nodeRefFromName[n].position.toArray()", node))


def show(lab: Lab, page: Page, shown: bool) -> None:
    """Show or hide the solid arm."""
    layer = arm_layer(lab)

    def write() -> None:
        for frame in layer.placed.frames:
            frame.visible = shown
        lab.display.audience.flush()

    lab.session.loop.call_soon_threadsafe(write)
    script = "(n) => window.__viserMutable.nodeRefFromName[n].visible"
    until(page, lambda: page.evaluate(script, layer.placed.frames[0].name) is shown)
    page.wait_for_timeout(1000)


def test_the_arm_is_in_the_picture_and_every_part_of_it_is_somewhere_else(lab: Lab, page: Page, arm: State) -> None:
    with_arm = canvas(page)
    show(lab, page, False)
    without = canvas(page)
    show(lab, page, True)
    assert (abs(with_arm - without) > 12).sum() > DRAWN
    layer = arm_layer(lab)
    base = ElementTree.parse(arm.robot.urdf).find(f"link[@name='{arm.robot.base_link}']/visual")
    assert set(layer.placed.links) == set(range(base is None, len(arm.robot.joints) + 1)), "base and each moving link"
    for shape in lab.shapes:
        expected = arm.arm.poses[shape.link] @ np.append(shape.T_link_shape[:3, 3], 1)
        np.testing.assert_allclose(position(page, f"/arm/{shape.name}"), expected[:3], atol=1e-6)


def test_a_number_moves_its_joint(lab: Lab, page: Page, arm: State) -> None:
    joint = arm.robot.variables[0]
    scale = 1000.0 if joint.is_prismatic else 180 / np.pi
    step = 40.0 if joint.is_prismatic else 6.0
    value = round(scale * arm.arm.q[0] + (step if scale * joint.upper - scale * arm.arm.q[0] > step else -step), 1)
    box(page, 0, str(value))
    until(page, lambda: abs(scale * lab.state.arm.q[0] - value) < 0.06)
    assert (lab.state.arm.q[1:] == arm.arm.q[1:]).all()


def way(page: Page, state: State) -> tuple[Array, Array]:
    """From the tool to a point on an arrow of the gizmo, and a displacement along that arrow, (3,) m each.

    The arrow is the longest one on the screen among those along which the arm can follow.
    """
    T, length = state.T_world_tool, 0.06 * state.robot.reach
    best: tuple[float, Array, Array] | None = None
    for axis in range(3):
        for sign in (1.0, -1.0):
            arrow = ARROW * state.robot.reach / DRAWN_FOR * T[:3, axis]
            moved = T.copy()
            moved[:3, 3] += sign * length * T[:3, axis]
            seen = np.linalg.norm(np.subtract(pixels(page, T[:3, 3] + arrow), pixels(page, T[:3, 3])))
            if goal_at_pose(state.problem, state.arm.q, frozen(moved), False).position_error < 1e-4 and (
                not best or seen > best[0]
            ):
                best = (float(seen), arrow, sign * length * T[:3, axis])
    assert best is not None
    return best[1], best[2]


def test_the_gizmo_takes_the_tool_along(lab: Lab, page: Page, arm: State) -> None:
    lab.post(gate.keep_orientation(False))
    start = lab.state.T_world_tool[:3, 3]
    arrow, along = way(page, lab.state)
    grab(lab, page, start + arrow, start + arrow + along)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    lab.ticks(page, 150)
    moved = lab.state.T_world_tool[:3, 3] - start
    assert np.linalg.norm(moved - along) < 0.35 * np.linalg.norm(along), "the pointer is where the handle is"
    assert moved @ along > 0.6 * along @ along


def test_the_contact_sheet_shows_every_arm() -> None:
    with Image.open(sheet.PICTURE) as picture:
        last = sheet.corner(len(NAMES) - 1)[1]
        assert picture.size == (sheet.COLUMNS * sheet.CELL, last + sheet.CELL + sheet.LABEL), "run make docs-pictures"
    cells = sheet.cells()
    assert list(cells) == NAMES
    for name, cell in cells.items():
        middle = cell[sheet.CELL // 5 : -sheet.CELL // 5, sheet.CELL // 5 : -sheet.CELL // 5]
        assert (middle < 160).sum() > 200, name
    for name, other in pairwise(NAMES):
        assert (abs(cells[name] - cells[other]) > 40).sum() > 500, f"{name} and {other} are one picture"


def test_a_lesson_brings_its_arm_and_another_arm_ends_it(lab: Lab, page: Page) -> None:
    change(lab, page, "scara")
    tab(page, "Lesson")
    page.get_by_label("Lesson", exact=True).and_(page.locator("input")).click()
    page.get_by_role("option", name="Drive the arm").click()
    until(page, lambda: lab.state.robot.name == "movemaster")
    page.locator(".helicoide-lesson h3").wait_for()
    change(lab, page, "scara")
    page.locator(".helicoide-lesson h3").wait_for(state="detached")
    assert {seat.lesson for seat in lab.seats} == {None}


def test_an_arm_that_is_not_there_is_refused_in_words(lab: Lab, page: Page) -> None:
    here = lab.state.robot
    lab.change("nowhere")
    until(page, lambda: "There is no robot named 'nowhere'" in status(page))
    assert lab.state.robot is here


def change(lab: Lab, page: Page, name: str) -> None:
    lab.change(name)
    until(page, lambda: lab.state.robot.name == name)
    lab.furnished(page)
