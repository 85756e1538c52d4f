"""The enclosure on a page: measured by the camera, given, loaded, dragged; and a path that is taught and followed."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest
from playwright.sync_api import Browser, FilePayload, Locator, Page, TimeoutError, expect
from tests.browser.conftest import window
from tests.browser.lab import Lab, grab, pixels, status, tab, until
from tests.perception.views import between

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToJoints, Replay
from helicoide.confinement import pane_axes, planes_of
from helicoide.confinement.plane_file import encode_planes
from helicoide.readout import plane_distances
from helicoide.trajectory.waypoints import MOVE_TYPES

SHOWN = "(name) => Boolean(window.__viserMutable.nodeRefFromName[name]?.visible)"
RING = 0.65 * 0.2  # m, radius of the rings of this gizmo


@pytest.fixture(scope="module")
def page(shared_page: Page) -> Page:
    tab(shared_page, "Robot")
    shared_page.get_by_text("Planes", exact=True).click()
    shared_page.get_by_text("Define a plane", exact=True).click()
    shared_page.get_by_text("From a point cloud", exact=True).click()
    shared_page.get_by_text("Teach a path", exact=True).click()
    return shared_page


def test_the_measuring_tour_finds_the_enclosure_and_confines_the_arm(lab: Lab, page: Page) -> None:
    lab.watch()
    page.get_by_role("button", name="Measure with the camera").click()
    until(page, lambda: len(lab.state.clouds) == 3, 300)
    until(page, lambda: page.evaluate(SHOWN, "/cloud/+z"))
    until(page, lambda: "points on the plane" in page.locator("body").inner_text())
    true = lab.state.robot.panes
    planes = lab.state.problem.planes
    for pane in true:
        k = planes.names.index(pane.name)
        assert between(planes.normals[k], pane.normal) < np.radians(0.5), pane.name
        assert abs(planes.centres[k] @ pane.normal - pane.offset) < 0.002, pane.name
    until(page, lambda: lab.state.request.command == HoldPosition())
    lab.nearest = np.inf
    lab.post(gate.set_target([0.6, 0.0, 0.9], [1, 0, 0, 0]))
    until(page, lambda: "plane +z" in status(page))
    lab.ticks(page, 200)
    assert lab.nearest >= 0.080 - 1e-9


def send(page: Page, button: str, name: str, content: bytes) -> None:
    """Choose a file for a button."""
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name=button).click()
    chooser.value.set_files(FilePayload(name=name, mimeType="text/plain", buffer=content))


def test_planes_are_given_loaded_and_restored(lab: Lab, page: Page) -> None:
    page.get_by_role("button", name="Add", exact=True).first.click()
    until(page, lambda: "p1" in lab.state.problem.planes.names)
    until(page, lambda: page.evaluate(SHOWN, f"/planes/{len(lab.state.problem.planes.names) - 1}"))
    measured = planes_of(lab.state.robot.panes)
    send(page, "Load planes", "planes.toml", encode_planes(measured.names, measured).encode())
    until(page, lambda: "p1" not in lab.state.problem.planes.names and "+y" in lab.state.problem.planes.names)
    send(page, "Load planes", "junk.toml", b"\x00\xff")
    until(page, lambda: "junk.toml" in status(page))
    page.get_by_role("button", name="Reset planes").click()
    until(page, lambda: lab.state.problem.planes.names == measured.names)


def test_a_cloud_in_centimetres_is_asked_about_and_then_read(lab: Lab, page: Page) -> None:
    rng = np.random.default_rng(0)
    ceiling = np.column_stack([rng.uniform(20, 90, 400), rng.uniform(-30, 30, 400), rng.normal(70, 0.05, 400)])
    cloud = "\n".join(f"{x:.3f} {y:.3f} {z:.3f}" for x, y, z in ceiling).encode()
    send(page, "Fit to a cloud: ceiling", "room.xyz", cloud)
    until(page, lambda: "whether these are centimetres, inches, feet" in status(page))
    page.locator("input[role=combobox]:visible").and_(page.get_by_label("unit of the file")).click()
    page.get_by_role("option", name="centimetres").click()
    until(page, lambda: lab.seats[-1].cloud_unit == "cm")
    send(page, "Fit to a cloud: ceiling", "room.xyz", cloud)
    expect(page.get_by_text("In centimetres, as chosen: x 0.20 to 0.90")).to_be_visible()
    planes = lab.state.problem.planes
    assert abs(planes.offsets[planes.names.index("+z")] + 0.700) < 0.002
    lab.post(gate.restore_planes())


def test_any_name_of_a_plane_is_text_in_a_new_window(lab: Lab, page: Page, browser: Browser) -> None:
    measured = planes_of(lab.state.robot.panes)
    names = ["<img src=x onerror='window.ran = true'>", "north wall", *measured.names[2:]]
    lab.post(gate.take_planes_of(encode_planes(names, measured).encode(), "planes.toml"))
    with window(browser, lab.port) as other:
        tab(other, "Algebra")
        other.get_by_text("Planes", exact=True).click()
        for name in names:
            shown = other.get_by_text(f"plane {name} ", exact=False).and_(other.locator(":visible"))
            expect(shown.first).to_be_visible()
        assert not other.evaluate("Boolean(window.ran) || document.querySelectorAll('img[src=x]').length > 0")
    lab.post(gate.restore_planes())
    until(page, lambda: lab.state.problem.planes.names == measured.names)


def test_three_clicked_points_make_a_plane(lab: Lab, page: Page) -> None:
    """The points are on the left wall, so the new plane is that wall."""
    lab.reset(page)
    page.get_by_role("button", name="Pick three points").click()
    planes = lab.state.problem.planes
    wall = planes.names.index("+y")
    across, up, _ = pane_axes(planes.normals[wall]).T
    corners = [planes.centres[wall] + x * across + z * up for x, z in [(-0.12, -0.1), (0.12, -0.1), (0.0, 0.12)]]
    for said, corner in zip(("Point 2 of 3", "Point 3 of 3", "Pick three points"), corners, strict=True):
        click_until(page, corner, page.get_by_role("button", name=said))
    until(page, lambda: "p1" in lab.state.problem.planes.names)
    new = lab.state.problem.planes
    k = new.names.index("p1")
    assert between(new.normals[k], planes.normals[wall]) < np.radians(0.2)
    assert abs((new.centres[k] - planes.centres[wall]) @ planes.normals[wall]) < 1e-3


def click_until(page: Page, point: Array, button: Locator) -> None:
    """Click at a point of the scene until a button shows that it was received: a slow page may miss a click."""
    for _ in range(20):
        page.mouse.click(*pixels(page, point))
        with contextlib.suppress(TimeoutError):
            button.wait_for(timeout=6000)
            return
    raise AssertionError("no click was noticed")


def test_a_plane_is_turned_by_its_ring(lab: Lab, page: Page) -> None:
    lab.reset(page)
    page.get_by_text("Show", exact=True).click()
    page.get_by_label("Plane rotation rings").check()
    wall = lab.state.problem.planes.names.index("+y")
    until(page, lambda: page.evaluate(SHOWN, f"/turns/plane {wall}"))
    before, centre = lab.state.problem.planes.normals[wall], lab.state.problem.planes.centres[wall]
    R = pane_axes(before)
    angles = np.radians([45.0, 65.0])
    start, end = (centre + RING * (np.cos(angle) * R[:, 1] + np.sin(angle) * R[:, 2]) for angle in angles)
    grab(lab, page, start, end)
    until(page, lambda: between(lab.state.problem.planes.normals[wall], before) > np.radians(10))
    page.mouse.up()
    until(page, lambda: lab.state.request.drag is None)
    turned = lab.state.problem.planes
    assert abs(turned.normals[wall] @ R[:, 0]) < 0.05, "about the ring's axis"
    assert plane_distances(lab.state).min() >= 0.080 - 1e-9
    page.get_by_label("Plane rotation rings").uncheck()
    until(page, lambda: not page.evaluate(SHOWN, f"/turns/plane {wall}"))
    lab.reset(page)


def test_a_taught_path_is_gone_through(lab: Lab, page: Page) -> None:
    lab.post(gate.get_ready())
    until(page, lambda: lab.state.request.command == HoldPosition())
    page.get_by_role("button", name="Add waypoint").click()
    until(page, lambda: len(lab.state.taught.waypoints) == 1)
    lab.post(gate.set_joint(0, 0.3))
    until(page, lambda: abs(lab.state.arm.q[0] - 0.3) < 1e-4)
    page.get_by_label("move type").first.click()
    page.get_by_role("option", name=MOVE_TYPES["line"].en, exact=True).click()
    page.get_by_role("button", name="Add waypoint").click()
    until(page, lambda: len(lab.state.taught.waypoints) == 2)
    page.get_by_role("button", name="Run waypoints").click()
    until(page, lambda: isinstance(lab.state.request.command, Replay))
    until(page, lambda: isinstance(lab.state.request.command, MoveToJoints))
    until(page, lambda: bool(np.abs(lab.state.arm.q - lab.state.taught.waypoints[-1].q).max() < 1e-4))
