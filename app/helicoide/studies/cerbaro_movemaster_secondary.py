"""The Movemaster round its ellipse with its orientation free: one gain for all joints keeps off limits, and fails."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.confined import limit_margins
from helicoide.studies.cerbaro_runs.runs import (
    LoopRun,
    error_chart,
    joint_charts,
    loop_motion,
    pitch,
    pitch_chart,
    share_of_runs,
)
from helicoide.studies.cerbaro_runs.tracking import (
    DT,
    DT_SHORT,
    LimitGain,
    gain_in_degrees,
    run_free_ellipse,
    start_of_ellipse,
)
from helicoide.studies.study import Figure, Interpretation, Progress, Result, Row, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="One gain for all joints, and where it fails", pt_BR="Um só ganho para as juntas, e onde falha")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 3, fig. 37"
ROBOT = "movemaster"
ABOUT = Text(
    en="The ellipse once more with the orientation free: J2, J3 and J4 have a freedom to share. One gain for all pulls "
    "J3, which begins beyond its limit, back at once, and pays for it with J4, which ends nearer to its own than "
    "without any pull. J3 then stays inside. The loop has the velocity ẋ_d of the path. Were k₀ counted in degrees, "
    "and with the 6 that eq. 14 prints, it would be two thousand times weaker: J3 would stay outside longer, but J4 "
    "would end farther from its limit.",
    pt_BR="De novo a elipse, com a orientação livre: J2, J3 e J4 dividem uma liberdade. Um só ganho para todas traz "
    "J3, que parte além do limite, logo de volta, à custa de J4, que acaba mais perto do seu do que sem atração "
    "nenhuma. Depois disso J3 fica dentro. A malha leva a velocidade ẋ_d da trajetória. Com k₀ contado em graus, e com "
    "o 6 que a eq. 14 imprime, ele valeria duas mil vezes menos: J3 ficaria mais tempo fora, mas J4 acabaria mais "
    "longe do seu limite.",
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
PASSES = Statement(Text(en="J3 passes its limit", pt_BR="J3 ultrapassa o limite"), "§4.4.4, fig. 37", 0.0, "<")
FROM_THE_START = Interpretation(
    Text(en="the start counts", pt_BR="o início conta"),
    Text(
        en="inside after 0.03 s, with a margin of 21° from 0.1 s on",
        pt_BR="dentro depois de 0,03 s, com folga de 21° a partir de 0,1 s",
    ),
)
IN_RADIANS = Interpretation(
    Text(en="k₀ counted in radians", pt_BR="k₀ contado em radianos"),
    Text(
        en="in degrees J4 ends 6.6° farther from its limit than with k₀ = 0",
        pt_BR="em graus J4 acaba 6,6° mais longe do limite do que com k₀ = 0",
    ),
)
SETTLED = 0.1


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms without k₀, with it, and with it in degrees; in a quick run a tenth of them."""
    dt, q = DT_SHORT if short else DT, start_of_ellipse()
    gains = (0.0, options.gain, gain_in_degrees(options.gain, len(q)))
    plain, pushed, in_deg = (
        run_free_ellipse(q, LimitGain(k0), dt, share_of_runs(progress, i, 3)) for i, k0 in enumerate(gains)
    )
    named = (
        (Text(en="k₀ = 0", pt_BR="k₀ = 0"), plain),
        (Text(en="with k₀", pt_BR="com k₀"), pushed),
        (Text(en="with k₀ in degrees", pt_BR="com k₀ em graus"), in_deg),
    )
    charts = (
        *joint_charts("fig. 37", setups.movemaster(), (2, 3, 4), *named),
        pitch_chart("fig. 37f", "q₂ + q₃ + q₄", *named),
        error_chart("fig. 37", *named),
    )
    found = secondary_rows(plain, pushed, in_deg, short)
    motions = tuple(loop_motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def secondary_rows(plain: LoopRun, pushed: LoopRun, in_deg: LoopRun, short: bool) -> tuple[Row, ...]:
    """What the source says of fig. 37; error and first speed for steps of 1 ms only."""
    movemaster = setups.movemaster()
    j4 = [float(limit_margins(movemaster, one.q)[3]) for one in (plain, pushed, in_deg)]
    j3 = [float(limit_margins(movemaster, one.q)[2]) for one in (pushed, pushed.since(SETTLED), in_deg.since(SETTLED))]
    nearer = Text(en="J4 to its limit {which}, less that without", pt_BR="J4 até o limite {which}, menos a sem k₀")
    room = Text(en="least margin of J3 to its limits, {which}", pt_BR="menor folga de J3 até os limites, {which}")
    later = Text(en="{which}, after {t:g} s", pt_BR="{which}, após {t:g} s")
    with_k0, degrees = Text(en="with k₀", pt_BR="com k₀"), Text(en="with k₀ in degrees", pt_BR="com k₀ em graus")
    found = [
        Row(nearer.format(which=with_k0), j4[1] - j4[0], "°", NEARER, (IN_RADIANS,)),
        Row(room.format(which=with_k0), j3[0], "°", PASSES, (FROM_THE_START,)),
        Row(
            Text(en="J1 and J5 moved by the objective", pt_BR="J1 e J5 movidas pelo objetivo"),
            float(np.degrees(np.abs(pushed.q - plain.q)[:, [0, 4]].max())),
            "°",
            OTHERS,
        ),
        *(
            Row(
                Text(en="pitch at the end, {which}", pt_BR="arfagem (Pitch) no fim, {which}").format(which=which),
                float(np.degrees(pitch(one.q[-1:])[0])),
                "°",
                Figure("fig. 37f"),
            )
            for which, one in ((untranslated("k₀ = 0"), plain), (with_k0, pushed))
        ),
        Row(nearer.format(which=degrees), j4[2] - j4[0], "°"),
        *(
            Row(room.format(which=later.format(which=which, t=SETTLED)), margin, "°")
            for which, margin in zip((with_k0, degrees), j3[1:], strict=True)
        ),
    ]
    if not short:
        error = Text(en="largest position error", pt_BR="maior erro de posição")
        first = Text(en="fastest joint, at the very first", pt_BR="junta mais rápida, logo no início")
        back = Text(en="J3 begins beyond its limit and is back after", pt_BR="J3 parte além do limite e volta após")
        found += [
            Row(error, float(pushed.position_error.max()), "mm", Figure("fig. 37")),
            Row(first, float(np.degrees(pushed.largest_velocity.max())), "°/s"),
            Row(back, float(pushed.t[pushed.q[:, 2] < movemaster.limits.lower[2]].max()), "s"),
        ]
    return tuple(found)
