"""The Movemaster round its ellipse with its orientation free: one gain for all joints keeps off limits, and fails."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_charts, motion, part
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, free_ellipse, start_of_ellipse
from helicoide.studies.study import FIGURE_ONLY, Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="One gain for all joints, and where it fails", pt_BR="Um só ganho para as juntas, e onde falha")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 3, fig. 37"
ROBOT = "movemaster"
ABOUT = Text(
    en="The ellipse once more with the orientation free: J2, J3 and J4 have a freedom to share. One gain for all pulls "
    "J3 back from beyond its limit, and pays for it with J4, which ends nearer to its own limit than without any pull.",
    pt_BR="De novo a elipse, com a orientação livre: J2, J3 e J4 dividem uma liberdade. Um só ganho para todas traz J3 "
    "de volta de além do limite, à custa de J4, que acaba mais perto do próprio limite do que sem atração nenhuma.",
)
OTHER = Text(en="another gain than the source’s", pt_BR="ganho diferente do da fonte")
ENDS = (
    Text(en="J{joint}, least, {which}", pt_BR="J{joint}, mínimo, {which}"),
    Text(en="J{joint}, largest, {which}", pt_BR="J{joint}, máximo, {which}"),
)
PLAIN, PUSHED = {3: (-130.8, -98.4), 4: (12.4, 22.9)}, {3: (-129.9, -72.0), 4: (-60.4, 13.5)}


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms with k₀ and without; in short form a tenth of them."""
    dt, q = DT_SHORT if short else DT, start_of_ellipse()
    plain, pushed = (free_ellipse(q, k0, dt, False, part(progress, i, 2)) for i, k0 in enumerate((0.0, options.gain)))
    named = ((Text(en="k₀ = 0", pt_BR="k₀ = 0"), plain), (Text(en="with k₀", pt_BR="com k₀"), pushed))
    charts = (*joint_charts(arms.movemaster(), (2, 3, 4), *named), *(error_chart(one) for one in named))
    return Result(rows(plain, pushed, options, short), charts, motion(ROBOT, pushed))


def rows(plain: Run, pushed: Run, options: Options, short: bool) -> tuple[Row, ...]:
    """What the digest gives; error and first speed for steps of 1 ms only."""
    other = None if options == Options() else OTHER
    found = [*_ranges(plain, PLAIN, "k₀ = 0", None), *_ranges(pushed, PUSHED, "k₀", other)]
    idle = Text(en="J1 and J5 moved by the objective", pt_BR="J1 e J5 movidas pelo objetivo")
    moved = float(np.degrees(np.abs(pushed.q - plain.q)[:, [0, 4]].max()))
    none = Text(en="only J2, J3, J4 change", pt_BR="só J2, J3, J4 mudam")
    limit = np.degrees(arms.movemaster().limits.upper[3])
    room = Text(en="J4 to its limit with k₀, less that without", pt_BR="J4 até o limite com k₀, menos a sem k₀")
    with_k0, without = (float(limit - np.degrees(np.abs(r.q[:, 3]).max())) for r in (pushed, plain))
    nearer = Text(en="J4 nearer its limit", pt_BR="J4 mais perto do limite")
    found += [
        Row(room, with_k0 - without, 0.0, 0.0, "°", nearer, "≤", assumed=other),
        Row(idle, moved, 0.0, 0.01, "°", none),
    ]
    if not short:
        error = Text(en="largest position error", pt_BR="maior erro de posição")
        first = Text(en="fastest joint, at the very first", pt_BR="junta mais rápida, logo no início")
        fast = float(np.degrees(pushed.fastest.max()))
        found += [
            Row(error, float(pushed.error.max()), 0.007, 2e-4, "mm", FIGURE_ONLY, assumed=other),
            Row(first, fast, 650.0, 5.0, "°/s", assumed=other),
        ]
    return tuple(found)


def _ranges(run: Run, told: dict[int, tuple[float, float]], which: str, assumed: Text | None) -> list[Row]:
    return [
        Row(end.format(joint=j, which=which), ours, digest, 0.06, "°", FIGURE_ONLY, assumed=assumed)
        for j, bounds in told.items()
        for end, ours, digest in zip(ENDS, run.degrees(j), bounds, strict=True)
    ]
