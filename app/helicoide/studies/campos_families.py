"""The families of methods of slide 37 side by side: the same goals, by closed forms of four kinds and by iteration."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import closed
from helicoide.ik.method import Quantity
from helicoide.ik.postures import numeric
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.ik.postures.measure import left
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_iteration import (
    EXAMPLE,
    NAMES,
    converged_from_starts,
    iteration_charts,
    iteration_motion,
    iteration_rows,
)
from helicoide.studies._campos_rows import PUMA_LENGTHS, campos_result, posture_chart, posture_motion, slide_statement
from helicoide.studies.study import Chart, ChartLine, Motion, Progress, Result, Row, Statement, printed_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="The families of methods, side by side", pt_BR="As famílias de métodos, lado a lado")
SOURCE = "Campos 1998, s.20, s.23–24, s.37; Paden 1986; Murray, Li, Sastry 1994"
ABOUT = Text(
    en="A slide names the families: inverse transforms, screws, dual matrices and quaternions, geometry, iteration. "
    "All but dual matrices, which move lines as dual quaternions do, solve the same goals of the PUMA and of the "
    "Movemaster here. The closed ones give every posture, and the same ones to rounding; an iteration comes to one "
    "from each start, and which one depends on the start.",
    pt_BR="Um slide nomeia as famílias: transformadas inversas, helicoides, matrizes e quatérnios duais, geometria, "
    "iteração. Aqui todas, menos as matrizes duais, que movem retas como os quatérnios duais, resolvem os mesmos alvos "
    "do PUMA e do Movemaster. As fechadas dão todas as posturas, e as mesmas a menos de arredondamento; de cada "
    "partida a iteração chega a uma, e qual delas depende da partida.",
)
ROBOT = "puma560"

INVERSE = Text(en="inverse transforms", pt_BR="transformadas inversas")
SCREWS = Text(en="screws", pt_BR="helicoides")
DUAL = Text(en="dual quaternions", pt_BR="quatérnios duais")
GEOMETRY = Text(en="geometry", pt_BR="geometria")
SEARCH = Text(en="iteration with restarts", pt_BR="iteração com reinícios")
# The closed form of each family for each arm. Dual matrices are left out: they transform lines as dual quaternions do.
FORMS = {
    "puma560": {INVERSE: "puma560", SCREWS: "screws", DUAL: "dual_quaternions", GEOMETRY: "geometry"},
    "movemaster": {INVERSE: "inverse_transform", SCREWS: "screws", DUAL: "dual_quaternions", GEOMETRY: "movemaster"},
}
# Intermediate values of each family: meaning and unit.
AHEAD = Text(en="wrist ahead of the shoulder", pt_BR="punho à frente do ombro"), "m"
ABOVE = Text(en="wrist above the shoulder", pt_BR="punho acima do ombro"), "m"
FROM_AXIS_1 = Text(en="wrist ahead of axis 1", pt_BR="punho à frente do eixo 1"), "m"
FAR = Text(en="distance of wrist and shoulder", pt_BR="distância entre punho e ombro"), "m"
BEYOND = (
    Text(en="wrist beyond the elbow, along the upper arm", pt_BR="punho além do cotovelo, ao longo do braço superior"),
    "m",
)
STEPS: dict[str, dict[Text, dict[str, tuple[Text, str]]]] = {
    "puma560": {
        INVERSE: {"K": (untranslated("a₃ c₃ − d₄ s₃"), "m"), "u": FROM_AXIS_1},
        SCREWS: {"δ": FAR},
        DUAL: {"k": BEYOND},
        GEOMETRY: {
            "u": FROM_AXIS_1,
            "β": (
                Text(en="wrist below the horizontal, from the shoulder", pt_BR="punho abaixo da horizontal, do ombro"),
                "rad",
            ),
            "ψ": (Text(en="angle from there to the upper arm", pt_BR="ângulo dali ao braço superior"), "rad"),
        },
    },
    "movemaster": {
        INVERSE: {
            "s_234": (Text(en="sine of θ₂ + θ₃ + θ₄", pt_BR="seno de θ₂ + θ₃ + θ₄"), ""),
            "c_234": (Text(en="cosine of θ₂ + θ₃ + θ₄", pt_BR="cosseno de θ₂ + θ₃ + θ₄"), ""),
            "w_x": AHEAD,
            "w_y": ABOVE,
        },
        SCREWS: {
            "α": (Text(en="turn of the hand about axis 2, −y", pt_BR="giro da mão em torno do eixo 2, −y"), "rad"),
            "δ": FAR,
        },
        DUAL: {"k": BEYOND},
        GEOMETRY: {
            "α": (Text(en="turn of the hand about y", pt_BR="giro da mão em torno de y"), "rad"),
            "u_W": AHEAD,
            "z_W": ABOVE,
        },
    },
}
FEW, STARTS, FEW_STARTS, MOST = 20, 200, 40, 64
GOALS = Quantity(Text(en="random goals", pt_BR="alvos aleatórios"), 10, 5000, decades=True)


@dataclass(frozen=True)
class Options:
    """How many random goals each family solves on each arm."""

    goals: Annotated[float, GOALS] = 200


@dataclass(frozen=True)
class Tally:
    """The results of a family of methods.

    postures: their number; residuals: the worst of each goal, m or rad; distance: the largest distance, rad, between a
    posture of this family or of the inverse transforms and the nearest posture of the other.
    """

    postures: int
    residuals: Array
    distance: float


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both arms with each family of methods, and iterations from many starts.

    short: twenty goals, and too few starts to count where they lead.
    """
    count, rows, charts, motions = FEW if short else int(options.goals), list[Row](), list[Chart](), list[Motion]()
    for part, name in enumerate(FORMS):
        robot = load_robot(name)
        tallies = family_tallies(robot, count, _part(progress, part))
        steps = {family: _of(robot, family, np.array(EXAMPLE[name])) for family in FORMS[name]}
        starts = converged_from_starts(robot, FEW_STARTS if short else STARTS)
        progress((part + 1) / len(FORMS))
        rows += [*_rows(robot, tallies, count), *_steps(robot, steps)]
        if not short:
            rows += iteration_rows(robot, starts, steps[INVERSE])
        charts += [*_charts(robot, tallies, steps[INVERSE]), *iteration_charts(robot, starts, steps[INVERSE])]
        postures = [branch.q for branch in steps[INVERSE].branches]
        motions += [
            posture_motion(name, postures, title=POSTURES.format(arm=NAMES[name])),
            iteration_motion(robot, starts),
        ]
    return campos_result(rows, charts, motions)


