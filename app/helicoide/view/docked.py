"""The open lesson, in a panel at the left edge of a window: its current step, or the summary after the last one."""

from __future__ import annotations

import viser

from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.view.lesson_rows import step_rows
from helicoide.view.lesson_summary import summary_rows
from helicoide.view.open_step import lesson_of, open_step
from helicoide.view.placed_rows import WindowRow, place_rows
from helicoide.view.requests import Act
from helicoide.view.rows import Row
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
        lesson = lesson_of(view.seat)
        if not key or lesson is None:
            return
        if self.panel is None:
            self.panel = self.gui.add_panel()
            self.tab = self.panel.add_tab(lesson.title[view.seat.language])
            self.panel.dock_left()
            self.panel.expand()  # on a phone it is a section of the bottom sheet
            self.panel.set_width(LARGE if view.seat.projector else WIDTH)
        with self.tab:
            self.rows = place_rows(self.gui, lesson_rows(view.state.robot, view.seat), view, self.act)


def lesson_rows(robot: Robot, seat: Seat) -> list[Row]:
    """The rows of the open step, or of the summary."""
    opened = open_step(seat)
    return summary_rows() if opened is None else step_rows(robot, opened, seat.language)


def _key(view: View) -> tuple[object, ...]:
    """What the panel depends on; empty if there is no lesson, or its robot is not loaded yet."""
    seat, lesson = view.seat, lesson_of(view.seat)
    if lesson is None or lesson.robot != view.state.robot.name or seat.lesson_progress is None:
        return ()
    opened = open_step(seat)
    is_answered = opened is not None and opened.answer is not None
    lines = 0 if opened is None else len(opened.accepted_lines)
    return seat.language, seat.lesson, seat.projector, seat.lesson_progress.step, is_answered, lines
