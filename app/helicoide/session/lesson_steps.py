"""Set up the steps of lessons: the arm and its robot, what is shown, the camera and the tab; undo it on leaving."""

from __future__ import annotations

from collections.abc import Callable

from helicoide import lesson
from helicoide.seat import LessonProgress, Seat
from helicoide.session.bay import Bays
from helicoide.session.lessons import is_about
from helicoide.session.step_setup import StepSetup
from helicoide.session.visitor import Visitor
from helicoide.view import panels
from helicoide.view.open_step import lesson_of, open_step
from helicoide.view.requests import Look, ShowTab


class LessonSteps:
    """Follows the visitors through their lessons. Use it only on the event loop.

    move: moves a visitor to its own arm (True), or back to the shared one.
    """

    def __init__(self, bays: Bays, move: Callable[[Visitor, bool], None]) -> None:
        self.bays, self.move = bays, move

    def follow(self, visitor: Visitor, before: Seat) -> None:
        """After a change of the seat: leave the step where it was before, and begin the one where it is now."""
        after = visitor.place.seat
        if _place(before) == _place(after) and not _is_cleared(before, after):
            return
        if (left := open_step(before)) is not None:
            visitor.seat_as(lesson.without_step_shown(visitor.place.seat, left.step))
        if before.lesson != after.lesson:
            self._leave(visitor)
        if after.lesson is not None:
            self.begin(visitor)

    def begin(self, visitor: Visitor) -> None:
        """Set up the open step. If its robot is another one, that is loaded first, and the step is set up later."""
        chosen = lesson_of(visitor.place.seat)
        if chosen is None:
            return
        if chosen.own_arm and not visitor.place.at_own:
            self.move(visitor, True)
            visitor.lesson_arm = visitor.place.at_own
        bay = self.bays.of(visitor.place)
        if chosen.robot != bay.workcell.state.robot.name:
            visitor.awaits_arm = True
            bay.arms.change(chosen.robot)
        else:
            self._set_up(visitor)

    def meet(self, visitor: Visitor) -> None:
        """Another robot is in the workcell of a visitor: a lesson about it begins, any other lesson is left."""
        visitor.meet()
        chosen = lesson_of(visitor.place.seat)
        if chosen is not None and chosen.robot == visitor.bay.workcell.state.robot.name:
            self._set_up(visitor)

    def check(self, visitor: Visitor) -> None:
        """Leave a lesson whose robot was there so briefly that no frame showed it, so that `meet` was not called."""
        bay = self.bays.of(visitor.place)
        if bay is visitor.bay and not is_about(visitor.place.seat, (bay.workcell.state.robot.name, bay.arms.wanted)):
            visitor.meet()

    def settled(self, visitor: Visitor) -> None:
        """A visitor has moved to another workcell, where the robot of its lesson may have arrived before it."""
        chosen = lesson_of(visitor.place.seat)
        if visitor.awaits_arm and chosen is not None and chosen.robot == visitor.bay.workcell.state.robot.name:
            self._set_up(visitor)

    def open(self, visitor: Visitor) -> None:
        """A window opens in a lesson. If its step was never shown, it is now; a shared arm stays as it is."""
        opened = open_step(visitor.place.seat)
        if opened is None or visitor.place.seat.outside is not None:
            return
        if opened.lesson.own_arm:
            self.begin(visitor)
        else:
            visitor.seat_as(lesson.with_step_shown(visitor.place.seat, opened.step))

    def _set_up(self, visitor: Visitor) -> None:
        visitor.awaits_arm = False
        opened = open_step(visitor.place.seat)
        if opened is None:
            return
        visitor.seat_as(lesson.with_step_shown(visitor.place.seat, opened.step))
        visitor.setup = StepSetup(opened.step.setup)
        self.bays.of(visitor.place).workcell.ask(visitor.setup)
        shown = opened.step.shown
        if shown.camera is not None and visitor.window.layers is not None:
            visitor.keep_outlook()
            visitor.window.act(Look(shown.camera))
        if shown.tab in panels.panel_names():
            visitor.window.act(ShowTab(panels.panel_names().index(shown.tab)))
        visitor.write()

    def _leave(self, visitor: Visitor) -> None:
        """Bring back the camera, and the shared arm if the lesson had brought one of its own."""
        visitor.look_as_before()
        if visitor.lesson_arm:
            visitor.lesson_arm = False
            self.move(visitor, False)


def _place(seat: Seat) -> tuple[str | None, int]:
    """The lesson and the step at which a seat is."""
    return seat.lesson, 0 if seat.lesson_progress is None else seat.lesson_progress.step


def _is_cleared(before: Seat, after: Seat) -> bool:
    """Whether the lesson was begun again."""
    return after.lesson is not None and before.lesson_progress != after.lesson_progress == LessonProgress(after.lesson)
