"""The map of the workspace on a page: chosen, computed, drawn, cut, ended, removed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, press, tab, until
from tests.browser.test_arms import canvas
from tests.browser.test_methods import choose

from helicoide.kinematics.workspace import CHUNK, MAP_KINDS
from helicoide.session import mapping
from helicoide.view.workspace_rows import measure_title

SHOWN = "() => Boolean(window.__viserMutable.nodeRefFromName['/workspace']?.visible)"


@pytest.fixture(autouse=True)
def counting(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Maps with few postures, cached in a folder of the test."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    of_size(monkeypatch, 4 * CHUNK)


def of_size(monkeypatch: pytest.MonkeyPatch, samples: int) -> None:
    monkeypatch.setattr(mapping, "SAMPLES", {kind: {2: samples, 3: samples} for kind in MAP_KINDS})


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    tab(shared_page, "Robot")
    if not shared_page.get_by_role("button", name="Compute map", exact=True).is_visible():
        shared_page.get_by_role("button", name="Workspace", exact=True).click()
    return shared_page


def different(one: np.ndarray, other: np.ndarray) -> int:
    return int((abs(one - other) > 12).sum())


def test_the_map_is_worked_out_seen_cut_hidden_and_taken_away(lab: Lab, page: Page) -> None:
    choose(page, "Map", "Manipulability")
    until(page, lambda: {seat.map_kind for seat in lab.seats} == {"manipulability"})
    page.wait_for_timeout(1000)
    without = canvas(page)
    press(page, "Compute map")
    until(page, lambda: lab.state.workspace.map is not None and page.evaluate(SHOWN))
    found = lab.state.workspace.map
    assert found is not None
    until(page, lambda: measure_title(found).en in page.locator(".helicoide-note:visible").last.inner_text())
    page.locator(".helicoide-scale").wait_for()
    page.wait_for_timeout(1000)
    half = canvas(page)
    assert different(half, without) > 20_000
    cut = page.locator("input.mantine-NumberInput-input:visible").last
    cut.fill("60")
    cut.press("Enter")
    until(page, lambda: {seat.cut for seat in lab.seats} == {0.6})
    page.wait_for_timeout(1000)
    less = canvas(page)
    assert 1000 < different(less, without) < 0.8 * different(half, without)
    page.get_by_text("Show", exact=True).click()
    page.get_by_label("Workspace map").click()
    until(page, lambda: not page.evaluate(SHOWN))
    page.get_by_label("Workspace map").click()
    until(page, lambda: bool(page.evaluate(SHOWN)))
    press(page, "Remove map")
    until(page, lambda: lab.state.workspace.map is None)
    until(page, lambda: not page.evaluate(SHOWN))
    page.locator(".helicoide-scale").wait_for(state="detached")
    page.get_by_text("Show", exact=True).click()


def test_the_same_button_ends_the_calculation(lab: Lab, page: Page, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, 10**6 * CHUNK)
    press(page, "Compute map")
    until(page, lambda: lab.state.workspace.progress is not None and lab.state.workspace.progress.share > 0)
    page.wait_for_timeout(500)
    bar = page.locator(".mantine-Progress-root:visible")
    bar.wait_for()
    press(page, "End calculation")
    until(page, lambda: lab.state.workspace.progress is None)
    bar.wait_for(state="detached")
    page.get_by_role("button", name="Compute map", exact=True).wait_for()
    assert lab.state.workspace.map is None


def test_another_arm_has_no_map_yet(lab: Lab, page: Page) -> None:
    press(page, "Compute map")
    until(page, lambda: bool(page.evaluate(SHOWN)))
    lab.change("planar2r")
    until(page, lambda: lab.state.robot.name == "planar2r" and not page.evaluate(SHOWN))
    assert lab.state.workspace.map is None
    lab.change("movemaster")
    until(page, lambda: lab.state.robot.name == "movemaster")
    page.wait_for_timeout(1000)


def test_a_map_is_worked_out_by_finger(browser: Browser, lab: Lab) -> None:
    with window(browser, lab.port, "phone") as page:
        until(page, lambda: lab.session.ready, 300)
        page.get_by_role("tab", name="Robot").tap()
        page.get_by_role("button", name="Workspace", exact=True).tap()
        page.get_by_role("button", name="Compute map", exact=True).tap()
        until(page, lambda: bool(page.evaluate(SHOWN)))
        page.locator(".helicoide-scale").wait_for()
        page.wait_for_timeout(500)  # its note moves the button
        page.get_by_role("button", name="Remove map", exact=True).tap()
        until(page, lambda: not page.evaluate(SHOWN))
