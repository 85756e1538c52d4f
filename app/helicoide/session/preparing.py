"""What is run before the arm does, so that nothing is compiled in the middle of a motion."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from contextlib import suppress

import numpy as np

from helicoide import gate, kernels
from helicoide.advance import advance
from helicoide.foresight import foreseen, search
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.ik.postures.subspace import project
from helicoide.jobs.apart import Apart
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.perception.planes import find
from helicoide.session.workcell import TICK
from helicoide.state import State, ToJoints, ToPose, commanded, initial
from helicoide.text import Text

# How many compilations `exercise` takes: a test counts them. Where it is written down that they are done, Python by
# Python, as numba keeps them.
COMPILATIONS = 79
PREPARED = kernels.CACHE_FOLDER / f"prepared.{sys.implementation.cache_tag}"
COMPILING = Text(
    en="Preparing the kernels: {done} of {total}. This happens once.",
    pt_BR="Preparando os kernels: {done} de {total}. Acontece uma vez só.",
)


def exercise(robot_name: str = "movemaster") -> State:
    """Run everything that the loop runs once, so that every kernel is compiled or loaded, for whatever robot."""
    state = initial(load(robot_name))
    asked = commanded(state, ToPose(state.T_world_tool))
    asked = gate.drag_target("", "start", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = gate.drag_target("", "end", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = search(asked)(asked)
    asked = foreseen(advance(gate.play()(asked), TICK))
    find(np.indices((10, 10, 1)).reshape(3, -1).T / 100, [0, 0, 1], [0, 0, 1])
    CL031.sandwich(rigid.motor_from_pose(state.T_world_tool), rigid.point(state.T_world_tool[:3, 3]))
    return foreseen(advance(commanded(asked, ToJoints(state.q)), TICK))


def compiled(report: Callable[[int], None]) -> None:
    """Compile every kernel that the loop needs, report how many are done, and leave word of it in the cache."""
    done = 0

    def told(count: int) -> None:
        nonlocal done
        done = count
        report(count)

    with kernels.counted(told):
        exercise()
    with suppress(OSError):  # they are looked for again at the next start
        PREPARED.write_text(f"{done}\n")


def rehearse(robot: Robot) -> None:
    """Run what only some arms need, such as the search for the nearest pose of one with five joints."""
    state = initial(robot)
    project(robot, state.T_world_tool, state.q)


def compiling(done: int) -> Text:
    """What is said while so many kernels are compiled."""
    return COMPILING.format(done=done, total=COMPILATIONS)


async def prepare(robot: Robot, compilation: Apart, say: Callable[[Text], None]) -> None:
    """Compile in another process what is not compiled yet, say how far it is, and load it all in a thread."""
    loop = asyncio.get_running_loop()

    def listen() -> None:
        for done in compilation.progress():
            loop.call_soon_threadsafe(say, compiling(done))

    if not PREPARED.exists():
        await asyncio.to_thread(listen)
    await asyncio.to_thread(exercise)
    await asyncio.to_thread(rehearse, robot)
