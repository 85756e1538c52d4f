"""E3: an operator's hand leads the tool near a singularity, while the entry point moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.geometry import rotation
from helicoide.ik.method import OneOf, Quantity
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.follow import followed
from helicoide.ik.rcm.passage import through
from helicoide.studies._coutinho_hand import PERIOD, SAMPLE, Device, dragging, steering
from helicoide.studies._coutinho_rows import FEEDBACK, FIGURES, charts_of, motion_of, row
from helicoide.studies._coutinho_runs import (
    DEPTH,
    LINK,
    ROBOT,
    START,
    Run,
    control,
    dia10,
    entry_on,
    first_memory,
    measured,
    problem_of,
)
from helicoide.studies.coutinho_s3 import INVERSE, INVERSES
from helicoide.studies.study import Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="A hand leads the tool", pt_BR="A mão conduz a ponta")
SOURCE = "Coutinho 2015, §4.2, §4.2.3, figs. 4.38–4.43"
ABOUT = Text(
    en="A hand on a haptic device leads the tool, a thousand poses a second, while the entry point swings; the path "
    "comes through θ₇ = 0, as the operator was asked to steer. With a bounded inverse the joints stay calm, while "
    "the tip gives way at the singularity and comes back behind it.",
    pt_BR="A mão num dispositivo háptico conduz a ponta, mil poses por segundo, enquanto o ponto de entrada oscila; a "
    "trajetória passa por θ₇ = 0, como se pediu ao operador. Com uma inversa limitada as juntas ficam calmas, e a "
    "ponta cede na singularidade e se recupera depois dela.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

STEP, SHORT = 0.002, 10.0
# w_r above which the arm counts as far from the singularity.
FAR = 0.5
HAND = Text(
    en="the motion of the hand is a formula of ours, and so are the joints at the start",
    pt_BR="o movimento da mão é uma fórmula nossa, assim como as juntas no início",
)


@dataclass(frozen=True)
class Options:
    """How J^r is inverted, and the gain Kr, 1/s."""

    inverse: Annotated[str, OneOf(INVERSE, {name: title for name, (title, _) in INVERSES.items()})] = "filtered"
    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 5.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The hand's motion at 2 ms; short: its first 10 s, in which the wrist has come through the singularity once."""
    got = led(options, SHORT if short else PERIOD, progress)
    bounded = options.inverse != "plain"
    near = got["w"] < FAR
    return Result(
        rows=(
            _figure(got, "lateral", "≤0.05" if options.feedback > 0 else None),
            _figure(got, "slip", "≤1e-7"),
            row(NEAREST, got["w"].min(), "≤0.05" if bounded else None, assumed=HAND),
            _figure(got, "rate", "≤10" if bounded else None),
            row(TIP_NEAR, got["tip_mm"][near].max(), None, "mm", assumed=HAND),
            row(TIP_FAR, got["tip_mm"][~near].max(), None, "mm", assumed=HAND),
            row(STEADY, _unsteady(), "≤1e-9", "m/s", assumed=HAND),
        ),
        charts=charts_of({INVERSES[options.inverse][0]: got}),
        motion=motion_of(got),
    )


def led(options: Options, seconds: float, progress: Progress) -> Run:
    """What the steps of so many seconds measured; w: w_r at each of them, by its formula."""
    robot = dia10()
    problem, passage = problem_of(robot), through(robot, LINK)
    entry, device = entry_on(robot, START, DEPTH), Device(steering, tool_at(robot, START))
    gained = control(options.feedback, INVERSES[options.inverse][1])
    memory = first_memory(problem, passage, gained, START, entry)
    steps = followed(problem, passage, gained, device.wished, START, entry, STEP, memory)
    got = measured(steps, round(seconds / STEP) + 1, STEP, progress)
    w = (got["inside"] / got["outside"]) ** 2 * np.abs(np.sin(got["q7"]))
    return {**got, "w": w}


def _figure(got: Run, name: str, printed: str | None) -> Row:
    title, unit, figure = FIGURES[name]
    return row(title, figure(got), printed, unit, assumed=HAND)


def _unsteady() -> float:
    """By how much the velocity that is read of a steady drag differs from it, m/s, over a second."""
    velocity = np.array([0.01, -0.02, 0.015])
    T = np.eye(4)
    T[:3, :3] = rotation.exponential([0.3, -1.1, 0.6])
    device = Device(dragging(velocity), T)
    read = np.array([device.wished(number * SAMPLE).ahead[:3] for number in range(1, 1001)])
    return float(np.abs(read - T[:3, :3] @ velocity).max())


NEAREST = Text(en="smallest w_r on the way", pt_BR="menor w_r no caminho")
TIP_NEAR = Text(en="largest error of the tip where w_r < 0.5", pt_BR="maior erro da ponta onde w_r < 0,5")
TIP_FAR = Text(en="largest error of the tip elsewhere", pt_BR="maior erro da ponta no resto do caminho")
STEADY = Text(
    en="a steady drag: how far its read velocity is from steady",
    pt_BR="arrasto constante: quanto a velocidade lida difere da constante",
)
