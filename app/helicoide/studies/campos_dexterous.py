"""Which points a planar arm reaches with every orientation: the dexterous set of two and of three links."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.elbow import Annulus
from helicoide.ik.method import Quantity
from helicoide.ik.postures.workspace import dexterous
from helicoide.studies._campos_rows import campos_result, length_settings, posture_motion, slide_statement
from helicoide.studies.study import Chart, ChartLine, Progress, Result, Row
from helicoide.text import Text, untranslated

TITLE = Text(en="With every orientation", pt_BR="Com qualquer orientação")
SOURCE = "Campos 1998, s.6–10, s.53"
ABOUT = Text(
    en="A point belongs to the dexterous workspace if the hand can be there with every orientation: the circle of the "
    "wrist around it must lie in the annulus of the first two links. Two unequal links have no such point, two equal "
    "ones a single one, the first axis.",
    pt_BR="Um ponto pertence ao espaço destro se a mão pode estar nele com qualquer orientação: o círculo do punho em "
    "torno dele deve caber no anel dos dois primeiros elos. Dois elos desiguais não têm nenhum ponto assim; dois "
    "iguais têm um só, o primeiro eixo.",
)
ROBOT = "planar3r"

L1, L2 = 1.0, 0.7
HAND = Quantity(Text(en="length of the hand", pt_BR="comprimento da mão"), 0.05, 0.5, "m")
TURNS, FEW = 36_000, 3600
DISTANCES = (0.49, 0.51, 1.0, 1.49, 1.51)
# A link's end is at a point to so much, m; points at which two links are tried, from the first axis, m.
THERE, STEP = 1e-9, 0.01


@dataclass(frozen=True)
class Options:
    """The length of the third link, m; the others have 1 m and 0.7 m."""

    l3: Annotated[float, HAND] = 0.2


def orientation_share(r: float, l3: float, rotations: int) -> float:
    """The fraction of orientations in which the tool reaches a point at the distance r, m, from trials."""
    links = Annulus(L1, L2)
    phis = 2 * np.pi * (np.arange(rotations) + 0.5) / rotations
    return float(np.mean([bool(links.elbows(hypot(r - l3 * np.cos(phi), l3 * np.sin(phi)))) for phi in phis]))


def two_link_share(r: float, l1: float, l2: float, rotations: int) -> float:
    """The same of two links: those orientations of the second with which it begins where the first one ends."""
    phi = 2 * np.pi * np.arange(rotations) / rotations
    return float(np.mean(np.abs(np.hypot(r - l2 * np.cos(phi), l2 * np.sin(phi)) - l1) < THERE))


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Two links, equal and not, and where the share of three becomes whole; short: fewer orientations."""
    l3, turns = options.l3, FEW if short else TURNS
    whole = [dexterous_points(l1, l2) for l1, l2 in ((L1, L2), (L1, L1))]
    progress(0.2)
    rows = [
        Row(UNEQUAL, len(whole[0]), "", NO_SPACE),
        Row(EQUAL, len(whole[1]), "", ONE_POINT),
        Row(FARTHEST, max(whole[1], default=np.nan), "m", AT_ORIGIN),
        *(Row(SHARE.format(r=r), orientation_share(r, l3, turns)) for r in DISTANCES),
    ]
    for inner, outer in dexterous(np.array([L1, L2, l3]))[-1:]:
        rows += [Row(INNER, _edge(inner, l3, +1), "m"), Row(OUTER, _edge(outer, l3, -1), "m")]
    progress(0.6)
    r = np.linspace(0, L1 + L2 + l3, 100)
    shares = np.array([orientation_share(x, l3, 360) for x in r])
    progress(1.0)
    chart = Chart(
        SHARES_TITLE,
        untranslated("r, m"),
        ORIENTATIONS,
        (ChartLine(untranslated("l₃ = {l3:g} m").format(l3=l3), r, shares),),
    )
    return campos_result(
        rows, [chart], [posture_motion(ROBOT, hand_rotation(l3), length_settings(l1=L1, l2=L2, l3=l3))]
    )


def dexterous_points(l1: float, l2: float) -> list[float]:
    """The distances of a fine row, m, at which two links are with each of 360 orientations."""
    return [float(r) for r in np.arange(0, l1 + l2 + STEP, STEP) if two_link_share(r, l1, l2, 360) == 1]


def _edge(near: float, l3: float, inwards: int) -> float:
    """The distance, m, within 5 % of another, from which on all of 720 orientations are met, by halving."""
    out, into = near * (1 - 0.05 * inwards), near * (1 + 0.05 * inwards)
    for _ in range(20):
        middle = 0.5 * (out + into)
        out, into = (out, middle) if orientation_share(middle, l3, 720) == 1 else (middle, into)
    return into


def hand_rotation(l3: float) -> list[Array]:
    """Postures, rad, with the tool at 1 m and the hand at all angles, with one sign of the elbow."""
    links, postures = Annulus(L1, L2), []
    for phi in np.linspace(0, 2 * np.pi, 25):
        x, y = 1.0 - l3 * np.cos(phi), -l3 * np.sin(phi)
        theta2 = float(np.arccos((x * x + y * y - links.l1**2 - links.l2**2) / (2 * links.l1 * links.l2)))
        theta1 = float(np.arctan2(y, x) - np.arctan2(links.l2 * np.sin(theta2), links.l1 + links.l2 * np.cos(theta2)))
        postures.append(np.array([theta1, theta2, phi - theta1 - theta2]))
    return postures


NO_SPACE = slide_statement("L₁ ≠ L₂: no dexterous space", "L₁ ≠ L₂: não há espaço destro", "s.10", 0)
ONE_POINT = slide_statement("L₁ = L₂: a single point", "L₁ = L₂: um único ponto", "s.8", 1)
AT_ORIGIN = slide_statement("the origin", "a origem", "s.8", 0)
UNEQUAL = Text(en="dexterous points of two unequal links", pt_BR="pontos destros de dois elos desiguais")
EQUAL = Text(en="dexterous points of two equal links", pt_BR="pontos destros de dois elos iguais")
FARTHEST = Text(en="distance of that point from the first axis", pt_BR="distância desse ponto ao primeiro eixo")
SHARE = Text(
    en="share of orientations of three links at r = {r} m", pt_BR="fração das orientações de três elos em r = {r} m"
)
INNER = Text(en="inner edge of the dexterous ring", pt_BR="borda interna do anel destro")
OUTER = Text(en="outer edge of the dexterous ring", pt_BR="borda externa do anel destro")
SHARES_TITLE = Text(en="Share of orientations by distance", pt_BR="Fração das orientações por distância")
ORIENTATIONS = Text(en="share of all orientations", pt_BR="fração de todas as orientações")