def _part(progress: Progress, part: int) -> Progress:
    return lambda share: progress((part + 0.8 * share) / len(FORMS))


def family_tallies(robot: Robot, count: int, progress: Progress) -> dict[Text, Tally]:
    """The results of each family for the poses of random postures."""
    postures, apart = dict[Text, int](), dict[Text, float]()
    residuals = dict[Text, list[float]]()
    for done, q in enumerate(np.random.default_rng(37).uniform(-2.5, 2.5, (count, len(robot.variables))), start=1):
        first: Array | None = None
        T = tool_at(robot, q)
        for family, found in _by_family(robot, T):
            first = found if first is None else first
            postures[family] = postures.get(family, 0) + len(found)
            residuals.setdefault(family, []).append(max((max(left(robot, one, T)) for one in found), default=np.inf))
            apart[family] = max(apart.get(family, 0.0), _largest_difference(first, found))
        progress(done / count)
    return {family: Tally(postures[family], np.array(residuals[family]), apart[family]) for family in postures}


def _by_family(robot: Robot, T: Array) -> Iterator[tuple[Text, Array]]:
    """Every posture (k, n), rad, that each family finds, the inverse transforms first."""
    now = np.zeros(len(robot.variables))
    for family, name in FORMS[robot.name].items():
        yield (
            family,
            np.array(
                [branch.q for branch in closed.solve_closed_form(closed.closed_forms()[name], robot, T, now).branches]
            ),
        )
    yield SEARCH, numeric.distinct_postures(robot, np.ascontiguousarray(T), now, True, MOST)[0]


