"""Another arm in a workcell, and what is worked out before it begins or is shown: in threads, and a stop ends it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine
from dataclasses import replace
from typing import Any

from helicoide import gate
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_faults import faults, remarks_and_faults
from helicoide.session.preparing import rehearse
from helicoide.session.workcell import FAILED, Workcell
from helicoide.state import State, Update, initial_state
from helicoide.studies.study import Motion
from helicoide.text import HelicoideError, Text
from helicoide.view import shapes

WRONG_FILES = Text(
    en="Something is wrong in the files of {robot}: {fault}. The Robot tab has all of it.",
    pt_BR="Há algo errado nos arquivos de {robot}: {fault}. A aba Robô mostra tudo.",
)
PLAYED = Text(en="Playing the study", pt_BR="Reproduzindo o estudo")
log = logging.getLogger("helicoide")


class Arms:
    """What brings arms and motions into one workcell. Only on the event loop.

    wanted: the robot that is on its way, or came last; nothing where it could not come.
    """

    def __init__(self, workcell: Workcell) -> None:
        self.workcell = workcell
        self.wanted = ""
        self._tasks: set[asyncio.Task[None]] = set()

    def play(self, motion: Motion) -> None:
        """Play what an arm did, on that arm."""
        wish, (name, lengths) = gate.replay_motion(motion.times, motion.q, PLAYED), (motion.robot, motion.parameters)
        if self.workcell.state.robot.name == name and not lengths:
            self.workcell.ask(wish)
        else:
            self.change(name, lengths, wish)

    def change(self, robot_name: str, lengths: tuple[str, ...] = (), then: Update | None = None) -> None:
        """Put another robot there, as soon as it is loaded, and post a wish to it.

        lengths: parameters of the robot, as `load` takes them.
        """
        self.wanted = robot_name
        self._begin(self._change(robot_name, lengths, then))

    def work_out(self, way: Callable[[State], Update]) -> None:
        """Work out a motion, which begins unless something else is asked in the meantime."""
        self._begin(self._work_out(way, gate.while_asked))

    def find(self, way: Callable[[State], Update]) -> None:
        """Find what is to be shown of this arm, whatever it does meanwhile."""
        self._begin(self._work_out(way, gate.while_there))

    def _begin(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _work_out(self, way: Callable[[State], Update], unless: Callable[[State, Update], Update]) -> None:
        state = self.workcell.state
        try:
            wish = await asyncio.to_thread(way, state)
        except Exception:
            log.exception("what was asked could not be worked out")
            wish = gate.say(FAILED)
        self.workcell.ask(unless(state, wish))

    async def _change(self, robot_name: str, lengths: tuple[str, ...], then: Update | None) -> None:
        """Load a robot; what is wrong with it is said, and the old one stays."""
        before = self.workcell.state
        try:
            robot = await asyncio.to_thread(_loaded, robot_name, lengths)
        except Exception as error:
            if robot_name == self.wanted:
                self.wanted = ""
            log.warning("%s was not put up", robot_name, exc_info=not isinstance(error, HelicoideError))
            self.workcell.tell(gate.say(error.text if isinstance(error, HelicoideError) else FAILED))
            return
        if robot_name == self.wanted:
            self.workcell.tell(_put_up(robot, before, then))


def _loaded(robot_name: str, lengths: tuple[str, ...]) -> Robot:
    """The robot, with all that is needed to draw and to drive it."""
    robot = load_robot(robot_name, None, lengths)
    shapes.load_shapes(robot)
    remarks_and_faults(robot)  # its panel shows them, and does not wait for files
    for fault in faults(robot):
        log.warning("%s: %s", robot.name, fault.en)
    rehearse(robot)
    return robot


def begun(robot: Robot) -> State:
    """A robot at `ready`; where something is wrong in its files, its notice says so."""
    state, wrong = initial_state(robot), faults(robot)
    if not wrong:
        return state
    return replace(state, notice=WRONG_FILES.format(robot=robot.title, fault=wrong[0]))


def _put_up(robot: Robot, before: State, then: Update | None) -> Update:
    """The new robot at `ready`; the wish for it is done unless something else was asked since it was wished."""

    def update(state: State) -> State:
        fresh = begun(robot)
        return fresh if then is None or state.request.command is not before.request.command else then(fresh)

    return update
