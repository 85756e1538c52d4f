"""An arm in a notebook: its named postures, the arm at a posture, and every posture for a pose of its end effector."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.commands import language as of_terminal
from helicoide.geometry.multivector import Multivector
from helicoide.ik.postures.solve import solve, solve_by
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.teaching import tables
from helicoide.teaching.elements import pose_of
from helicoide.teaching.inverse import InverseKinematics
from helicoide.teaching.posture import ArmAtPosture, state_at
from helicoide.text import HelicoideError, Language, Text

NO_POSTURE = Text(
    en="{robot} has no posture {name!r}; postures: {known}. Or give the joint values.",
    pt_BR="{robot} não tem a postura {name!r}; posturas: {known}. Ou dê os valores das juntas.",
)
HEADS = (
    Text(en="joint", pt_BR="junta"),
    Text(en="lower limit", pt_BR="limite inferior"),
    Text(en="upper limit", pt_BR="limite superior"),
    Text(en="speed", pt_BR="velocidade"),
)


def robot(
    name: str,
    language: Language | None = None,
    tip: str | None = None,
    base: str | None = None,
    parameters: Mapping[str, float] | None = None,
) -> TeachingArm:
    """An arm by its name, such as "puma560", or by the path of a URDF file.

    language: in which its tables are written, "en" or "pt_BR"; that of the terminal if none; tip and base: the links of
    a URDF where the arm ends and begins; parameters: lengths of its file to change, mm, by name.
    Raises HelicoideError, which lists the names there are.
    """
    settings = [f"{length}={float(mm)!r}" for length, mm in (parameters or {}).items()]
    return TeachingArm(load_robot(name, tip, settings, base), language or of_terminal())


@dataclass(frozen=True, eq=False)
class TeachingArm:
    """An arm. Joint values q (n,) are in rad, or in m where a joint slides; poses (4, 4) are in m."""

    robot: Robot
    language: Language

    @property
    def postures(self) -> Mapping[str, Array]:
        """The named postures of its file, each (n,): "ready", and others."""
        return self.robot.poses

    def at(self, q: ArrayLike | str, planes: Mapping[str, Multivector] | None = None) -> ArmAtPosture:
        """The arm at joint values (n,), or at a named posture.

        planes: by name, instead of those of its file. Raises HelicoideError for anything else.
        """
        return ArmAtPosture(state_at(self.robot, self._joints(q), planes), self.language)

    def inverse(
        self,
        goal: ArrayLike | Multivector,
        start: ArrayLike | str = "ready",
        orientation: bool = True,
        by: str | None = None,
    ) -> InverseKinematics:
        """Every posture that brings the end effector to a pose, (4, 4) or a motor, the nearest to `start` first.

        orientation: whether it counts, or the position alone; by: a closed form, a method that iterates from `start`,
        or "numeric"; the best closed form if none. An arm with fewer than six joints goes to the nearest pose that it
        can take. Raises HelicoideError for an invalid pose, and lists the names that are valid for `by`.
        """
        asked = (self.robot, pose_of(goal), self._joints(start), True, orientation)
        return InverseKinematics(self.robot, solve(*asked) if by is None else solve_by(by, *asked), self.language)

    def _joints(self, q: ArrayLike | str) -> Array:
        if not isinstance(q, str):
            return self.robot.check_joints(q)
        if q not in self.robot.poses:
            known = ", ".join(self.robot.poses)
            raise HelicoideError(NO_POSTURE.format(robot=self.robot.name, name=q, known=known))
        return self.robot.poses[q]

    def __repr__(self) -> str:
        return f"{self.robot.title[self.language]}: {', '.join(joint.name for joint in self.robot.variables)}"

    def _repr_html_(self) -> Markup:
        """Title, source, and a table of the joints."""
        title = Markup("<p><b>{}</b>. {}</p>").format(self.robot.title[self.language], self.robot.source)
        rows = []
        for joint in self.robot.variables:
            scale, unit = (1000.0, " mm") if joint.is_prismatic else (float(np.degrees(1.0)), "°")
            limits = (joint.lower, joint.upper, joint.speed)
            words = [tables.decimal_text(scale * x, 1, self.language) + unit for x in limits]
            rows.append((f"{joint.name}: {joint.title[self.language]}", *words[:2], words[2] + "/s"))
        return title + tables.table([head[self.language] for head in HEADS], rows)
