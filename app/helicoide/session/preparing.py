"""What is run so that nothing is compiled in the middle of a motion.

Until every kernel is loaded the arms live by kernels that run as Python. The lab's own process compiles only what
cannot be had otherwise, and no arm moves meanwhile.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from contextlib import suppress

import numpy as np

from helicoide import gate, kernels
from helicoide.advance import advance
from helicoide.command import ToJoints, ToPose
from helicoide.confinement.planes import distances
from helicoide.foresight import foreseen, search
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.ik.families import parallel_arm, parallel_postures
from helicoide.ik.families.polish import polisher
from helicoide.ik.packing import packed
from helicoide.ik.postures import numeric
from helicoide.ik.postures.measure import left
from helicoide.ik.postures.nearest import nearest
from helicoide.ik.postures.packed import WIDTH
from helicoide.ik.postures.solve import solve
from helicoide.ik.postures.subspace import project
from helicoide.ik.step import STILL, task_at
from helicoide.jobs.apart import Apart, Failed, Killed
from helicoide.kinematics import tool, workspace
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.singularity import usual_rank
from helicoide.perception.columns import Column
from helicoide.perception.lists import walked
from helicoide.perception.lzf import unpacked
from helicoide.perception.planes import find
from helicoide.session.postures import postures
from helicoide.session.workcell import TICK
from helicoide.state import State, commanded, initial
from helicoide.text import Text

COMPILING = Text(
    en="Preparing the kernels: {done} of {total}. This happens once; the arm moves already.",
    pt_BR="Preparando os kernels: {done} de {total}. Acontece uma vez só; o braço já se move.",
)
AGAIN = Text(
    en="The preparation was ended from outside, perhaps for want of memory; it begins again.",
    pt_BR="A preparação foi encerrada de fora, talvez por falta de memória; ela recomeça.",
)
HERE = Text(
    en="Preparing the kernels: {done} of {total}. The arm waits, and the page is slow meanwhile.",
    pt_BR="Preparando os kernels: {done} de {total}. Enquanto isso, o braço espera e a página fica lenta.",
)
NOT_KEPT = Text(
    en="Preparing the kernels: {done} of {total}. They cannot be kept in {folder}, so this happens at every start; the "
    "arm waits, and the page is slow meanwhile.",
    pt_BR="Preparando os kernels: {done} de {total}. Não é possível guardá-los em {folder}, então isso acontece a cada "
    "início; enquanto isso, o braço espera e a página fica lenta.",
)
log = logging.getLogger("helicoide")
Say = Callable[[Text], None]
Meanwhile = Callable[[bool], None]


def exercise(robot_name: str = "movemaster") -> None:
    """Call what calls the kernels of the lab, so that each is compiled or loaded, for whatever robot."""
    state = initial(load(robot_name))
    _drive(state)
    _look(state)


def _drive(state: State) -> None:
    """What is asked while the arm moves."""
    asked = commanded(state, ToPose(state.T_world_tool))
    asked = gate.drag_target("", "start", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = gate.drag_target("", "end", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = search(asked)(asked)
    asked = foreseen(advance(gate.play()(asked), TICK))
    foreseen(advance(commanded(asked, ToJoints(state.arm.q)), TICK))
    task_at(packed(state.problem), state.arm.q.copy(), state.T_world_tool, STILL, TICK)


def _look(state: State) -> None:
    """What is asked now and then: multivectors, distances, postures, clouds and maps."""
    robot, T, q = state.robot, state.T_world_tool, state.arm.q
    CL031.sandwich(rigid.motor_from_pose(T), rigid.point(T[:3, 3]))
    CL031.outer(rigid.point(T[:3, 3]), rigid.point(T[:3, 3]))
    distances(*state.problem.plane_arrays[:2], state.guarded_points)
    numeric.posture(robot, T, q)
    left(robot, q, T)
    nearest(robot, T, q, with_orientation=True)
    postures(state)(state)
    tool.tool_pose(tool.packed(robot), q)
    tool.tool_jacobian(tool.packed(robot), q)
    _list_postures()
    find(np.indices((10, 10, 1)).reshape(3, -1).T / 100, [0, 0, 1], [0, 0, 1])
    unpacked(bytes(2), 1)
    walked([Column("", "<u1")], 1, bytes(1), 0)
    workspace.counted(workspace.planned(robot, "reachable", 1), 0)


def _list_postures() -> None:
    """Closed forms of other arms than the one that drives."""
    for name in ("puma560", "zebra_zero"):
        robot = load(name)
        solve(robot, robot.T_world_tool_0, robot.poses["ready"], every=True)
    arm = np.ones((parallel_arm.POLISHER, WIDTH))
    parallel_postures.joint_values(np.concatenate([arm, polisher(robot)]), robot.T_world_tool_0, robot.poses["ready"])


def compiled(report: Callable[[int], None]) -> None:
    """Compile every kernel of the lab and report how many are done; ends when one cannot be kept on disk.

    This is for a process of its own, of whose work only what is kept remains.
    """

    def told(done: int) -> None:
        report(done)
        if kernels.Kept.refusal is not None:
            raise kernels.NotKept

    with suppress(kernels.NotKept), kernels.counted(told):
        exercise()


def rehearse(robot: Robot) -> None:
    """Run what only some arms need, such as the search for the nearest pose of one with five joints, and keep ranks."""
    state = initial(robot)
    project(robot, state.T_world_tool, state.arm.q)
    usual_rank(robot)


def compiling(done: int, words: Text = COMPILING) -> Text:
    """What is said while so many kernels are compiled."""
    return words.format(done=done, total=len(kernels.KERNELS), folder=kernels.CACHE_FOLDER)


async def prepare(robot: Robot, compilation: Apart, say: Say, meanwhile: Meanwhile) -> None:
    """Load the kernels in a thread; where one is not on disk, have them compiled first, and say how far that is.

    `meanwhile` is told that the arms may live by kernels that run as Python, and when they may no longer.
    """
    loop = asyncio.get_running_loop()

    def tell(text: Text) -> None:
        loop.call_soon_threadsafe(say, text)

    def live(alive: bool) -> None:
        loop.call_soon_threadsafe(meanwhile, alive)

    await asyncio.to_thread(_prepare, robot, compilation, tell, live)


def _prepare(robot: Robot, compilation: Apart, say: Say, live: Meanwhile) -> None:
    live(True)
    if not _loaded():
        _compile_apart(compilation, say)
        if compilation.stopped:
            return
        if not _loaded():
            live(False)
            _compile_here(say)
    with kernels.by_machine_code():
        rehearse(robot)


def _loaded() -> bool:
    """Load every kernel; false as soon as one is not on disk, or damaged there."""
    try:
        with kernels.by_machine_code(), kernels.only_kept():
            exercise()
    except kernels.NotKept:
        return False
    return True


def _compile_apart(compilation: Apart, say: Say) -> None:
    """Have the kernels compiled in another process; where that is killed, once more."""
    for words in (AGAIN, HERE):
        try:
            for done in compilation.progress():
                say(compiling(done))
            return
        except Killed as killed:
            log.warning("while kernels were compiled, %s", killed)
            say(compiling(0, words))
        except Failed as failure:
            log.warning("the kernels cannot be compiled apart:\n%s", failure)
            return


def _compile_here(say: Say) -> None:
    """Compile what was not compiled apart, or could not be kept."""

    def told(done: int) -> None:
        say(compiling(done, HERE if kernels.Kept.refusal is None else NOT_KEPT))

    with kernels.by_machine_code(), kernels.counted(told):
        exercise()
    if kernels.Kept.refusal is not None:
        log.warning("the kernels cannot be kept: %s", kernels.Kept.refusal)
