"""The workcells of the lab, each with its jobs and its display."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

from helicoide import gate
from helicoide.command import HoldPosition
from helicoide.history import History
from helicoide.kinematics.robot import Robot
from helicoide.session.arms import Arms, begun
from helicoide.session.display import Display, Supply
from helicoide.session.mapping import MapJob
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures, to_singular_posture
from helicoide.session.replaying import along_fastest
from helicoide.session.seats import Place
from helicoide.session.surveying import Surveying
from helicoide.session.workcell import Workcell
from helicoide.state import State, with_command
from helicoide.text import HelicoideError, Text
from helicoide.view import requests
from helicoide.view.layers import needed
from helicoide.view.requests import PageRequest
from helicoide.view.window import Window
from helicoide.view.window_view import View

MOST_OWN, MAPS = 64, 2  # most own arms; most maps that are computed at once

FULL = Text(
    en="All {n} separate arms are in use; use the shared arm.",
    pt_BR="Todos os {n} braços próprios estão em uso; use o braço comum.",
)


PutUp = Callable[[Workcell, Supply], Display]


class Bay:
    """A workcell, its jobs, and its display, None while it has no windows. Use it only on the event loop.

    maps: limits the number of maps that the lab computes at once; put_up: makes the display.
    """

    def __init__(self, workcell: Workcell, maps: asyncio.Semaphore, put_up: PutUp) -> None:
        def now() -> State:
            return workcell.state

        self.workcell = workcell
        self.arms = Arms(workcell)
        self.survey = Surveying(now, workcell.tell)
        self.mapping = MapJob(now, workcell.tell, maps)
        self.display: Display | None = None
        self._put_up = put_up
        self._supplied: tuple[object, ...] = ()

    async def enter(self, window: Window) -> None:
        """Show the workcell in one more window, unless the window closes first."""
        self.workcell.pause(False)
        if self.display is None:
            self.display = self._put_up(self.workcell, self.supply)
        if not window.gone:
            await self.display.enter(window)
        if window.gone:
            self.leave(window)

    def leave(self, window: Window) -> None:
        """Remove a window that moves to another workcell or has closed."""
        if self.display is not None:
            self.display.leave(window)
            if self.display.empty:
                self.display.close()
                self.display = None

    def supply(self, view: View) -> None:
        """Have computed what the layers of a view need, once for each command."""
        for request in needed(view):
            asked = view.state.request
            key = request, view.state.robot, asked.command, asked.with_orientation
            if key != self._supplied:
                self._supplied = key
                self.do(request)

    def finish_change(self) -> None:
        """Let the next change of the scene be one of its own."""
        if self.workcell.state.history.unfinished:
            self.workcell.tell(gate.finish_change())

    def do(self, request: PageRequest) -> None:
        """Carry out a request about the arm or its scene."""
        match request:
            case requests.ForArm(update):
                self.workcell.ask(update)
            case requests.Undo():
                self.workcell.ask(lambda state: gate.undo_change(self.workcell.connected)(state))
            case requests.Redo():
                self.workcell.ask(lambda state: gate.redo_change(self.workcell.connected)(state))
            case requests.ForLab(robot):
                self.arms.change(robot)
            case requests.Play(motion):
                self.arms.play(motion)
            case requests.Tour(real):
                self.survey.tour(real)
            case requests.ReadCloud(name, content, plane, unit):
                self.survey.read(name, content, plane, unit)
            case requests.CountMap(kind):
                self.mapping.begin(kind)
            case requests.ListPostures():
                self.arms.find(list_postures)
            case requests.PlanMotion(update, title):
                self.arms.find(lambda state: plan_motion(state, update, title))
            case requests.TrySingular():
                self.arms.work_out(to_singular_posture)
            case requests.PlayTaught():
                self.arms.work_out(gate.replay_through)
            case requests.PlayFastest():
                self.arms.work_out(along_fastest)


class Bays:
    """The bay of the shared workcell, and those of own workcells.

    wake: called when a workcell has something to do; searcher: runs posture searches; put_up: makes the display of a
    workcell; workcells: all workcells, for the clock's thread, replaced as a whole.
    """

    def __init__(
        self,
        robot: Robot,
        wake: Callable[[], None],
        searcher: ThreadPoolExecutor,
        put_up: PutUp,
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
        """The bay that a place shows: its own, or the shared one."""
        return self.shared if place.own is None or not place.at_own else self.all[place.own]

    def give(self, place: Place) -> None:
        """Give a place its own arm, at first a copy of the shared one.

        Raises HelicoideError if there are too many own arms already.
        """
        if place.own is None:
            if len(self.all) > MOST_OWN:
                raise HelicoideError(FULL.format(n=MOST_OWN))
            copy = with_command(self.shared.workcell.state, HoldPosition())
            request = replace(copy.request, drag=None, goal=None)
            place.own = self._add(replace(copy, request=request, history=History())).workcell

    def keep(self, places: Iterable[Place]) -> None:
        """Keep the own workcells of these places, and remove all others."""
        kept = {place.own for place in places} | {self.shared.workcell}
        self.all = {workcell: bay for workcell, bay in self.all.items() if workcell in kept}
        self.workcells = tuple(self.all)
