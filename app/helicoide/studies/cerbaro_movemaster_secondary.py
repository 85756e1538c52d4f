"""The Movemaster round its ellipse with its orientation free: one gain for all joints keeps off limits, and fails."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_charts, motion, part, pitch, pitch_chart
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, free_ellipse, start_of_ellipse
from helicoide.studies.study import Figure, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="One gain for all joints, and where it fails", pt_BR="Um só ganho para as juntas, e onde falha")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 3, fig. 37"
ROBOT = "movemaster"
ABOUT = Text(
    en="The ellipse once more with the orientation free: J2, J3 and J4 have a freedom to share. One gain for all "
    "pulls J3, which begins beyond its limit, back at once, and pays for it with J4, which ends nearer to its own than "
    "without any pull. How J3 passes its limit later is a matter of gain and start: see Algorithm 1.",
    pt_BR="De novo a elipse, com a orientação livre: J2, J3 e J4 dividem uma liberdade. Um só ganho para todas traz "
    "J3, que parte além do limite, logo de volta, à custa de J4, que acaba mais perto do seu do que sem atração "
    "nenhuma. Se J3 passa do limite depois é questão de ganho e de partida: veja o Algoritmo 1.",
)
NEARER = Statement(
    Text(en="J4 ends nearer its limit than with k₀ = 0", pt_BR="J4 acaba mais perto do limite do que com k₀ = 0"),
    "§4.4.4, fig. 37",
    0.0,
    "<",
)
OTHERS = Statement(
    Text(en="only J2, J3 and J4 change", pt_BR="só J2, J3 e J4 mudam"), "§4.4.4, fig. 37", 0.0, "=", 0.01
)


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms with k₀ and without; in short form a tenth of them."""
    dt, q = DT_SHORT if short else DT, start_of_ellipse()
    plain, pushed = (free_ellipse(q, k0, dt, False, part(progress, i, 2)) for i, k0 in enumerate((0.0, options.gain)))
    named = ((Text(en="k₀ = 0", pt_BR="k₀ = 0"), plain), (Text(en="with k₀", pt_BR="com k₀"), pushed))
    charts = (
        *joint_charts("fig. 37", arms.movemaster(), (2, 3, 4), *named),
        pitch_chart("fig. 37f", "q₂ + q₃ + q₄", *named),
        error_chart("fig. 37", *named),
    )
    found = rows(plain, pushed, short)
    motions = tuple(motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def rows(plain: Run, pushed: Run, short: bool) -> tuple[Row, ...]:
    """What the source says of fig. 37; error and first speed for steps of 1 ms only."""
    limit = np.degrees(arms.movemaster().limits.upper[3])
    with_k0, without = (float(limit - np.degrees(np.abs(one.q[:, 3]).max())) for one in (pushed, plain))
    found = [
        Row(
            Text(en="J4 to its limit with k₀, less that without", pt_BR="J4 até o limite com k₀, menos a sem k₀"),
            with_k0 - without,
            "°",
            NEARER,
        ),
        Row(
            Text(en="J1 and J5 moved by the objective", pt_BR="J1 e J5 movidas pelo objetivo"),
            float(np.degrees(np.abs(pushed.q - plain.q)[:, [0, 4]].max())),
            "°",
            OTHERS,
        ),
        *(
            Row(
                Text(en=f"pitch at the end, {which}", pt_BR=f"arfagem no fim, {which}"),
                float(np.degrees(pitch(one.q[-1:])[0])),
                "°",
                Figure("fig. 37f"),
            )
            for which, one in (("k₀ = 0", plain), ("k₀", pushed))
        ),
    ]
    if not short:
        error = Text(en="largest position error", pt_BR="maior erro de posição")
        first = Text(en="fastest joint, at the very first", pt_BR="junta mais rápida, logo no início")
        back = Text(en="J3 begins beyond its limit and is back after", pt_BR="J3 parte além do limite e volta após")
        found += [
            Row(error, float(pushed.error.max()), "mm", Figure("fig. 37")),
            Row(first, float(np.degrees(pushed.fastest.max())), "°/s"),
            Row(back, float(pushed.t[pushed.q[:, 2] < arms.movemaster().limits.lower[2]].max()), "s"),
        ]
    return tuple(found)
