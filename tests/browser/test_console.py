"""The console on the page: numbers and geometry that follow a joint, sliders, errors, completion and example sheets."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect
from tests.browser.lab import Lab, press, tab, until

from helicoide import gate
from helicoide.console import sheet_results
from helicoide.geometry import rigid
from helicoide.geometry.multivector import Multivector
from helicoide.sheet import NameSlider, Sheet, SheetLine
from helicoide.text import number_text
from helicoide.view.share import encode_link

EXPRESSIONS = ("p = M_tool >> point(0, 0, 0.1)", "ell = join(elbow, tool)", "distance(tool, ceiling)")
NODE = "(path) => window.__viserMutable.nodeRefFromName[path]?.position.toArray() ?? null"
VISIBLE = "(path) => window.__viserMutable.nodeRefFromName[path]?.visible ?? false"


@pytest.fixture(scope="module")
def console(shared_page: Page) -> Page:
    tab(shared_page, "Algebra")
    shared_page.get_by_text("Console", exact=True).click()
    return shared_page


@pytest.fixture
def page(console: Page, lab: Lab) -> Page:
    """The console with an empty sheet."""
    lab.reset(console)
    visitor = next(iter(lab.session.visitors.values()))
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: replace(seat, sheet=Sheet()))
    until(console, lambda: lab.seats[0].sheet == Sheet())
    expect(lines(console)).to_have_count(0)
    return console


def lines(page: Page) -> Locator:
    return page.locator(".helicoide-line")


def enter(lab: Lab, page: Page, line: str) -> None:
    """Type a line and enter it, when the page has emptied the field after the last one."""
    field, count = page.get_by_label("expression"), len(lab.seats[0].sheet.lines)
    expect(field).to_have_value("")
    field.fill(line)
    until(page, lambda: lab.seats[0].sheet.entry.text == line)
    press(page, "Enter line")
    until(page, lambda: len(lab.seats[0].sheet.lines) == count + 1)


def drawn(page: Page, path: str) -> np.ndarray:
    return np.array(page.evaluate(NODE, path) or [np.nan] * 3)


def point_of(lab: Lab) -> np.ndarray:
    """Where the first line's point is at the present posture."""
    point = sheet_results(lab.seats[0].sheet, lab.state)[0].value
    assert isinstance(point, Multivector)
    return rigid.coordinates(point.values)


def distance_of(lab: Lab) -> float:
    distance = sheet_results(lab.seats[0].sheet, lab.state)[2].value
    assert isinstance(distance, float)
    return distance


def test_three_expressions_follow_a_joint_in_numbers_and_in_the_scene(lab: Lab, page: Page) -> None:
    for line in EXPRESSIONS:
        enter(lab, page, line)
    expect(lines(page)).to_have_count(3)
    before = lines(page).all_inner_texts()
    assert [text.rstrip().rpartition("\n")[2] for text in before] == ["point", "line", "number"]
    until(page, lambda: bool(page.evaluate(VISIBLE, "/console/0/point")))
    start = drawn(page, "/console/0/point")
    shoulder = float(lab.state.arm.q[1]) + 0.2
    lab.post(gate.set_joint(1, shoulder))
    until(page, lambda: abs(lab.state.arm.q[1] - shoulder) < 1e-3 and not lab.state.arm.moving)
    until(page, lambda: np.allclose(drawn(page, "/console/0/point"), point_of(lab), atol=1e-6))
    assert np.linalg.norm(drawn(page, "/console/0/point") - start) > 0.01
    until(page, lambda: number_text(distance_of(lab), ".5g").en in lines(page).nth(2).inner_text())
    after = lines(page).all_inner_texts()
    assert all(old != new for old, new in zip(before, after, strict=True))


def test_a_new_name_becomes_a_slider_that_moves_the_geometry(lab: Lab, page: Page) -> None:
    enter(lab, page, "exp(0.5*phi*L1) >> tool")
    slider = page.locator(".mantine-Slider-thumb:visible").last
    page.get_by_text("phi", exact=True).wait_for()
    start = drawn(page, "/console/0/point")
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    until(page, lambda: lab.seats[0].sheet.slider("phi").value > 1.2)
    until(page, lambda: bool(np.linalg.norm(drawn(page, "/console/0/point") - start) > 0.02))


def test_an_error_stands_under_its_line_and_a_name_is_completed(lab: Lab, page: Page) -> None:
    enter(lab, page, "jion(elbow, tool)")
    expect(lines(page).first).to_contain_text("there is no function jion; similar: join")
    expect(page.locator(".helicoide-wrong")).to_have_text("^^^^")
    page.get_by_label("expression").fill("1 + dis")
    expect(page.locator(".helicoide-names").first).to_contain_text("distance(A, B)")
    page.get_by_label("expression").fill("")


def test_an_example_sheet_is_opened_and_its_link_brings_it_back(lab: Lab, page: Page) -> None:
    page.get_by_text("Sheets", exact=True).click()
    page.get_by_label("example").click()
    page.get_by_role("option", name="Distance of a point from a plane").click()
    expect(lines(page)).to_have_count(6)
    expect(lines(page).nth(3)).to_contain_text("= 2")
    sheet, link = lab.seats[0].sheet, page.get_by_label("link to this sheet")
    expect(link).to_have_value(re.compile(rf"^http://127\.0\.0\.1:{lab.port}/.*#sheet=[\w-]+$"))
    shared = link.input_value()
    press(page, "Empty sheet")
    expect(lines(page)).to_have_count(0)
    link.fill(shared)
    press(page, "Open link")
    expect(lines(page)).to_have_count(6)
    assert lab.seats[0].sheet == sheet
    link.fill(shared[:-5])
    press(page, "Open link")
    page.get_by_text("The sheet in the link is damaged").wait_for()
    assert lab.seats[0].sheet == sheet


def test_an_address_of_a_sheet_opens_it_and_undo_brings_the_own_one_back(lab: Lab, page: Page) -> None:
    shared = Sheet((SheetLine("p = M_tool >> point(a, 0, 0.1)"),), (("a", NameSlider(0.1, 0.0, 1.0)),))
    enter(lab, page, "L2")
    own = lab.seats[0].sheet
    page.goto("about:blank")
    page.goto(f"http://127.0.0.1:{lab.port}/?fixedDpr=0.25#{encode_link(shared)}")
    page.get_by_text("Undo brings yours back").wait_for()
    expect(page.get_by_role("tab", name="Algebra")).to_have_attribute("aria-selected", "true")
    assert lab.seats[0].sheet == shared
    assert page.evaluate("location.hash") == ""
    press(page, "Undo: sheet changed")
    until(page, lambda: lab.seats[0].sheet == own)
    press(page, "Redo: sheet changed")
    until(page, lambda: lab.seats[0].sheet == shared)
    page.get_by_text("Console", exact=True).click()
    expect(lines(page)).to_have_count(1)
