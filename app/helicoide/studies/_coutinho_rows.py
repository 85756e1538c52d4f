"""What the studies of Coutinho's runs show of them: rows beside those of the digest, curves, the arm's motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from helicoide.ik.method import OneOf, Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies._coutinho_runs import ROBOT, Run
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Motion, Row
from helicoide.text import Text, same

POINTS = 500  # of a curve

STEPS = {"2": same("2 ms"), "20": same("20 ms")}
STEP = Text(en="sample time", pt_BR="período de amostragem")
FEEDBACK = Text(en="drift feedback Kr", pt_BR="realimentação da deriva Kr")
SHAFT_START = Text(
    en="the joints at the start and the sample time are ours: the source gives neither",
    pt_BR="as juntas no início e o período de amostragem são nossos: a fonte não informa",
)


@dataclass(frozen=True)
class Options:
    """The sample time, ms, and the gain of the second run, 1/s: the first has none, as the source."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "2"
    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 5.0


Figure = tuple[Text, str, Callable[[Run], float]]
FIGURES: Mapping[str, Figure] = {
    "tip": (Text(en="largest error of the tip", pt_BR="maior erro da ponta"), "mm", lambda run: run["tip_mm"].max()),
    "angle": (
        Text(en="largest error of orientation", pt_BR="maior erro de orientação"),
        "°",
        lambda run: run["angle_deg"].max(),
    ),
    "lateral": (
        Text(
            en="largest distance of the shaft from the entry point",
            pt_BR="maior distância da haste ao ponto de entrada",
        ),
        "mm",
        lambda run: run["lateral_mm"].max(),
    ),
    "slip": (
        Text(en="largest forbidden velocity at the entry point", pt_BR="maior velocidade proibida no ponto de entrada"),
        "mm/s",
        lambda run: run["slip_mm_s"].max(),
    ),
    "q7_min": (Text(en="smallest θ₇", pt_BR="menor θ₇"), "rad", lambda run: run["q7"].min()),
    "q7_max": (Text(en="largest θ₇", pt_BR="maior θ₇"), "rad", lambda run: run["q7"].max()),
    "outside_min": (Text(en="smallest l_a", pt_BR="menor l_a"), "m", lambda run: run["outside"].min()),
    "outside_max": (Text(en="largest l_a", pt_BR="maior l_a"), "m", lambda run: run["outside"].max()),
    "w_r": (Text(en="smallest w_r", pt_BR="menor w_r"), "", lambda run: run["w_r"].min()),
    "rate": (Text(en="largest joint rate", pt_BR="maior velocidade de junta"), "rad/s", lambda run: run["rate"].max()),
}
OF = Text(en="{what}, {which}", pt_BR="{what}, {which}")
AT = Text(en="{what} at {t} s", pt_BR="{what} em {t} s")
SAMPLED = {"outside": (same("l_a"), "m"), "q7": (same("θ₇"), "rad"), "w_r": (same("w_r"), ""), "w_i": (same("w_i"), "")}
NO_FEEDBACK = same("Kr = 0")


def with_feedback(gain: float) -> Text:
    """The name of a run by its gain Kr, 1/s."""
    return same(f"Kr = {gain:g}")


def row(
    quantity: Text, ours: float, printed: str | None, unit: str = "", last: float = 0.55, assumed: Text = SHAFT_START
) -> Row:
    """A row beside what the digest prints: to within `last` units of its last digit, or "≤" or "≥" and a bound.

    A number without exponent is meant to its last digit; None: the digest has none. The source shows curves only.
    """
    if printed is None:
        return Row(quantity, float(ours), unit=unit, source=FIGURE_ONLY, assumed=assumed)
    relation: Literal["=", "≥", "≤"] = "="
    if printed[0] in "≤≥":
        relation, printed, last = ("≤" if printed[0] == "≤" else "≥"), printed[1:], 0.0
    value, near = printed.split(" ± ") if " ± " in printed else (printed, None)
    tolerance = float(near) if near else last * 10.0 ** -len(value.partition(".")[2])
    return Row(quantity, float(ours), float(value), tolerance, unit, FIGURE_ONLY, relation=relation, assumed=assumed)


