"""What the windows of a lab ask for, except Stop, handed to what carries it out."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from helicoide.gate.undoing import REDONE, UNDONE
from helicoide.session.bay import Bays
from helicoide.session.exporting import Exporting
from helicoide.session.lesson_steps import LessonSteps
from helicoide.session.line_checking import LineChecking
from helicoide.session.recording_requests import RecordingRequests
from helicoide.session.studies import Studies
from helicoide.session.visitor import Visitor
from helicoide.sheet import with_sheet_redone, with_sheet_undone
from helicoide.text import HelicoideError
from helicoide.view import requests
from helicoide.view.requests import PageRequest
from helicoide.view.window import Window
from helicoide.view.window_view import View


class WindowRequests:
    """Carries out requests. Use it only on the event loop.

    view: returns what a window shows now; news: has the rows of all windows written.
    """

    def __init__(
        self,
        bays: Bays,
        studies: Studies,
        recording: RecordingRequests,
        exporting: Exporting,
        view: Callable[[Window], View],
        news: Callable[[], object],
    ) -> None:
        self.bays, self.studies, self.recording, self.exporting = bays, studies, recording, exporting
        self.view, self.news = view, news
        self.steps = LessonSteps(bays, self._move)
        self.checking = LineChecking(news)

    def do(self, visitor: Visitor, request: PageRequest) -> None:
        """Carry out a request of a window."""
        match request:
            case requests.ForSeat(update):
                before = visitor.place.seat
                try:
                    visitor.reseat(update)
                    self.steps.follow(visitor, before)
                except HelicoideError as refusal:
                    visitor.window.tell(refusal.text)
                self.news()
            case requests.CheckLine(text):
                self.checking.begin(visitor, text)
            case requests.ResetStep():
                self.steps.begin(visitor)
            case requests.Undo() if (change := self.view(visitor.window).sheet_undo) is not None:
                visitor.return_sheet(with_sheet_undone, UNDONE.format(what=change.title))
            case requests.Redo() if (change := self.view(visitor.window).sheet_redo) is not None:
                visitor.return_sheet(with_sheet_redone, REDONE.format(what=change.title))
            case requests.ForStudyPanel(update):
                self.studies.change(visitor.place, update)
            case requests.OwnArm(on):
                self._move(visitor, on)
            case requests.TakeLink(own):
                self._take_link(visitor, own)
            case requests.OpenLink(address):
                visitor.open_link(address.strip().rpartition("#")[2])
            case requests.CloseLink():
                visitor.close_link()
            case requests.Save() | requests.SaveNotebook() | requests.SaveClip() | requests.SavePicture():
                self.exporting.begin(visitor, request)
            case request if isinstance(request, requests.RecordingRequest):
                self.recording.do(visitor, request)
            case _:
                visitor.bay.do(request)

    def _move(self, visitor: Visitor, own: bool) -> None:
        """Move a visitor to its own arm, which begins as a copy of the shared one, or back to the shared arm."""
        if own:
            try:
                self.bays.give(visitor.place)
            except HelicoideError as refusal:
                visitor.window.tell(refusal.text)
                return
        visitor.place.at_own = own
        self.recording.recordings.meet(visitor.place)
        if visitor.settled:
            visitor.moving = asyncio.get_running_loop().create_task(self._settle(visitor))

    async def _settle(self, visitor: Visitor) -> None:
        await visitor.settle(self.bays, self.view)
        self.steps.settled(visitor)

    def _take_link(self, visitor: Visitor, own: bool) -> None:
        """Bring the arm of a visitor to the posture of a link, or its own arm, which it gets first.

        On the shared arm no other robot is loaded, also if it has changed since the page offered this.
        """
        if own:
            self._move(visitor, True)
        linked, bay = visitor.place.seat.linked, self.bays.of(visitor.place)
        if linked is None:
            return
        if visitor.place.at_own or (not own and linked.robot == bay.workcell.state.robot.name):
            bay.arms.go_to(linked.robot, linked.q)
            visitor.close_link()
