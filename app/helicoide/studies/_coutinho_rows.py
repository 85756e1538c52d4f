"""Rows, curves and motions of the studies of Coutinho 2015."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.method import OneOf, Quantity
from helicoide.studies._coutinho_runs import ROBOT, Run
from helicoide.studies.study import Chart, ChartLine, Figure, Fitted, Interpretation, Motion, Row, Statement
from helicoide.text import Text, untranslated

POINTS, POSES = 500, 300  # of a curve, of a motion
# What words ask of numbers: the error of a tip that follows its path, and one that is low, mm; a velocity that is about
# null, and one that is small, mm/s; the part of v_rd by which a shaft that follows it may miss.
FOLLOWED, LOW = 0.3, 1.0
NULL, SMALL, MISSED = 0.1, 1.0, 0.1

STEPS = {"2": untranslated("2 ms"), "20": untranslated("20 ms")}
STEP = Text(en="sample time", pt_BR="período de amostragem")
FEEDBACK = Text(en="drift feedback Kr", pt_BR="realimentação da deriva Kr")
ARM = Interpretation(
    Text(en="axes, zero posture and speeds of our arm", pt_BR="eixos, postura zero e velocidades do nosso braço"),
    Text(
        en="counted from another zero the joints have other numbers, and the end effector moves alike",
        pt_BR="contadas de outro zero, as juntas têm outros números, e o efetuador se move igual",
    ),
)
# Joints at the start that hold all that is printed of S1 to S4; found by tests/studies/fits/coutinho.py.
FITTED_START = (
    ARM,
    Fitted(untranslated("θ₂(0)"), -0.25, -0.3125, -0.1875, "rad"),
    Fitted(untranslated("θ₄(0)"), -1.65, -2.0625, -1.4025, "rad"),
    Fitted(untranslated("θ₆(0)"), 1.1, 1.045, 1.375, "rad"),
    Fitted(untranslated("θ₇(0)"), -0.225, -0.28125, -0.2025, "rad"),
    Fitted(untranslated("θ₈(0)"), 1.57, 1.4915, 1.6485, "rad"),
)
# The sample time of the simulations, which is not printed: that of S1 and S2, and of S4, by the same search.
SAMPLED = Fitted(STEP, 20.0, 2.0, 200.0, "ms")
SAMPLED_S4 = Fitted(STEP, 20.0, 2.0, 35.0, "ms")


@dataclass(frozen=True)
class Options:
    """The sample time, ms, and the gain of the second run, 1/s: the first has none, as the source."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "20"
    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 5.0


OF = untranslated("{what}, {which}")
BY_STEP = Text(en="{what} at {step:g} ms", pt_BR="{what} a {step:g} ms")
NO_FEEDBACK = untranslated("Kr = 0")
SLIP = Text(en="largest forbidden velocity at the entry point", pt_BR="maior velocidade proibida no ponto de entrada")
LEAVES = Text(
    en="how fast the shaft leaves its entry point, over steps of {step:g} ms",
    pt_BR="com que rapidez a haste se afasta do ponto de entrada, a passos de {step:g} ms",
)
TIMES = Text(en="how often θ₇ changes its sign", pt_BR="quantas vezes θ₇ muda de sinal")
ENTRY = Text(en="largest velocity that the entry point is given", pt_BR="maior velocidade imposta ao ponto de entrada")
SHARE = Text(
    en="largest share of a joint's speed (of the SDA10F)",
    pt_BR="maior fração da velocidade máxima de uma junta (do SDA10F)",
)
RATE = Text(en="largest joint velocity", pt_BR="maior velocidade de junta")
TIP = Text(en="largest error of the tip", pt_BR="maior erro da ponta")
LATERAL = Text(
    en="largest distance of the shaft from the entry point", pt_BR="maior distância da haste ao ponto de entrada"
)


@dataclass(frozen=True)
class Measure:
    """A quantity measured on a run, and its unit."""

    title: Text
    unit: str
    of: Callable[[Run], float]


# Measures and curves that the captions of the source's figures name.
DRAWN = ("tip", "angle", "entry", "command", "outside", "outside_min", "outside_max", "rate")
MEASURES: Mapping[str, Measure] = {
    "tip": Measure(TIP, "mm", lambda run: run["tip_mm"].max()),
    "angle": Measure(
        Text(en="largest error of orientation", pt_BR="maior erro de orientação"),
        "°",
        lambda run: run["angle_deg"].max(),
    ),
    "lateral": Measure(LATERAL, "mm", lambda run: run["lateral_mm"].max()),
    "q7_min": Measure(Text(en="smallest θ₇", pt_BR="menor θ₇"), "rad", lambda run: run["q7"].min()),
    "q7_max": Measure(Text(en="largest θ₇", pt_BR="maior θ₇"), "rad", lambda run: run["q7"].max()),
    "outside_min": Measure(Text(en="smallest l_a", pt_BR="menor l_a"), "m", lambda run: run["outside"].min()),
    "outside_max": Measure(Text(en="largest l_a", pt_BR="maior l_a"), "m", lambda run: run["outside"].max()),
    "w_r": Measure(Text(en="smallest w_r", pt_BR="menor w_r"), "", lambda run: run["w_r"].min()),
    "rate": Measure(RATE, "rad/s", lambda run: run["rate"].max()),
}


