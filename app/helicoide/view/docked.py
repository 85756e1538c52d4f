"""The current step of a lesson, in a panel at the left edge of a window."""

from __future__ import annotations

import viser

from helicoide.lesson import load_lesson
from helicoide.view.panels.lesson import step_rows
from helicoide.view.placed_rows import WindowRow, place_rows
from helicoide.view.requests import Act
from helicoide.view.window_view import View

WIDTH, LARGE = 320.0, 480.0  # px; LARGE on a projector


class DockedLesson:
    """The panel of a lesson, shown while the seat has a lesson about the current robot."""

    def __init__(self, gui: viser.GuiApi, act: Act) -> None:
        self.gui, self.act = gui, act
        self.rows: list[WindowRow] = []
        self.panel: viser.PanelHandle | None = None
        self.key: tuple[object, ...] = ()

    def show(self, view: View) -> None:
        """Add, remove or update the panel for a view."""
        key = _key(view)
        if key != self.key:
            self._put_up(view, key)
        for row in self.rows:
            row.refresh(view)

    def _put_up(self, view: View, key: tuple[object, ...]) -> None:
        if self.panel is not None and (not key or key[:3] != self.key[:3]):
            self.panel.remove()
            self.panel, self.rows = None, []
        while self.rows:
            self.rows.pop().remove()
        self.key = key
        if not key or view.seat.lesson is None:
            return
        if self.panel is None:
            self.panel = self.gui.add_panel()
            self.tab = self.panel.add_tab(load_lesson(view.seat.lesson).title[view.seat.language])
            self.panel.dock_left()
            self.panel.expand()  # on a phone it is a section of the bottom sheet
            self.panel.set_width(LARGE if view.seat.projector else WIDTH)
        joints = load_lesson(view.seat.lesson).steps[view.seat.step].joints
        with self.tab:
            self.rows = place_rows(self.gui, step_rows(view.state.robot, joints), view, self.act)


def _key(view: View) -> tuple[object, ...]:
    """What the panel depends on; empty if there is no lesson, or its robot is not loaded yet."""
    seat, robot = view.seat, view.state.robot
    if seat.lesson is None or load_lesson(seat.lesson).robot != robot.name:
        return ()
    return seat.language, seat.lesson, seat.projector, seat.step
