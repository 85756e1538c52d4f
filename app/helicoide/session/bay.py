"""A workcell with all that works for it, and what its windows show."""

from __future__ import annotations

import asyncio

from helicoide.session.arms import Arms
from helicoide.session.display import Display
from helicoide.session.mapping import Mapping
from helicoide.session.replaying import along_fastest, through
from helicoide.session.surveying import Surveying
from helicoide.session.workcell import Workcell
from helicoide.state import State
from helicoide.view import rows
from helicoide.view.rows import Wish


class Bay:
    """Its jobs, and its display, None while it has no windows. Only on the event loop.

    maps: how many maps of the lab may be counted at once.
    """

    def __init__(self, workcell: Workcell, maps: asyncio.Semaphore) -> None:
        def now() -> State:
            return workcell.state

        self.workcell = workcell
        self.arms = Arms(workcell)
        self.survey = Surveying(now, workcell.tell)
        self.mapping = Mapping(now, workcell.tell, maps)
        self.display: Display | None = None

    def do(self, wish: Wish) -> None:
        """Do what is wished of the arm and its scene."""
        match wish:
            case rows.ForArm(update):
                self.workcell.ask(update)
            case rows.ForLab(robot):
                self.arms.change(robot)
            case rows.Play(motion):
                self.arms.play(motion)
            case rows.Tour(real):
                self.survey.tour(real)
            case rows.ReadCloud(name, content, plane):
                self.survey.read(name, content, plane)
            case rows.CountMap(kind):
                self.mapping.begin(kind)
            case rows.PlayTaught():
                self.arms.work_out(through)
            case rows.PlayFastest():
                self.arms.work_out(along_fastest)
