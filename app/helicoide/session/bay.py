"""The workcells of the lab, each with all that works for it and what its windows show."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

from helicoide.command import HoldPosition
from helicoide.kinematics.robot import Robot
from helicoide.session.arms import Arms, begun
from helicoide.session.display import Display
from helicoide.session.mapping import MapJob
from helicoide.session.postures import list_postures
from helicoide.session.replaying import along_fastest, replay_through
from helicoide.session.seats import Place
from helicoide.session.surveying import Surveying
from helicoide.session.workcell import Workcell
from helicoide.state import State, with_command
from helicoide.text import HelicoideError, Text
from helicoide.view import rows
from helicoide.view.rows import PageRequest
from helicoide.view.window import Window

MOST_OWN, MAPS = 64, 2  # arms of somebody's own; maps that are counted at once

FULL = Text(
    en="There are {n} arms of somebody's own already: more do not fit into this program.",
    pt_BR="Já há {n} braços próprios: não cabem mais neste programa.",
)


class Bay:
    """A workcell, its jobs, and its display, None while it has no windows. Only on the event loop.

    maps: how many maps of the lab may be counted at once; put_up: makes the display.
    """

    def __init__(self, workcell: Workcell, maps: asyncio.Semaphore, put_up: Callable[[Workcell], Display]) -> None:
        def now() -> State:
            return workcell.state

        self.workcell = workcell
        self.arms = Arms(workcell)
        self.survey = Surveying(now, workcell.tell)
        self.mapping = MapJob(now, workcell.tell, maps)
        self.display: Display | None = None
        self._put_up = put_up

    async def enter(self, window: Window) -> None:
        """One more window in front of it, unless it leaves before it may enter."""
        self.workcell.pause(False)
        if self.display is None:
            self.display = self._put_up(self.workcell)
        if not window.gone:
            await self.display.enter(window)
        if window.gone:
            self.leave(window)

    def leave(self, window: Window) -> None:
        """A window shows another workcell, or nothing any more."""
        if self.display is not None:
            self.display.leave(window)
            if self.display.empty:
                self.display.close()
                self.display = None

    def do(self, wish: PageRequest) -> None:
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
            case rows.ReadCloud(name, content, plane, unit):
                self.survey.read(name, content, plane, unit)
            case rows.CountMap(kind):
                self.mapping.begin(kind)
            case rows.ListPostures():
                self.arms.find(list_postures)
            case rows.PlayTaught():
                self.arms.work_out(replay_through)
            case rows.PlayFastest():
                self.arms.work_out(along_fastest)


class Bays:
    """The shared one, and those that are somebody's own.

    wake: called when a workcell has something to do; searcher: where searches run; put_up: makes what the windows of a
    workcell show. workcells: for the clock's thread, replaced as a whole.
    """

    def __init__(
        self,
        robot: Robot,
        wake: Callable[[], None],
        searcher: ThreadPoolExecutor,
        put_up: Callable[[Workcell], Display],
    ) -> None:
        self.wake, self.searcher, self.put_up = wake, searcher, put_up
        self.maps = asyncio.Semaphore(MAPS)
        self.all: dict[Workcell, Bay] = {}
        self.shared = self._add(begun(robot))

    def __iter__(self) -> Iterator[Bay]:
        return iter(tuple(self.all.values()))

    def _add(self, state: State) -> Bay:
        bay = Bay(Workcell(state, self.wake, self.searcher), self.maps, self.put_up)
        self.all[bay.workcell] = bay
        self.workcells = tuple(self.all)
        return bay

    def of(self, place: Place) -> Bay:
        """The one in front of which a person sits."""
        return self.shared if place.own is None or not place.at_own else self.all[place.own]

    def give(self, place: Place) -> None:
        """Give a person an arm of their own, at first a copy of the shared one.

        Raises HelicoideError where there are too many already.
        """
        if place.own is None:
            if len(self.all) > MOST_OWN:
                raise HelicoideError(FULL.format(n=MOST_OWN))
            copy = with_command(self.shared.workcell.state, HoldPosition())
            place.own = self._add(replace(copy, request=replace(copy.request, drag=None, goal=None))).workcell

    def keep(self, places: Iterable[Place]) -> None:
        """Forget those of places that are no more."""
        kept = {place.own for place in places} | {self.shared.workcell}
        self.all = {workcell: bay for workcell, bay in self.all.items() if workcell in kept}
        self.workcells = tuple(self.all)
