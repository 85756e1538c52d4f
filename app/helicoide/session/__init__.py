"""The one mutable object: the inbox, the loop, the windows.

Everything here runs on the event loop of the server, so nothing is locked: callbacks post, the loop drains, a tick
advances, a frame is drawn. Long work is done in threads and processes that post their result.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
from collections import deque
from collections.abc import Callable
from dataclasses import replace

from helicoide import content, gate, lesson
from helicoide.advance import advance, foreseen, leads_elsewhere
from helicoide.jobs.apart import Apart
from helicoide.kinematics.robot import Robot
from helicoide.session.changing import FAILED, Changing
from helicoide.session.mapping import Mapping
from helicoide.session.preparing import TICK, compiled, compiling, prepare
from helicoide.session.replaying import along_fastest, through
from helicoide.session.studies import Studies
from helicoide.session.surveying import Surveying
from helicoide.state import Seat, State, Update, initial
from helicoide.text import Language, Text
from helicoide.view import shapes
from helicoide.view.channel import PATH, Control, Notice
from helicoide.view.rows import CountMap, Play, PlayFastest, PlayTaught, ReadCloud, Tour, View, Wish
from helicoide.view.scene import NOBODY, Scene
from helicoide.view.serve import serve
from helicoide.view.window import Client, Window, remember, remembered, seated

TICKS_PER_FRAME = 2
FRAMES_PER_TEXT = 5
LET_GO = 0.5

log = logging.getLogger("helicoide")


class Session:
    """One arm, the people in front of it, and the loop."""

    def __init__(self, robot: Robot, language: Language, lesson_name: str | None) -> None:
        self.robot, self.language, self.lesson_name = robot, language, lesson_name
        self.state = initial(robot)
        self.shapes = shapes.load(robot)
        self.seats: dict[str, Seat] = {}
        self.windows: dict[int, Window] = {}
        self.control = Control(lambda: self.post(gate.stop()), self._released)
        self.studies = Studies(lambda: self.loop.call_soon(self._write))
        self.survey = Surveying(lambda: self.state, self.post)
        self.mapping = Mapping(lambda: self.state, self.post)
        self.changing = Changing(self)
        self.inbox: deque[Update] = deque()
        self.frames = 0
        self.ticks = 0
        self.ready = False
        self._compilation = Apart(compiled)
        self.said = compiling(0)
        self._drawn: State | None = None
        self._foreseen: State | None = None
        self._woken = False

    def open(self, host: str, port: int) -> int:
        """Serve the page; returns the port. Raises HelicoideError when it cannot be had."""
        self.server = serve(host, port, content.STATIC, {PATH: self.control.serve})
        self.loop = self.server.get_event_loop()
        self.loop.call_soon_threadsafe(self._begin)
        return int(self.server.get_port())

    def close(self) -> None:
        """Stop the loop, the compilation and the server."""
        self.ready = False
        self._compilation.stop()
        self.studies.close()
        self.mapping.close()
        self.loop.call_soon_threadsafe(lambda: self._starting.cancel())  # it may not have begun yet
        self.server.stop()

    def post(self, update: Update) -> None:
        """Put a wish into the inbox and wake the loop. Only on the event loop."""
        self.inbox.append(update)
        if self.ready and not self._woken:
            self._woken = True
            self.loop.call_soon(self._drain)

    def _begin(self) -> None:
        self.scene = Scene(self.server, self.robot, self.shapes)
        self.draw()
        self.server.on_client_connect(self._enter)
        self.server.on_client_disconnect(self._leave)
        self._starting = self.loop.create_task(self._start())

    async def _start(self) -> None:
        """Prepare while the page is up, then let the arm run."""
        try:
            await prepare(self.robot, self._compilation, self._say)
        except Exception:
            log.exception("the kernels could not be prepared")
            self._say(FAILED)
            return
        self.ready = True
        self.next_tick = self.loop.time()
        self._tick()

    def _say(self, text: Text) -> None:
        """Show a sentence in every window, also in those that open later, while the arm does not run yet."""
        self.said = text
        for window in self.windows.values():
            seat = window.view.seat
            self.control.push(seat.token, Notice(seat.language, text, "warn"))

    async def _enter(self, client: Client) -> None:
        """A window opens: with its old seat when its browser still has the token of one."""
        try:
            token = await self._seat_of(client)
        except RuntimeError:  # the client left again
            return
        self._furnish(client, self.view(token))

    async def _seat_of(self, client: Client) -> str:
        """The token of the client's seat, kept in its browser; a new seat where there is none."""
        token = await remembered(client)
        if token is None or token not in self.seats:
            token = secrets.token_urlsafe(12)
            self.seats[token] = seated(token, self.language, self.lesson_name)
            remember(client, token)
        return token

    def _furnish(self, client: Client, view: View) -> None:
        wishes = (self.post, self._reseat, self.change, self.studies.redesk, self.ask)
        window = Window(client, self.robot, self.shapes, view, self.control, *wishes)
        self.windows[client.client_id] = window
        window.draw(view)
        if not self.ready:
            self._say(self.said)

    def view(self, token: str) -> View:
        """What a person sees."""
        return View(self.state, self.seats[token], self.studies.desk(token), self.ready)

    async def _leave(self, client: Client) -> None:
        """A window closes: what it held is let go where it is."""
        window = self.windows.pop(client.client_id, None)
        if window and all(other.view.seat.token != window.view.seat.token for other in self.windows.values()):
            self.control.forget(window.view.seat.token)
            self.studies.forget(window.view.seat.token)
        grasp = self.state.grasp
        if grasp is not None and grasp.seat == str(client.client_id):
            self.post(gate.let_go(grasp))

    def _released(self, token: str) -> None:
        """A pointer was let go: what it held ends soon, also when the drag's own end gets lost on its way."""
        grasp = self.state.grasp
        whose = {str(number) for number, window in self.windows.items() if window.view.seat.token == token}
        if grasp is not None and grasp.seat in whose:
            self.loop.call_later(LET_GO, self.post, gate.let_go(grasp))

    def change(self, robot_name: str) -> None:
        """Put another robot in front of everybody, as soon as it is loaded. Only on the event loop."""
        self.changing.change(robot_name)

    def _reseat(self, seat: Seat) -> None:
        """A person changed something about their own window; a lesson brings its robot with it."""
        before = self.seats.get(seat.token)
        self.seats[seat.token] = seat
        if before and seat.lesson and (before.lesson, before.step) != (seat.lesson, seat.step):
            chosen = lesson.load(seat.lesson)
            if chosen.robot != self.robot.name:
                self.change(chosen.robot)
            else:
                self.post(chosen.steps[seat.step].setup)
        self.loop.call_soon(self._write)

    def ask(self, wish: Wish) -> None:
        """What needs more than the loop: motions to play, clouds to read, maps to count. Only on the event loop."""
        match wish:
            case Play(motion):
                self.changing.play(motion)
            case Tour(real):
                self.survey.tour(real)
            case ReadCloud(name, content, plane):
                self.survey.read(name, content, plane)
            case CountMap():
                self.mapping.begin()
            case PlayTaught():
                self._replaying = self.loop.create_task(self._work_out(through))
            case PlayFastest():
                self._replaying = self.loop.create_task(self._work_out(along_fastest))

    async def _work_out(self, way: Callable[[State], Update]) -> None:
        """Work out a motion in a thread; a stop, or another wish, in the meantime ends it."""
        state = self.state
        wish = await asyncio.to_thread(way, state)
        if self.robot is state.robot and self.state.command is state.command:
            self.post(wish)

    def _drain(self) -> None:
        """Apply every wish in the inbox and show at once what they changed; the arm itself moves in ticks."""
        self._woken = False
        self._apply()
        if self._drawn is None or self._drawn.problem is not self.state.problem:
            self.draw()
        else:
            self._draw_windows()

    def _apply(self) -> None:
        while self.inbox:
            self.state = self._tried(self.inbox.popleft(), lambda state: state)

    def _tried(self, update: Update, otherwise: Update) -> State:
        """What an update makes of the state; when it fails, another one and a notice, with the reason in the log."""
        try:
            return update(self.state)
        except Exception:
            log.exception("an update failed and was skipped")
            return replace(otherwise(self.state), notice=FAILED)

    def _tick(self) -> None:
        """One hundredth of a second of the arm; no catching up after a delay."""
        if not self.ready:
            return
        self.next_tick = max(self.next_tick + TICK, self.loop.time())
        self.loop.call_at(self.next_tick, self._tick)
        self._apply()
        self.state = self._tried(lambda state: advance(state, TICK), otherwise=gate.stop())
        self.ticks += 1
        if self.ticks % TICKS_PER_FRAME == 0:
            self._frame()

    def _frame(self) -> None:
        """Foresee the goal where something changed, draw; check lessons and write words at a fifth of the rate."""
        if not self.windows:
            return
        if leads_elsewhere(self._foreseen, self.state):
            self.state = foreseen(self.state)
            self._foreseen = self.state
        self.draw()
        self.frames += 1
        if self.frames % FRAMES_PER_TEXT == 0:
            self._check_lessons()
            self._write()

    def _check_lessons(self) -> None:
        for token, seat in self.seats.items():
            if seat.lesson:
                try:
                    self.seats[token] = lesson.progressed(lesson.load(seat.lesson), self.state, seat)
                except Exception:
                    log.exception("the goal of lesson %s failed", seat.lesson)
                    self.seats[token] = replace(seat, lesson=None)

    def draw(self) -> None:
        """Bring scene and windows to the state, as one message to each browser."""
        with self.server.atomic():
            self.scene.update(View(self.state, NOBODY))
            self._drawn = self.state
            self._draw_windows()
        self.server.flush()

    def _draw_windows(self) -> None:
        """Bring what each window has for itself to the state."""
        for window in self.windows.values():
            window.draw(self.view(window.view.seat.token))

    def _write(self) -> None:
        for window in self.windows.values():
            window.write(self.view(window.view.seat.token))
        if not self.ready:
            self._say(self.said)