def with_feedback(gain: float) -> Text:
    """The name of a run by its gain Kr, 1/s."""
    return untranslated("Kr = {gain:g}").format(gain=gain)


def measure_rows(
    run: Run,
    which: Text,
    dt: float,
    place: str = "",
    names: tuple[str, ...] = tuple(MEASURES),
    by_step: tuple[str, ...] = ("tip", "angle", "lateral"),
) -> list[Row]:
    """Rows without printed values; place: the figures in which the source shows those of `DRAWN`.

    dt: the sample time, s, named where a number goes with it.
    """
    found = []
    for name in names:
        measure = MEASURES[name]
        title = BY_STEP.format(what=measure.title, step=1e3 * dt) if name in by_step else measure.title
        shown = Figure(place) if place and name in DRAWN else None
        found.append(Row(OF.format(what=title, which=which), float(measure.of(run)), measure.unit, shown))
    return found


def leaving_rate_row(
    run: Run,
    dt: float,
    stated: Statement | None = None,
    fitted: tuple[Fitted | Interpretation, ...] = (),
    which: Text | None = None,
) -> Row:
    """How fast the shaft leaves its entry point, compared with the statement of the source.

    By construction the velocity is zero at each instant; over a step of dt, s, the shaft can move.
    """
    title = LEAVES.format(step=1e3 * dt)
    title = title if which is None else OF.format(what=title, which=which)
    return Row(title, float(run["moved_mm_s"].max()), "mm/s", stated, fitted)


TIME = Text(en="time, s", pt_BR="tempo, s")
VELOCITY = Text(en="velocity, mm/s", pt_BR="velocidade, mm/s")


@dataclass(frozen=True)
class Curve:
    """Columns of a run over time, each with its name where there are several."""

    title: Text
    up: Text
    columns: Mapping[str, str]
    log: bool = False


CURVES: Mapping[str, Curve] = {
    "tip": Curve(Text(en="Error of the tip", pt_BR="Erro da ponta"), untranslated("|e_p|, mm"), {"tip_mm": ""}),
    "entry": Curve(
        Text(en="Velocity of the shaft at the entry point", pt_BR="Velocidade da haste no ponto de entrada"),
        VELOCITY,
        {"v_x": "x", "v_z": "z"},
    ),
    "command": Curve(
        Text(en="Cartesian command", pt_BR="Comando cartesiano"),
        VELOCITY,
        {"nu_x": "x", "nu_y": "y", "nu_z": "z"},
    ),
    "lateral": Curve(
        Text(en="Distance of the shaft from the entry point", pt_BR="Distância da haste ao ponto de entrada"),
        untranslated("|e_r|, mm"),
        {"lateral_mm": ""},
        log=True,
    ),
    "rate": Curve(
        Text(en="Largest joint velocity", pt_BR="Maior velocidade de junta"),
        untranslated("max |θ̇|, rad/s"),
        {"rate": ""},
    ),
    "outside": Curve(
        Text(en="From joint 6 to the entry point", pt_BR="Da junta 6 ao ponto de entrada"),
        untranslated("l_a, m"),
        {"outside": ""},
    ),
    "q7": Curve(
        Text(en="θ₇, the bend beyond the entry point", pt_BR="θ₇, a flexão além do ponto de entrada"),
        untranslated("θ₇, rad"),
        {"q7": ""},
    ),
    "w": Curve(
        Text(en="Manipulability of arm and wrist", pt_BR="Manipulabilidade do braço e do punho"),
        untranslated("w"),
        {"w_r": "w_r", "w_i": "w_i"},
        log=True,
    ),
}


def run_charts(runs: Mapping[Text, Run], figures: Mapping[str, str], log: tuple[str, ...] = ()) -> tuple[Chart, ...]:
    """The curves of several runs over time, in common charts.

    figures: the names of the curves, in their order, with the figure of the source beside which each of `DRAWN` stands;
    log: those that differ by powers of ten from run to run.
    """
    return tuple(
        Chart(
            curve.title,
            TIME,
            curve.up,
            _lines(runs, curve),
            figure if name in DRAWN else "",
            curve.log or name in log,
        )
        for name, figure in figures.items()
        for curve in (CURVES[name],)
    )


def _lines(runs: Mapping[Text, Run], curve: Curve) -> tuple[ChartLine, ...]:
    return tuple(
        ChartLine(OF.format(what=label, which=which) if label else which, *peaks(_times(run, column), run[column]))
        for which, run in runs.items()
        for column, label in curve.columns.items()
    )


def _times(run: Run, column: str) -> Array:
    return run["t"] if len(run[column]) == len(run["t"]) else run["t_w"]


def peaks(x: Array, y: Array) -> tuple[Array, Array]:
    """At most `POINTS` points of a curve: the largest |y| of each section, so that peaks remain."""
    stretches = np.array_split(np.arange(len(x)), min(POINTS, len(x)))
    kept = [stretch[np.argmax(np.abs(y[stretch]))] for stretch in stretches]
    return x[kept], y[kept]


def run_motions(runs: Mapping[Text, Run], robot: str = ROBOT) -> tuple[Motion, ...]:
    """The motion of the arm in each run."""
    return tuple(_motion(which, run, robot) for which, run in runs.items())


def _motion(which: Text, run: Run, robot: str) -> Motion:
    stride = -(-len(run["t_w"]) // POSES)
    return Motion(robot, run["t_w"][::stride], run["q"][::stride], title=which)
