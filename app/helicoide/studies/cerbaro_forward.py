"""The worked examples of forward kinematics, by DH rows and by screws, beside what was measured on the arms."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import euler
from helicoide.kinematics.dh import DhRow
from helicoide.kinematics.forward import dh_frames, formulation_difference, screw_displacements, tool_by_screws
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies.study import (
    Chart,
    ChartLine,
    Interpretation,
    Motion,
    Progress,
    Result,
    Row,
    Statement,
    printed_statement,
)
from helicoide.text import Text, untranslated

TITLE = Text(en="Forward kinematics, two arms", pt_BR="Cinemática direta, dois braços")
SOURCE = "Cerbaro 2022, §4.2–4.3, eqs. 1–8, figs. 25, 26"
ROBOT = "movemaster"
ABOUT = Text(
    en="Where the end effectors of the ORCA and the Movemaster are in one posture each: by DH rows, whose matrix ends "
    "in the last DH frame, and by successive screws, whose matrix is what the point of the end effector at q = 0 is "
    "moved by. Two people measured both on the arms, ten times. Where a table or an equation was put right for this, "
    "the row says so; what tables 5 and 6 give as they are printed has rows of its own.",
    pt_BR="Onde ficam os efetuadores do ORCA e do Movemaster numa postura de cada um: pelas linhas DH, cuja matriz "
    "termina no último referencial DH, e por helicoides sucessivos, cuja matriz é o que move o ponto do efetuador em "
    "q = 0. Duas pessoas mediram ambos nos braços, dez vezes. Onde uma tabela ou equação foi corrigida para isso, a "
    "linha o diz; o que as tabelas 5 e 6 dão como impressas tem linhas próprias.",
)
# Eqs. 4 and 8, entries of R.
R_DH = np.array([[0.5, -0.75, 0.433], [-0.866, -0.433, 0.25], [0, -0.5, -0.866]])
R_SCREWS = np.array([[0.433, 0.75, 0.5], [0.25, 0.433, -0.866], [-0.866, 0.5, 0]])
TABLE_5 = (0.235, 0.245, 0.065)  # a, m
MEASURED = {"orca": np.array([335.0, 330.0, 0.0]), "movemaster": np.array([477.0, 275.0, 293.0])}
FIGURES = {"orca": "fig. 25", "movemaster": "fig. 26"}
SAMPLES, SECONDS = 200, 5.0
LENGTHS = Interpretation(
    Text(en="the lengths of table 7 in table 5", pt_BR="os comprimentos da tabela 7 na tabela 5"),
    Text(en="(202.03; 310.60) mm", pt_BR="(202,03; 310,60) mm"),
)
FIRST_OFFSET = Interpretation(
    Text(en="d₁ = 400 mm in table 6", pt_BR="d₁ = 400 mm na tabela 6"), untranslated("z = −100 mm")
)
SINES = Interpretation(
    Text(en="eq. 61 with the signs of Rodrigues’ formula", pt_BR="a eq. 61 com os sinais da fórmula de Rodrigues"),
    Text(en="no rotation comes out", pt_BR="não resulta uma rotação"),
)
CUT = Interpretation(
    Text(en="digits cut after three decimals", pt_BR="dígitos cortados na terceira casa"),
    Text(en="rounded, 271.603, 413.013 and 1010.141 mm", pt_BR="arredondados, 271,603; 413,013 e 1010,141 mm"),
)
SQUARED = Text(
    en="1.02 % comes out of the squared distances; the rule that gives the 5.98 % of the ORCA gives 0.51 %",
    pt_BR="1,02 % sai das distâncias ao quadrado; a regra que dá os 5,98 % do ORCA dá 0,51 %",
)


@dataclass(frozen=True)
class Options:
    """No settings."""


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The examples, and how far the formulations differ on the way from q = 0 to them; a quick run is the whole."""
    orca, movemaster = robots = (load_robot("orca"), load_robot("movemaster"))
    motions = tuple(_motion(robot) for robot in robots)
    rows = (*_of_orca(orca), *_of_movemaster(movemaster), *_measured(orca, movemaster))
    return Result(rows, _charts(robots, motions), motions)


