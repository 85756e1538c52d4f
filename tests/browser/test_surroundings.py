"""Obstacles and the entry point on a page: added, dragged, read, removed."""

from __future__ import annotations

import numpy as np
import pytest
from playwright.sync_api import Page
from tests.browser.lab import Lab, grab, tab, until
from tests.driving import apart
from tests.gate.test_entry import beside

from helicoide import gate

ARROW = 0.12
SHOWN = "(name) => Boolean(window.__viserMutable.nodeRefFromName[name]?.visible)"


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    tab(shared_page, "Robot")
    return shared_page


def change(lab: Lab, page: Page, name: str) -> None:
    lab.change(name)
    until(page, lambda: lab.state.robot.name == name)
    lab.furnished(page)
    page.wait_for_timeout(1000)


def test_a_sphere_is_added_dragged_and_taken_away(lab: Lab, page: Page) -> None:
    change(lab, page, "puma560")
    page.get_by_text("Obstacles", exact=True).click()
    page.get_by_role("button", name="Add sphere").click()
    until(page, lambda: len(lab.state.problem.obstacles.radii) == 1 and page.evaluate(SHOWN, "/obstacles/0"))
    centre = lab.state.problem.obstacles.ends[0, 0]
    scale = lab.state.robot.reach / 0.82
    up = np.array([0.0, 0.0, 1.0])
    grab(lab, page, centre + ARROW * scale * up, centre + (ARROW * scale + 0.1) * up)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    moved = lab.state.problem.obstacles.ends[0, 0] - centre
    np.testing.assert_allclose(moved, 0.1 * up, atol=0.03)
    lab.post(gate.keep_orientation(False))
    lab.post(gate.set_target(lab.state.problem.obstacles.ends[0, 0], [1, 0, 0, 0]))
    tab(page, "Method")
    until(page, lambda: "obstacle 1" in page.locator(".helicoide-instruments").inner_text())
    assert apart(lab.state) >= -1e-9
    tab(page, "Robot")
    page.get_by_role("button", name="Remove sphere 1").click()
    until(page, lambda: not lab.state.problem.obstacles.radii.size and not page.evaluate(SHOWN, "/obstacles/0"))
    page.get_by_text("Obstacles", exact=True).click()


def test_the_instrument_is_kept_in_its_entry_point_by_a_method_of_the_source(lab: Lab, page: Page) -> None:
    change(lab, page, "dia10")
    page.get_by_text("Entry point (remote centre of motion, RCM)", exact=True).click()
    page.get_by_label("Enforce the RCM").click()
    until(page, lambda: lab.state.problem.entry is not None and page.evaluate(SHOWN, "/entry"))
    lab.post(gate.choose_method("pseudoinverse"))
    T = lab.state.T_world_tool
    lab.post(gate.set_target(T[:3, 3] + 0.02 * T[:3, 0], [1, 0, 0, 0]))
    lab.post(gate.keep_orientation(False))
    until(page, lambda: lab.state.arm.moving)
    until(page, lambda: not lab.state.arm.moving)
    assert beside(lab.state) < 1e-5
    tab(page, "Method")
    until(page, lambda: "distance to the entry point" in page.locator(".helicoide-instruments").inner_text())
    assert "manipulability beyond the entry point" in page.locator(".helicoide-instruments").inner_text()
    tab(page, "Robot")
    page.get_by_label("Enforce the RCM").click()
    until(page, lambda: lab.state.problem.entry is None and not page.evaluate(SHOWN, "/entry"))


def test_an_arm_without_an_instrument_has_no_entry_point(lab: Lab, page: Page) -> None:
    change(lab, page, "movemaster")
    until(page, lambda: page.get_by_text("Entry point (remote centre of motion, RCM)").count() == 0)
    assert page.get_by_text("Obstacles", exact=True).count() == 1
