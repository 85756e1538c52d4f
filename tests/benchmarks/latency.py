"""From a gizmo's event to the first scene message that shows it, beside the least that viser can do."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field
from time import perf_counter

import numpy as np
from tests.benchmarks.report import p50, spread, verdict
from tests.benchmarks.served import served
from tests.pages import Page, Point, opened, single

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.kinematics.library import load_robot
from helicoide.state import initial_state

TITLE = "Gizmo event to the first scene message that shows it"
GOAL = 1.5
RADIUS = 0.04
EVENTS_PER_LAP = 60
AT_MOST = 1.0


@dataclass
class Hand:
    """A hand that drags the target of one page around a circle, and notes how long each event took to show.

    An event shows when a scene message carries its position, or that of a later event.
    """

    page: Page
    T_world_target: Array
    took: list[float] = field(default_factory=list)
    sent: dict[Point, float] = field(default_factory=dict)
    events: int = 0

    async def drag(self, events: int, period: float) -> None:
        """Press, move at a fixed rate, release; ends when the last event shows."""
        self.page.shown = self._shown
        await self.page.gizmo("DragStart")
        next_event = perf_counter()
        for _ in range(events):
            position, wxyz = self._pose()
            self.sent[position] = perf_counter()
            await self.page.gizmo("Update", position=position, wxyz=wxyz)
            next_event += period
            await asyncio.sleep(max(0.0, next_event - perf_counter()))
        while self.sent and perf_counter() < next_event + AT_MOST:
            await asyncio.sleep(0.005)
        await self.page.gizmo("DragEnd")
        self._give_up()

    def _pose(self) -> tuple[Point, Point]:
        self.events += 1
        angle = 2 * np.pi * self.events / EVENTS_PER_LAP
        offset = [0.0, np.cos(angle), np.sin(angle)]
        position = single(self.T_world_target[:3, 3] + RADIUS * np.array(offset))
        return position, tuple(map(float, rotation.from_matrix(self.T_world_target[:3, :3])))

    def _shown(self, when: float, point: Point) -> None:
        if point not in self.sent:
            return
        for earlier in list(self.sent):
            self.took.append(1000 * (when - self.sent.pop(earlier)))
            if earlier == point:
                return

    def _give_up(self) -> None:
        self.took += [1000 * AT_MOST] * len(self.sent)
        self.sent.clear()


async def _measure(helicoide: int, echo: int) -> None:
    T_world_target = initial_state(load_robot("movemaster")).T_world_tool
    async with opened(helicoide) as ours, opened(echo) as bare:
        await ours.ready()
        await bare.owner
        for name, rounds, events, period in (("60 Hz", 6, 60, 1 / 60), ("after a pause", 3, 12, 0.25)):
            hands = Hand(ours, T_world_target), Hand(bare, T_world_target)
            for _ in range(rounds):
                for hand in hands:
                    await hand.drag(events, period)
            spread(f"helicoide, {name}", hands[0].took, "ms", 95)
            spread(f"bare viser that flushes, {name}", hands[1].took, "ms", 95)
            verdict(f"ratio at p50, {name}", p50(hands[0].took) / p50(hands[1].took), GOAL, "×")


def run() -> None:
    with served("helicoide", "--port", "0", "--store", "none") as helicoide, served("tests.benchmarks.echo") as echo:
        asyncio.run(_measure(helicoide, echo))
