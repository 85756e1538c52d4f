"""E3: an operator's hand leads the tool near a singularity, while the entry point moves."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.studies._coutinho_hand import (
    BODY_FRAME_ERROR,
    ENTRY_SPEED,
    PERIOD,
    SAMPLE,
    STEP,
    HapticDevice,
    Options,
    dragging_hand,
    run_led,
    steering_hand,
)
from helicoide.studies._coutinho_rows import (
    ARM,
    ENTRY,
    LOW,
    MISSED,
    SHARE,
    leaving_rate_row,
    measure_rows,
    run_charts,
    run_motions,
)
from helicoide.studies._coutinho_runs import INVERSES, ROBOT, Run
from helicoide.studies.coutinho_e2 import LASTS
from helicoide.studies.study import INPUT_VALUE, Fitted, Progress, Result, Row, Statement, printed_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="E3: a hand near a singularity", pt_BR="E3: a mão perto de uma singularidade")
SOURCE = "Coutinho 2015, §4.2, §4.2.3, figs. 4.38–4.43, tab. 4.3"
ABOUT = Text(
    en="A hand on a haptic device leads the end effector, a thousand poses a second, while the entry point swings; how "
    "it moves is ours, twice through θ₇ = 0, as the operator was asked to steer. With the filtered inverse the joints "
    "stay calm, while the error of the tip is a fifth larger near the singularity than away from it.",
    pt_BR="A mão num dispositivo háptico conduz a ponta, mil poses por segundo, enquanto o ponto de entrada oscila; o "
    "movimento dela é nosso e passa duas vezes por θ₇ = 0, como se pediu ao operador. Com a inversa filtrada as juntas "
    "ficam calmas, e o erro da ponta é um quinto maior perto da singularidade do que longe dela.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

SHORT = 16.0
# w_r below which the wrist counts as near the singularity, and above which it has left it.
NEAR, LEFT = 0.1, 0.2
# What the hand does, mm and rad; by tests/studies/fits/coutinho_hand.py.
SIZE = Fitted(
    Text(en="half of how far the hand leads in", pt_BR="metade do avanço da mão para dentro"), 9.0, 8.1, 9.9, "mm"
)
TURN = Fitted(Text(en="its turn", pt_BR="o giro dela"), 0.26, 0.234, 0.286, "rad")
HAND = (SIZE, TURN, LASTS)
LED = (ARM, *HAND, BODY_FRAME_ERROR)
BOUND = Fitted(Text(en="bound of w_r", pt_BR="limiar de w_r"), NEAR, 0.03, 0.3)
TWO = Text(en="two points near the singularity", pt_BR="dois pontos próximos da singularidade")
LARGER = Text(en="errors larger near the singular points", pt_BR="erros maiores perto dos pontos singulares")
SMALL = Text(en="low errors", pt_BR="erros baixos")
CALM = Text(en="the norm of the joint velocities stays low", pt_BR="a norma das velocidades das juntas continua baixa")
FIGURES = "figs. 4.38–4.43"
MEASURED = ("tip", "angle", "lateral", "q7_min", "q7_max", "outside_min", "outside_max", "rate")
CHARTS = ("tip", "entry", "command", "outside", "rate", "q7", "w", "lateral")


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The hand's motion at 2 ms; short: its first 16 s, in which the wrist has come through the singularity once."""
    title, of_tool = INVERSES[options.inverse]
    hand = steering_hand(1e-3 * SIZE.value, 0.0, TURN.value)
    got = run_led(hand, ENTRY_SPEED, of_tool, options.feedback, SHORT if short else PERIOD, progress)
    counted = (
        ()
        if short
        else (Row(TIMES, singular_approaches(got["w"]), "", Statement(TWO, "§4.2.3", 2.0), given=INPUT_VALUE),)
    )
    rows = (
        *counted,
        *e3_rows(got),
        Row(STEADY, _unsteady(), "m/s"),
        *measure_rows(got, title, STEP, FIGURES, MEASURED),
    )
    return Result(
        rows=rows,
        charts=run_charts({title: got}, dict.fromkeys(CHARTS, FIGURES)),
        motions=run_motions({title: got}),
    )


def singular_approaches(w: Array) -> int:
    """The number of times that w_r (k,) approaches the singularity after being far from it."""
    times, is_near = 0, False
    for value in w:
        if value < NEAR and not is_near:
            times, is_near = times + 1, True
        elif value > LEFT:
            is_near = False
    return times


def e3_rows(got: Run) -> list[Row]:
    """What the source says of E3, but for the number of its singular points."""
    near = got["w"] < NEAR
    error_near, error_far = got["tip_mm"][near].max(initial=0.0), got["tip_mm"][~near].max(initial=0.0)
    return [
        Row(RATIO, float(error_near / error_far), "", Statement(LARGER, "§4.2.3", 1.0, ">"), (*LED, BOUND)),
        Row(SHARE, float(got["of_speed"].max()), "", Statement(CALM, "§4.2.3", 1.0, "<"), LED),
        leaving_rate_row(
            got, STEP, Statement(untranslated("H V_r = v_rd"), "eq. 3.30", 1e3 * MISSED * ENTRY_SPEED, "≤"), LED
        ),
        Row(TIP_FAR, float(error_far), "mm", Statement(SMALL, "§4.2.3", LOW, "≤"), LED),
        Row(ENTRY, 0.1 * float(got["v_x"].max()), "cm/s", printed_statement("1", "§4.2.1, §4.2.3"), given=INPUT_VALUE),
        Row(TIP_NEAR, float(error_near), "mm"),
    ]


def _unsteady() -> float:
    """The largest error of the velocity, m/s, read by the controller over one second of constant motion."""
    velocity = np.array([0.01, -0.02, 0.015])
    T = np.eye(4)
    T[:3, :3] = rotation.exponential([0.3, -1.1, 0.6])
    device = HapticDevice(dragging_hand(velocity), T)
    read = np.array([device.reference(number * SAMPLE).feedforward[:3] for number in range(1, 1001)])
    return float(np.abs(read - T[:3, :3] @ velocity).max())


TIMES = Text(en="how often w_r falls below 0.1", pt_BR="quantas vezes w_r cai abaixo de 0,1")
RATIO = Text(
    en="largest error of the tip where w_r < 0.1, over that elsewhere",
    pt_BR="maior erro da ponta onde w_r < 0,1, sobre o do resto do caminho",
)
TIP_NEAR = Text(en="largest error of the tip where w_r < 0.1", pt_BR="maior erro da ponta onde w_r < 0,1")
TIP_FAR = Text(en="largest error of the tip elsewhere", pt_BR="maior erro da ponta no resto do caminho")
STEADY = Text(
    en="largest error of the velocity read off a hand that drags steadily",
    pt_BR="maior erro da velocidade lida quando a mão puxa com velocidade constante",
)
