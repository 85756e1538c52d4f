"""Redundancy: one point in two postures, and the null space that leads from one to the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem, objectives
from helicoide.ik.clik import ControlLaw, TaskFunction, closed_loop
from helicoide.ik.method import Quantity
from helicoide.ik.secondary import push
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import LoopRun, collected, error_chart, joint_chart, loop_motion, pitch_chart
from helicoide.studies.study import (
    Chart,
    ChartLine,
    Interpretation,
    Progress,
    Result,
    Row,
    Statement,
    printed_statement,
)
from helicoide.text import Text, untranslated

TITLE = Text(en="Redundancy of the ORCA", pt_BR="Redundância do ORCA")
SOURCE = "Cerbaro 2022, §4.4.1, fig. 27"
ROBOT = "orca"
ABOUT = Text(
    en="An arm with three joints needs only two to put its end effector on a point of its plane: one freedom is left. "
    "The arm glides from posture A to posture B of the source through the null space of its Jacobian, and the end "
    "effector stays where it is.",
    pt_BR="Um braço de três juntas só precisa de duas para pôr o efetuador num ponto do plano: sobra uma liberdade. "
    "O braço desliza da postura A à postura B da fonte pelo espaço nulo do jacobiano, e o efetuador fica onde está.",
)
A, B = np.array([np.pi / 4, -np.pi / 4, 0.0]), np.array([0.0087, 0.7852, -0.7942])
GAIN, SECONDS, DT = 225.0, 12.0, 0.004
ROWS = Statement(
    Text(en="only rows 2, 3 and 4 are not zero", pt_BR="só as linhas 2, 3 e 4 não são nulas"), "§4.4.1", 0.0, "=", 1e-9
)
NO_ROLL = Interpretation(
    Text(en="said of the motion at q₅ = 0", pt_BR="dito do movimento com q₅ = 0"),
    Text(
        en="row 5 of the matrix I − J† J is not zero at any q₅, and at q₅ = 90° J5 turns too, at 0.96 of the fastest",
        pt_BR="a linha 5 da matriz I − J† J não é nula com nenhum q₅, e com q₅ = 90° J5 também gira, a 0,96 da mais "
        "rápida",
    ),
)
EMPTY = Statement(
    Text(en="five tasks, five joints: the null space is empty", pt_BR="cinco tarefas, cinco juntas: espaço nulo vazio"),
    "§6.1",
    0.0,
)


@dataclass(frozen=True)
class Options:
    """pull: k₀ of the null-space motion towards B, 1/s."""

    pull: Annotated[float, Quantity(Text(en="pull towards B, k₀", pt_BR="atração para B, k₀"), 0.5, 10.0, "1/s")] = 2.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both postures, the sizes of the null spaces, and the way from A to B in steps of 4 ms; short: the first half."""
    orca = setups.orca()
    objective = objectives.named("reference_posture")
    to_b = push(orca, [(objective, objective.Options(reference=tuple(B)))], options.pull)
    here = setups.position_task(orca, setups.fixed_point(*setups.tool_position(orca, A)))
    moments = closed_loop(orca, ControlLaw(setups.damped_inverse(0.0), GAIN, DT), here, A, to_b)
    way = collected(moments, SECONDS / 2 if short else SECONDS, progress)
    return Result(
        rows=_rows(orca, way),
        charts=_charts(way),
        motions=(loop_motion(ROBOT, Text(en="from A to B", pt_BR="de A a B"), way),),
    )


def null_space_size(aiming: TaskFunction, q: Array) -> tuple[int, float]:
    """The dimension of the null space of a task at q, and ‖J N‖ of N = I − J† J, in units of J."""
    J = aiming(q, 0.0).J
    found = analyse_jacobian(J)
    return found.null_space.shape[1], float(np.linalg.norm(J @ found.null_projector) / np.linalg.norm(J))


def _rows(orca: Problem, way: LoopRun) -> tuple[Row, ...]:
    movemaster = setups.movemaster()
    q, goal = movemaster.robot.poses["example"], setups.fixed_point(0.44, 0, 0.2)
    free, _ = null_space_size(setups.position_task(orca, goal), A)
    free_5r, _ = null_space_size(setups.position_task(movemaster, goal), q)
    held_5r, _ = null_space_size(setups.pitch_and_roll_task(movemaster, goal, 0.0), q)
    points = [
        Row(
            Text(en="{name}: {axis} of the end effector", pt_BR="{name}: {axis} do efetuador").format(
                name=name, axis=axis
            ),
            1000 * setups.tool_position(orca, posture)[i],
            "mm",
            printed_statement(("583,2", "173,2")[i], "§4.4.1, fig. 27"),
        )
        for name, posture in (("A", A), ("B", B))
        for i, axis in enumerate("xy")
    ]
    return (
        *points,
        Row(
            Text(
                en="Movemaster, null space: speed of J1 or J5, over that of the fastest joint",
                pt_BR="Movemaster, espaço nulo: velocidade de J1 ou J5, sobre a da junta mais rápida",
            ),
            side_motion(movemaster),
            "",
            ROWS,
            (NO_ROLL,),
        ),
        Row(
            Text(en="freedoms, Movemaster with orientation", pt_BR="liberdades, Movemaster com orientação"),
            held_5r,
            "",
            EMPTY,
        ),
        Row(Text(en="freedoms, ORCA at x, y", pt_BR="liberdades, ORCA em x, y"), free),
        Row(Text(en="freedoms, Movemaster at x, y, z", pt_BR="liberdades, Movemaster em x, y, z"), free_5r),
        Row(
            Text(
                en="way from A to B: the end effector leaves its point by",
                pt_BR="de A a B: o efetuador sai do ponto por",
            ),
            float(way.position_error.max()),
            "mm",
        ),
        Row(
            Text(en="way from A to B: largest joint error at the end", pt_BR="de A a B: maior erro de junta no fim"),
            float(np.degrees(np.abs(way.q[-1] - B).max())),
            "°",
        ),
    )


def side_motion(movemaster: Problem) -> float:
    """By how much N q̇₀ of eqs. 9, 10 and 14 moves J1 and J5, as a share of what it moves most, where q₅ = 0."""
    q = movemaster.robot.poses["example"].copy()
    q[4] = 0.0
    J = setups.position_task(movemaster, setups.fixed_point(0, 0))(q, 0.0).J
    rates = np.abs(analyse_jacobian(J).null_projector @ push(movemaster, setups.limit_distance(), 1.0)(q, 0.0))
    return float(rates[[0, 4]].max() / rates.max())


def _charts(way: LoopRun) -> tuple[Chart, ...]:
    named = (Text(en="of the end effector", pt_BR="do efetuador"), way)
    return (
        _postures(),
        joint_chart("fig. 27", way, (1, 2, 3)),
        pitch_chart("fig. 27", "φ", named),
        error_chart("", named),
    )


def _postures() -> Chart:
    """The arm in both postures, from above: its joints and its tool."""
    orca = setups.orca()
    lines = []
    for name, q in (("A", A), ("B", B)):
        joints = link_poses(orca.robot.chain, q)[1:, :2, 3]
        x, y = 1000 * np.vstack([joints, setups.tool_position(orca, q)[:2]]).T
        lines.append(ChartLine(untranslated(name), x, y))
    title = Text(en="One point, two postures, from above", pt_BR="Um ponto, duas posturas, vistas de cima")
    return Chart(title, untranslated("x (mm)"), untranslated("y (mm)"), tuple(lines), "fig. 27")
