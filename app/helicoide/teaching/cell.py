"""The lab in a cell of a notebook: a server of its own in the background, shown in a frame."""

from __future__ import annotations

import atexit

from markupsafe import Markup
from numpy.typing import ArrayLike

from helicoide import gate
from helicoide.arrays import Array
from helicoide.commands import language as of_terminal
from helicoide.geometry import rotation
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.library import load_robot, register_robot
from helicoide.kinematics.robot import Robot
from helicoide.session.lab import Lab
from helicoide.state import State, Update
from helicoide.teaching.arm import TeachingArm
from helicoide.teaching.elements import pose_of
from helicoide.text import HelicoideError, Language, Text

HOST = "127.0.0.1"
FRAME = Markup('<iframe src="{url}" title="Helicoide" width="100%" height="600" style="border:0"></iframe>')
CLOSED = Text(en="This lab is closed. helicoide.lab(…) opens another one.", pt_BR="Este laboratório está fechado.")


def lab(robot: str | TeachingArm = "movemaster", language: Language | None = None) -> LabCell:
    """The lab with an arm, as the last line of a cell. It listens on a free port of this computer alone.

    language: of new windows, "en" or "pt_BR"; that of the browser if none. Each call opens another lab, which runs
    until it is closed or the kernel ends. Raises HelicoideError, which lists the robots there are.
    """
    return LabCell(robot.robot if isinstance(robot, TeachingArm) else load_robot(robot), language)


class LabCell:
    """A running lab. What is asked of it here goes through the same checks as what is asked in its page."""

    def __init__(self, robot: Robot, language: Language | None) -> None:
        register_robot(robot)
        self.language = language or of_terminal()
        self._lab = Lab(robot, language, None)
        self.url = f"http://{HOST}:{self._lab.open(HOST, 0, framed=True)}/"
        self._open = True
        atexit.register(self.close)

    @property
    def state(self) -> State:
        """The arm and its scene at this instant."""
        return self._lab.shared.workcell.state

    @property
    def q(self) -> Array:
        """The joint values now, (n,), rad or m. Set them to ask the arm to go there."""
        return self.state.arm.q

    @q.setter
    def q(self, q: ArrayLike) -> None:
        self._ask(gate.set_joints(q))

    @property
    def target(self) -> Array:
        """The pose of the end effector now, (4, 4), m. Set it, as a matrix or a motor, to ask for another one."""
        return self.state.T_world_tool

    @target.setter
    def target(self, target: ArrayLike | Multivector) -> None:
        T = pose_of(target)
        self._ask(gate.set_target(T[:3, 3], rotation.from_matrix(T[:3, :3])))

    def stop(self) -> None:
        """Stop all motion, as Esc does in the page."""
        self._lab.shared.workcell.stop()

    def close(self) -> None:
        """End the lab and its server. Closing it again does nothing."""
        if self._open:
            self._open = False
            atexit.unregister(self.close)
            self._lab.close()

    def _ask(self, update: Update) -> None:
        """Ask the arm. Raises HelicoideError with the reason for which the lab would refuse."""
        if not self._open:
            raise HelicoideError(CLOSED)
        state = self.state  # once: the clock replaces it meanwhile
        tried = update(state)
        if tried.request is state.request and tried.notice is not None:
            raise HelicoideError(tried.notice)
        self._lab.shared.workcell.ask(update)

    def __repr__(self) -> str:
        return f"Helicoide: {self.url}" if self._open else CLOSED[self.language]

    def _repr_html_(self) -> Markup:
        """The page of the lab in a frame."""
        return FRAME.format(url=self.url) if self._open else Markup("<p>{}</p>").format(CLOSED[self.language])
