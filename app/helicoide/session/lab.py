"""The lab: the server, its event loop, the open windows, and the workcell that each of them shows."""

from __future__ import annotations

import asyncio
import gc
import logging
import secrets
from collections.abc import Collection
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from time import monotonic

from helicoide import content, gate
from helicoide.jobs.process import ProcessJob
from helicoide.kinematics.robot import Robot
from helicoide.session.bay import Bays
from helicoide.session.clock import Clock
from helicoide.session.display import Display, Supply
from helicoide.session.exporting import Exporting
from helicoide.session.preparing import compiled, compiling, prepare
from helicoide.session.recording_requests import RecordingRequests
from helicoide.session.saving import Saving
from helicoide.session.seats import Place, Seats
from helicoide.session.studies import Studies
from helicoide.session.visitor import Visitor
from helicoide.session.window_requests import WindowRequests
from helicoide.session.workcell import FAILED, Workcell
from helicoide.store.database import Store
from helicoide.text import Language, Text
from helicoide.view import requests
from helicoide.view.channel import PATH, ControlChannel, Hello, WindowChannel, introduce
from helicoide.view.link import (
    HelicoideFence,
    HelicoideFirstLesson,
    HelicoideFollow,
    HelicoideMadeAt,
    HelicoideRedo,
    HelicoideUndo,
    PageMessage,
    connection_of,
)
from helicoide.view.panels.lesson import first_lesson
from helicoide.view.prose_links import requests_of
from helicoide.view.requests import PageRequest
from helicoide.view.scene import light_scene
from helicoide.view.serve import serve
from helicoide.view.window import Client, Window, preload
from helicoide.view.window_view import View

UNTIDY = 10  # rounds of `_tidy` without a garbage collection while an arm moves
# s: time to wait for the first message of a page; after which a drag ends if its end was lost; between two checks of a
# lesson's goal; after which a control that was touched is written again; between two rounds of `_tidy`
ANSWER, LET_GO, JUDGED, PUT_RIGHT, TIDIED = 5.0, 0.5, 0.2, 0.8, 60.0
log = logging.getLogger("helicoide")