def example_posture(robot: Robot) -> Array:
    """The posture of the source's example, (n,), rad."""
    return robot.poses["example"]


def truncated_row(row: Row) -> Row:
    """The row of a truncated number: the tolerance is one unit of its last digit."""
    assert isinstance(row.source, Statement)
    source = replace(row.source, within=2 * row.source.within * (1 - 1e-6))
    return replace(row, source=source, fitted=(*row.fitted, CUT))


def row_by_table(row: Row, table: int, robot: Robot, rows: Iterable[DhRow], axis: int) -> Row:
    """The same coordinate with the DH rows of a table as it is printed, and the erratum about that."""
    as_printed = replace(robot, dh=replace(robot.dh, rows=tuple(rows)))
    quantity = Text(en="{row}, table {table} as printed", pt_BR="{row}, com a tabela {table} como impressa")
    ours = 1000 * float(dh_frames(as_printed, example_posture(robot))[-1][axis, 3])
    erratum = {5: "cerbaro-1", 6: "cerbaro-2"}[table]
    return replace(
        row, quantity=quantity.format(row=row.quantity, table=table), computed=ours, fitted=(), erratum=erratum
    )


def _of_orca(orca: Robot) -> tuple[Row, ...]:
    by_dh, by_screws = dh_frames(orca, example_posture(orca))[-1], screw_displacements(orca, example_posture(orca))[-1]
    x, y = _places("ORCA, DH", by_dh[:2, 3], ("318,140", "309,321"), "eqs. 1–3", (LENGTHS,))
    lengths = (replace(row, a=a) for row, a in zip(orca.dh.rows, TABLE_5, strict=True))
    return (
        *(x, y, row_by_table(x, 5, orca, lengths, 0)),
        _entries("ORCA, DH", by_dh, np.eye(3), "eqs. 1–3"),
        *_places("ORCA, H", by_screws[:2, 3], ("−336,860", "309,321"), "eq. 7", (SINES,)),
        _entries("ORCA, H", by_screws, np.eye(3), "eq. 7", (SINES,)),
    )


def _of_movemaster(movemaster: Robot) -> tuple[Row, ...]:
    by_dh = dh_frames(movemaster, example_posture(movemaster))[-1]
    by_screws = screw_displacements(movemaster, example_posture(movemaster))[-1]
    turns = euler.euler_angles(by_dh[:3, :3], euler.ROLL_PITCH_YAW).values
    x, y, z = _places("Movemaster, DH", by_dh[:3, 3], ("470,429", "271,602", "300,000"), "eqs. 4–5")
    u, v, w = _places("Movemaster, H", by_screws[:3, 3], ("−84,641", "413,012", "1010,140"), "eq. 8", (SINES,))
    first, *others = movemaster.dh.rows
    return (
        *(x, truncated_row(y), replace(z, fitted=(FIRST_OFFSET,))),
        row_by_table(z, 6, movemaster, (replace(first, d=0.0), *others), 2),
        _entries("Movemaster, DH", by_dh, R_DH, "eq. 4"),
        *_rotation_rows("Movemaster, DH", turns, ("−1,047", "0,000", "−2,618"), "eq. 6"),
        *(u, truncated_row(v), truncated_row(w)),
        _entries("Movemaster, H", by_screws, R_SCREWS, "eq. 8", (SINES,)),
    )


def _places(
    name: str, place: Array, words: tuple[str, ...], where: str, taken: tuple[Interpretation, ...] = ()
) -> tuple[Row, ...]:
    told = zip("xyz", 1000 * place, words, strict=False)
    return tuple(
        Row(untranslated(f"{name}: {axis}"), float(ours), "mm", printed_statement(said, where), taken)
        for axis, ours, said in told
    )


def _entries(name: str, H: Array, R: Array, where: str, taken: tuple[Interpretation, ...] = ()) -> Row:
    said = Text(en="its R, to three decimals", pt_BR="o seu R, com três decimais")
    quantity = Text(en="{name}: largest difference of R", pt_BR="{name}: maior diferença em R").format(name=name)
    return Row(quantity, float(np.abs(H[:3, :3] - R).max()), "", Statement(said, where, 0.0, "=", 5e-4), taken)


