"""How the studies of Vargas 2013 write rows, draw charts, and hand over the motion of the arm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

import numpy as np

from helicoide.ik.method import OneOf, Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Motion, Row
from helicoide.studies.vargas.arms import LENGTHS
from helicoide.studies.vargas.runs import Run, Way
from helicoide.text import Text, same

Gain = Annotated[float, Quantity(Text(en="update gain γ", pt_BR="ganho γ"), 0.1, 1e4, "1/(ℓ² s)", decades=True)]
Step = Annotated[float, Quantity(Text(en="step", pt_BR="passo"), 1e-4, 2e-2, "s", decades=True)]

SECONDS = Text(en="t, s", pt_BR="t, s")
RATES = Text(en="joint rate, rad/s", pt_BR="velocidade de junta, rad/s")
ERRORS = Text(en="error", pt_BR="erro")
FASTEST = Text(en="fastest joint", pt_BR="junta mais rápida")
FASTEST_LATER = Text(en="fastest joint from 5 s on", pt_BR="junta mais rápida a partir de 5 s")
ERROR_LATER = Text(en="largest error from 5 s on", pt_BR="maior erro a partir de 5 s")
RMS_LATER = Text(en="rms error from 5 s on", pt_BR="erro rms a partir de 5 s")
FASTEST_AFTER_3 = Text(en="fastest joint after 3 s", pt_BR="junta mais rápida após 3 s")
WORST_AFTER_3 = Text(en="largest error after 3 s", pt_BR="maior erro após 3 s")
RMS_AFTER_3 = Text(en="rms error after 3 s", pt_BR="erro rms após 3 s")
NEAREST_AFTER_3 = Text(en="least distance after 3 s", pt_BR="menor distância após 3 s")
APART = Text(en="largest difference of a joint from the pseudoinverse", pt_BR="maior diferença à pseudoinversa")
NO_LENGTHS = Text(en="link lengths 2, 1, 1", pt_BR="comprimentos dos elos 2, 1, 1")


def choice(ways: Mapping[str, Way]) -> OneOf:
    """A setting: which of the runs the arm shows."""
    return OneOf(
        Text(en="run that the arm shows", pt_BR="simulação que o braço mostra"),
        {key: one.title for key, one in ways.items()},
    )


@dataclass(frozen=True)
class Sheet:
    """How a study writes its rows: in its short form or not, and with the settings of the digest or others.

    With other settings there is nothing to compare with, and every number stands alone.
    """

    short: bool
    changed: bool = False

    def row(
        self,
        quantity: Text,
        of: Text | None,
        ours: float,
        digest: str | None = None,
        unit: str = "",
        *,
        coarse: float | None = None,
        within: float | None = None,
        relation: Literal["=", "≥", "≤"] = "=",
        source: str | Text = FIGURE_ONLY,
        assumed: Text | None = None,
    ) -> Row:
        """A quantity of one of the runs, beside the number of the digest as it is printed there.

        It is met to little more than half a unit of its last digit, or `within` what is given; `coarse` is the share of
        it that the short form may miss besides, None where that does not hold the number.
        """
        title = quantity if of is None else Text(en=f"{quantity.en}: {of.en}", pt_BR=f"{quantity.pt_BR}: {of.pt_BR}")
        if self.changed:
            return Row(title, ours, unit=unit)
        if digest is None or (self.short and coarse is None):
            return Row(title, ours, unit=unit, source=source, assumed=assumed)
        value = float(digest)
        tolerance = (last_digit(digest) if relation == "=" else 0.0) if within is None else within
        if self.short:
            tolerance = max(tolerance, (coarse or 0.0) * abs(value))
        return Row(title, ours, value, tolerance, unit, source, relation, assumed=assumed)


def last_digit(digits: str) -> float:
    """Little more than half a unit of the last digit of a printed number, such as "0.0246" or "8.3e-4"."""
    mantissa, _, power = digits.partition("e")
    return 0.6 * 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


def is_changed(options: Any) -> bool:
    """Whether settings are not those of the digest; which run is shown does not count."""
    usual = type(options)()
    return bool((replace(options, shown=usual.shown) if hasattr(usual, "shown") else options) != usual)


def rates_chart(run: Run, of: Text, when: slice = slice(None)) -> Chart:
    """The joint rates of a run."""
    t, rates = thinned(run.t[when]), thinned(run.rates[when])
    lines = tuple(Line(same(f"q̇{i + 1}"), t, column) for i, column in enumerate(rates.T))
    return Chart(Text(en=f"joint rates, {of.en}", pt_BR=f"velocidades de junta, {of.pt_BR}"), SECONDS, RATES, lines)


def errors_chart(runs: Mapping[Text, Run], unit: str, title: Text = ERRORS) -> Chart:
    """‖e‖ of several runs."""
    lines = tuple(Line(name, thinned(run.t), thinned(run.size)) for name, run in runs.items())
    return Chart(title, SECONDS, Text(en=f"‖e‖, {unit}", pt_BR=f"‖e‖, {unit}"), lines)


def figures_chart(title: Text, symbol: str, runs: Mapping[Text, Run], unit: str = "") -> Chart:
    """A figure of the method, such as V_c or δ, of several runs."""
    lines = tuple(Line(name, run.shown, run.figure(symbol)) for name, run in runs.items())
    return Chart(title, SECONDS, same(f"{symbol}{unit and ', ' + unit}"), lines)


def w_chart(runs: Mapping[Text, Run], unit: str) -> Chart:
    """The manipulability of several runs."""
    lines = tuple(Line(name, thinned(run.t), thinned(run.w)) for name, run in runs.items())
    return Chart(Text(en="manipulability", pt_BR="manipulabilidade"), SECONDS, same(f"w, {unit}"), lines)


def way_chart(lines: Mapping[Text, Array], across: str, up: str) -> Chart:
    """Ways in a plane, (k, 2) each."""
    return Chart(
        Text(en="way", pt_BR="caminho"),
        same(across),
        same(up),
        tuple(Line(name, *thinned(points).T) for name, points in lines.items()),
    )


def titled(ways: Mapping[str, Way], runs: Mapping[str, Run]) -> dict[Text, Run]:
    """The runs by their titles."""
    return {ways[key].title: run for key, run in runs.items()}


def thinned(values: Array, most: int = 2000) -> Array:
    """At most about so many of the values, evenly picked."""
    return values[:: max(1, len(values) // most)]


def planar_motion(run: Run) -> Motion:
    """What the planar arm did."""
    return Motion("planar3r", thinned(run.t), thinned(run.q), LENGTHS)


def zebra_motion(run: Run) -> Motion:
    """What the Zebra-ZERO did; its last three joints at 0 where the run has three."""
    q = thinned(run.q)
    return Motion("zebra_zero", thinned(run.t), np.pad(q, ((0, 0), (0, 6 - q.shape[1]))))