class Lab:
    """The server, the seats, the windows and the workcells. Its methods run on the server's event loop.

    For new seats: language, None for that of the browser; lesson_name, the first lesson; projector, whether text and
    handles are large. store: keeps the progress in lessons; without one it is lost when the lab ends.
    """

    def __init__(
        self,
        robot: Robot,
        language: Language | None,
        lesson_name: str | None,
        projector: bool = False,
        store: Store | None = None,
    ) -> None:
        self.language = language
        self.seats = Seats(lesson_name, projector)
        self.visitors: dict[int, Visitor] = {}
        self.lines: dict[int, WindowChannel] = {}
        self.control = ControlChannel(self._stopped, self._released, self._turned, self._pressed)
        self.ready = False
        self.clock = Clock(lambda: self.bays.workcells, self._changed)
        self.searcher = ThreadPoolExecutor(1, "helicoide search")
        self.studies = Studies(self._news)
        self.pen = asyncio.Lock()
        self.bays = Bays(robot, self.clock.wake, self.searcher, self._put_up)
        self.shared = self.bays.shared
        self.recording = RecordingRequests(self.bays, self.seats, self.visitors, self._news)
        self.saving = Saving(store, self.seats.places.values, self._tell)
        self.said = compiling(0)
        self._compilation = ProcessJob(compiled)
        self._signalled = False
        self._untidy = 0

    def open(self, host: str, port: int, origins: Collection[str] = (), framed: bool = False) -> int:
        """Serve the page; returns the port. Arguments and errors as in `serve`."""
        self.server = serve(host, port, content.STATIC, {PATH: self.control.serve}, origins, framed)
        self.loop = self.server.get_event_loop()
        self.loop.call_soon_threadsafe(self._begin)
        return int(self.server.get_port())

    def close(self) -> None:
        """Stop the arms, the jobs and the server. Call it from another thread than the event loop's."""
        self.saving.close()
        self._compilation.stop()
        self.studies.close()
        self.recording.recorders.close()
        for bay in self.bays:
            bay.mapping.close()
        self.clock.end()
        self.searcher.shutdown(wait=False, cancel_futures=True)
        self.loop.call_soon_threadsafe(lambda: self._starting.cancel())  # later, since `_begin` may not have run yet
        self.server.stop()

    def _begin(self) -> None:
        light_scene(self.server.scene)
        exporting = Exporting(self.server)
        self.requests = WindowRequests(self.bays, self.studies, self.recording, exporting, self.view, self._news)
        connection_of(self.server, self._on_message)
        self.server.on_client_connect(self._enter)
        self.server.on_client_disconnect(self._leave)
        self._furniture = self.loop.run_in_executor(None, preload, self.shared.workcell.state.robot)
        self._starting = self.loop.create_task(self._start())
        self._tidy()
        self._judge()

    async def _start(self) -> None:
        """Prepare the kernels while the page is served already; then the arms use the compiled kernels."""
        try:
            await prepare(self.shared.workcell.state.robot, self._compilation, self._say, self._meanwhile)
        except Exception:
            log.exception("the kernels could not be prepared")
            self._say(FAILED)
            return
        self.ready = True
        self.clock.start_ticking()
        self._news()

    def _meanwhile(self, alive: bool) -> None:
        """Until the kernels are compiled, run the arms with kernels as Python, or halt them."""
        self.clock.start_ticking(plain=True, halted=not alive)

    def _say(self, text: Text) -> None:
        """Show a text in every window, also in those that open later, until the kernels are compiled."""
        self.said = text
        for visitor in self.visitors.values():
            visitor.say(self.control, self.said)

    def _tell(self, text: Text) -> None:
        """Show a notification in every window."""
        for visitor in self.visitors.values():
            visitor.window.tell(text)
        self._news()

    def _tidy(self) -> None:
        self.seats.tidy(monotonic())
        self.bays.keep(self.seats.places.values())
        self._untidy = 0 if self.clock.idle else self._untidy + 1
        if self._untidy in (0, UNTIDY):
            self._untidy = 0
            gc.collect()
        self.loop.call_later(TIDIED, self._tidy)

    def _judge(self) -> None:
        """Judge the steps of the lessons, also those that wait while all arms are at rest."""
        for visitor in self.visitors.values():
            self.requests.steps.check(visitor)
            visitor.judge()
        self.loop.call_later(JUDGED, self._judge)

    # Messages from the clock.

    def _changed(self) -> None:
        """Called after each round of the clock, in its thread."""
        if self.visitors and not self._signalled:
            self._signalled = True
            self.loop.call_soon_threadsafe(self._on_news)

    def _on_news(self) -> None:
        self._signalled = False
        for bay in self.bays:
            if bay.display is not None:
                bay.display.tell()
        for visitor in self.visitors.values() if self.ready else ():
            visitor.sample()

    def _news(self) -> None:
        """Have the rows of all windows updated, since something besides their arms may have changed."""
        for bay in self.bays:
            if bay.display is not None:
                bay.display.news.set()

    # Windows that open and close.

    async def _enter(self, client: Client) -> None:
        """A window opens. It gets its old seat if its browser has stored the token of one."""
        key = secrets.token_urlsafe(9)
        line = self.lines[client.client_id] = self.control.open(key)
        introduce(client, key)
        await asyncio.shield(self._furniture)
        try:
            hello = await asyncio.wait_for(line.hello, ANSWER)
        except TimeoutError:
            hello = Hello(None, None)
        except asyncio.CancelledError:  # the client has disconnected
            if client.client_id in self.lines:
                raise
            return
        progress = await self.saving.load(hello.seat)
        if client.client_id not in self.lines:  # it has disconnected meanwhile
            return
        place = self.seats.take(hello.seat, self.language or hello.language or "en", hello.dark, progress)
        line.tell(seat=place.seat.token)
        await self._furnish(client, line, place, hello)

    async def _furnish(self, client: Client, line: WindowChannel, place: Place, hello: Hello) -> None:
        bay = self.bays.of(place)
        window = Window(
            client, line.link, View(bay.workcell.state, place.seat, place.study_panel, self.ready), self.act
        )
        visitor = self.visitors[client.client_id] = Visitor(window, place, bay, hello.address)
        visitor.progress_changed = self.saving.changed
        if not self.ready:
            visitor.say(self.control, self.said)
        self.recording.enter(place)
        await window.furnish(self.view(window))
        await visitor.attach(bay)
        await visitor.settle(self.bays, self.view)
        self.requests.steps.open(visitor)
        if self.saving.failure is not None and not window.gone:
            window.tell(self.saving.failure)
        if hello.link and not window.gone:
            visitor.open_link(hello.link)

    async def _leave(self, client: Client) -> None:
        """A window closes."""
        line = self.lines.pop(client.client_id, None)
        if line is not None:
            self.control.close(line.link.key)
        visitor = self.visitors.pop(client.client_id, None)
        if visitor is not None:
            visitor.window.leave()
            self.seats.leave(visitor.place)
            visitor.detach()
            if visitor.place.windows == 0:
                self.studies.forget(visitor.place)
                self.recording.recordings.forget(visitor.place)

    def view(self, window: Window) -> View:
        """What a window shows now."""
        view = self.visitors[window.client.client_id].view(self.ready)
        return replace(view, progress_note=self.saving.note)

    # Messages from windows.

    def _on_message(self, client_id: int, message: PageMessage) -> None:
        line, visitor = self.lines.get(client_id), self.visitors.get(client_id)
        match message:
            case HelicoideFence() | HelicoideMadeAt():
                if line is not None and line.link.hear(message) and visitor is not None:
                    visitor.window.restore()
                    visitor.write()
            case _ if visitor is None:
                return
            case HelicoideFirstLesson():
                visitor.window.act(first_lesson())
            case HelicoideFollow():
                for request in requests_of(message.target):
                    visitor.window.act(request)
            case HelicoideUndo():
                visitor.window.act(requests.Undo())
            case HelicoideRedo():
                visitor.window.act(requests.Redo())

    def act(self, window: Window, request: PageRequest) -> None:
        """Carry out a request if it is accepted. The rows of the window are written again in any case."""
        visitor = self.visitors.get(window.client.client_id)
        if visitor is None:
            return
        visitor.write()
        self.loop.call_later(PUT_RIGHT, visitor.rewrite)
        if isinstance(request, requests.Stop):
            self._stopped(window.link.key)
        elif not window.link.has_control:
            if window.link.late:
                window.tell_late()
        elif isinstance(request, requests.ForgetProgress):
            self.saving.forget(visitor.place, window.tell)
        else:
            self.requests.do(visitor, request)

    def _stopped(self, key: str | None, closing: bool = False) -> None:
        """Stop the workcell of a window, or the shared one if the window is unknown, and all with a real arm.

        Messages from the windows of these workcells are rejected until their pages know of the stop.
        closing: whether the same keystroke also closes something on the page.
        """
        visitor = self._with(key)
        mine = self.shared if visitor is None else visitor.bay
        stopped = {bay.workcell for bay in self.bays if bay is mine or bay.workcell.connected}
        for workcell in stopped:
            workcell.stop(closing)
        for number, line in self.lines.items():
            visitor = self.visitors.get(number)
            if visitor is None or visitor.bay.workcell in stopped:
                self.control.fence(line.link.key)

    def _released(self, key: str) -> None:
        """A pointer was released: its drag ends soon, even if the message that ends it is lost."""
        visitor = self._with(key)
        if visitor is not None and (grasp := visitor.drag) is not None:
            self.loop.call_later(LET_GO, visitor.bay.workcell.tell, gate.let_go(grasp))

    def _pressed(self, key: str) -> None:
        """A pointer or a key goes down in a window: what it changes is a change of its own, for undo."""
        if (visitor := self._with(key)) is not None:
            visitor.finish_change()

    def _turned(self, key: str, tab: int) -> None:
        """Another tab of a window is in front."""
        if (visitor := self._with(key)) is not None:
            visitor.window.tab = tab
            visitor.rewrite()

    def _with(self, key: str | None) -> Visitor | None:
        """The visitor with the window of that key, or None."""
        return next((one for one in self.visitors.values() if one.window.link.key == key), None)

    def _put_up(self, workcell: Workcell, supply: Supply) -> Display:
        """The display of a workcell."""
        return Display(self.server, self.control, workcell, self.view, self._arrived, self.pen, supply)

    def _arrived(self, display: Display) -> None:
        """Another robot was loaded into a workcell."""
        for visitor in self.visitors.values():
            if visitor.bay.display is display:
                self.requests.steps.meet(visitor)
                self.recording.recordings.meet(visitor.place)
