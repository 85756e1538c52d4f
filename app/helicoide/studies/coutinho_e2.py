"""E2: an operator's hand leads the tool through an entry point that stands still."""

from __future__ import annotations

from helicoide.studies._coutinho_hand import BODY_FRAME_ERROR, PERIOD, STEP, Options, run_led, steering_hand
from helicoide.studies._coutinho_rows import ARM, NULL, TIMES, leaving_rate_row, measure_rows, run_charts, run_motions
from helicoide.studies._coutinho_runs import INVERSES, ROBOT, Run, sign_changes
from helicoide.studies.study import INPUT_VALUE, Fitted, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="E2: a hand leads the end effector", pt_BR="E2: a mão conduz a ponta")
SOURCE = "Coutinho 2015, §4.2, §4.2.2, figs. 4.31–4.37, tab. 4.3"
ABOUT = Text(
    en="A hand on a haptic device leads the end effector, a thousand poses a second, while the entry point stands "
    "still; the filtered inverse answers every 2 ms, with the gains of the experiments. How the hand moves is ours, "
    "and it keeps away from the singularity θ₇ = 0; the shaft slides and turns in its entry point without pushing it. "
    "The source measured this on the robot; here hand and arm are simulated, without noise.",
    pt_BR="A mão num dispositivo háptico conduz a ponta, mil poses por segundo, com o ponto de entrada parado; a "
    "inversa filtrada responde a cada 2 ms, com os ganhos dos experimentos. O movimento da mão é nosso e fica longe da "
    "singularidade θ₇ = 0; a haste desliza e gira no ponto de entrada sem empurrá-lo. A fonte mediu isso no robô; aqui "
    "a mão e o braço são simulados, sem ruído.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

SHORT = 6.0
# What the hand does, mm and s; by tests/studies/fits/coutinho_hand.py.
SIZE = Fitted(
    Text(en="half of how far the hand leads in", pt_BR="metade do avanço da mão para dentro"), 27.0, 24.3, 29.7, "mm"
)
ASIDE = Fitted(Text(en="how far it leads aside", pt_BR="o avanço dela para o lado"), 15.0, 13.5, 16.5, "mm")
LASTS = Fitted(Text(en="its period", pt_BR="o período dela"), PERIOD, 54.0, 66.0, "s")
NONE_MET = Text(en="no singularity is met", pt_BR="nenhuma singularidade é encontrada")
STILL = Text(
    en="velocities of the entry point about 0, up to the robot's noise",
    pt_BR="velocidades do ponto de entrada praticamente nulas, a menos do ruído do robô",
)
FIGURES = "figs. 4.31–4.37"
CHARTS = ("tip", "entry", "command", "outside", "rate", "q7", "w")


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The hand's motion at 2 ms; short: its first 6 s."""
    title, of_tool = INVERSES[options.inverse]
    hand = steering_hand(1e-3 * SIZE.value, 1e-3 * ASIDE.value, 0.0)
    got = run_led(hand, 0.0, of_tool, options.feedback, SHORT if short else PERIOD, progress)
    rows = (*e2_rows(got), *measure_rows(got, title, STEP, FIGURES))
    return Result(
        rows=rows,
        charts=run_charts({title: got}, dict.fromkeys(CHARTS, FIGURES)),
        motions=run_motions({title: got}),
    )


def e2_rows(got: Run) -> list[Row]:
    """What the source says of E2."""
    return [
        leaving_rate_row(got, STEP, Statement(STILL, "§4.2.2", NULL, "≤"), (ARM, SIZE, ASIDE, LASTS, BODY_FRAME_ERROR)),
        Row(TIMES, sign_changes(got["q7"]), "", Statement(NONE_MET, "§4.2.2", 0.0), given=INPUT_VALUE),
    ]
