"""The look of a window: dark, transparent arm, camera presets; a link opened in another window; undo by keyboard."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.lab import Lab, grab, press, tab, until

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition
from helicoide.sheet import NameSlider, Sheet, SheetHistory, SheetLine

CAMERA = "() => { const c = window.__viserMutable.camera; return [...c.position.toArray()]; }"
SHOWN = "(name) => Boolean(window.__viserMutable.nodeRefFromName[name]?.visible)"
OPACITIES = """() => {
  const found = [];
  for (const [name, node] of Object.entries(window.__viserMutable.nodeRefFromName))
    if (node && name.startsWith("/arm/")) node.traverse((part) => part.material && found.push(part.material.opacity));
  return found;
}"""
GROUND = "getComputedStyle(document.querySelector('#helicoide-status')).backgroundColor"


@pytest.fixture(scope="module")
def opened_page(shared_page: Page) -> Page:
    shared_page.get_by_text("View", exact=True).click()
    shared_page.get_by_role("button", name="Top", exact=True).wait_for()
    return shared_page


@pytest.fixture
def page(opened_page: Page, lab: Lab) -> Page:
    lab.reset(opened_page)
    return opened_page


def eye(page: Page) -> Array:
    return np.array(page.evaluate(CAMERA))


def test_the_dark_look_is_of_one_window_and_the_arm_is_seen_through(lab: Lab, page: Page, browser: Browser) -> None:
    with window(browser, lab.port) as other:
        page.get_by_role("checkbox", name="Dark", exact=True).check()
        page.wait_for_selector("html[data-mantine-color-scheme=dark]")
        assert page.evaluate(GROUND) == "rgb(36, 36, 36)"
        page.get_by_label("Transparent arm").check()
        until(page, lambda: bool(shares := page.evaluate(OPACITIES)) and max(shares) < 0.5)
        assert other.locator("html[data-mantine-color-scheme=light]").count() == 1
        assert min(other.evaluate(OPACITIES)) > 0.5
        page.get_by_label("Transparent arm").uncheck()
        until(page, lambda: min(page.evaluate(OPACITIES)) > 0.5)
        page.get_by_role("checkbox", name="Dark", exact=True).uncheck()
        page.wait_for_selector("html[data-mantine-color-scheme=light]")


def test_the_look_that_a_browser_prefers_comes_first(lab: Lab, browser: Browser) -> None:
    context = browser.new_context(color_scheme="dark")
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{lab.port}/?fixedDpr=0.25")
    expect(page.locator("html")).to_have_attribute("data-mantine-color-scheme", "dark")
    context.close()


def test_a_camera_preset_moves_the_camera_of_this_window_also_while_the_arm_moves(
    lab: Lab, page: Page, browser: Browser
) -> None:
    press(page, "Initial")
    with window(browser, lab.port) as other:
        until(other, lambda: "/target" in other.evaluate("Object.keys(window.__viserMutable.nodeRefFromName)"))
        until(other, lambda: bool(abs(eye(other) - eye(page)).max() < 1e-3))
        first = eye(page)
        tab(page, "Robot")
        press(page, "Play")
        until(page, lambda: lab.state.arm.moving)
        press(page, "Side")
        until(page, lambda: abs(eye(page) - first).max() > 0.1)
        assert lab.state.arm.moving
        assert abs(eye(other) - first).max() < 1e-3
    press(page, "Initial")
    until(page, lambda: bool(abs(eye(page) - first).max() < 1e-3))


def test_a_link_shows_its_view_in_another_window_and_moves_nothing(lab: Lab, page: Page, browser: Browser) -> None:
    tab(page, "Algebra")
    press(page, "Top")
    until(page, lambda: eye(page)[1] > 1.0)  # three.js: y is upward
    there = eye(page)
    lab.post(gate.set_joint(0, 0.3))
    until(page, lambda: abs(lab.state.arm.q[0] - 0.3) < 1e-3)
    sheet = Sheet((SheetLine("a * L1"),), (("a", NameSlider(0.5, 0.0, 1.0)),))
    (visitor,) = lab.session.visitors.values()
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: replace(seat, sheet=sheet))
    page.get_by_role("button", name="Undo: sheet changed").wait_for()
    press(page, "Copy link to this view")
    page.wait_for_function("location.hash.endsWith('&end=1')")
    fragment = page.evaluate("location.hash")
    lab.reset(page)
    q = lab.state.arm.q
    with window(browser, lab.port, locale="pt-BR", path="/") as other:
        other.goto(f"http://127.0.0.1:{lab.port}/?fixedDpr=0.25{fragment}")
        expect(other.get_by_role("tab", name="Álgebra")).to_have_attribute("aria-selected", "true")
        until(other, lambda: bool(abs(eye(other) - there).max() < 1e-3))
        other.get_by_role("button", name="Ir à postura do link").wait_for()
        assert lab.seats[-1].sheet == sheet
        until(other, lambda: other.evaluate(SHOWN, f"/linked/{lab.shapes[1].name}"))
        assert lab.state.arm.q is q
        assert lab.state.request.command == HoldPosition()
        other.get_by_role("button", name="Ir à postura do link").click()
        until(other, lambda: abs(lab.state.arm.q[0] - 0.3) < 1e-3)
        expect(other.get_by_role("button", name="Ir à postura do link")).to_have_count(0)
        assert other.evaluate("location.hash") == ""
    page.evaluate("window.helicoideShare('')")
    emptied = {"sheet": Sheet(), "sheet_history": SheetHistory()}
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: replace(seat, **emptied))


def test_a_dragged_plane_is_undone_by_keyboard_but_not_in_a_text_field(lab: Lab, page: Page) -> None:
    tab(page, "Robot")
    planes = lab.state.problem.planes
    index = planes.names.index("+y")
    start, normal = planes.centres[index], planes.normals[index]
    q = lab.state.arm.q

    def moved() -> float:
        return float((lab.state.problem.planes.centres[index] - start) @ normal)

    arrow = start + 0.12 * normal
    grab(lab, page, arrow, arrow - 0.08 * normal)
    until(page, lambda: moved() < -0.02)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    page.get_by_role("button", name="Undo: plane +y moved").wait_for()
    assert len(lab.state.history.undo) == 1
    away = moved()
    page.locator("input.mantine-NumberInput-input").first.focus()
    page.keyboard.press("Control+z")
    page.wait_for_timeout(500)
    assert moved() == away
    page.get_by_role("slider").first.focus()
    page.keyboard.press("Control+z")
    until(page, lambda: abs(moved()) < 1e-9)
    page.get_by_role("button", name="Redo: plane +y moved").wait_for()
    page.keyboard.press("Control+y")
    until(page, lambda: moved() == away)
    page.keyboard.press("Control+z")
    until(page, lambda: abs(moved()) < 1e-9)
    page.keyboard.press("Control+Shift+z")
    until(page, lambda: moved() == away)
    page.get_by_role("button", name="Undo: plane +y moved").click()
    until(page, lambda: abs(moved()) < 1e-9)
    assert (lab.state.arm.q == q).all()


def test_a_slider_that_is_held_is_one_change(lab: Lab, page: Page) -> None:
    """Two drags of a slider with a release in between are two changes."""
    tab(page, "Method")
    lab.post(gate.choose_method("pseudoinverse"))
    lab.post(gate.finish_change())
    until(page, lambda: lab.state.request.controller.method == "pseudoinverse" and not lab.state.history.unfinished)
    before = len(lab.state.history.undo)
    page.get_by_text("Gains", exact=True).click()
    slider = page.get_by_role("slider", name="x [1/s]", exact=True)
    slider.scroll_into_view_if_needed()
    for count in (1, 2):
        box = slider.bounding_box()
        assert box is not None
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        for k in range(1, 6):
            page.mouse.move(x + (5 if count == 1 else -5) * k, y)
            page.wait_for_timeout(100)
        page.mouse.up()
        until(page, lambda count=count: len(lab.state.history.undo) >= before + count)  # type: ignore[misc]
        page.wait_for_timeout(500)
        assert len(lab.state.history.undo) == before + count
