"""The controls of the panels work on the page, in both languages, on a desktop screen and on a phone."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.lab import Lab, box, press, status, tab, until

from helicoide.command import FollowPath, HoldPosition, MoveToJoints, MoveToPose
from helicoide.text import Language


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    tab(shared_page, "Robot")
    return shared_page


def degrees(lab: Lab, joint: int) -> float:
    return float(np.degrees(lab.state.arm.q[joint]))


def test_a_joint_moves_by_its_slider_with_mouse_and_keyboard(lab: Lab, page: Page) -> None:
    thumb = page.locator(".mantine-Slider-thumb").first
    spot = thumb.bounding_box()
    assert spot is not None
    x, y = spot["x"] + spot["width"] / 2, spot["y"] + spot["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 12, y, steps=6)
    page.mouse.up()
    until(page, lambda: degrees(lab, 0) > 5 and not lab.state.arm.moving)
    before = degrees(lab, 0)
    thumb.focus()
    page.keyboard.press("ArrowLeft")
    until(page, lambda: degrees(lab, 0) < before - 0.05)


def test_a_joint_moves_by_its_number_box_and_stays_within_its_limits(lab: Lab, page: Page) -> None:
    box(page, 2, "-90.5")
    until(page, lambda: abs(degrees(lab, 2) + 90.5) < 0.01)
    box(page, 0, "500")
    lab.ticks(page, 200)
    assert degrees(lab, 0) <= 90 + 1e-9


def test_park_and_ready(lab: Lab, page: Page) -> None:
    press(page, "Park (planes off)")
    until(page, lambda: lab.state.arm.parked and lab.state.request.command == HoldPosition())
    assert np.array_equal(lab.state.arm.q, lab.state.robot.poses["home"])
    until(page, lambda: "Parked" in status(page))
    press(page, "Ready pose")
    until(page, lambda: not lab.state.arm.parked and lab.state.request.command == HoldPosition())
    assert np.allclose(lab.state.arm.q, lab.state.robot.poses["ready"], atol=2e-3)


def test_a_named_pose(lab: Lab, page: Page) -> None:
    page.get_by_label("Go to pose").click()
    title = lab.state.robot.pose_titles["reading_left"].en
    page.get_by_role("option", name=title).click()
    until(page, lambda: np.allclose(lab.state.arm.q, lab.state.robot.poses["reading_left"], atol=1e-3))


def test_the_gripper_opens(lab: Lab, page: Page) -> None:
    box(page, 5, "100")
    until(page, lambda: lab.state.arm.gripper == 1.0)
    left = "() => window.__viserMutable.nodeRefFromName['/arm/finger_left'].position.toArray()"
    right = left.replace("left", "right")
    until(page, lambda: math.dist(page.evaluate(left), page.evaluate(right)) > 0.055)


def test_the_target_by_numbers_with_and_without_orientation(lab: Lab, page: Page) -> None:
    box(page, 7, "120")
    until(page, lambda: abs(lab.state.T_world_tool[1, 3] - 0.12) < 1e-3)
    until(page, lambda: "orientation" in status(page))
    page.get_by_label("Keep orientation").click()
    until(page, lambda: not lab.state.request.with_orientation)
    until(page, lambda: "Goal reached" in status(page))
    page.get_by_label("Keep orientation").click()
    until(page, lambda: lab.state.request.with_orientation)


def test_the_path_plays_pauses_and_scrubs(lab: Lab, page: Page) -> None:
    press(page, "Play")
    until(page, lambda: isinstance(lab.state.request.command, FollowPath) and lab.state.request.command.s > 0.5)
    press(page, "Pause")
    until(page, lambda: isinstance(lab.state.request.command, FollowPath) and not lab.state.request.command.playing)
    stood = lab.state.request.path_s
    lab.ticks(page, 50)
    assert lab.state.request.path_s == stood
    box(page, 17, "50")
    until(page, lambda: lab.state.request.path_s == 10.0)
    assert isinstance(lab.state.request.command, FollowPath)
    assert not lab.state.request.command.playing


@pytest.mark.parametrize("way", ["button", "key", "key in a box"])
def test_stop_stops_the_moving_arm(lab: Lab, page: Page, way: str) -> None:
    press(page, "Play")
    until(page, lambda: lab.state.arm.moving)
    if way == "button":
        page.locator("#helicoide-stop").click()
    elif way == "key in a box":
        page.locator("input.mantine-NumberInput-input").first.focus()
    if way != "button":
        page.keyboard.press("Escape")
    until(page, lambda: lab.state.request.command == HoldPosition(stopped=True))
    q = lab.state.arm.q
    lab.ticks(page, 50)
    assert (lab.state.arm.q == q).all()
    until(page, lambda: "Stopped" in status(page))
    press(page, "Ready pose")
    until(page, lambda: lab.state.request.command != HoldPosition(stopped=True))


def test_the_multivectors_live_and_light_up(lab: Lab, page: Page) -> None:
    tab(page, "Algebra")
    page.locator("math").first.wait_for()
    motor = page.locator(".helicoide-reading").filter(has_text="end-effector motor").locator(".helicoide-grid")
    before = motor.inner_text()
    page.get_by_label("Highlight", exact=True).click()
    page.get_by_role("option", name="axis of joint 3 (elbow)").click()
    shown = "() => window.__viserMutable.nodeRefFromName['/lit/lines'].visible"
    until(page, lambda: bool(page.evaluate(shown)))
    until(page, lambda: page.locator(".helicoide-lit .helicoide-grid i").count() == 16)
    tab(page, "Robot")
    box(page, 1, "35")
    until(page, lambda: abs(degrees(lab, 1) - 35) < 0.01)
    tab(page, "Algebra")
    until(page, lambda: motor.inner_text() != before)
    page.get_by_label("Highlight", exact=True).click()
    page.get_by_role("option", name="none").click()
    until(page, lambda: not page.evaluate(shown))


def test_the_language_switches_every_word_of_ours(lab: Lab, page: Page) -> None:
    def words() -> str:
        said = [page.locator("body").inner_text()]
        for name in page.get_by_role("tab").all_inner_texts():
            tab(page, name)
            said.append(page.locator("body").inner_text())
        return "\n".join(said)

    page.get_by_label("Language · Idioma").click()
    page.get_by_role("option", name="Português (Brasil)").click()
    page.get_by_role("tab", name="Robô").wait_for()
    until(page, lambda: "Pronto" in status(page))
    portuguese = words()
    assert page.locator("html").get_attribute("lang") == "pt-BR"
    for english in (
        "Ready pose",
        "Park (planes off)",
        "Joints",
        "Gripper",
        "Target",
        "Play",
        "Stop motion",
        "Highlight",
        "Lesson",
    ):
        assert english not in portuguese, english
    for word in (
        "Juntas",
        "Garra",
        "Alvo",
        "Parar o movimento",
        "Destacar",
        "Estacionar (sem planos)",
        "Eixos helicoidais das juntas",
    ):
        assert word in portuguese, word
    page.get_by_label("Idioma · Language").click()
    page.get_by_role("option", name="English").click()
    page.get_by_role("tab", name="Robot").wait_for()
    until(page, lambda: "Ready" in status(page))


def test_the_lesson_by_the_page_alone_and_after_a_reload(lab: Lab, page: Page) -> None:
    tab(page, "Lesson")
    page.get_by_role("combobox").nth(1).click()
    page.get_by_role("option", name="Drive the arm").click()
    press(page, "Hint")
    page.locator(".helicoide-lesson blockquote").wait_for()
    until(page, lambda: "Step not completed" in page.locator(".helicoide-verdict").inner_text())
    elbow = page.locator("input.mantine-NumberInput-input:visible")  # the slider of the step
    elbow.fill("-100")
    elbow.press("Enter")
    until(page, lambda: not lab.state.arm.moving and abs(degrees(lab, 2) + 100) < 1)
    tab(page, "Robot")
    expect(page.locator(".helicoide-lesson h3")).to_be_visible()
    tab(page, "Lesson")
    until(page, lambda: "Done" in page.locator(".helicoide-verdict").inner_text())
    press(page, "Reset step")
    until(page, lambda: np.allclose(lab.state.arm.q, lab.state.robot.poses["ready"], atol=2e-3))
    press(page, "Next step")
    until(page, lambda: page.locator(".helicoide-lesson h3").inner_text().startswith("2."))
    page.reload()
    page.locator(".helicoide-lesson h3").wait_for()
    assert page.locator(".helicoide-lesson h3").inner_text().startswith("2.")
    assert page.locator(".helicoide-dots .done").count() == 1
    page.get_by_role("combobox").nth(1).click()
    page.get_by_role("option", name="Explore freely").click()


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_the_phone_shows_stop_and_scrolls_nothing_sideways(lab: Lab, browser: Browser, language: Language) -> None:
    lab.session.language = language
    with window(browser, lab.port, "phone") as page:
        until(page, lambda: lab.session.ready, 300)
        page.get_by_role("tab", name={"en": "Robot", "pt_BR": "Robô"}[language]).wait_for()
        for name in page.get_by_role("tab").all_inner_texts():
            page.get_by_role("tab", name=name).tap()
            page.wait_for_timeout(400)
            spot = page.locator("#helicoide-stop").bounding_box()
            assert spot is not None
            assert 0 <= spot["y"] <= spot["y"] + spot["height"] <= 844
            assert page.evaluate("document.scrollingElement.scrollWidth <= innerWidth")
            assert page.evaluate(SIDEWAYS) == []
        lab.post(lambda state: state)
        page.locator("#helicoide-stop").tap()
        until(page, lambda: lab.state.request.command == HoldPosition(stopped=True))


SIDEWAYS = """() => [...document.querySelectorAll('[class^=helicoide], [class*=" helicoide"]')]
  .filter(e => !e.matches('.helicoide-formula') && e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0)
  .map(e => e.className)"""


def test_the_page_is_up_before_the_kernels_are_compiled(browser: Browser, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "helicoide", "--port", "0", "--lang", "pt_BR", "--store", "none"]
    app = str(Path(__file__).parents[2] / "app")
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": app}
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) as lab:
        assert lab.stdout is not None
        port = int(lab.stdout.readline().rsplit(":", 1)[1])
        try:
            with window(browser, port, locale="pt-BR") as page:
                until(page, lambda: "Compilando kernels" in status(page))
                until(page, lambda: bool(page.evaluate("'/arm/waist' in window.__viserMutable.nodeRefFromName")))
                until(page, lambda: "Compilando" not in status(page), 600)
                assert status(page).startswith("Pronto")
            assert any(tmp_path.rglob("*.guarded.guarded_tick-*")), "it will not be compiled a second time"
        finally:
            lab.send_signal(signal.SIGTERM)
            assert lab.wait(60) == 0


def test_a_target_out_of_reach_says_by_how_much(lab: Lab, page: Page) -> None:
    box(page, 6, "1200")
    until(page, lambda: isinstance(lab.state.request.command, MoveToPose))
    until(page, lambda: "Out of reach by" in status(page))


def test_the_postures_of_the_target_are_listed_and_one_of_them_is_gone_to(lab: Lab, page: Page) -> None:
    """The Movemaster has two postures at `ready`. The second is outside its limits, which the status line says."""
    page.get_by_text("Postures for the target", exact=True).click()
    press(page, "List postures")
    rows = page.locator(".helicoide-postures li")
    rows.nth(1).wait_for()
    until(page, lambda: "current posture" in rows.nth(0).inner_text())
    assert "outside the joint limits" in rows.nth(1).inner_text()
    for place in (1, 0):
        name = rows.nth(place).locator("b").inner_text()
        page.get_by_label("Go to posture").click()
        page.get_by_role("option", name=name).click()
        until(page, lambda said=place == 1: ("outside the joint limits" in status(page)) == said)  # type: ignore[misc]
    assert isinstance(lab.state.request.command, MoveToJoints)
    page.get_by_text("Postures for the target", exact=True).click()
