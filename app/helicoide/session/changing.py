"""Another arm in front of everybody: loaded in a thread, then put up in place of the old one in every window."""

from __future__ import annotations

import asyncio
import logging
from collections import deque
from dataclasses import replace
from typing import Protocol

from helicoide import gate, lesson
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.session.preparing import rehearse
from helicoide.state import Seat, State, Update, initial
from helicoide.studies.study import Motion
from helicoide.text import HelicoideError, Text
from helicoide.view import shapes
from helicoide.view.rows import View
from helicoide.view.scene import Scene, Server
from helicoide.view.window import Window

CLEARED = 0.15
PLAYED = Text(en="Playing the study", pt_BR="Reproduzindo o estudo")
FAILED = Text(
    en="Something went wrong inside; see the terminal.",
    pt_BR="Algo deu errado por dentro; veja o terminal.",
)
log = logging.getLogger("helicoide")


class Lab(Protocol):
    """What belongs to the arm of a session, and so changes with it."""

    robot: Robot
    shapes: list[shapes.Shape]
    state: State
    seats: dict[str, Seat]
    windows: dict[int, Window]
    inbox: deque[Update]
    server: Server
    scene: Scene

    def post(self, update: Update) -> None:
        """Put a wish into the inbox."""

    def view(self, token: str) -> View:
        """What a person sees."""

    def draw(self) -> None:
        """Bring scene and windows to the state."""


class Changing:
    """What puts another arm into a lab. Only on the event loop."""

    def __init__(self, lab: Lab) -> None:
        self.lab = lab

    def play(self, motion: Motion) -> None:
        """Play what an arm did, on that arm."""
        wish, (name, lengths) = gate.replay_motion(motion.times, motion.q, PLAYED), (motion.robot, motion.parameters)
        if self.lab.robot.name == name and not lengths:
            self.lab.post(wish)
        else:
            self.change(name, lengths, wish)

    def change(self, robot_name: str, lengths: tuple[str, ...] = (), then: Update | None = None) -> None:
        """Put another robot in front of everybody, as soon as it is loaded, and post a wish to it.

        lengths: parameters of the robot, as `load` takes them.
        """
        self._wanted = robot_name
        self._task = asyncio.get_running_loop().create_task(self._change(robot_name, lengths, then))

    async def _change(self, robot_name: str, lengths: tuple[str, ...], then: Update | None) -> None:
        """Load a robot in a thread; what is wrong with it is said, and the old one stays."""
        before = self.lab.state.command
        try:
            robot = await asyncio.to_thread(load, robot_name, None, lengths)
            drawn = await asyncio.to_thread(shapes.load, robot)
            await asyncio.to_thread(rehearse, robot)
        except Exception as error:
            log.warning("%s was not put up", robot_name, exc_info=not isinstance(error, HelicoideError))
            words = error.text if isinstance(error, HelicoideError) else FAILED
            self.lab.post(lambda state: replace(state, notice=words))
            return
        if robot_name == self._wanted:
            stopped = self.lab.state.command is not before
            await self._clear()
            self._mount(robot, drawn)
            if then is not None and not stopped:
                self.lab.post(then)

    async def _clear(self) -> None:
        """Clear the scenes, and let the browsers have that: a node put back in the same message keeps its old pose."""
        self.lab.scene.clear(self.lab.server)
        for window in self.lab.windows.values():
            window.clear()
        self.lab.server.flush()
        await asyncio.sleep(CLEARED)

    def _mount(self, robot: Robot, drawn: list[shapes.Shape]) -> None:
        """The new robot at `ready`; lessons about another robot are left."""
        lab = self.lab
        lab.robot, lab.shapes, lab.state = robot, drawn, initial(robot)
        lab.inbox.clear()
        lab.seats = {token: _seated_at(robot, seat) for token, seat in lab.seats.items()}
        with lab.server.atomic():
            lab.scene = Scene(lab.server, robot, drawn)
            for window in lab.windows.values():
                window.mount(robot, drawn, lab.view(window.view.seat.token))
        lab.draw()
        for seat in lab.seats.values():
            if seat.lesson:
                lab.post(lesson.load(seat.lesson).steps[seat.step].setup)


def _seated_at(robot: Robot, seat: Seat) -> Seat:
    """The seat in front of another robot: nothing selected, and in a lesson only where that is about this robot."""
    stays = seat.lesson is not None and lesson.load(seat.lesson).robot == robot.name
    return replace(seat if stays else lesson.entered(seat, None), selected=None, picked=None)
