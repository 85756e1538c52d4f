"""Maps of the workspace, computed in another process. The state of the arm says whether a map is still wanted."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable

from helicoide import gate
from helicoide.jobs import chunks
from helicoide.jobs.process import JobFailed, ProcessJob, Report, follow_job
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MapKind, MapPlan, WorkspaceMap, plan_map, plane_normal
from helicoide.state import State, Update
from helicoide.text import Text

# Number of postures, for an arm in a plane (2) and in space (3): a few to about twenty seconds on one core.
SAMPLES: dict[MapKind, dict[int, int]] = {
    "reachable": {2: 1_450_000, 3: 10_600_000},
    "dexterous": {2: 12_600_000, 3: 13_700_000},
    "manipulability": {2: 1_450_000, 3: 7_100_000},
}
LOOK = 0.05
FAILED = Text(
    en="The map could not be computed; see the terminal.", pt_BR="Não foi possível calcular o mapa; veja o terminal."
)
log = logging.getLogger("helicoide")


def plan_of(robot: Robot, kind: MapKind) -> MapPlan:
    """The plan of a map of an arm, fine enough to be shown."""
    return plan_map(robot, kind, SAMPLES[kind][3 if plane_normal(robot) is None else 2])


def counted(report: Report, plan: MapPlan) -> WorkspaceMap:
    """Compute a map and keep it on disk, or read it if it is there."""
    return chunks.workspace_map(plan, progress=report)


class MapJob:
    """Computes the maps of one workcell. Use it only on the event loop.

    state: returns the current state; post: takes an update of it; limit: of the number of maps that the lab
    computes at once.
    """

    def __init__(
        self, state: Callable[[], State], post: Callable[[Update], None], limit: asyncio.Semaphore | None = None
    ) -> None:
        self.state, self.post, self.limit = state, post, limit or asyncio.Semaphore(1)
        self._job: ProcessJob | None = None
        self._task: asyncio.Task[None] | None = None

    def begin(self, kind: MapKind) -> None:
        """Compute a map of the current arm; a computation that is running is ended."""
        state = self.state()
        if self._task is not None:
            self._task.cancel()
        self.close()
        self.post(gate.start_map(state.robot, kind))
        self._task = asyncio.get_running_loop().create_task(self._map(state.robot, kind))

    def close(self) -> None:
        """End the computation."""
        if self._job is not None:
            self._job.stop()

    async def _map(self, robot: Robot, kind: MapKind) -> None:
        """Post the map of an arm, at once if it is on disk, or say that it failed."""
        plan = plan_of(robot, kind)
        try:
            found = await asyncio.to_thread(chunks.cached_map, plan)
            if found is None:
                async with self.limit:
                    found = await self._counted(robot, plan)
            if found is None and self._is_counting(robot):
                log.error("the process that counts the map of %s was ended from outside", robot.name)
        except JobFailed as failure:
            log.error("the map of %s failed:\n%s", robot.name, failure)
            found = None
        except Exception:
            log.exception("the map of %s failed", robot.name)
            found = None
        self.post(gate.fail_map(robot, FAILED) if found is None else gate.show_map(robot, found))

    async def _counted(self, robot: Robot, plan: MapPlan) -> WorkspaceMap | None:
        """Compute in another process, which is ended as soon as the map is not wanted any more."""
        self._job = job = ProcessJob(counted, plan)

        def tell(share: float) -> None:
            if self._job is job:
                self.post(gate.tell_map(robot, share))

        listening = asyncio.create_task(follow_job(job, tell))
        begun = False
        while not listening.done():
            await asyncio.wait([listening], timeout=LOOK)
            wanted = self._is_counting(robot)
            begun |= wanted
            if self.state().robot is not robot or (begun and not wanted):
                job.stop()
        listening.result()
        return None if job.result is None else _frozen(job.result)

    def _is_counting(self, robot: Robot) -> bool:
        state = self.state()
        return state.robot is robot and state.workspace.progress is not None


def _frozen(found: WorkspaceMap) -> WorkspaceMap:
    """The map with read-only arrays again, since the transfer from another process makes them writeable."""
    for array in (found.hits, found.values):
        array.flags.writeable = False
    return found
