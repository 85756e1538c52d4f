"""Two windows: a stop in one ends the drag in the other, and each may have its own arm."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from contextlib import ExitStack

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, Session, box, press, status, tab, until
from tests.browser.proxy import PREFIX, behind

from helicoide import gate
from helicoide.command import HoldPosition, MoveToJoints
from helicoide.kinematics.library import load_robot
from helicoide.session.workcell import Workcell

THUMB = ".mantine-Slider-thumb"


@pytest.fixture(scope="module")
def pair(browser: Browser, lab: Lab) -> Iterator[tuple[Page, Page]]:
    with window(browser, lab.port) as one, window(browser, lab.port, locale="pt-BR") as other:
        until(one, lambda: lab.session.ready, 300)
        for page, name in ((one, "Robot"), (other, "Robô")):
            tab(page, name)
            page.locator(THUMB).first.wait_for()
        yield one, other


def hold_the_waist(page: Page, lab: Lab) -> tuple[float, float]:
    """Press on the first joint's slider and drag it, without a release; returns the pointer's position, px."""
    spot = page.locator(THUMB).first.bounding_box()
    assert spot is not None
    x, y = spot["x"] + spot["width"] / 2, spot["y"] + spot["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 30, y, steps=5)
    until(page, lambda: isinstance(lab.state.request.command, MoveToJoints))
    return x + 30, y


def test_a_slider_that_is_held_is_dead_after_anothers_stop_until_it_is_let_go(
    lab: Lab, pair: tuple[Page, Page]
) -> None:
    one, other = pair
    x, y = hold_the_waist(one, lab)
    other.keyboard.press("Escape")
    until(one, lambda: lab.state.request.command == HoldPosition(stopped=True))
    until(one, lambda: "Stopped" in status(one))
    q = lab.state.arm.q
    for step in range(20):
        one.mouse.move(x + 3 * step, y)
        one.wait_for_timeout(30)
    assert lab.state.request.command == HoldPosition(stopped=True)
    one.mouse.up()
    lab.ticks(one, 50)
    assert lab.state.request.command == HoldPosition(stopped=True)
    assert (lab.state.arm.q == q).all()
    shown = "() => document.querySelector('input.mantine-NumberInput-input').value"
    until(one, lambda: abs(float(one.evaluate(shown)) - np.degrees(q[0])) < 0.11)
    hold_the_waist(one, lab)
    one.mouse.up()


def test_the_page_speaks_what_its_browser_asks_for(pair: tuple[Page, Page]) -> None:
    one, other = pair
    assert one.get_by_role("tab", name="Algebra").count() == 1
    assert other.get_by_role("tab", name="Álgebra").count() == 1


def own(lab: Lab) -> Workcell:
    (found,) = (cell for cell in lab.session.bays.workcells if cell is not lab.cell)
    return found


def test_each_drags_plays_and_changes_the_arm_without_the_other_seeing_it(lab: Lab, pair: tuple[Page, Page]) -> None:
    one, other = pair
    lab.reset(one)
    press(other, "Usar meu próprio braço")
    until(other, lambda: len(lab.session.bays.workcells) == 2)
    other.get_by_role("button", name="Voltar ao braço comum").wait_for()
    mine = own(lab)
    until(other, lambda: len(lab.windows) == 1)
    shared = lab.state
    box(other, 0, "20")
    until(other, lambda: abs(np.degrees(mine.state.arm.q[0]) - 20) < 0.1)
    assert (lab.state.arm.q == shared.arm.q).all()
    box(one, 0, "-15")
    until(one, lambda: abs(np.degrees(lab.state.arm.q[0]) + 15) < 0.1)
    assert abs(np.degrees(mine.state.arm.q[0]) - 20) < 0.1
    waist = "() => window.__viserMutable.nodeRefFromName['/arm/waist'].quaternion.toArray()"
    until(one, lambda: bool(abs(np.array(one.evaluate(waist)) - np.array(other.evaluate(waist))).max() > 0.2))
    press(other, "Reproduzir")
    until(other, lambda: bool(mine.state.request.path_s > 0.5))
    assert lab.state.request.path_s == 0.0
    one.keyboard.press("Escape")
    until(one, lambda: lab.state.request.command == HoldPosition(stopped=True))
    assert mine.state.request.command != HoldPosition(stopped=True)
    other.keyboard.press("Escape")
    until(other, lambda: mine.state.request.command == HoldPosition(stopped=True))
    lab.session.loop.call_soon_threadsafe(lab.session.bays.all[mine].arms.change, "planar2r")
    until(other, lambda: mine.state.robot.name == "planar2r")
    until(other, lambda: "/arm/waist" not in nodes(other) and any(name.startswith("/arm/") for name in nodes(other)))
    assert lab.state.robot.name == "movemaster"
    assert "/arm/waist" in nodes(one)


def nodes(page: Page) -> list[str]:
    """The names of the nodes in the scene of a page."""
    found = "() => Object.entries(window.__viserMutable.nodeRefFromName).filter(([_, node]) => node).map(([n]) => n)"
    return list(page.evaluate(found))


def test_an_arm_of_ones_own_outlives_a_reload_and_waits_for_its_owner(lab: Lab, pair: tuple[Page, Page]) -> None:
    _, other = pair
    mine = own(lab)
    other.reload()
    other.get_by_role("button", name="Voltar ao braço comum").wait_for()
    until(other, lambda: any(visitor.bay.workcell is mine for visitor in lab.session.visitors.values()))
    until(other, lambda: any(name.startswith("/arm/") for name in nodes(other)))
    assert "/arm/waist" not in nodes(other)
    press(other, "Voltar ao braço comum")
    until(other, lambda: len(lab.windows) == 2)
    until(other, lambda: "/arm/waist" in nodes(other))
    press(other, "Usar meu próprio braço")
    until(other, lambda: len(lab.windows) == 1)
    assert own(lab) is mine
    assert mine.state.robot.name == "planar2r"
    lab.post(gate.get_ready())


def test_behind_a_sub_path_the_page_drives_and_stops(browser: Browser) -> None:
    """All addresses are relative to the page; without the control channel of Stop, the page could not drive."""
    session = Session(load_robot("movemaster"), None, None)
    with ExitStack() as stack:
        listener = stack.enter_context(socket.create_server(("127.0.0.1", 0)))
        port = listener.getsockname()[1]
        listener.close()
        proxy = stack.enter_context(behind(port))
        session.open("127.0.0.1", port, (f"http://127.0.0.1:{proxy}",))
        stack.callback(session.close)
        page = stack.enter_context(window(browser, proxy, path=PREFIX.decode()))
        lab = Lab(session)
        until(page, lambda: session.ready, 300)
        tab(page, "Robot")
        box(page, 0, "12")
        until(page, lambda: abs(np.degrees(lab.state.arm.q[0]) - 12) < 0.1)
        page.locator("#helicoide-stop").click()
        until(page, lambda: lab.state.request.command == HoldPosition(stopped=True))
