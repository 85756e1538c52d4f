"""E3: an operator's hand leads the tool near a singularity, while the entry point moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.geometry import rotation
from helicoide.ik.method import OneOf, Quantity
from helicoide.studies._coutinho_hand import ENTRY_SPEED, PERIOD, SAMPLE, TURN, Device, dragging, led, steering
from helicoide.studies._coutinho_rows import FEEDBACK, charts_of, motions_of, rows_of, stays
from helicoide.studies._coutinho_runs import INVERSES, ROBOT, Run, crossings
from helicoide.studies.coutinho_e2 import CROSSED, HAND, INVERSE
from helicoide.studies.study import Fitted, Progress, Result, Row, Statement, printed, unstated
from helicoide.text import Text

TITLE = Text(en="E3: a hand near a singularity", pt_BR="E3: a mão perto de uma singularidade")
SOURCE = "Coutinho 2015, §4.2, §4.2.3, figs. 4.38–4.43, tab. 4.3"
ABOUT = Text(
    en="A hand on a haptic device leads the tool, a thousand poses a second, while the entry point swings; the path "
    "comes through θ₇ = 0, as the operator was asked to steer. With the filtered inverse the joints stay calm, while "
    "the tip gives way at the singularity and comes back behind it.",
    pt_BR="A mão num dispositivo háptico conduz a ponta, mil poses por segundo, enquanto o ponto de entrada oscila; a "
    "trajetória passa por θ₇ = 0, como se pediu ao operador. Com a inversa filtrada as juntas ficam calmas, e a ponta "
    "cede na singularidade e se recupera depois dela.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

SHORT = 6.0
# w_r above which the arm counts as far from the singularity.
FAR = 0.1
TURNED = Fitted(Text(en="its turn", pt_BR="o giro dela"), TURN, 0.9 * TURN, 1.1 * TURN, "rad")
TWO = Text(en="two points near the singularity", pt_BR="dois pontos próximos da singularidade")
LARGER = Text(en="errors larger near the singular points", pt_BR="erros maiores perto dos pontos singulares")
LOW = Text(en="low errors", pt_BR="erros baixos")
CALM = Text(en="the norm of the joint velocities stays low", pt_BR="a norma das velocidades das juntas continua baixa")
FIGURES = "figs. 4.38–4.43"
CHARTS = ("tip", "entry", "command", "outside", "rate", "q7", "w", "lateral")


@dataclass(frozen=True)
class Options:
    """How J^r is inverted, and the gain Kr, 1/s."""

    inverse: Annotated[str, OneOf(INVERSE, {name: title for name, (title, _) in INVERSES.items()})] = "filtered"
    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 0.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The hand's motion at 2 ms; short: its first 6 s, in which the wrist has come through the singularity once."""
    title, of_tool = INVERSES[options.inverse]
    got = led(steering(), ENTRY_SPEED, of_tool, options.feedback, SHORT if short else PERIOD, progress)
    rows = (*_stated(got, short), Row(STEADY, _unsteady(), "m/s"), *rows_of(got, title, 0.002, FIGURES))
    return Result(
        rows=rows if options.inverse == "filtered" else unstated(rows),
        charts=charts_of({title: got}, dict.fromkeys(CHARTS, FIGURES)),
        motions=motions_of({title: got}),
    )


def _stated(got: Run, short: bool) -> list[Row]:
    """What the source says of E3; the beginning cannot count the singular points."""
    near, fitted = got["w"] < FAR, (*HAND, TURNED)
    error_near, error_far = got["tip_mm"][near].max(initial=0.0), got["tip_mm"][~near].max(initial=0.0)
    counted = Row(CROSSED, crossings(got["q7"]), "", Statement(TWO, "§4.2.3", 2.0), fitted)
    return [
        *(() if short else (counted,)),
        Row(RATIO, float(error_near / error_far), "", Statement(LARGER, "§4.2.3", 1.0, ">"), fitted),
        Row(SHARE, float(got["of_speed"].max()), "", Statement(CALM, "§4.2.3", 1.0, "<"), fitted),
        Row(ENTRY, 0.1 * float(got["v_x"].max()), "cm/s", printed("1", "§4.2.1, §4.2.3")),
        stays(got, "eq. 3.30", Text(en="H V_r = v_rd", pt_BR="H V_r = v_rd")),
        Row(TIP_FAR, float(error_far), "mm", Statement(LOW, "§4.2.3", 1.0, "≤"), fitted),
        Row(TIP_NEAR, float(error_near), "mm"),
    ]


def _unsteady() -> float:
    """By how much the velocity that is read of a steady drag differs from it, m/s, over a second."""
    velocity = np.array([0.01, -0.02, 0.015])
    T = np.eye(4)
    T[:3, :3] = rotation.exponential([0.3, -1.1, 0.6])
    device = Device(dragging(velocity), T)
    read = np.array([device.wished(number * SAMPLE).ahead[:3] for number in range(1, 1001)])
    return float(np.abs(read - T[:3, :3] @ velocity).max())


RATIO = Text(
    en="largest error of the tip where w_r < 0.1, over that elsewhere",
    pt_BR="maior erro da ponta onde w_r < 0,1, sobre o do resto do caminho",
)
SHARE = Text(en="largest share of a joint's speed", pt_BR="maior fração da velocidade de uma junta")
ENTRY = Text(
    en="largest velocity of the shaft at the entry point", pt_BR="maior velocidade da haste no ponto de entrada"
)
TIP_NEAR = Text(en="largest error of the tip where w_r < 0.1", pt_BR="maior erro da ponta onde w_r < 0,1")
TIP_FAR = Text(en="largest error of the tip elsewhere", pt_BR="maior erro da ponta no resto do caminho")
STEADY = Text(
    en="a steady drag: how far its read velocity is from steady",
    pt_BR="arrasto constante: quanto a velocidade lida difere da constante",
)
