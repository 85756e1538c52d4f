"""Find planes in point clouds from the camera on the arm or from a file, in threads."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from typing import Any

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToJoints
from helicoide.perception import cloud_file, realsense
from helicoide.perception.camera import DepthCamera, SimulatedCamera
from helicoide.perception.cloud import PointCloud
from helicoide.perception.enclosure_reading import (
    NOISE,
    OUTLIERS,
    PLANE_READINGS,
    PlaneReading,
    available_readings,
    camera_cloud,
    plane_in_cloud,
)
from helicoide.perception.units import Unit
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text

LOOK, STILL = 0.05, 1e-3
NOTHING_TO_READ = Text(
    en="This arm has no measuring postures, so it cannot measure planes.",
    pt_BR="Este braço não tem posturas de medição, por isso não mede planos.",
)
log = logging.getLogger("helicoide")


class Surveying:
    """Measures planes. state: returns the current state; post: takes an update of it. Use it only on the event loop."""

    def __init__(self, state: Callable[[], State], post: Callable[[Update], None]) -> None:
        self.state, self.post = state, post
        self._task: asyncio.Task[None] | None = None

    def tour(self, real: bool = False) -> None:
        """Go to every posture from which the arm can measure a plane, and measure it. Another request ends the tour.

        real: with the connected RealSense, not with the simulated camera.
        """
        if not available_readings(self.state().robot):
            self.post(gate.say(NOTHING_TO_READ))
        elif real:
            self._begin(partial(self._with, realsense.connected()))
        else:
            simulated = SimulatedCamera(noise=NOISE, outliers=OUTLIERS, resolution=(160, 90))
            self._begin(partial(self._with, nullcontext(simulated)))

    def read(self, name: str, content: bytes, plane: str, unit: Unit | None = None) -> None:
        """Find a plane, by its name, in the point cloud of a file. unit: of its coordinates; None if not chosen."""
        reading = next(one for one in PLANE_READINGS if one.name == plane)
        self._begin(partial(self._from_file, name, content, reading, unit))

    def _begin(self, work: Callable[[], Coroutine[Any, Any, None]]) -> None:
        if self._task is not None:
            self._task.cancel()
        self._task = asyncio.get_running_loop().create_task(self._guarded(work))

    async def _guarded(self, work: Callable[[], Coroutine[Any, Any, None]]) -> None:
        try:
            await work()
        except HelicoideError as refusal:
            self.post(gate.say(refusal.text))
        except Exception:
            log.exception("a reading failed")
            self.post(gate.say(FAILED))

    async def _with(self, opened: AbstractContextManager[DepthCamera]) -> None:
        """The tour with a camera, which is closed in every case, also after a cancellation while it is opened."""
        opening = asyncio.create_task(asyncio.to_thread(opened.__enter__))
        try:
            await self._tour(await asyncio.shield(opening))
        finally:
            await asyncio.shield(_let_go(opening, opened))

    async def _tour(self, camera: DepthCamera) -> None:
        state = self.state()
        self.post(gate.clear_planes())
        for seed, reading in enumerate(available_readings(state.robot)):
            await self._done(gate.while_asked(state, gate.go_to(reading.pose)))
            if not await self._arrived(reading.pose):
                return
            state = self.state()
            cloud = await asyncio.to_thread(camera_cloud, camera, state)
            await self._find(cloud, reading, state.T_world_tool[:3, 3], seed)
            if self.state().request.command is not state.request.command:  # the arm has another command
                return
        self.post(gate.while_asked(state, gate.get_ready()))

    async def _done(self, update: Update) -> None:
        """Post an update, and wait until it has been applied, since the arm's thread may be late."""
        loop, done = asyncio.get_running_loop(), asyncio.Event()

        def tell(state: State) -> State:
            loop.call_soon_threadsafe(done.set)
            return state

        self.post(update)
        self.post(tell)
        await done.wait()

    async def _arrived(self, pose: str) -> bool:
        """Wait until the arm is at a posture; False if it gets another command or cannot come nearer."""
        command = self.state().request.command
        while self.state().request.command is command and isinstance(command, MoveToJoints):
            state = self.state()
            if abs(state.arm.q - state.robot.poses[pose]).max() < STILL:
                return True
            if state.request.unchanged > 1.0 and not state.arm.moving:
                return False
            await asyncio.sleep(LOOK)
        return False

    async def _from_file(self, name: str, content: bytes, reading: PlaneReading, unit: Unit | None) -> None:
        cloud = await asyncio.to_thread(cloud_file.read_cloud, name, content, unit)
        await self._find(cloud, reading, self.state().T_world_tool[:3, 3], 0)

    async def _find(self, cloud: PointCloud, reading: PlaneReading, inside: Array, seed: int) -> None:
        seen, pane = await asyncio.to_thread(plane_in_cloud, cloud, reading, inside, seed)
        self.post(gate.show_cloud(reading.name, seen, pane))


async def _let_go(opening: asyncio.Task[DepthCamera], opened: AbstractContextManager[DepthCamera]) -> None:
    """Wait until a camera is open, then close it. A failure to open it has been reported already."""
    await asyncio.wait([opening])
    if opening.exception() is None:
        await asyncio.to_thread(opened.__exit__, None, None, None)


FAILED = Text(en="The measurement failed; see the terminal.", pt_BR="A medição falhou; veja o terminal.")
