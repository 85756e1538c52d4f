"""The step of a lesson at the left edge of a window, beside the panel whose controls it asks for."""

from __future__ import annotations

import viser

from helicoide.lesson import load_lesson
from helicoide.view.panels.lesson import step_rows
from helicoide.view.placed_rows import PlacedRow, place_rows
from helicoide.view.rows import Act, View

WIDTH, LARGE = 320.0, 480.0  # px; the latter on a projector


class DockedLesson:
    """There while a person is in a lesson about the arm that stands there."""

    def __init__(self, gui: viser.GuiApi, act: Act) -> None:
        self.gui, self.act = gui, act
        self.rows: list[PlacedRow] = []
        self.panel: viser.PanelHandle | None = None
        self.key: tuple[object, ...] = ()

    def show(self, view: View) -> None:
        """Bring it to a view: put up, taken down, or kept in step."""
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
            self.panel.expand()  # a phone shows it as a section of its sheet
            self.panel.set_width(LARGE if view.seat.projector else WIDTH)
        joints = load_lesson(view.seat.lesson).steps[view.seat.step].joints
        with self.tab:
            self.rows = place_rows(self.gui, step_rows(view.state.robot, joints), view, self.act)


def _key(view: View) -> tuple[object, ...]:
    """What it is built for; nothing where there is no lesson, or its arm is still on its way."""
    seat, robot = view.seat, view.state.robot
    if seat.lesson is None or load_lesson(seat.lesson).robot != robot.name:
        return ()
    return seat.language, seat.lesson, seat.projector, seat.step
