"""The result of inverse kinematics in a notebook: every posture for a pose, as a sequence and as a table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

import numpy as np
from markupsafe import Markup

from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import Branch
from helicoide.ik.postures.solve import answer_status
from helicoide.kinematics.robot import Robot
from helicoide.teaching import tables
from helicoide.text import Language, Text

BRANCH, MISSED = Text(en="posture", pt_BR="postura"), Text(en="error", pt_BR="erro")
LIMITS = {
    True: Text(en="within the limits", pt_BR="dentro dos limites"),
    False: Text(en="outside the limits", pt_BR="fora dos limites"),
}


class InverseKinematics(Sequence[Branch]):
    """Every posture for a pose, the nearest first. Each has a `name`, its `q`, and its errors `missed` and `turned`.

    answer: the whole result, with the pose that was solved for and the values between.
    """

    def __init__(self, robot: Robot, answer: Answer, language: Language) -> None:
        self.robot, self.answer, self.language = robot, answer, language

    @overload
    def __getitem__(self, index: int) -> Branch: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Branch]: ...
    def __getitem__(self, index: int | slice) -> Branch | Sequence[Branch]:
        return self.answer.branches[index]

    def __len__(self) -> int:
        return len(self.answer.branches)

    def __repr__(self) -> str:
        return "\n".join([self._status(), *(f"{one.name[self.language]}: {np.round(one.q, 6)}" for one in self)])

    def _repr_html_(self) -> Markup:
        """What was found in words, and a table of the postures."""
        heads = [BRANCH[self.language], *(joint.name for joint in self.robot.variables), MISSED[self.language], ""]
        return Markup("<p>{}</p>").format(self._status()) + tables.table(heads, map(self._row, self))

    def _status(self) -> str:
        said, words = answer_status(self.answer)[self.language], self.answer.words[self.language]
        return f"{self.robot.name}: {said}. {words}".strip()

    def _row(self, branch: Branch) -> list[str]:
        def word(value: float, decimals: int) -> str:
            return tables.decimal_text(value, decimals, self.language)

        values = [
            f"{word(1000 * x, 2)} mm" if joint.is_prismatic else f"{word(float(np.degrees(x)), 2)}°"
            for joint, x in zip(self.robot.variables, branch.q.tolist(), strict=True)
        ]
        missed = f"{word(1000 * branch.missed, 4)} mm, {word(float(np.degrees(branch.turned)), 4)}°"
        return [branch.name[self.language], *values, missed, LIMITS[branch.within][self.language]]
