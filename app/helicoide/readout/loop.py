"""The control loop that moves the arm now, as blocks in their order, and the signals on the arrows between them."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.command import MoveToJoints
from helicoide.ik import objectives
from helicoide.ik.controller import GUARDED
from helicoide.ik.methods import filtered, filtered_modified, filtered_normal, named
from helicoide.readout.signals import signals_of
from helicoide.state import State
from helicoide.text import Text

FILTERS = tuple(module.__name__.rpartition(".")[2] for module in (filtered, filtered_modified, filtered_normal))


@dataclass(frozen=True)
class SideBlock:
    """A block that feeds another one from the side. signals: names of those on its arrow."""

    title: Text
    signals: tuple[str, ...] = ()


@dataclass(frozen=True)
class LoopBlock:
    """A block of the loop. equation: what it computes; symbol: of the arrow that leaves it; signals: on this arrow.

    sides: the blocks that feed it; returns: whether its arrow closes the loop.
    """

    title: Text
    equation: str
    symbol: str
    signals: tuple[str, ...] = ()
    sides: tuple[SideBlock, ...] = ()
    returns: bool = False


ERROR = Text(en="error of the end effector", pt_BR="erro do efetuador")
JOINT_ERROR = Text(en="error of the joints", pt_BR="erro das juntas")
GAINS, TASK = Text(en="gains", pt_BR="ganhos"), Text(en="task of one tick", pt_BR="tarefa de um ciclo")
STEP = Text(en="constrained QP step", pt_BR="passo com restrições (QP)")
ARM = Text(en="joints of the arm", pt_BR="juntas do braço")
KINEMATICS = Text(en="forward kinematics", pt_BR="cinemática direta")
FILTER = Text(en="filter Θ", pt_BR="filtro Θ")
PLANES, OBSTACLES = Text(en="planes", pt_BR="planos"), Text(en="obstacles", pt_BR="obstáculos")
SHAFT = Text(en="shaft in its entry point", pt_BR="haste no ponto de entrada")
ENTRY = Text(en="entry point", pt_BR="ponto de entrada")
SPEEDS = Text(en="speed limits", pt_BR="limites de velocidade")


def control_loop(state: State) -> tuple[LoopBlock, ...]:
    """The blocks of the loop; only signals that the state knows are on their arrows."""
    known = signals_of(state)
    return tuple(_with_known(block, frozenset(known)) for block in _blocks(state))


def loop_signals(state: State) -> tuple[str, ...]:
    """The names of the signals on all arrows, each once, in the order of the blocks."""
    blocks = control_loop(state)
    names = (name for block in blocks for part in (block.sides, (block,)) for one in part for name in one.signals)
    return tuple(dict.fromkeys(names))


def _with_known(block: LoopBlock, known: frozenset[str]) -> LoopBlock:
    def only(names: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(name for name in names if name in known)

    sides = tuple(SideBlock(side.title, only(side.signals)) for side in block.sides)
    return LoopBlock(block.title, block.equation, block.symbol, only(block.signals), sides, block.returns)


def _blocks(state: State) -> tuple[LoopBlock, ...]:
    step = LoopBlock(STEP, "b₋ ≤ A Δq ≤ b₊", "q̇", ("speed",), _around(state))
    if isinstance(state.request.command, MoveToJoints):
        return (
            LoopBlock(JOINT_ERROR, "e = q_d − q", "e"),
            LoopBlock(TASK, "v = (1 − exp(−K Δt)) e", "v"),
            step,
            LoopBlock(ARM, "q ← q + q̇ Δt", "q", ("positions",), returns=True),
        )
    guarded = state.request.controller.method == GUARDED
    return (
        LoopBlock(ERROR, "e = x_d − x", "e", ("position error", "orientation error")),
        LoopBlock(TASK, "v = ẋ_d Δt + α e", "v") if guarded else LoopBlock(GAINS, "ν = ẋ_d + Λ e", "ν"),
        *(() if guarded else _method(state)),
        step,
        LoopBlock(ARM, "q ← q + q̇ Δt", "q", ("positions",)),
        LoopBlock(KINEMATICS, "x = f(q)", "x", ("condition number",), returns=True),
    )


def _method(state: State) -> tuple[LoopBlock, ...]:
    """The method, fed by its filter and by the secondary objective; with an entry point also the shaft's motion."""
    drive = state.request.controller
    sides = []
    if drive.method in FILTERS:
        sides.append(SideBlock(FILTER, ("inversion error",)))
    if drive.secondary is not None:
        sides.append(SideBlock(objectives.named(drive.secondary.objective).TITLE))
    title = named(drive.method).TITLE
    if state.problem.entry is None or not state.request.with_orientation:
        equation = "q̇ = Θ ν" if drive.method == FILTERS[0] else "q̇ = B ν"
        return (LoopBlock(title, equation, "q̇", ("asked speed",), tuple(sides)),)
    return (
        LoopBlock(title, "u = B (ν − J_c v_rd)", "u", (), tuple(sides)),
        LoopBlock(SHAFT, "V = Λ# v + Λ† v_rd", "q̇"),
    )


def _around(state: State) -> tuple[SideBlock, ...]:
    """What limits the guarded step: speeds, planes, obstacles and the entry point."""
    problem = state.problem
    sides = [SideBlock(SPEEDS, ("speeds",))]
    if problem.planes.panes:
        sides.append(SideBlock(PLANES, ("planes",)))
    if problem.obstacles.radii.size:
        sides.append(SideBlock(OBSTACLES, ("obstacles",)))
    if problem.entry is not None:
        sides.append(SideBlock(ENTRY, ("entry distance",)))
    return tuple(sides)
