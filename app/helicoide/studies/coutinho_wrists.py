"""The constrained Jacobian of three wrists: the printed matrices, manipulabilities and singularities."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.method import Quantity
from helicoide.ik.rcm import wrists
from helicoide.ik.rcm.constrained import Constrained, constrained
from helicoide.ik.rcm.passage import SLIT, TROCAR, through
from helicoide.kinematics.robot import Robot
from helicoide.studies._coutinho_runs import (
    LINK,
    ROBOT,
    dia10,
    entry_on,
    problem_without_planes,
    seven_joints,
    zx_wrist,
)
from helicoide.studies.study import Chart, ChartLine, Progress, Result, Row, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Three wrists behind the entry point", pt_BR="Três punhos atrás do ponto de entrada")
SOURCE = "Coutinho 2015, §1.4, §3.2, §3.3, §3.5, eqs. 3.24–3.42, figs. 3.7–3.9"
ABOUT = Text(
    en="Beyond a slit (r = 1) or a trocar (r = 2) the end effector has a wrist whose last joint turns about y (zy) or "
    "x (zx). The constrained Jacobian, computed from the chain, stands beside the printed matrices at random postures, "
    "and its manipulability w_r beside the printed formulas. The curves are sections of the printed surfaces, on a "
    "link of 2 m.",
    pt_BR="Além de uma fenda (r = 1) ou de um trocarte (r = 2), o instrumento tem um punho cuja última junta gira em "
    "torno de y (zy) ou de x (zx). O Jacobiano restrito, calculado a partir da cadeia, fica ao lado das matrizes "
    "impressas em posturas aleatórias, e sua manipulabilidade w_r ao lado das fórmulas impressas. As curvas são seções "
    "das superfícies impressas, num elo de 2 m.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

LENGTH, L_8, POSTURES, SHORT = 0.33, 0.21, 100, 20
# Of the examples: a posture, rad, and l_a next to joint 6, m.
BENT, CLOSE = frozen([0.4, -0.3, -1.0, -1.2, 0.8, 0.9, 0.7, 0.5]), 0.005
# Of what a formula gives.
CLOSE = 5e-4
# Of the surfaces: l_a + l_b, m; l_b of their sections, m; θ₇ up to 8 rad as in fig. 3.7.
WHOLE, SECTIONS, ACROSS = 2.0, (0.1, 0.4, 0.7, 1.0), np.linspace(0.0, 8.0, 321)

Matrix = Callable[[float, float, float, float, float], Array]
Formula = Callable[[float, float, float], float]


@dataclass(frozen=True)
class Wrist:
    """A wrist behind what forbids r velocities: the arm, and its matrix and manipulability in closed form.

    matrix_in, w_in: the equation that prints it so, none where it is corrected here; figure: of the surface of w_r;
    singular: θ₇ at which the source has it so, rad.
    """

    title: Text
    arm: Callable[[], Robot]
    across: Array
    matrix: Matrix
    matrix_in: str
    w: Formula
    w_in: str
    figure: str
    singular: tuple[tuple[str, float], ...] = ()


KINDS: Mapping[str, Wrist] = {
    "slit": Wrist(
        Text(en="slit, zy", pt_BR="fenda, zy"),
        dia10,
        SLIT,
        wrists.zy_slit,
        "eq. 3.24",
        wrists.w_zy_slit,
        "",
        "fig. 3.7",
    ),
    "zx": Wrist(
        Text(en="trocar, zx", pt_BR="trocarte, zx"),
        zx_wrist,
        TROCAR,
        wrists.zx_trocar,
        "",
        wrists.w_zx_trocar,
        "eq. 3.41",
        "fig. 3.8",
        (("π/2", np.pi / 2), ("3π/2", 1.5 * np.pi)),
    ),
    "zy": Wrist(
        Text(en="trocar, zy", pt_BR="trocarte, zy"),
        dia10,
        TROCAR,
        wrists.zy_trocar,
        "",
        wrists.w_zy_trocar,
        "eq. 3.42",
        "fig. 3.9",
        (("0", 0.0), ("π", np.pi)),
    ),
}
DEPTH = Text(en="l_a of the examples", pt_BR="l_a dos exemplos")


@dataclass(frozen=True)
class Options:
    """l_a at which single values are taken, m."""

    depth: Annotated[float, Quantity(DEPTH, 0.03, 0.3, "m")] = 0.15


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Each wrist at 100 random postures; short: at 20."""
    rows: list[Row] = []
    for done, kind in enumerate(KINDS.values()):
        rows += [*_as_printed(kind, SHORT if short else POSTURES), *_singular(kind, options.depth)]
        progress((done + 1) / len(KINDS))
    return Result((*rows, *_wrong(options.depth), *_ranks()), tuple(map(_sections, KINDS.values())))


def entry_at(kind: Wrist, q: Array, l_a: float) -> Constrained:
    """The arm at q (n,), rad, with the entry point on its shaft, l_a, m, from joint 6; Λ# as in the source."""
    robot = kind.arm()
    return constrained(
        problem_without_planes(robot), through(robot, LINK, kind.across), q, entry_on(robot, q, l_a), "source"
    )


def _as_printed(kind: Wrist, count: int) -> list[Row]:
    """The difference between J^r and w_r from the chain and in closed form, at random postures and depths."""
    robot, random = kind.arm(), np.random.default_rng(2015)
    matrix, w = [], []
    for q in random.uniform(robot.lower, robot.upper, (count, len(robot.variables))):
        l_a = random.uniform(0.05, 0.3)
        at, expected = entry_at(kind, q, l_a), kind.w(l_a, LENGTH - l_a, q[6])
        matrix.append(np.abs(at.J - kind.matrix(l_a, LENGTH - l_a, L_8, q[6], q[7])).max())
        w.append(abs(at.of_tool.w - expected) / expected)
    return [
        Row(MATRIX.format(which=kind.title), float(max(matrix)), "", _exact(kind.matrix_in, "J^r", 1e-12)),
        Row(FORMULA.format(which=kind.title), float(max(w)), "", _exact(kind.w_in, "w_r", 1e-8)),
    ]


