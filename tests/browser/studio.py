"""The place where a picture of the gallery is set up: a lab, a window of it, and a camera that knows where is room."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy as np
from playwright.sync_api import Locator, Page
from tests.browser.lab import Lab, until
from tests.browser.sheet import placed

from helicoide.arrays import Array
from helicoide.seat import SeatUpdate
from helicoide.session.visitor import Visitor
from helicoide.state import Update
from helicoide.text import Language, Text

# The part of the canvas that nothing covers, px: its left, upper, right and lower edge; the size of the canvas.
FREE = """() => {
  const canvas = window.__viserMutable.canvas.getBoundingClientRect();
  const scene = (x, y) => document.elementFromPoint(x, y)?.tagName === "CANVAS";
  const column = canvas.left + canvas.width / 3, row = canvas.top + canvas.height / 3;
  const top = document.querySelector("#helicoide-status").getBoundingClientRect().bottom;
  let bottom = row, right = column;
  while (bottom < canvas.bottom && scene(column, bottom)) bottom += 1;
  while (right < canvas.right && scene(right, row)) right += 1;
  return [0, top - canvas.top, right - canvas.left, bottom - canvas.top, canvas.width, canvas.height];
}"""
UNFOLDING_MS = 1_500
FROM_THE_FRONT = (0.55, -1.0, 0.45)


@dataclass
class Studio:
    """A lab and the one window that is photographed."""

    lab: Lab
    page: Page
    language: Language

    @property
    def visitor(self) -> Visitor:
        return list(self.lab.session.visitors.values())[-1]

    def load(self, robot: str) -> None:
        """Load an arm, unless it is there, and wait until the window has its rows."""
        if self.lab.state.robot.name != robot:
            self.lab.change(robot)
            until(self.page, lambda: self.lab.state.robot.name == robot)
        until(self.page, lambda: all(one.robot is self.lab.state.robot for one in self.lab.windows))
        until(self.page, lambda: all(one.written and not one._busy.locked() for one in self.lab.windows))

    def sit(self, update: SeatUpdate) -> None:
        """Change what the person at the window has chosen."""
        self.lab.session.loop.call_soon_threadsafe(self.visitor.reseat, update)
        self.page.wait_for_timeout(300)

    def show(self, *layers: str) -> None:
        """Show layers of the scene."""
        for layer in layers:
            self.sit(lambda seat, layer=layer: seat.with_layer(layer, True))  # type: ignore[misc]

    def move(self, update: Update) -> None:
        """Ask the arm for something, and wait until it rests."""
        ticks = self.lab.cell.ticks
        self.lab.post(update)
        until(self.page, lambda: self.lab.cell.ticks > ticks + 20 or self.lab.cell.resting)
        until(self.page, lambda: self.lab.cell.resting)

    def tab(self, panel: ModuleType) -> None:
        """Bring a panel to the front."""
        self.page.get_by_role("tab", name=panel.TITLE[self.language]).click()

    def heading(self, title: Text) -> Locator:
        """The heading of a folder, which opens and closes it."""
        return self.page.get_by_role("button", name=title[self.language], exact=True).locator("visible=true").last

    def unfold(self, title: Text) -> None:
        """Open a folder, and scroll the panel so that it begins with it."""
        self.heading(title).click()
        self.page.wait_for_timeout(UNFOLDING_MS)
        self.begin_with(self.heading(title))

    def begin_with(self, element: Locator) -> None:
        """Scroll the panel so that it begins with an element."""
        element.evaluate("element => element.scrollIntoView({ block: 'start' })")

    def arm(self) -> Array:
        """Points (k, 3), m, on all edges of the arm."""
        return np.concatenate([placed(self.lab.state, shape) for shape in self.lab.shapes if len(shape.edges)])

    def aim(self, direction: Sequence[float] = FROM_THE_FRONT, points: Array | None = None, share: float = 0.9) -> None:
        """Look from a direction (3,) at points (k, 3), m, or at the arm: they fill a share of the free part."""
        points = self.arm() if points is None else points
        left, top, right, bottom, width, height = self.page.evaluate(FREE)
        window = self.visitor.window
        focal = height / 2 / np.tan(window.client.camera.fov / 2)  # pixels of one metre that is one metre away
        away = np.asarray(direction) / np.linalg.norm(direction)
        to_the_right = np.cross([0.0, 0.0, 1.0], away) / np.linalg.norm(away[:2])
        axes = np.array([to_the_right, np.cross(away, to_the_right), away])
        wanted = np.array([left + right - width, height - top - bottom]) / 2
        room = share * np.array([right - left, bottom - top])
        eye = fitting_eye(points @ axes.T, wanted / focal, room / focal) @ axes
        self.lab.session.loop.call_soon_threadsafe(window.look, eye, eye - away)


def fitting_eye(points: Array, wanted: Array, room: Array) -> Array:
    """Where the eye (3,) stands that sees points (k, 3), m, to the right, up and towards it, within some room.

    wanted: where their picture is centred, to the right and up (2,); room: its largest width and height (2,); both in
    units of the focal length.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    eye = (low + high) / 2 + [0.0, 0.0, 2 * np.linalg.norm(high - low)]
    for _ in range(200):
        seen = (points - eye)[:, :2] / (eye - points)[:, 2:]
        first, last = seen.min(axis=0), seen.max(axis=0)
        far = eye[2] - high[2]
        eye[:2] += 0.5 * far * ((first + last) / 2 - wanted)
        eye[2] = high[2] + far * np.sqrt(((last - first) / room).max())
    return np.asarray(eye)
