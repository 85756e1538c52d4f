"""Keyboard use: all controls have names and can be reached, arrow keys move joints and the target, Escape stops."""

from __future__ import annotations

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.lab import Lab, press, status, tab, until

from helicoide import gate
from helicoide.command import HoldPosition, MoveToPose
from helicoide.view.page import STEPS


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    tab(shared_page, "Robot")
    return shared_page


SHOWN_AT = "x => Math.abs(1000 * window.__viserMutable.nodePoseData['/target'].position[0] - x) < 0.01"


def asked(lab: Lab) -> float:
    """The x coordinate of the target, mm; NaN without a target."""
    command = lab.state.request.command
    return 1000 * float(command.T_world_target[0, 3]) if isinstance(command, MoveToPose) else np.nan


def test_a_folder_opens_and_closes_by_its_key(page: Page) -> None:
    heading = page.get_by_role("button", name="Show", exact=True)
    expect(heading).to_have_attribute("aria-expanded", "false")
    heading.focus()
    page.keyboard.press("Enter")
    expect(heading).to_have_attribute("aria-expanded", "true")
    page.keyboard.press("Space")
    expect(heading).to_have_attribute("aria-expanded", "false")


@pytest.mark.parametrize(("keys", "step"), [("ArrowRight", 1.0), ("Shift+ArrowRight", 10.0), ("Alt+ArrowLeft", -0.1)])
def test_a_joint_moves_in_the_steps_of_a_pendant(lab: Lab, page: Page, keys: str, step: float) -> None:
    start = round(float(np.degrees(lab.state.arm.q[0])), 1)
    slider = page.get_by_role("slider").first
    expect(slider).to_have_attribute("aria-valuenow", f"{start:g}")
    slider.focus()
    for presses in (1, 2):
        page.keyboard.press(keys)
        wanted = start + presses * step
        until(page, lambda wanted=wanted: abs(float(np.degrees(lab.state.arm.q[0])) - wanted) < 0.01)  # type: ignore[misc]


def test_the_target_moves_in_the_steps_of_a_pendant(lab: Lab, page: Page) -> None:
    start = 1000 * float(lab.state.T_world_tool[0, 3])
    page.wait_for_function(SHOWN_AT, arg=start)
    page.locator("canvas[role=application]").focus()
    for keys, step in (("Shift+ArrowDown", -10.0), ("ArrowDown", -11.0), ("Alt+ArrowUp", -10.9)):
        page.keyboard.press(keys)
        until(page, lambda step=step: abs(asked(lab) - start - step) < 0.01)  # type: ignore[misc]
        until(page, lambda: lab.state.request.drag is None and not lab.state.arm.moving)
        page.wait_for_function(SHOWN_AT, arg=start + step)  # the next key moves the target from where the page has it


def test_a_held_key_is_dead_after_a_stop_until_it_is_pressed_anew(lab: Lab, page: Page) -> None:
    page.locator("canvas[role=application]").focus()
    page.keyboard.down("Shift")
    page.keyboard.down("ArrowDown")
    until(page, lambda: lab.state.arm.moving)
    page.keyboard.press("Escape")
    until(page, lambda: lab.state.request.command == HoldPosition(stopped=True))
    q = lab.state.arm.q
    for _ in range(10):
        page.keyboard.down("ArrowDown")
        page.wait_for_timeout(50)
    assert lab.state.request.command == HoldPosition(stopped=True)
    assert (lab.state.arm.q == q).all()
    page.keyboard.up("ArrowDown")
    page.keyboard.up("Shift")
    page.wait_for_timeout(500)
    assert (lab.state.arm.q == q).all()
    page.keyboard.press("ArrowDown")
    until(page, lambda: isinstance(lab.state.request.command, MoveToPose))


def test_a_key_whose_release_macos_does_not_report_is_not_held(page: Page) -> None:
    """While Command is down, macOS reports no release of other keys; the page must accept actions after a stop."""
    page.keyboard.down("Meta")
    page.keyboard.down("z")
    page.keyboard.up("Meta")
    page.evaluate("window.drives = false")
    page.keyboard.press("Escape")
    page.wait_for_function("window.drives")
    page.keyboard.up("z")


def test_escape_closes_a_list_and_says_no_more_where_nothing_moved(lab: Lab, page: Page) -> None:
    press(page, "Play")
    until(page, lambda: lab.state.arm.moving)
    for moves in (True, False):
        if not moves:
            lab.reset(page)
            lab.post(gate.set_target([0.6, 0.0, 0.2], [1.0, 0.0, 0.0, 0.0]))
            until(page, lambda: isinstance(lab.state.request.command, MoveToPose) and not lab.state.arm.moving)
            lab.ticks(page, 300)
        page.get_by_label("Path", exact=True).click()
        page.get_by_role("option", name="circle").wait_for()
        page.keyboard.press("Escape")
        page.get_by_role("option", name="circle").wait_for(state="hidden")
        until(page, lambda moves=moves: lab.state.request.command == HoldPosition(stopped=moves))  # type: ignore[misc]
        until(page, lambda moves=moves: ("Stopped" in status(page)) == moves)  # type: ignore[misc]


def test_a_first_visit_has_a_hint_that_stays_closed(lab: Lab, browser: Browser) -> None:
    with window(browser, lab.port, first=True, locale="pt-BR") as page:
        hint = page.locator("#helicoide-hint")
        assert hint.locator("li").all_inner_texts() == [step.pt_BR for step in STEPS]
        page.get_by_role("tab", name="Robô").click()
        hint.get_by_role("button", name="Primeira lição").click()
        expect(page.get_by_role("tab", name="Lição")).to_have_attribute("aria-selected", "true")
        expect(page.locator(".helicoide-lesson h3")).to_contain_text("1.")
        expect(hint).to_have_count(0)
        page.reload()
        page.wait_for_selector("#helicoide-stop[data-link=up]")
        expect(hint).to_have_count(0)