def _of(robot: Robot, family: Text, q: Array) -> Answer:
    return closed.solve_closed_form(
        closed.closed_forms()[FORMS[robot.name][family]], robot, tool_at(robot, q), np.zeros(len(q))
    )


def _largest_difference(one: Array, other: Array) -> float:
    """The largest distance, rad, from a posture of one set to the nearest of the other; infinite if a set is empty."""
    if not (len(one) and len(other)):
        return np.inf
    ways = np.abs(wrap(one[:, None] - other)).max(axis=2)
    return float(max(ways.min(axis=0).max(), ways.min(axis=1).max()))


def _rows(robot: Robot, tallies: dict[Text, Tally], count: int) -> Iterator[Row]:
    """Rows: postures for each goal, residuals, and differences between the families."""
    if robot.name == "puma560":
        counts = [tally.postures / count for tally in tallies.values()]
        yield Row(FEWEST, min(counts), "", printed_statement("8", "s.20"), (PUMA_LENGTHS,))
        yield Row(MOST_FOUND, max(counts), "", printed_statement("8", "s.20"), (PUMA_LENGTHS,))
    for family, tally in tallies.items():
        named = {"arm": NAMES[robot.name], "family": family}
        yield Row(COUNT.format(**named), tally.postures / count)
        yield Row(RESIDUAL.format(**named), float(tally.residuals.max()))
        if family is not INVERSE:
            yield Row(APART.format(**named), tally.distance, "rad", ALIKE.get(family))


def _steps(robot: Robot, steps: dict[Text, Answer]) -> Iterator[Row]:
    """Rows: intermediate values of each family for its first posture."""
    for family, symbols in STEPS[robot.name].items():
        for symbol, (meant, unit) in symbols.items():
            quantity = STEP.format(arm=NAMES[robot.name], family=family, symbol=symbol, meant=meant)
            yield Row(quantity, steps[family].values[0][symbol], unit)


def _charts(robot: Robot, tallies: dict[Text, Tally], answer: Answer) -> Iterator[Chart]:
    yield posture_chart(POSTURES.format(arm=NAMES[robot.name]), [(branch.name, branch.q) for branch in answer.branches])
    yield Chart(
        RESIDUALS.format(arm=NAMES[robot.name]),
        Text(en="share of goals", pt_BR="fração dos alvos"),
        untranslated("m, rad"),
        tuple(
            ChartLine(
                family, np.arange(1, len(tally.residuals) + 1) / len(tally.residuals), np.sort(tally.residuals) + 1e-17
            )
            for family, tally in tallies.items()
        ),
        log=True,
    )


ALIKE: dict[Text, Statement] = {
    GEOMETRY: slide_statement(
        "algebraic and geometric differ in approach only",
        "algébrica e geométrica: diferem só na abordagem",
        "s.24",
        0,
        "=",
        1e-8,
    )
}
COUNT = Text(en="{arm}, {family}: postures for each goal", pt_BR="{arm}, {family}: posturas por alvo")
FEWEST = Text(
    en="PUMA: postures for each goal by the family that finds the fewest",
    pt_BR="PUMA: posturas por alvo da família que encontra menos",
)
MOST_FOUND = Text(
    en="PUMA: postures for each goal by the family that finds the most",
    pt_BR="PUMA: posturas por alvo da família que encontra mais",
)
RESIDUAL = Text(en="{arm}, {family}: worst residual, m or rad", pt_BR="{arm}, {family}: maior resíduo, m ou rad")
APART = Text(
    en="{arm}, {family}: farthest posture from those of inverse transforms",
    pt_BR="{arm}, {family}: postura mais distante das de transformadas inversas",
)
STEP = Text(
    en="{arm}, {family}: {symbol} of the goal shown, {meant}",
    pt_BR="{arm}, {family}: {symbol} do alvo mostrado, {meant}",
)
POSTURES = Text(en="{arm}: the postures of a goal", pt_BR="{arm}: as posturas de um alvo")
RESIDUALS = Text(en="{arm}: residuals by family", pt_BR="{arm}: resíduos por família")
