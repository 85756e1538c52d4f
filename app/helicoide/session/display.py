"""The display of one workcell: it draws the scene and updates the rows of its windows, with pauses for other tasks."""

from __future__ import annotations

import asyncio
import logging
from collections import deque
from collections.abc import Callable
from dataclasses import replace

from helicoide.kinematics.robot import Robot
from helicoide.readout import status
from helicoide.session.workcell import Workcell
from helicoide.state import State
from helicoide.view import shapes
from helicoide.view.audience import Audience, Server
from helicoide.view.channel import ControlChannel, Notice
from helicoide.view.layers import any_moves
from helicoide.view.scene import NOBODY, Scene
from helicoide.view.window import CLEARED, Window
from helicoide.view.window_view import View

# s: the shortest time between two frames, and between two updates of rows
FRAME, WORDS = 0.016, 0.2
MOVES = 0.05  # s between two frames if the arm is at rest and a layer moves by itself
# Pauses after drawing and after writing, as multiples of the time that these took.
SPARE, SPARE_WORDS = 0.3, 3.0
# s: the length of the clip of the last seconds, and the time between its frames
CLIP_SECONDS, CLIP_STEP = 12.0, 0.04

Supply = Callable[[View], None]
log = logging.getLogger("helicoide")


class Display:
    """The windows of a workcell, and two tasks: one draws the scene, the other updates rows and status lines.

    view: returns what a window shows now; arrived: called when another robot was loaded, before the windows are filled
    for it; pen: a lock, so that only one window of the lab is written at a time; supply: has computed what the layers
    of a view need.
    """

    def __init__(
        self,
        server: Server,
        control: ControlChannel,
        workcell: Workcell,
        view: Callable[[Window], View],
        arrived: Callable[[Display], None],
        pen: asyncio.Lock,
        supply: Supply,
    ) -> None:
        self.control, self.workcell, self.view, self.arrived, self.supply = control, workcell, view, arrived, supply
        self._pen = pen
        self.audience = Audience(server)
        self.windows: list[Window] = []
        self._entering: set[Window] = set()
        self.frames = 0
        self.recent: deque[State] = deque()  # the states that were drawn in the last seconds, for a clip
        self.news = asyncio.Event()  # set when rows may be out of date
        self._moved = asyncio.Event()  # set when the scene may be out of date
        self._again: asyncio.TimerHandle | None = None  # of the next frame, if a layer moves by itself
        self._putting_up = asyncio.Lock()
        self._scene: Scene | None = None
        self._drawn: tuple[Robot | None, object] = (None, None)
        self._tasks = [asyncio.create_task(work) for work in (self._draw(), self._write())]

    @property
    def empty(self) -> bool:
        """Whether no window shows the workcell or is about to show it."""
        return not self.windows and not self._entering

    def close(self) -> None:
        """End both tasks."""
        if self._again is not None:
            self._again.cancel()
        for task in self._tasks:
            task.cancel()

    def tell(self) -> None:
        """Have the windows redrawn if the state of the workcell has changed."""
        if self.windows and self._drawn[1] is not self.workcell.state:
            self.redraw()

    def redraw(self) -> None:
        """Have the scene and the rows of all windows updated."""
        self._moved.set()
        self.news.set()

    async def enter(self, window: Window) -> None:
        """Add a window and draw the current scene in it, unless the window leaves first."""
        self._entering.add(window)
        try:
            async with self._putting_up:
                await self._up_to_date()
                if window not in self._entering:
                    return
                self.audience.enter(window.client)
                self.windows.append(window)
                view = self.view(window)
                if view.state.robot is self._drawn[0]:  # otherwise `_up_to_date` stages it with the others
                    window.stage(view, shapes.load_shapes(view.state.robot))
                    window.draw(view)
                    if window.robot is not view.state.robot:  # the robot has changed since it was furnished
                        await window.fill(view)
        finally:
            self._entering.discard(window)
        self.redraw()

    def leave(self, window: Window) -> None:
        """Remove a window that moves to another workcell or has closed."""
        self._entering.discard(window)
        if window in self.windows:
            self.windows.remove(window)
            self.audience.leave(window.client, shown=not window.gone)

    async def _draw(self) -> None:
        """Draw a frame whenever something has moved, each followed by a pause for other tasks."""
        clock = asyncio.get_running_loop().time
        while True:
            await self._moved.wait()
            self._moved.clear()
            began = clock()
            if self.windows:
                try:
                    async with self._putting_up:
                        await self._frame(await self._up_to_date())
                except Exception:
                    log.exception("a frame could not be drawn")
            took = clock() - began
            await asyncio.sleep(max(FRAME - took, SPARE * took))

    async def _frame(self, state: State) -> None:
        """Draw the shared scene, then the layers of each window, unless that has another robot by now."""
        self._drawn = state.robot, state
        self.frames += 1
        self._remember(state)
        assert self._scene is not None
        with self.audience.atomic():
            self._scene.update(View(state, NOBODY))
        moves = False
        for window in tuple(self.windows):
            if window in self.windows and (view := self.view(window)).state.robot is state.robot:
                window.draw(view)
                self.supply(view)
                moves = moves or any_moves(view)
            window.client.flush()  # the server's own flush does not send messages to one client
            await asyncio.sleep(0)
        if self._again is not None:
            self._again.cancel()
        if moves:
            self._again = asyncio.get_running_loop().call_later(MOVES, self._moved.set)

    def _remember(self, state: State) -> None:
        """Keep a state for a clip; those of another robot, or of a time that did not lead here, are dropped."""
        recent = self.recent
        if recent and (recent[-1].robot is not state.robot or recent[-1].t > state.t):
            recent.clear()
        if not recent or state.t - recent[-1].t >= CLIP_STEP:
            recent.append(state)
        while state.t - recent[0].t > CLIP_SECONDS:
            recent.popleft()

    async def _up_to_date(self) -> State:
        """Build the scene and fill the windows for the current robot, if another one is drawn; returns the state."""
        while (robot := (state := self.workcell.state).robot) is not self._drawn[0]:
            if self._scene is not None:
                self.audience.scene.reset()
                for window in self.windows:
                    window.clear()
                    window.client.flush()
                await asyncio.sleep(CLEARED)
                self.arrived(self)
            drawn = await asyncio.to_thread(shapes.load_shapes, robot)
            with self.audience.atomic():
                self._scene = Scene(self.audience.scene, robot, drawn)
                self._scene.update(View(state, NOBODY))
            self._drawn = robot, None
            for window in tuple(self.windows):
                if window in self.windows:  # it may leave while others are filled
                    view = replace(self.view(window), state=state)
                    window.stage(view, drawn)
                    await window.fill(view)
        return state

    async def _write(self) -> None:
        """Update the rows, one window of the lab at a time, each followed by a pause of `SPARE_WORDS` times as long."""
        clock = asyncio.get_running_loop().time
        while True:
            await self.news.wait()
            self.news.clear()
            begins = clock()
            for window in tuple(self.windows):
                async with self._pen:
                    if window in self.windows:
                        await asyncio.sleep(SPARE_WORDS * await self._written(window))
            await asyncio.sleep(begins + WORDS - clock())

    def _say(self, window: Window, view: View) -> None:
        """Update the status line. Until the kernels are compiled, `Lab` writes it."""
        if view.ready:
            said = status(view.state)
            seat, everywhere = view.seat, self.workcell.connected
            notice = Notice(seat.language, said.text, said.tone, everywhere, seat.projector, seat.transparent)
            self.control.push(window.link.key, notice)

    async def _written(self, window: Window) -> float:
        """Update the rows and the status line of a window; returns the time that this took, s."""
        try:
            view = self.view(window)
            if view.state.robot is self._drawn[0]:
                self._say(window, view)
                return await window.write(view)
        except Exception:
            log.exception("the words of a window could not be written")
        return 0.0
