"""A running lab for tests that drive it through a page and read its state."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from time import monotonic

import numpy as np
from playwright.sync_api import Page

from helicoide.arrays import Array
from helicoide.command import HoldPosition
from helicoide.confinement import signed_distances
from helicoide.kinematics.library import load_robot
from helicoide.seat import Seat
from helicoide.session.display import Display
from helicoide.session.lab import Lab as Session
from helicoide.session.workcell import TICK, Workcell
from helicoide.state import State, Update, initial_state
from helicoide.text import Language
from helicoide.view import panels, shapes
from helicoide.view.window import Window

PROJECT = """(p) => {
  const m = window.__viserMutable, v = m.camera.position.clone();
  v.set(p[0], p[1], p[2]); m.nodeRefFromName[''].localToWorld(v); v.project(m.camera);
  const r = m.canvas.getBoundingClientRect();
  return [r.left + (v.x + 1) / 2 * r.width, r.top + (1 - v.y) / 2 * r.height];
}"""


def clearance(state: State) -> float:
    """The smallest distance of a guarded point to a plane, m."""
    normals, offsets, _ = state.problem.plane_arrays
    return float(signed_distances(normals, offsets, state.monitored_points.copy()).min())


@dataclass
class Lab:
    """A lab with the Movemaster as its shared arm.

    Over all watched ticks since the last reset, nearest: the smallest clearance, m; fastest: the largest joint speed,
    divided by its limit.
    """

    session: Session
    nearest: float = field(default=np.inf)
    fastest: float = 0.0

    @property
    def state(self) -> State:
        return self.cell.state

    @property
    def cell(self) -> Workcell:
        return self.session.shared.workcell

    @property
    def display(self) -> Display:
        assert self.session.shared.display is not None
        return self.session.shared.display

    @property
    def windows(self) -> list[Window]:
        """The windows that show the shared arm, the newest last."""
        return [] if self.session.shared.display is None else list(self.display.windows)

    @property
    def seats(self) -> list[Seat]:
        return [visitor.place.seat for visitor in self.session.visitors.values()]

    @property
    def shapes(self) -> list[shapes.Shape]:
        return shapes.load_shapes(self.state.robot)

    def change(self, robot: str) -> None:
        """Load another robot without the page."""
        self.session.loop.call_soon_threadsafe(self.session.shared.arms.change, robot)

    @property
    def port(self) -> int:
        return int(self.session.server.get_port())

    def furnished(self, page: Page) -> None:
        """Wait until every window has the rows of the current robot: what is typed into older rows is lost."""
        until(page, lambda: all(one.robot is self.state.robot and not one._busy.locked() for one in self.windows))
        last = len(self.state.robot.variables)
        page.get_by_text(f"{last} {self.state.robot.variables[-1].title.en}").first.wait_for(state="attached")

    def post(self, update: Update) -> None:
        """Apply an update without the page, to prepare a test."""
        self.cell.tell(update)

    def watch(self) -> None:
        """Record `nearest` and `fastest` at every tick from now on."""
        if self.cell.tick.__name__ == "watched":
            return
        tick = self.cell.tick

        def watched() -> None:
            before, limit = self.state.arm.q, self.state.problem.limits.speed * TICK
            tick()
            self.fastest = max(self.fastest, float(np.max(np.abs(self.state.arm.q - before) / limit)))
            if not self.state.arm.parked:
                self.nearest = min(self.nearest, clearance(self.state))

        self.cell.tick = watched  # type: ignore[method-assign]

    def reset(self, page: Page) -> None:
        """Put the arm to `ready` inside the measured planes; a stop before that cancels earlier requests."""
        page.keyboard.press("Escape")
        until(page, lambda: self.state.request.command == HoldPosition(stopped=True))
        fresh = initial_state(self.state.robot)
        self.post(lambda state: replace(fresh, t=state.t))
        until(page, lambda: bool((self.state.arm.q == fresh.arm.q).all()))
        page.wait_for_timeout(1000)  # controls that were touched are not written for a moment
        self.nearest, self.fastest = np.inf, 0.0

    def ticks(self, page: Page, n: int) -> None:
        """Wait for n ticks, or until the arm is at rest."""
        end = self.cell.ticks + n
        self.cell.pause(False)
        until(page, lambda: self.cell.ticks >= end or self.cell.resting)


def until(page: Page, condition: Callable[[], bool], seconds: float = 120.0) -> None:
    """Wait for a condition, with a long limit, since a slow machine must not fail a test."""
    end = monotonic() + seconds
    while monotonic() < end:
        if condition():
            return
        page.wait_for_timeout(20)
    raise AssertionError(f"it did not happen within {seconds:.0f} s")


def opened() -> Lab:
    """A running lab on a free port."""
    session = Session(load_robot("movemaster"), None, None)
    session.open("127.0.0.1", 0)
    return Lab(session)


def pixels(page: Page, point: Array | Sequence[float]) -> tuple[float, float]:
    """The position on the page, px, of a point (3,) of the world, m."""
    x, y = page.evaluate(PROJECT, [float(value) for value in point])
    return x, y


def grab(lab: Lab, page: Page, start: Array, end: Array, steps: int = 15) -> None:
    """Press on a handle of the scene and drag it from `start` to `end`, (3,), m, without a release.

    The press is repeated if a slow page has not found the handle under the pointer yet.
    """
    for _ in range(20):
        page.mouse.move(*pixels(page, start))
        page.wait_for_timeout(400)
        page.mouse.down()
        page.mouse.move(*pixels(page, start + 0.02 * (end - start)))
        for _ in range(50):
            if lab.state.request.drag is not None:
                page.mouse.move(*pixels(page, end), steps=steps)
                return
            page.wait_for_timeout(20)
        page.mouse.up()
        page.wait_for_timeout(200)
    raise AssertionError("the handle could not be grabbed")


def status(page: Page) -> str:
    """The text of the status line."""
    return page.locator("#helicoide-status").inner_text()


def tab(page: Page, name: str) -> None:
    page.get_by_role("tab", name=name).click()
    page.wait_for_timeout(200)


def speak(lab: Lab, page: Page, language: Language) -> None:
    """Set the language of the newest window."""
    until(page, lambda: bool(lab.session.visitors))
    visitor = list(lab.session.visitors.values())[-1]
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: replace(seat, language=language))
    page.get_by_role("tab", name=panels.all_panels()[0].TITLE[language]).wait_for()


def box(page: Page, index: int, value: str) -> None:
    """Type into a number box of the Robot tab.

    Joints 0 to 4, gripper 5, position 6 to 8, angles 9 to 11, weights of postures 12 to 16, time 17.
    """
    field = page.locator("input.mantine-NumberInput-input").nth(index)
    field.fill(value)
    field.press("Enter")


def press(page: Page, name: str) -> None:
    """Press the button with that name."""
    page.get_by_role("button", name=name, exact=True).click()
