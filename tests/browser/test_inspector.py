"""The inspector on the page: select by a click, type a coefficient, light up its meaning, the quaternion playground."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image, ImageChops
from playwright.sync_api import Page
from tests.browser.lab import Lab, pixels, press, speak, tab, until
from tests.browser.readable import remaining

from helicoide import gate, readout
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.seat import Seat, Selection
from helicoide.text import LANGUAGES, Language
from helicoide.view import code_rows, pose_form_rows, term_rows
from helicoide.view.panels import algebra

VISIBLE = "(name) => window.__viserMutable.nodeRefFromName[name]?.visible === true"


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    inspect(lab, shared_page, None)
    tab(shared_page, "Algebra")
    return shared_page


def seat(lab: Lab) -> Seat:
    return lab.seats[-1]


def inspect(lab: Lab, page: Page, selection: Selection | None, coefficient: str | None = None) -> None:
    """Select without the page, to prepare a test."""
    visitor = list(lab.session.visitors.values())[-1]

    def update(seat: Seat) -> Seat:
        return replace(seat.inspecting(selection), coefficient=coefficient)

    lab.session.loop.call_soon_threadsafe(visitor.reseat, update)
    until(page, lambda: seat(lab).selected == selection and seat(lab).coefficient == coefficient)


def picture(page: Page) -> Image.Image:
    """The scene left of the panel, once it is drawn."""
    page.wait_for_timeout(1500)
    shot = page.screenshot(clip={"x": 0, "y": 60, "width": 870, "height": 600})
    return Image.open(io.BytesIO(shot)).convert("RGB")


def click(page: Page, point: Array) -> None:
    page.mouse.click(*pixels(page, point))


def choose(page: Page, label: str, option: str) -> None:
    page.get_by_label(label, exact=True).click()
    page.get_by_role("option", name=option, exact=True).click()


def test_a_link_is_inspected_by_a_click_and_left_by_another(lab: Lab, page: Page) -> None:
    points = lab.state.monitored_points
    upper_arm = 0.5 * points[1] + 0.5 * points[2]
    click(page, upper_arm)
    until(page, lambda: seat(lab).selected == Selection("link", 1))
    card = page.locator(".helicoide-lit")
    until(page, lambda: "motor of link 2" in card.inner_text())
    until(page, lambda: bool(page.evaluate(VISIBLE, "/lit/frame")))
    assert bool(page.evaluate(VISIBLE, "/screw/helix"))
    click(page, upper_arm)
    until(page, lambda: seat(lab).selected is None)
    until(page, lambda: not page.evaluate(VISIBLE, "/screw/helix"))


def test_a_drag_of_the_camera_selects_nothing(lab: Lab, page: Page) -> None:
    points = lab.state.monitored_points
    x, y = pixels(page, 0.5 * points[1] + 0.5 * points[2])
    eye = "() => window.__viserMutable.camera.position.toArray()"
    before = page.evaluate(eye)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=6)
    page.mouse.up()
    until(page, lambda: page.evaluate(eye) != before)
    page.mouse.move(x + 60, y)
    page.mouse.down()
    page.mouse.move(x, y, steps=6)
    page.mouse.up()
    page.wait_for_timeout(500)
    assert seat(lab).selected is None


def test_a_typed_coefficient_moves_the_arm(lab: Lab, page: Page) -> None:
    choose(page, "Highlight", "end-effector motor")
    choose(page, "Coefficient", "e₁e")
    until(page, lambda: seat(lab).coefficient == "e1e")
    field = page.get_by_label("New value of e₁e [m]")
    field.fill("0,21")
    press(page, "Set")
    until(page, lambda: isinstance(lab.state.request.command, MoveToPose))
    until(page, lambda: not lab.state.arm.moving)
    element = readout.element_of(lab.state, Selection("tool"))
    assert element is not None
    until(page, lambda: abs(element.values(lab.state)[8] - 0.21) < 1e-3)
    assert readout.coefficients("motor", seat(lab).notation)[8].blade == "e1e"
    until(page, lambda: "0.210" in page.locator(".helicoide-lit .chosen").inner_text())


def test_words_that_are_no_number_are_refused(lab: Lab, page: Page) -> None:
    inspect(lab, page, Selection("tool"), "e1e")
    page.get_by_label("New value of e₁e [m]").fill("fast")
    press(page, "Set")
    until(page, lambda: "one number" in page.locator("#helicoide-status").inner_text())


def test_a_coefficient_lights_up_where_its_meaning_is(lab: Lab, page: Page) -> None:
    """The offset of a plane: a segment from the origin to its foot changes the picture, and nothing far from it."""
    lab.post(gate.add_plane([0.0, 0.6, -0.8, -0.7]))
    until(page, lambda: len(lab.state.problem.planes.panes) == 5)
    inspect(lab, page, Selection("plane", 4))
    plain = picture(page)
    inspect(lab, page, Selection("plane", 4), "e")
    marked = picture(page)
    changed = np.argwhere(np.array(ImageChops.difference(plain, marked)).max(axis=2) > 30)[:, ::-1] + [0, 60]
    assert len(changed) > 20
    foot = lab.state.problem.planes.offsets[4] * lab.state.problem.planes.normals[4]
    start, end = np.array(pixels(page, np.zeros(3))), np.array(pixels(page, foot))
    along = (end - start) / np.linalg.norm(end - start)
    across = np.abs((changed - start) @ np.array([-along[1], along[0]]))
    assert across.max() < 25
    words = page.locator(".helicoide-meaning").inner_text()
    assert "700.0 mm" in words.replace("−", "")


def test_the_copy_button_gives_every_digit(lab: Lab, page: Page) -> None:
    inspect(lab, page, Selection("tool"))
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    button = page.locator(".helicoide-copy")
    button.click()
    element = readout.element_of(lab.state, Selection("tool"))
    assert element is not None
    exact = readout.exact_text("motor", element.values(lab.state), seat(lab).notation)
    until(page, lambda: page.evaluate("navigator.clipboard.readText()").replace("\r\n", "\n") == exact)


def test_the_copy_button_works_where_the_clipboard_is_forbidden(lab: Lab, page: Page) -> None:
    """As in the cell of a notebook, a frame of another origin."""
    inspect(lab, page, Selection("tool"))
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.evaluate("navigator.clipboard.writeText('')")
    page.evaluate("() => { navigator.clipboard.writeText = () => Promise.reject(new DOMException('forbidden')); }")
    page.locator(".helicoide-copy").click()
    until(page, lambda: page.evaluate("navigator.clipboard.readText()").startswith("Cl("))
    page.evaluate("() => { delete navigator.clipboard.writeText; }")


def test_both_algebras_and_both_names_of_blades(lab: Lab, page: Page) -> None:
    inspect(lab, page, Selection("tool"))
    grid = page.locator(".helicoide-lit .helicoide-grid")
    until(page, lambda: "e3e1" in grid.inner_text().replace("\n", ""))
    choose(page, "Blades", "indices: e₂₃, e₀₁")
    until(page, lambda: "e31" in grid.inner_text().replace("\n", ""))
    choose(page, "Algebra", "Cl(3,0,1), as in modern texts")
    until(page, lambda: "−0.500" in grid.inner_text())
    choose(page, "Algebra", "Cl(0,3,1), as in the sources")
    choose(page, "Blades", "products: e₂e₃, e₁e")
    until(page, lambda: "e3e1" in grid.inner_text().replace("\n", ""))


def test_why_this_number_and_the_joint_of_a_term(lab: Lab, page: Page) -> None:
    inspect(lab, page, Selection("tool"), "e1e")
    page.get_by_text("Why this number", exact=True).click()
    terms = page.locator(".helicoide-terms")
    until(page, lambda: terms.locator("li").count() > 2 and "sin(θ₂/2)" in terms.inner_text())
    choose(page, "Highlight a joint", "joint 2 (shoulder)")
    until(page, lambda: bool(page.evaluate(VISIBLE, "/lit/joint")))
    page.get_by_text("Why this number", exact=True).click()


def test_the_quaternion_playground(lab: Lab, page: Page) -> None:
    """It is shown beside the arm, follows its numbers, and −q changes the way but not the frame."""
    plain = picture(page)
    page.get_by_text("Quaternion playground", exact=True).last.click()
    page.get_by_label("Show beside the arm").click()
    until(page, lambda: bool(page.evaluate(VISIBLE, "/playground")))
    assert ImageChops.difference(plain, picture(page)).getbbox() is not None
    page.get_by_label("Write −q₁ instead of q₁").click()
    until(page, lambda: seat(lab).playground.opposite)
    until(page, lambda: "longer way" in page.locator("body").inner_text())
    frame = "() => window.__viserMutable.nodeRefFromName['/playground/product0'].quaternion.toArray()"
    before = page.evaluate(frame)
    page.get_by_label("Write −q₁ instead of q₁").click()
    until(page, lambda: not seat(lab).playground.opposite)
    page.wait_for_timeout(500)
    assert abs(np.dot(before, page.evaluate(frame))) == pytest.approx(1.0, abs=1e-5)
    page.get_by_label("Show beside the arm").click()
    until(page, lambda: not page.evaluate(VISIBLE, "/playground"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_inspected_object_can_be_read(lab: Lab, page: Page, language: Language) -> None:
    """Sizes and contrasts of all that the inspector shows, with its folders open."""
    inspect(lab, page, Selection("tool"), "e1e")
    speak(lab, page, language)
    tab(page, algebra.TITLE[language])
    titles = [title[language] for title in (algebra.MEANINGS, pose_form_rows.TITLE, term_rows.TITLE, code_rows.TITLE)]
    for title in titles:
        page.get_by_text(title, exact=True).click()
    try:
        assert remaining(page, False) == []
    finally:
        for title in titles:
            page.get_by_text(title, exact=True).click()
        speak(lab, page, "en")
