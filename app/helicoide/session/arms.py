"""Load another robot into a workcell, and compute motions and posture lists for it, in threads."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine, Sequence
from dataclasses import replace
from typing import Any, TypeVar

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
    en="The files of {robot} have errors: {fault}. The Robot tab lists all of them.",
    pt_BR="Os arquivos de {robot} têm erros: {fault}. A aba Robô lista todos.",
)
PLAYED = Text(en="Playing the study", pt_BR="Reproduzindo o estudo")
COMPUTING = Text(en="Computing…", pt_BR="Calculando…")
LOADING = Text(en="Loading the arm…", pt_BR="Carregando o braço…")
SOON = 0.2  # s: what takes less needs no words
T = TypeVar("T")
log = logging.getLogger("helicoide")


class Arms:
    """Loads robots and computes motions for one workcell. Use it only on the event loop.

    wanted: name of the robot that is being loaded or was loaded last; empty if that failed.
    """

    def __init__(self, workcell: Workcell) -> None:
        self.workcell = workcell
        self.wanted = ""
        self._tasks: set[asyncio.Task[None]] = set()

    def play(self, motion: Motion) -> None:
        """Replay a motion on its own robot, which is loaded first if necessary."""
        update, (name, lengths) = gate.replay_motion(motion.times, motion.q, PLAYED), (motion.robot, motion.parameters)
        if self.workcell.state.robot.name == name and not lengths:
            self.workcell.ask(update)
        else:
            self.change(name, lengths, update)

    def go_to(self, robot_name: str, q: Sequence[float]) -> None:
        """Bring a robot to joint values q, rad or m. Another robot is loaded first."""
        if self.workcell.state.robot.name == robot_name:
            self.workcell.ask(gate.set_joints(q))
        else:
            self.change(robot_name, then=gate.set_joints(q))

    def change(self, robot_name: str, lengths: tuple[str, ...] = (), then: Update | None = None) -> None:
        """Load another robot into the workcell, and then apply an update to it.

        lengths: parameters of the robot, as `load_robot` takes them.
        """
        self.wanted = robot_name
        self._begin(self._change(robot_name, lengths, then))

    def work_out(self, way: Callable[[State], Update]) -> None:
        """Compute a motion, and start it unless something else is asked in the meantime."""
        self._begin(self._work_out(way, gate.while_asked))

    def find(self, way: Callable[[State], Update]) -> None:
        """Compute something to show for this arm, whatever the arm does in the meantime."""
        self._begin(self._work_out(way, gate.while_there))

    def _begin(self, work: Coroutine[Any, Any, None]) -> None:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _computed(self, words: Text, way: Callable[..., T], *args: object) -> T:
        """The result of a function in a thread. The status line says `words` if it takes longer than `SOON`."""
        task = asyncio.create_task(asyncio.to_thread(way, *args))
        await asyncio.wait({task}, timeout=SOON)
        if task.done():
            return task.result()
        self.workcell.tell(gate.say(words))
        try:
            return await task
        finally:
            self.workcell.tell(gate.unsay(words))

    async def _work_out(self, way: Callable[[State], Update], unless: Callable[[State, Update], Update]) -> None:
        state = self.workcell.state
        try:
            update = await self._computed(COMPUTING, way, state)
        except Exception:
            log.exception("what was asked could not be worked out")
            update = gate.say(FAILED)
        self.workcell.ask(unless(state, update))

    async def _change(self, robot_name: str, lengths: tuple[str, ...], then: Update | None) -> None:
        """Load a robot. If that fails, say why and keep the old one."""
        before = self.workcell.state
        try:
            robot = await self._computed(LOADING, _loaded, robot_name, lengths)
        except Exception as error:
            if robot_name == self.wanted:
                self.wanted = ""
            log.warning("%s was not put up", robot_name, exc_info=not isinstance(error, HelicoideError))
            self.workcell.tell(gate.say(error.text if isinstance(error, HelicoideError) else FAILED))
            return
        if robot_name == self.wanted:
            self.workcell.tell(_put_up(robot, before, then))


def _loaded(robot_name: str, lengths: tuple[str, ...]) -> Robot:
    """The robot. What is needed to draw and to drive it is computed in advance."""
    robot = load_robot(robot_name, None, lengths)
    shapes.load_shapes(robot)
    remarks_and_faults(robot)  # cached here, so that the panel does not wait for files
    for fault in faults(robot):
        log.warning("%s: %s", robot.name, fault.en)
    rehearse(robot)
    return robot


def begun(robot: Robot) -> State:
    """The state of a robot at `ready`. If its files have faults, the notice gives the first one."""
    state, wrong = initial_state(robot), faults(robot)
    if not wrong:
        return state
    return replace(state, notice=WRONG_FILES.format(robot=robot.title, fault=wrong[0]))


def _put_up(robot: Robot, before: State, then: Update | None) -> Update:
    """The update to the new robot at `ready`. `then` is applied unless the command has changed since `before`."""

    def update(state: State) -> State:
        fresh = begun(robot)
        return fresh if then is None or state.request.command is not before.request.command else then(fresh)

    return update
