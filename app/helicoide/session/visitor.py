"""A window with whoever sits in front of it, and the workcell that it looks at."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass

from helicoide import gate, lesson
from helicoide.seat import SeatUpdate
from helicoide.session import lessons
from helicoide.session.bay import Bay, Bays
from helicoide.session.seats import Place
from helicoide.state import Drag
from helicoide.view.rows import View
from helicoide.view.window import CLEARED, Window


@dataclass(eq=False)
class Visitor:
    """A window, where its person sits, and in front of which workcell.

    settled: whether it stays there for now; moving: what brings it elsewhere.
    """

    window: Window
    place: Place
    bay: Bay
    settled: bool = False
    moving: asyncio.Task[None] | None = None

    def view(self, ready: bool) -> View:
        """What the window shows; ready: whether the arms live."""
        place = self.place
        return View(self.bay.workcell.state, place.seat, place.desk, ready, self.bay.workcell is place.own)

    async def attach(self, bay: Bay) -> None:
        """Bring the window in front of a workcell."""
        self.bay, robots = bay, (bay.workcell.state.robot.name, bay.arms.wanted)
        if not lessons.is_about(self.place.seat, robots):
            self.place.seat = lessons.seated_at(robots, self.place.seat)
        await bay.enter(self.window)
        if self.window.gone:
            self.detach()

    def detach(self) -> None:
        """Take the window away from its workcell; what it held is let go where it is."""
        self.bay.leave(self.window)
        if (grasp := self.grasp) is not None:
            self.bay.workcell.tell(gate.let_go(grasp))

    async def settle(self, bays: Bays, view: Callable[[Window], View]) -> None:
        """Bring the window to the workcell where its person wishes to be, however often they change their mind."""
        self.settled = False
        try:
            while not self.window.gone and (bay := bays.of(self.place)) is not self.bay:
                await self._move(bay, view)
        finally:
            self.settled = True

    async def _move(self, bay: Bay, view: Callable[[Window], View]) -> None:
        self.detach()
        robot, self.bay = self.bay.workcell.state.robot, bay
        self.window.clear()
        self.window.client.flush()
        await asyncio.sleep(CLEARED)
        if bay.workcell.state.robot is not robot and not self.window.gone:
            await self.window.fill(view(self.window))
        await self.attach(bay)

    def write(self) -> None:
        """What the window shows may be something else."""
        if self.bay.display is not None:
            self.bay.display.news.set()

    def rewrite(self) -> None:
        """What the window shows may be wrong."""
        self.window.written = None
        self.write()

    @property
    def grasp(self) -> Drag | None:
        """What the window holds with the pointer."""
        grasp = self.bay.workcell.state.request.drag
        return grasp if grasp is not None and grasp.seat == str(self.window.client.client_id) else None

    def reseat(self, update: SeatUpdate) -> None:
        """The person changes something about their own windows; a lesson brings its robot with it."""
        before, bay = self.place.seat, self.bay
        seat = self.place.seat = update(before)
        if seat.lesson and (before.lesson, before.step) != (seat.lesson, seat.step):
            chosen = lesson.load_lesson(seat.lesson)
            if chosen.robot != bay.workcell.state.robot.name:
                bay.arms.change(chosen.robot)
            else:
                bay.workcell.ask(chosen.steps[seat.step].setup)
        if bay.display is not None:
            bay.display.redraw()

    def meet(self) -> None:
        """The arm of the workcell is another one: a lesson about it begins, another is left."""
        robot = self.bay.workcell.state.robot.name
        seat = self.place.seat = lessons.seated_at((robot, self.bay.arms.wanted), self.place.seat)
        if seat.lesson and (chosen := lesson.load_lesson(seat.lesson)).robot == robot:
            self.bay.workcell.ask(chosen.steps[seat.step].setup)

    def judge(self) -> None:
        """See whether the goal of the lesson is met."""
        judged = lessons.judged(self.place.seat, self.bay.workcell.state)
        if judged is not self.place.seat:
            self.place.seat = judged
            self.write()
