"""The lab in Firefox and in WebKit: the page comes up, the arm is drawn, it moves and it stops."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from tests.browser.lab import PROJECT, Lab, opened
from tests.soak.engines import until
from tests.soak.windows import ESCAPE, Window, window

from helicoide.command import HoldPosition

pytestmark = pytest.mark.soak

FIREFOX = pytest.param("firefox", marks=pytest.mark.firefox)
WEBKIT = pytest.param("webkit", marks=pytest.mark.webkit)
WAIST_BOX, WAIST_THUMB = "input.mantine-NumberInput-input", ".mantine-Slider-thumb"
NEAR = 40  # pixels around a joint of the arm
TICKS_S = 0.5


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    lab = opened()
    yield lab
    lab.session.close()


@pytest.fixture(scope="module", params=[FIREFOX, WEBKIT])
def page(request: pytest.FixtureRequest, lab: Lab) -> Iterator[Window]:
    """A window in which the arm runs, its Robot tab in front."""
    with window(request.param, lab.port) as page:
        until(lambda: lab.session.ready, "the kernels are ready")
        page.tab("Robot")
        yield page


def waist(lab: Lab) -> float:
    """The angle of the first joint, degrees."""
    return float(np.degrees(lab.state.arm.q[0]))


def test_the_page_is_up(page: Window) -> None:
    until(lambda: page.text("#helicoide-status"), "the status line speaks")
    assert page.text("#helicoide-stop-label") == "Stop motion"


def test_the_arm_is_drawn(lab: Lab, page: Window) -> None:
    x, y = page.evaluate(PROJECT, [float(value) for value in lab.state.arm.poses[2, :3, 3]])
    around = (int(x) - NEAR, int(y) - NEAR, int(x) + NEAR, int(y) + NEAR)
    until(lambda: len(page.picture().crop(around).getcolors(maxcolors=10**5) or ()) > 400, "the elbow is painted")


def test_a_joint_moves_by_its_slider(lab: Lab, page: Window) -> None:
    page.connected()
    before = waist(lab)
    page.drag(page.middle(WAIST_THUMB), right=12)
    until(lambda: waist(lab) > before + 5 and not lab.state.arm.moving, "the waist turns")


def test_a_joint_moves_by_its_number_box(lab: Lab, page: Window) -> None:
    page.connected()
    page.fill(WAIST_BOX, "-7.5")
    until(lambda: abs(waist(lab) + 7.5) < 0.01, "the waist turns to -7.5°")


@pytest.mark.parametrize("way", ["button", "key"])
def test_stop_stops_the_moving_arm(lab: Lab, page: Window, way: str) -> None:
    page.connected()
    page.press("button", "Play")
    until(lambda: lab.state.arm.moving, "the arm moves")
    if way == "button":
        page.press("#helicoide-stop")
    else:
        page.keys(ESCAPE)
    until(lambda: lab.state.request.command == HoldPosition(stopped=True), "the arm is stopped")
    q, t = lab.state.arm.q, lab.state.t
    until(lambda: lab.state.t > t + TICKS_S, "the arm lives on")
    assert (lab.state.arm.q == q).all()
    until(lambda: "Stopped" in page.text("#helicoide-status"), "the page says so")


@pytest.mark.firefox
def test_the_page_comes_up_in_portuguese(lab: Lab) -> None:
    with window("firefox", lab.port, "pt_BR") as page:
        assert page.evaluate("() => navigator.language") == "pt-BR"
        page.press("input.mantine-Select-input")
        page.press("[role=option]", "Português (Brasil)")
        until(lambda: page.text("#helicoide-stop-label") == "Parar o movimento", "Stop speaks Portuguese")
        page.middle("[role=tab]", "Robô")