def rows_of(run: Run, which: Text, printed: Mapping[str, str], last: float = 0.55) -> tuple[Row, ...]:
    """All figures of a run beside those of the digest, by the names of `FIGURES`; which: the name of the run."""
    return tuple(
        row(OF.format(what=title, which=which), figure(run), printed.get(name), unit, last)
        for name, (title, unit, figure) in FIGURES.items()
    )


def samples_of(run: Run, dt: float, printed: Mapping[int, tuple[str, str, str, str]]) -> tuple[Row, ...]:
    """l_a, θ₇, w_r and w_i at seconds that the run has come to, beside those of the digest. dt, s."""
    found = []
    for t, values in printed.items():
        if t > run["t"][-1] + dt / 2:
            continue
        for (name, (title, unit)), value in zip(SAMPLED.items(), values, strict=True):
            at = 2 * t if name.startswith("w") else round(t / dt)
            found.append(row(AT.format(what=title, t=t), run[name][at], value, unit))
    return tuple(found)


def formula_row(run: Run, dt: float, formula: Callable[[float, float, float], float], equation: str) -> Row:
    """How far w_r is from its closed form in l_a, l_b and θ₇, at every half second, as a part of it."""
    stride = round(0.5 / dt)
    places = zip(*(run[key][::stride] for key in ("outside", "inside", "q7")), strict=True)
    expected = np.array([formula(*place) for place in places])
    apart = float((np.abs(run["w_r"] - expected) / expected).max())
    title = Text(
        en="largest relative difference of w_r from eq. {equation}",
        pt_BR="maior diferença relativa entre w_r e a eq. {equation}",
    )
    return row(title.format(equation=equation), apart, "≤1e-9")


TIME = Text(en="time, s", pt_BR="tempo, s")
CURVES: Mapping[str, tuple[Text, Text]] = {
    "tip_mm": (Text(en="Error of the tip", pt_BR="Erro da ponta"), same("|e_p|, mm")),
    "lateral_mm": (
        Text(en="Distance of the shaft from the entry point", pt_BR="Distância da haste ao ponto de entrada"),
        same("|e_r|, mm"),
    ),
    "rate": (Text(en="Largest joint rate", pt_BR="Maior velocidade de junta"), same("max |θ̇|, rad/s")),
    "outside": (
        Text(en="From joint 6 to the entry point", pt_BR="Da junta 6 ao ponto de entrada"),
        same("l_a, m"),
    ),
    "q7": (Text(en="Bend of the wrist beyond it", pt_BR="Flexão do punho além dele"), same("θ₇, rad")),
    "w_r": (
        Text(en="Manipulability beyond the entry point", pt_BR="Manipulabilidade além do ponto de entrada"),
        same("w_r"),
    ),
    "w_i": (Text(en="Manipulability of the arm", pt_BR="Manipulabilidade do braço"), same("w_i")),
}


def charts_of(runs: Mapping[Text, Run], names: tuple[str, ...] = tuple(CURVES)) -> tuple[Chart, ...]:
    """The curves of several runs side by side over time."""
    return tuple(
        Chart(
            CURVES[name][0],
            TIME,
            CURVES[name][1],
            tuple(
                Line(which, *thinned(run["t_w" if name.startswith("w_") else "t"], run[name]))
                for which, run in runs.items()
            ),
        )
        for name in names
    )


def thinned(x: Array, y: Array) -> tuple[Array, Array]:
    """At most some hundreds of points of a curve: of each stretch the one with the largest |y|, so that peaks stay."""
    stretches = np.array_split(np.arange(len(x)), min(POINTS, len(x)))
    kept = [stretch[np.argmax(np.abs(y[stretch]))] for stretch in stretches]
    return x[kept], y[kept]


def motion_of(run: Run, robot: str = ROBOT) -> Motion:
    """What the arm did in a run."""
    return Motion(robot, run["t_w"], run["q"])
