"""The Method tab on a page: a change of method during a drag, settings, an objective, a compared arm."""

from __future__ import annotations

import numpy as np
import pytest
from playwright.sync_api import Page
from tests.browser.lab import Lab, grab, pixels, status, tab, until

from helicoide import gate
from helicoide.ik import objectives

CRITICAL = 0.080
ARROW = 0.22
OUTLINE_SHOWN = "() => window.__viserMutable.nodeRefFromName['/compared/gripper']?.visible"


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.watch()
    lab.reset(shared_page)
    tab(shared_page, "Method")
    return shared_page


def choose(page: Page, label: str, option: str) -> None:
    """Choose an option from a list of the open tab."""
    page.locator("input[role=combobox]:visible").and_(page.get_by_label(label, exact=True)).click()
    page.get_by_role("option", name=option, exact=True).click()


def by_palette(page: Page, words: str) -> None:
    """Choose a command with the keyboard, which is possible during a drag."""
    page.keyboard.press("Control+K")
    asked = page.get_by_placeholder("Search commands...")
    asked.wait_for()
    asked.fill(words)
    page.locator(".mantine-Spotlight-action").filter(has_text=words).first.wait_for()
    page.wait_for_timeout(300)
    page.keyboard.press("Enter")
    asked.wait_for(state="detached")


def reads(page: Page, title: str) -> list[str]:
    """The values of a quantity in the table, one for each arm."""
    row = page.locator(".helicoide-instruments tr").filter(has_text=title)
    return [] if row.count() == 0 else row.first.locator("td").all_inner_texts()[1:]


def test_a_method_is_chosen_while_the_hand_holds_the_target(lab: Lab, page: Page) -> None:
    T = lab.state.T_world_tool
    start, along = T[:3, 3], T[:3, 0]
    grab(lab, page, start + ARROW * along, start + (ARROW - 0.06) * along)
    for words, name in (("Method: damped least squares", "damped"), ("Method: filtered inverse", "filtered")):
        by_palette(page, words)
        until(page, lambda name=name: lab.state.request.controller.method == name)  # type: ignore[misc]
        assert lab.state.request.drag is not None
        page.mouse.move(*pixels(page, start + (ARROW - 0.12) * along), steps=5)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    until(page, lambda: not lab.state.arm.moving)
    assert np.linalg.norm(lab.state.T_world_tool[:3, 3] - start) > 0.08
    assert lab.fastest <= 1 + 1e-9
    assert lab.nearest >= CRITICAL - 1e-9


def test_the_table_follows_the_method_and_its_settings(lab: Lab, page: Page) -> None:
    lab.post(gate.set_target(lab.state.T_world_tool[:3, 3] + [0.05, 0.05, 0.0], [1, 0, 0, 0]))
    until(page, lambda: float(reads(page, "condition number")[0].replace("∞", "inf")) > 1)
    assert float(reads(page, "manipulability")[0]) > 0
    assert reads(page, "inversion error") == []
    choose(page, "Method", "filtered inverse")
    until(page, lambda: len(reads(page, "inversion error")) == 1)
    choose(page, "Integration", "explicit Euler")
    until(page, lambda: lab.state.request.controller.options("filtered").step == "euler")
    choose(page, "Method", "damped least squares")
    damping = page.get_by_role("slider", name="damping λ")
    damping.focus()
    page.keyboard.press("End")  # the slider's value is the exponent of ten, in mm/rad
    until(page, lambda: damping.get_attribute("aria-valuenow") == damping.get_attribute("aria-valuemax"))
    shown = 10 ** float(damping.get_attribute("aria-valuenow") or "nan")
    until(
        page,
        lambda: np.isclose(
            lab.state.request.controller.options("damped").damping * 1000 * lab.state.robot.reach, shown
        ),
    )
    page.get_by_text(f"damping λ: {shown:.3g} mm/rad").first.wait_for()


def test_an_objective_is_chosen_and_weighed(lab: Lab, page: Page) -> None:
    lab.post(gate.keep_orientation(False))
    choose(page, "Method", "pseudoinverse")
    page.get_by_text("Secondary objective", exact=True).click()
    choose(page, "Objective", objectives.named("limit_distance").TITLE.en)
    until(page, lambda: lab.state.request.controller.secondary is not None)
    lab.post(gate.set_target(lab.state.T_world_tool[:3, 3], [1, 0, 0, 0]))
    q, tool = lab.state.arm.q, lab.state.T_world_tool[:3, 3]
    page.get_by_label("Adapt weights near joint limits").click()
    lab.post(gate.weigh_objective(50.0))
    until(page, lambda: bool(np.abs(lab.state.arm.q - q).max() > 0.05))
    assert np.linalg.norm(lab.state.T_world_tool[:3, 3] - tool) < 1e-3
    assert lab.state.request.controller.secondary is not None
    assert lab.state.request.controller.secondary.adapts
    page.get_by_text("Secondary objective", exact=True).click()


def test_two_methods_follow_the_same_target_side_by_side(lab: Lab, page: Page) -> None:
    choose(page, "Compare with", "Jacobian transpose")
    until(page, lambda: lab.state.compared is not None and bool(page.evaluate(OUTLINE_SHOWN)))
    lab.post(gate.set_target(lab.state.T_world_tool[:3, 3] + [0.0, 0.12, 0.0], [1, 0, 0, 0]))
    until(page, lambda: len(reads(page, "position error")) == 2)
    until(page, lambda: reads(page, "position error")[0] != reads(page, "position error")[1])
    choose(page, "Compare with", "none")
    until(page, lambda: lab.state.compared is None and not page.evaluate(OUTLINE_SHOWN))


def test_what_holds_the_arm_is_named_and_a_method_that_does_not_apply_says_why(lab: Lab, page: Page) -> None:
    lab.post(gate.set_target([0.6, 0.0, 0.9], [1, 0, 0, 0]))
    until(page, lambda: "plane +z" in " ".join(reads(page, "limited by")))
    choose(page, "Method", "inverse")
    until(page, lambda: "rows" in status(page) and "joints" in status(page))
    page.get_by_text("About the method", exact=True).click()
    until(page, lambda: "np.linalg.inv" in page.locator(".helicoide-listing").inner_text())
    page.get_by_text("About the method", exact=True).click()


def test_the_tab_in_portuguese(lab: Lab, page: Page) -> None:
    page.get_by_label("Language · Idioma").click()
    page.get_by_role("option", name="Português (Brasil)").click()
    tab(page, "Método")
    choose(page, "Método", "inversa filtrada")
    until(page, lambda: lab.state.request.controller.method == "filtered")
    said = page.locator("body").inner_text()
    for word in ("Ajustes", "Ganhos", "Objetivo secundário", "Comparar com", "número de condição", "limitado por"):
        assert word in said, word
    for english in ("Settings", "Gains", "Compare with", "condition number", "limited by", "Guarantees"):
        assert english not in said, english
    page.get_by_label("Idioma · Language").click()
    page.get_by_role("option", name="English").click()
    tab(page, "Method")