def _rotation_rows(name: str, rotations: Array, words: tuple[str, ...], where: str) -> tuple[Row, ...]:
    told = zip(("Roll", "Pitch", "Yaw"), np.round(rotations, 12) + 0.0, words, strict=True)
    return tuple(
        Row(untranslated(f"{name}: {axis}"), float(ours), "rad", printed_statement(said, where))
        for axis, ours, said in told
    )


def _measured(orca: Robot, movemaster: Robot) -> tuple[Row, ...]:
    """How much farther out the measured points are, as the source counts it for each arm, and how far off."""
    farther = Text(
        en="{name}: measured point farther from the base by",
        pt_BR="{name}: ponto medido mais longe da origem da base por",
    )
    squared = Text(
        en="{name}: squared distance of the measured point larger by",
        pt_BR="{name}: quadrado da distância do ponto medido maior por",
    )
    off = Text(en="{name}: measured point off by", pt_BR="{name}: distância entre o ponto medido e o calculado")
    ratios = [_ratio(robot) for robot in (orca, movemaster)]
    apart = [
        float(np.linalg.norm(MEASURED[robot.name] - 1000 * tool_by_screws(robot, example_posture(robot))[:3, 3]))
        for robot in (orca, movemaster)
    ]
    return (
        Row(farther.format(name=orca.title), 100 * (ratios[0] - 1), "%", printed_statement("5,98", "fig. 25")),
        Row(
            farther.format(name=movemaster.title),
            100 * (ratios[1] - 1),
            "%",
            printed_statement("1,02", "fig. 26"),
            why=SQUARED,
        ),
        Row(squared.format(name=movemaster.title), 100 * (ratios[1] ** 2 - 1), "%"),
        *(Row(off.format(name=robot.title), mm, "mm") for robot, mm in zip((orca, movemaster), apart, strict=True)),
    )


def _ratio(robot: Robot) -> float:
    """The distance of the measured point from the base over that of the computed point."""
    tool = 1000 * tool_by_screws(robot, example_posture(robot))[:3, 3]
    return float(np.linalg.norm(MEASURED[robot.name]) / np.linalg.norm(tool))


def _motion(robot: Robot) -> Motion:
    shares = np.linspace(0.0, 1.0, SAMPLES)
    return Motion(robot.name, SECONDS * shares, shares[:, None] * example_posture(robot), title=robot.title)


def _charts(robots: tuple[Robot, ...], motions: tuple[Motion, ...]) -> tuple[Chart, ...]:
    time = Text(en="time (s)", pt_BR="tempo (s)")
    apart = tuple(
        ChartLine(robot.title, motion.times, 1000 * np.array([formulation_difference(robot, q) for q in motion.q]))
        for robot, motion in zip(robots, motions, strict=True)
    )
    title = Text(en="DH, screws and dual quaternions apart", pt_BR="Diferença entre DH, helicoides e quatérnios duais")
    return (
        *(_way(robot, motion) for robot, motion in zip(robots, motions, strict=True)),
        Chart(title, time, untranslated("mm"), apart, log=True),
    )


def _way(robot: Robot, motion: Motion) -> Chart:
    way = 1000 * np.array([tool_by_screws(robot, q)[:2, 3] for q in motion.q])
    measured = np.repeat(MEASURED[robot.name][None, :2], 2, axis=0)
    lines = (
        ChartLine(Text(en="from q = 0 to the example", pt_BR="de q = 0 ao exemplo"), way[:, 0], way[:, 1]),
        ChartLine(
            Text(en="measured, from the base", pt_BR="medido, a partir da base"),
            measured[:, 0] * (0, 1),
            measured[:, 1] * (0, 1),
        ),
    )
    title = Text(en="{robot}: the end effector, from above", pt_BR="{robot}: o efetuador, visto de cima").format(
        robot=robot.title
    )
    return Chart(title, untranslated("x (mm)"), untranslated("y (mm)"), lines, FIGURES[robot.name])