def _exact(equation: str, name: str, within: float) -> Statement | None:
    words = Text(en="{name} of {equation}", pt_BR="{name} da {equation}").format(name=name, equation=equation)
    return Statement(words, equation, 0.0, "=", within) if equation else None


def _singular(kind: Wrist, l_a: float) -> list[Row]:
    """w_r where the source has the wrist singular: at l_b = 0, and at some θ₇."""
    rows = [_lost(AT_JOINT_7.format(which=kind.title), entry_at(kind, BENT, LENGTH), "§3.5")]
    for angle, q7 in kind.singular:
        q = np.array([*BENT[:6], q7, BENT[7]])
        rows.append(_lost(AT.format(which=kind.title, angle=angle), entry_at(kind, q, l_a), kind.w_in))
    return rows


def _lost(title: Text, at: Constrained, place: str) -> Row:
    return Row(title, at.of_tool.w, "", Statement(SINGULAR, place, 0.0, "=", 1e-12))


def _wrong(l_a: float) -> list[Row]:
    """Differences between printed and correct formulas at one posture, and how J^r degrades next to joint 6."""
    slit, zy = KINDS["slit"], KINDS["zy"]
    l_b, c7, c8 = LENGTH - l_a, np.cos(BENT[6]), np.cos(BENT[7])
    entry = Statement(untranslated("l₈ c₇ c₈"), "eq. 3.28", float(L_8 * c7 * c8), "=", CLOSE)
    square = (l_b / l_a) ** 2 * ((LENGTH * np.sin(BENT[6])) ** 2 + 2)
    without = Statement(untranslated("(l_b/l_a)² ((l_a + l_b)² sin² θ₇ + 2)"), "eq. 3.40", float(square), "=", CLOSE)
    grown = entry_at(zy, BENT, CLOSE).of_tool.condition_number / entry_at(zy, BENT, l_a).of_tool.condition_number
    return [
        Row(ENTRY, float(entry_at(zy, BENT, l_a).J[2, 3]), "m", entry, erratum="coutinho-1"),
        Row(ROOT, entry_at(slit, BENT, l_a).of_tool.w, "", without, erratum="coutinho-3"),
        Row(GROWS, float(grown), "", Statement(ILL, "§3.5", 10.0, ">")),
    ]


def _ranks() -> list[Row]:
    """The rank of J^r behind a trocar, with eight and with seven joints."""
    rows = []
    stated = {dia10: Statement(ENOUGH, "§1.4, §5.1", 6.0), seven_joints: Statement(TOO_FEW, "§1.4, §5.1", 6.0, "<")}
    for arm, statement in stated.items():
        robot = arm()
        n = len(robot.variables)
        at = constrained(
            problem_without_planes(robot), through(robot, LINK), BENT[:n], entry_on(robot, BENT[:n], 0.15), "source"
        )
        rows.append(Row(RANK.format(n=n), at.of_tool.rank, "", statement))
    return rows


def _sections(kind: Wrist) -> Chart:
    """w_r over θ₇ at some l_b, on a link of 2 m."""
    lines = (ChartLine(untranslated("l_b = {l_b:g} m").format(l_b=l_b), ACROSS, _over(kind.w, l_b)) for l_b in SECTIONS)
    return Chart(
        SECTION.format(which=kind.title), untranslated("θ₇, rad"), untranslated("w_r"), tuple(lines), kind.figure
    )


def _over(w: Formula, l_b: float) -> Array:
    return np.array([w(WHOLE - l_b, l_b, q7) for q7 in ACROSS])


MATRIX = Text(
    en="largest difference of J^r from its closed form, {which}",
    pt_BR="maior diferença entre J^r e a forma fechada, {which}",
)
FORMULA = Text(
    en="largest relative difference of w_r from its closed form, {which}",
    pt_BR="maior diferença relativa entre w_r e a forma fechada, {which}",
)
AT_JOINT_7 = Text(en="w_r at l_b = 0, {which}", pt_BR="w_r em l_b = 0, {which}")
AT = Text(en="w_r at θ₇ = {angle}, {which}", pt_BR="w_r em θ₇ = {angle}, {which}")
SINGULAR = Text(en="singular", pt_BR="singular")
ENTRY = Text(en="entry (3, 4) of J^r, trocar, zy", pt_BR="elemento (3, 4) de J^r, trocarte, zy")
ROOT = Text(en="w_r at θ₇ = 0.7, slit, zy", pt_BR="w_r em θ₇ = 0,7, fenda, zy")
GROWS = Text(
    en="condition number of J^r at l_a = 5 mm over that of the example",
    pt_BR="número de condição de J^r em l_a = 5 mm sobre o do exemplo",
)
ILL = Text(en="ill-conditioned as l_a → 0", pt_BR="mal condicionado quando l_a → 0")
RANK = Text(en="rank of J^r behind a trocar with {n} joints", pt_BR="posto de J^r atrás de um trocarte com {n} juntas")
ENOUGH = Text(en="all six ways where n − r ≥ 6", pt_BR="os seis graus de liberdade onde n − r ≥ 6")
TOO_FEW = Text(en="fewer where n − r < 6", pt_BR="menos onde n − r < 6")
SECTION = Text(en="Manipulability over θ₇, {which}", pt_BR="Manipulabilidade em função de θ₇, {which}")
