"""Redundancy: one point in two postures, and the null space that leads from one to the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem, objectives
from helicoide.ik.clik import Aiming, followed
from helicoide.ik.method import Quantity
from helicoide.ik.secondary import push
from helicoide.kinematics.chain import Array
from helicoide.kinematics.manipulability import analysed
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_chart, motion, ran
from helicoide.studies.study import FIGURE_ONLY, Chart, Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="Redundancy of the ORCA", pt_BR="Redundância do ORCA")
SOURCE = "Cerbaro 2022, §4.4.1, fig. 27"
ROBOT = "orca"
ABOUT = Text(
    en="An arm with three joints needs only two to put its tool on a point of its plane: one freedom is left. "
    "The arm glides from posture A to posture B of the source through the null space of its Jacobian, and the tool "
    "stays where it is.",
    pt_BR="Um braço de três juntas só precisa de duas para pôr o efetuador num ponto do plano: sobra uma liberdade. "
    "O braço desliza da postura A à postura B da fonte pelo espaço nulo do jacobiano, e o efetuador fica onde está.",
)
A, B = np.array([np.pi / 4, -np.pi / 4, 0.0]), np.array([0.0087, 0.7852, -0.7942])
GAIN, SECONDS, DT = 225.0, 12.0, 0.004


@dataclass(frozen=True)
class Options:
    """pull: k₀ of the null-space motion towards B, 1/s."""

    pull: Annotated[float, Quantity(Text(en="pull towards B, k₀", pt_BR="atração para B, k₀"), 0.5, 10.0, "1/s")] = 2.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both postures, the sizes of the null spaces, and the way from A to B in steps of 4 ms; short: the first half."""
    orca = arms.orca()
    objective = objectives.named("reference_posture")
    to_b = push(orca, [(objective, objective.Options(reference=tuple(B)))], options.pull)
    here = arms.position(orca, arms.standing(*arms.tool(orca, A)))
    moments = followed(orca, *arms.inverse(0.0), here, GAIN, A, DT, to_b)
    way = ran(moments, SECONDS / 2 if short else SECONDS, progress)
    return Result(rows=_rows(orca, way), charts=_charts(way), motion=motion(ROBOT, way))


def null_space(aiming: Aiming, q: Array) -> tuple[int, float]:
    """How many freedoms a task leaves at q, and ‖J N‖ of its projector N = I − J† J, in units of J."""
    J = aiming(q, 0.0).J
    found = analysed(J)
    return found.null_space.shape[1], float(np.linalg.norm(J @ found.null_projector) / np.linalg.norm(J))


def _rows(orca: Problem, way: Run) -> tuple[Row, ...]:
    movemaster = arms.movemaster()
    q, goal = movemaster.robot.poses["example"], arms.standing(0.44, 0, 0.2)
    free, felt = null_space(arms.position(orca, goal), A)
    free_5r, felt_5r = null_space(arms.position(movemaster, goal), q)
    held_5r, _ = null_space(arms.with_pitch_and_roll(movemaster, goal, 0.0), q)
    points = [
        Row(
            Text(en=f"{name}: {axis} of the tool", pt_BR=f"{name}: {axis} do efetuador"),
            1000 * arms.tool(orca, posture)[i],
            digest=digest[i],
            tolerance=5.1e-5,
            unit="mm",
            source=("583.2", "173.2")[i],
        )
        for name, posture, digest in (("A", A, (583.2412, 173.2412)), ("B", B, (583.2474, 173.2228)))
        for i, axis in enumerate("xy")
    ]
    return (
        *points,
        Row(Text(en="freedoms, ORCA at x, y", pt_BR="liberdades, ORCA em x, y"), free, digest=1, source="1"),
        Row(
            Text(en="freedoms, Movemaster at x, y, z", pt_BR="liberdades, Movemaster em x, y, z"),
            free_5r,
            digest=2,
            source=Text(en="rows 2, 3, 4 not zero", pt_BR="linhas 2, 3, 4 não nulas"),
        ),
        Row(
            Text(en="freedoms, Movemaster with orientation", pt_BR="liberdades, Movemaster com orientação"),
            held_5r,
            digest=0,
            source=Text(en="none", pt_BR="nenhuma"),
        ),
        Row(
            Text(en="‖J N‖/‖J‖, the larger of both arms", pt_BR="‖J N‖/‖J‖, o maior dos dois braços"),
            max(felt, felt_5r),
            digest=0,
            tolerance=1e-12,
            source="0",
        ),
        Row(
            Text(en="way from A to B: the tool leaves its point by", pt_BR="de A a B: o efetuador sai do ponto por"),
            float(way.error.max()),
            digest=0.01,
            relation="≤",
            unit="mm",
            source=FIGURE_ONLY,
        ),
        Row(
            Text(en="way from A to B: largest joint error at the end", pt_BR="de A a B: maior erro de junta no fim"),
            float(np.degrees(np.abs(way.q[-1] - B).max())),
            unit="°",
        ),
    )


def _charts(way: Run) -> tuple[Chart, ...]:
    return joint_chart(way, (1, 2, 3)), error_chart((Text(en="of the tool", pt_BR="do efetuador"), way))
