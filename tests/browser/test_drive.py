"""Drags of the target and of planes in a browser: the arm follows, and keeps its distance from planes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, grab, pixels, status, until

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToPose

CRITICAL = 0.080
ARROW = 0.22  # m, from the centre of the target gizmo to a point on its arrow


@pytest.fixture
def page(browser: Browser, lab: Lab) -> Iterator[Page]:
    with window(browser, lab.port) as page:
        until(page, lambda: lab.session.ready, 300)
        lab.watch()
        lab.reset(page)
        page.wait_for_timeout(500)
        yield page


def target_position(lab: Lab) -> Array:
    """The position of the target, (3,), m; NaN without a target."""
    return (
        lab.state.request.command.T_world_target[:3, 3]
        if isinstance(lab.state.request.command, MoveToPose)
        else np.full(3, np.nan)
    )


@pytest.mark.parametrize(("axis", "distance"), [(2, 0.15), (0, -0.15)])
def test_a_drag_of_150_mm_brings_the_tool_there(lab: Lab, page: Page, axis: int, distance: float) -> None:
    T = lab.state.T_world_tool
    start, along = T[:3, 3], T[:3, axis]
    grab(lab, page, start + ARROW * along, start + (ARROW + distance) * along)
    until(page, lambda: abs(target_position(lab) - start - distance * along).max() < 0.015)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    lab.ticks(page, 100)
    assert abs(target_position(lab) - start - distance * along).max() < 0.015
    assert np.linalg.norm(lab.state.T_world_tool[:3, 3] - target_position(lab)) < 1e-3
    assert lab.nearest >= CRITICAL - 1e-9


def test_beyond_the_ceiling_every_point_keeps_its_distance_and_the_page_says_why(lab: Lab, page: Page) -> None:
    lab.post(gate.set_target([0.6, 0.0, 0.3], [1.0, 0.0, 0.0, 0.0]))
    until(page, lambda: abs(lab.state.T_world_tool[2, 3] - 0.3) < 1e-4)
    page.wait_for_timeout(500)
    start, up = lab.state.T_world_tool[:3, 3], np.array([0.0, 0.0, 1.0])
    grab(lab, page, start + ARROW * up, start + (ARROW + 0.533) * up, steps=40)
    until(page, lambda: bool(target_position(lab)[2] > 0.8))
    lab.ticks(page, 150)
    until(page, lambda: "Blocked by plane +z (ceiling)" in status(page))
    assert "at 80 mm" in status(page)
    assert any(point.title.en in status(page) for point in lab.state.robot.monitored)
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    lab.ticks(page, 100)
    assert lab.nearest >= CRITICAL - 1e-9


def test_a_pane_dragged_onto_the_arm_stops_80_mm_from_it(lab: Lab, page: Page) -> None:
    q = lab.state.arm.q
    centre, normal = lab.state.problem.planes.centres[0], lab.state.problem.planes.normals[0]
    grab(lab, page, centre + 0.15 * normal, centre + 0.45 * normal)
    until(page, lambda: "stops at 80 mm" in status(page))
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    lab.ticks(page, 20)
    distance = (lab.state.monitored_points - lab.state.problem.planes.centres[0]) @ normal
    assert distance.min() == pytest.approx(CRITICAL, abs=1e-9)
    assert np.linalg.norm(lab.state.problem.planes.centres[0] - centre) > 0.03
    assert (lab.state.arm.q == q).all()


def test_a_drag_that_goes_on_after_stop_moves_nothing(lab: Lab, page: Page) -> None:
    T = lab.state.T_world_tool
    start, along = T[:3, 3], T[:3, 2]
    grab(lab, page, start + ARROW * along, start + (ARROW + 0.1) * along)
    until(page, lambda: lab.state.arm.moving)
    page.keyboard.press("Escape")
    until(page, lambda: lab.state.request.command == HoldPosition(stopped=True))
    q = lab.state.arm.q
    page.mouse.move(*pixels(page, start + (ARROW + 0.2) * along), steps=10)
    page.mouse.up()
    lab.ticks(page, 50)
    assert (lab.state.arm.q == q).all()
    assert "Stopped" in status(page)


def test_two_windows_see_the_same_arm_and_a_closed_one_lets_go(lab: Lab, page: Page, browser: Browser) -> None:
    with window(browser, lab.port) as other:
        other.wait_for_timeout(500)
        T = lab.state.T_world_tool
        grab(lab, other, T[:3, 3] + ARROW * T[:3, 2], T[:3, 3] + (ARROW + 0.05) * T[:3, 2])
        until(other, lambda: lab.state.request.drag is not None)
    until(page, lambda: lab.state.request.drag is None and len(lab.windows) == 1)
    until(page, lambda: not lab.state.arm.moving)
    wrist = "() => window.__viserMutable.nodeRefFromName['/arm/wrist'].position.toArray()"
    shown = lab.state.arm.poses[4, :3, 3]
    until(page, lambda: bool(np.allclose(page.evaluate(wrist), shown, atol=1e-4)))


def test_the_gizmo_moves_by_touch(lab: Lab, browser: Browser) -> None:
    with window(browser, lab.port, "phone") as page:
        until(page, lambda: lab.session.ready, 300)
        lab.reset(page)
        page.locator("text=Helicoide").first.tap()  # fold the panel
        page.wait_for_timeout(1000)
        T = lab.state.T_world_tool
        start, along = T[:3, 3], T[:3, 2]
        touch = page.context.new_cdp_session(page)

        def send(kind: str, share: float | None) -> None:
            x, y = pixels(page, start + (ARROW + (share or 0) * 0.12) * along)
            points = [] if share is None else [{"x": x, "y": y}]
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        for _ in range(20):  # a page that draws slowly may not know yet what is under the finger
            send("touchStart", 0.0)
            page.wait_for_timeout(200)
            for share in np.linspace(0.1, 1.0, 10):
                send("touchMove", float(share))
                page.wait_for_timeout(30)
            taken = lab.state.request.drag is not None
            send("touchEnd", None)
            if taken:
                break
            page.wait_for_timeout(1000)
        until(page, lambda: isinstance(lab.state.request.command, MoveToPose) and lab.state.request.drag is None)
        lab.ticks(page, 100)
        assert (lab.state.T_world_tool[:3, 3] - start) @ along > 0.06
