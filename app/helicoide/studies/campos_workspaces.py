"""Where a planar arm reaches: the annulus of two links and the ring of the polar arm, counted and in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.closed import planar2r
from helicoide.ik.postures.workspace import reachable
from helicoide.kinematics import workspace
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import Map
from helicoide.studies._campos_arms import limited, planar, upright
from helicoide.studies._campos_rows import LENGTH_1, LENGTH_2, millimetres, posed, row
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="Workspaces in a plane", pt_BR="Espaços de trabalho no plano")
SOURCE = "Campos 1998, s.6–13, s.31–34"
ABOUT = Text(
    en="Two links reach an annulus, every point inside with two orientations and every point on an edge with one. "
    "Random postures find the same area as the formula, and limiting the elbow to one side changes the count, not "
    "the area.",
    pt_BR="Dois elos alcançam um anel: cada ponto interno com duas orientações, cada ponto da borda com uma. Posturas "
    "aleatórias encontram a mesma área da fórmula, e limitar o cotovelo a um lado muda a contagem, não a área.",
)
ROBOT = "planar2r"

SAMPLES, FEW = 4_000_000, 300_000
# Relative errors of an area; measured are 0.2 % and 1.2 % at most.
CLOSE, COARSE = 0.006, 0.02
# How far off an edge points are counted, m, as the slides' own check has it.
ASIDE = 1e-6


@dataclass(frozen=True)
class Options:
    """The lengths of the two links, m."""

    l1: Annotated[float, LENGTH_1] = 1.0
    l2: Annotated[float, LENGTH_2] = 0.7


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Areas by random postures, and counts at the edges; short: fewer postures."""
    l1, l2 = options.l1, options.l2
    robot, polar = planar(ROBOT, l1, l2), load("polar_rp")
    half = limited(robot, [0.0, 0.0], [2 * np.pi, np.pi])
    samples, near = (FEW, COARSE) if short else (SAMPLES, CLOSE)
    maps = [_map(arm, samples, done, progress) for done, arm in enumerate((robot, half, polar))]
    inner, outer = reachable(np.array([l1, l2]))
    low, high = polar.lower[1], polar.upper[1]
    areas = (np.pi * (outer**2 - inner**2), np.pi * (outer**2 - inner**2), np.pi * (high**2 - low**2))
    return Result(
        rows=(
            *(
                row(AREA.format(which=which), found.measure, area, near * area, "m²")
                for which, found, area in zip((TWO, HALF, POLAR), maps, areas, strict=True)
            ),
            *_counts(robot, half, inner, outer),
        ),
        charts=(_radial(maps[0]),),
        motion=posed(ROBOT, [np.zeros(2), np.array([0.0, np.pi])], millimetres(l1=l1, l2=l2)),
    )


def _map(robot: Robot, samples: int, done: int, progress: Progress) -> Map:
    plan = workspace.planned(robot, "reachable", samples)
    return workspace.gathered(plan, workspace.parts(plan), lambda share: progress((done + share) / 3))


def _counts(robot: Robot, half: Robot, inner: float, outer: float) -> list[Row]:
    """How many postures there are for points beside the edges, on them and between."""

    def count(arm: Robot, r: float) -> int:
        return sum(branch.within for branch in planar2r.solve(arm, upright(r, 0.0), np.zeros(2)).branches)

    places = [
        (OUTSIDE, outer + ASIDE, 0),
        (OUTER, outer, 1),
        (INSIDE, 0.5 * (inner + outer), 2),
        # equal links close the hole: there the centre is reached with any orientation, by one folded posture
        (INNER, inner, 1),
        *([(HOLE, inner - ASIDE, 0)] if inner > ASIDE else []),
    ]
    found = [row(which, count(robot, r), expected, source=str(expected)) for which, r, expected in places]
    return [*found, row(ONE_SIDE, count(half, 0.5 * (inner + outer)), 1, source="1")]


def _radial(found: Map) -> Chart:
    """How many postures there are for each area, by the distance from the first axis."""
    r = np.hypot(*found.cells.centres[:, :2].T)
    edges = np.linspace(0, r[found.reached].max(), 60)
    inside = np.histogram(r, edges)[0]
    hits = np.histogram(r, edges, weights=found.hits)[0]
    return Chart(
        Text(en="Random postures by distance", pt_BR="Posturas aleatórias por distância"),
        same("r, m"),
        Text(en="share of postures per m²", pt_BR="fração das posturas por m²"),
        (
            Line(
                TWO, 0.5 * (edges[1:] + edges[:-1]), hits / np.maximum(inside, 1) / found.samples / found.cells.size**2
            ),
        ),
    )


AREA = Text(en="area, {which}", pt_BR="área, {which}")
TWO = Text(en="two links", pt_BR="dois elos")
HALF = Text(en="the elbow to one side only", pt_BR="cotovelo só de um lado")
POLAR = Text(en="polar arm", pt_BR="braço polar")
OUTSIDE = Text(en="postures 1 µm beyond the outer edge", pt_BR="posturas 1 µm além da borda externa")
OUTER = Text(en="postures on the outer edge", pt_BR="posturas na borda externa")
INSIDE = Text(en="postures between the edges", pt_BR="posturas entre as bordas")
INNER = Text(en="postures on the inner edge", pt_BR="posturas na borda interna")
HOLE = Text(en="postures 1 µm inside the hole", pt_BR="posturas 1 µm para dentro do vazio")
ONE_SIDE = Text(
    en="postures between the edges, the elbow to one side only",
    pt_BR="posturas entre as bordas, cotovelo só de um lado",
)
