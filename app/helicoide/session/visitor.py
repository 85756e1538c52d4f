"""A window, its place, and the workcell that it shows."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from time import monotonic

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.lesson import StepWatch
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY, SignalHistory
from helicoide.readout.signals import needed_signals
from helicoide.seat import Seat, SeatUpdate
from helicoide.session import lessons
from helicoide.session.bay import Bay, Bays
from helicoide.session.seats import Place
from helicoide.session.step_setup import StepSetup
from helicoide.sheet import Sheet, SheetHistory
from helicoide.state import Drag, State
from helicoide.text import HelicoideError, Text
from helicoide.view.channel import ControlChannel, Notice, share_link
from helicoide.view.link_rows import with_linked
from helicoide.view.requests import ShowTab
from helicoide.view.share import BAD_NUMBERS, SharedView, console_tab, decode_link
from helicoide.view.window import CLEARED, Window
from helicoide.view.window_view import View

SAME_POSTURE = 1e-3  # rad or m; a link rounds joint values
SHEET_OPENED = Text(
    en="The console, under the tab “Algebra”, has the sheet of the link.",
    pt_BR="O console, na aba “Álgebra”, tem a folha do link.",
)
SHEET_REPLACED = Text(
    en="The console, under the tab “Algebra”, has the sheet of the link in the place of yours. Undo brings yours back.",
    pt_BR="O console, na aba “Álgebra”, tem a folha do link no lugar da sua. Desfazer traz a sua de volta.",
)
SheetReturn = Callable[[Sheet, SheetHistory], tuple[Sheet, SheetHistory]]
log = logging.getLogger("helicoide")


@dataclass(eq=False)
class Visitor:
    """A window, its place, and the bay of the workcell that it shows.

    address: that of its page; settled: whether the window is not moving to another workcell; moving: the task that
    moves it; history: the last samples of the signals that the seat charts; setup, watch: of the open step; judged:
    seat and state that were judged last; outlook: camera position and target, (3,) m each, before a lesson moved it;
    lesson_arm: whether a lesson has moved the visitor to its own arm; awaits_arm: whether a step waits for its robot;
    progress_changed: called with the place when its seat has other progress in lessons.
    """

    window: Window
    place: Place
    bay: Bay
    address: str = ""
    settled: bool = False
    moving: asyncio.Task[None] | None = None
    history: SignalHistory = NO_SIGNAL_HISTORY
    setup: StepSetup | None = None
    watch: StepWatch = field(default_factory=StepWatch)
    judged: tuple[Seat | None, State | None] = (None, None)
    outlook: tuple[Array, Array] | None = None
    lesson_arm: bool = False
    awaits_arm: bool = False
    progress_changed: Callable[[Place], object] = lambda place: None

    def view(self, ready: bool) -> View:
        """What the window shows now. ready: whether the kernels are compiled."""
        place, workcell = self.place, self.bay.workcell
        recorder = None if workcell.recorder is None else workcell.recorder.status
        own = workcell is place.own
        return View(
            workcell.state,
            place.seat,
            place.study_panel,
            ready,
            own,
            recordings=place.recordings,
            recorder=recorder,
            history=self.history,
            time=monotonic(),
            address=self.address,
            line_check=place.line_check,
        )

    def sample(self) -> None:
        """Add a sample to the history if one is due. Nothing is computed without charts, or while they are paused."""
        charts, state = self.place.seat.charts, self.bay.workcell.state
        if not any(charts.shown):
            self.history = NO_SIGNAL_HISTORY
        elif charts.paused:
            if self.history.robot is not state.robot:
                self.history = NO_SIGNAL_HISTORY
        else:
            try:
                signals = needed_signals(state, charts.shown)
                if self.history.is_due(state, signals):
                    self.history = self.history.with_sample(state, signals)
            except Exception:
                log.exception("the signals of a chart could not be read")

    async def attach(self, bay: Bay) -> None:
        """Show a workcell in the window."""
        self.bay, robots, self.history = bay, (bay.workcell.state.robot.name, bay.arms.wanted), NO_SIGNAL_HISTORY
        if not lessons.is_about(self.place.seat, robots):
            self.seat_as(lessons.seated_at(robots, self.place.seat))
        await bay.enter(self.window)
        if self.window.gone:
            self.detach()

    def detach(self) -> None:
        """Remove the window from its workcell, and end its drag there."""
        self.bay.leave(self.window)
        if (grasp := self.drag) is not None:
            self.bay.workcell.tell(gate.let_go(grasp))

    async def settle(self, bays: Bays, view: Callable[[Window], View]) -> None:
        """Move the window to the workcell of its place, also if that changes during the move."""
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

    def say(self, control: ControlChannel, text: Text) -> None:
        """Show a text in the status line, until the next one."""
        seat = self.place.seat
        notice = Notice(seat.language, text, "warn", projector=seat.projector, transparent=seat.transparent)
        control.push(self.window.link.key, notice)

    def open_link(self, text: str) -> None:
        """Show what a link carries, a view or a sheet alone; one that cannot be read is refused and changes nothing."""
        robot, q = self.bay.workcell.state.robot, self.bay.workcell.state.arm.q
        try:
            shared = decode_link(text)
            if (
                isinstance(shared, SharedView)
                and shared.posture.robot == robot.name
                and len(shared.posture.q) != len(q)
            ):
                raise HelicoideError(BAD_NUMBERS.format(part="q", count=len(q)))
        except HelicoideError as refusal:
            self.window.tell(refusal.text)
            return
        if isinstance(shared, SharedView):
            self._show(shared)
        else:
            self.window.act(ShowTab(console_tab()))
            self._open_sheet(shared)

    def _show(self, shared: SharedView) -> None:
        """Show the view of a link: camera, tab and sheet at once; an arm in another posture is only asked for."""
        linked, state = shared.posture, self.bay.workcell.state
        self.window.look(*shared.camera)
        self.window.act(ShowTab(shared.tab))
        here = linked.robot == state.robot.name
        there = here and np.allclose(linked.q, state.arm.q, rtol=0, atol=SAME_POSTURE)
        self.reseat(partial(with_linked, None if there else linked))
        if shared.sheet != Sheet():
            self._open_sheet(shared.sheet)

    def _open_sheet(self, sheet: Sheet) -> None:
        """Put the sheet of a link in the place of the seat's own; Undo brings that back."""
        own = self.place.seat.sheet
        self.finish_change()
        self.reseat(lambda seat: replace(seat, sheet=sheet))
        self.window.tell(SHEET_REPLACED if own.lines and own != sheet else SHEET_OPENED)

    def return_sheet(self, change: SheetReturn, notice: Text) -> None:
        """Undo or redo a change of the sheet, and say so."""
        sheet, history = change(self.place.seat.sheet, self.place.seat.sheet_history)
        self.reseat(lambda seat: replace(seat, sheet=sheet, sheet_history=history))
        self.window.tell(notice)

    def finish_change(self) -> None:
        """Let the next change of the scene or of the sheet be one of its own."""
        self.bay.finish_change()
        seat = self.place.seat
        if seat.sheet_history.unfinished:
            self.place.seat = replace(seat, sheet_history=seat.sheet_history.finished())

    def close_link(self) -> None:
        """Forget the link, also in the address of the page."""
        share_link(self.window.client, "")
        self.reseat(partial(with_linked, None))

    def write(self) -> None:
        """Have the rows of the window updated if they have changed."""
        if self.bay.display is not None:
            self.bay.display.news.set()

    def rewrite(self) -> None:
        """Have all rows of the window written again."""
        self.window.written = None
        self.write()

    @property
    def drag(self) -> Drag | None:
        """The drag of this window's pointer, or None."""
        grasp = self.bay.workcell.state.request.drag
        return grasp if grasp is not None and grasp.seat == str(self.window.client.client_id) else None

    def reseat(self, update: SeatUpdate) -> None:
        """Update the seat. A change of the sheet is recorded, so that it can be undone."""
        before, bay = self.place.seat, self.bay
        seat = update(before)
        if seat.sheet != before.sheet and seat.sheet_history is before.sheet_history:
            scene = len(bay.workcell.state.history.undo)
            seat = replace(seat, sheet_history=before.sheet_history.with_change(before.sheet, seat.sheet, scene))
        self.seat_as(seat)
        if bay.display is not None:
            bay.display.redraw()

    def meet(self) -> None:
        """Adapt the seat to a new robot in the workcell: a lesson that is not about it is left."""
        robot = self.bay.workcell.state.robot.name
        self.seat_as(lessons.seated_at((robot, self.bay.arms.wanted), self.place.seat))

    def judge(self) -> None:
        """Judge the step of the lesson, unless nothing has changed since the last time and time alone changes nothing.

        A step that is done is marked, an answer is revealed, and a mistake is explained.
        """
        seat, state = self.place.seat, self.bay.workcell.state
        if self.setup is not None and self.setup.is_under_way(state):
            return
        if self.judged[0] is seat and self.judged[1] is state and not self.watch.is_waiting:
            return
        after, self.watch = lessons.judged(seat, state, self.watch, monotonic())
        self.judged = after, state
        if after is not seat:
            self.seat_as(after)
            if self.bay.display is not None:
                self.bay.display.redraw()

    def seat_as(self, seat: Seat) -> None:
        """Replace the seat. A change of the progress in lessons is passed on."""
        before, self.place.seat = self.place.seat, seat
        if seat.progress is not before.progress:
            self.progress_changed(self.place)

    def keep_outlook(self) -> None:
        """Remember where the camera is before a lesson moves it."""
        camera = self.window.client.camera
        self.outlook = self.outlook or (np.array(camera.position), np.array(camera.look_at))

    def look_as_before(self) -> None:
        """Move the camera back to where it was before a lesson moved it."""
        if self.outlook is not None:
            self.window.look(*self.outlook)
            self.outlook = None
