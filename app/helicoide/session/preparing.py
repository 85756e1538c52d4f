"""Load or compile every kernel at the start, so that none is compiled during a motion.

Until then the arms use kernels that run as Python. Kernels are compiled in another process. The lab's own process
compiles only what is missing after that, and the arms are halted meanwhile.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from contextlib import suppress

import numpy as np

from helicoide import gate, kernels
from helicoide.advance import advance
from helicoide.command import MoveToJoints, MoveToPose
from helicoide.confinement.planes import signed_distances
from helicoide.console import all_functions, sheet_results
from helicoide.foresight import foreseen, search_posture
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.ik.families import parallel_arm, parallel_postures
from helicoide.ik.families.polish import polisher
from helicoide.ik.packing import packed
from helicoide.ik.postures import numeric
from helicoide.ik.postures.measure import left
from helicoide.ik.postures.nearest import nearest_posture
from helicoide.ik.postures.packed import WIDTH
from helicoide.ik.postures.solve import solve
from helicoide.ik.postures.subspace import project_to_subspace
from helicoide.ik.step import STILL, task_at
from helicoide.jobs.process import JobFailed, JobKilled, ProcessJob
from helicoide.kinematics import tool_kernels, workspace
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.singularity import singularity
from helicoide.perception.columns import Column
from helicoide.perception.lists import walk_rows
from helicoide.perception.lzf import unpack_lzf
from helicoide.perception.planes import find_plane
from helicoide.session.postures import list_postures
from helicoide.session.workcell import TICK
from helicoide.sheet import Sheet, SheetLine
from helicoide.state import State, initial_state, with_command
from helicoide.text import Text

COMPILING = Text(
    en="Compiling kernels: {done} of {total}. This happens once; the arm can already move.",
    pt_BR="Compilando kernels: {done} de {total}. Acontece uma vez só; o braço já se move.",
)
AGAIN = Text(
    en="The compilation was ended from outside, perhaps for lack of memory; it starts again.",
    pt_BR="A compilação foi encerrada de fora, talvez por falta de memória; ela recomeça.",
)
HERE = Text(
    en="Compiling kernels: {done} of {total}. Meanwhile the arm waits and the page is slow.",
    pt_BR="Compilando kernels: {done} de {total}. Enquanto isso, o braço espera e a página fica lenta.",
)
NOT_KEPT = Text(
    en="Compiling kernels: {done} of {total}. They cannot be saved in {folder}, so this happens at every start. "
    "Meanwhile the arm waits and the page is slow.",
    pt_BR="Compilando kernels: {done} de {total}. Não é possível gravá-los em {folder}, então isso acontece a cada "
    "início. Enquanto isso, o braço espera e a página fica lenta.",
)
log = logging.getLogger("helicoide")
Say = Callable[[Text], None]
Meanwhile = Callable[[bool], None]


def exercise(robot_name: str = "movemaster") -> None:
    """Call every kernel of the lab, so that each is compiled or loaded. The kernels are the same for every robot."""
    state = initial_state(load_robot(robot_name))
    _exercise(state)
    _look(state)


def _exercise(state: State) -> None:
    """Calls that occur while an arm moves."""
    asked = with_command(state, MoveToPose(state.T_world_tool))
    asked = gate.drag_target("", "start", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = gate.drag_target("", "end", asked.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(asked)
    asked = search_posture(asked)(asked)
    asked = foreseen(advance(gate.play()(asked), TICK))
    foreseen(advance(with_command(asked, MoveToJoints(state.arm.q)), TICK))
    task_at(packed(state.problem), state.arm.q.copy(), state.T_world_tool, STILL, TICK)


def _look(state: State) -> None:
    """Calls that occur now and then: multivectors, distances, postures, clouds and maps."""
    robot, T, q = state.robot, state.T_world_tool, state.arm.q
    CL031.sandwich(rigid.motor_from_pose(T), rigid.point(T[:3, 3]))
    CL031.outer(rigid.point(T[:3, 3]), rigid.point(T[:3, 3]))
    signed_distances(*state.problem.plane_arrays[:2], state.monitored_points)
    numeric.first_posture(robot, T, q)
    left(robot, q, T)
    nearest_posture(robot, T, q, with_orientation=True)
    list_postures(state)(state)
    tool_kernels.tool_pose(tool_kernels.arm_array(robot), q)
    tool_kernels.tool_jacobian(tool_kernels.arm_array(robot), q)
    _list_postures()
    _use_console(state)
    find_plane(np.indices((10, 10, 1)).reshape(3, -1).T / 100, [0, 0, 1], [0, 0, 1])
    unpack_lzf(bytes(2), 1)
    walk_rows([Column("", "<u1")], 1, bytes(1), 0)
    workspace.count_chunk(workspace.plan_map(robot, "reachable", 1), 0)


def _use_console(state: State) -> None:
    """The products of all algebras of the console."""
    lines = ("e1*e2", "e12 >> e1", "e1 ^ e2", "i*j", "i >> j", "modern(e1)*modern(e2)", "modern(e12) >> modern(e1)")
    for line in (*lines, *(function.example.expression for function in all_functions().values())):
        sheet_results(Sheet((SheetLine(line),)), state)


def _list_postures() -> None:
    """Closed-form postures of other families of arms."""
    for name in ("puma560", "zebra_zero"):
        robot = load_robot(name)
        solve(robot, robot.T_world_tool_0, robot.poses["ready"], every=True)
    arm = np.ones((parallel_arm.POLISHER, WIDTH))
    parallel_postures.parallel_joint_values(
        np.concatenate([arm, polisher(robot)]), robot.T_world_tool_0, robot.poses["ready"]
    )


def compiled(report: Callable[[int], None]) -> None:
    """Compile every kernel of the lab and report how many are done; end if one cannot be kept on disk.

    This runs in another process, whose only result is the kernels on disk.
    """

    def reported(done: int) -> None:
        report(done)
        if kernels.KernelCache.refusal is not None:
            raise kernels.NotCached

    with suppress(kernels.NotCached), kernels.count_compiled(reported):
        exercise()


def rehearse(robot: Robot) -> None:
    """Run what depends on the robot, such as the search for the nearest pose with five joints, and cache its ranks."""
    state = initial_state(robot)
    project_to_subspace(robot, state.T_world_tool, state.arm.q)
    singularity(robot, state.arm.q)


def compiling(done: int, words: Text = COMPILING) -> Text:
    """The text that is shown while kernels are compiled. done: number of kernels so far."""
    return words.format(done=done, total=len(kernels.KERNELS), folder=kernels.CACHE_FOLDER)


async def prepare(robot: Robot, compilation: ProcessJob, say: Say, meanwhile: Meanwhile) -> None:
    """Load the kernels in a thread; if one is not on disk, compile them first, and report the progress to `say`.

    meanwhile: called with True while the arms may use kernels that run as Python, with False when they have to halt.
    """
    loop = asyncio.get_running_loop()

    def tell(text: Text) -> None:
        loop.call_soon_threadsafe(say, text)

    def live(alive: bool) -> None:
        loop.call_soon_threadsafe(meanwhile, alive)

    await asyncio.to_thread(_prepare, robot, compilation, tell, live)


def _prepare(robot: Robot, compilation: ProcessJob, say: Say, live: Meanwhile) -> None:
    live(True)
    if not _loaded():
        _compile_in_process(compilation, say)
        if compilation.stopped:
            return
        if not _loaded():
            live(False)
            _compile_here(say)
    with kernels.run_compiled():
        rehearse(robot)


def _loaded() -> bool:
    """Load every kernel from disk; False if one is missing or damaged."""
    try:
        with kernels.run_compiled(), kernels.only_cached():
            exercise()
    except kernels.NotCached:
        return False
    return True


def _compile_in_process(compilation: ProcessJob, say: Say) -> None:
    """Compile the kernels in another process; once more if that is killed."""
    for words in (AGAIN, HERE):
        try:
            for done in compilation.reports():
                say(compiling(done))
            return
        except JobKilled as killed:
            log.warning("while kernels were compiled, %s", killed)
            say(compiling(0, words))
        except JobFailed as failure:
            log.warning("the kernels cannot be compiled apart:\n%s", failure)
            return


def _compile_here(say: Say) -> None:
    """Compile here what the other process did not compile or could not keep on disk."""

    def reported(done: int) -> None:
        say(compiling(done, HERE if kernels.KernelCache.refusal is None else NOT_KEPT))

    with kernels.run_compiled(), kernels.count_compiled(reported):
        exercise()
    if kernels.KernelCache.refusal is not None:
        log.warning("the kernels cannot be kept: %s", kernels.KernelCache.refusal)
