"""Which points a planar arm reaches with every orientation: the dexterous set of three links."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import Annotated

import numpy as np

from helicoide.ik.families.elbow import Annulus
from helicoide.ik.method import Quantity
from helicoide.ik.postures.workspace import dexterous
from helicoide.kinematics.chain import Array
from helicoide.studies._campos_rows import millimetres, posed, row
from helicoide.studies.study import Chart, Line, Progress, Result
from helicoide.text import Text, same

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
# Shares of all orientations that the digest counts at distances, m, for a hand of 0.2 m.
SHARES = {0.49: 0.92, 0.51: 1.0, 1.0: 1.0, 1.49: 1.0, 1.51: 0.89}


@dataclass(frozen=True)
class Options:
    """The length of the third link, m; the others have 1 m and 0.7 m."""

    l3: Annotated[float, HAND] = 0.2


def share(r: float, l3: float, turns: int) -> float:
    """The part of all orientations with which the tool reaches a point at the distance r, m, by trying so many."""
    links = Annulus(L1, L2)
    phis = 2 * np.pi * (np.arange(turns) + 0.5) / turns
    return float(np.mean([bool(links.elbows(hypot(r - l3 * np.cos(phi), l3 * np.sin(phi)))) for phi in phis]))


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Shares at the digest's distances, and where the share becomes whole; short: fewer orientations."""
    l3, turns = options.l3, FEW if short else TURNS
    known = SHARES if l3 == 0.2 else {}
    rows = [row(SHARE.format(r=r), share(r, l3, turns), expected, 0.005, source="") for r, expected in known.items()]
    rings = dexterous(np.array([L1, L2, l3]))
    for inner, outer in rings[-1:]:
        rows += [
            row(INNER, _edge(inner, l3, +1), inner, 0.01 * inner, "m"),
            row(OUTER, _edge(outer, l3, -1), outer, 0.01 * outer, "m"),
        ]
    progress(0.5)
    rows += [
        row(UNEQUAL, len(dexterous(np.array([L1, L2]))), 0, source="0"),
        row(EQUAL, _size(dexterous(np.array([L1, L1]))), 0.0, 0.0, "m", source="0"),
    ]
    r = np.linspace(0, L1 + L2 + l3, 100)
    shares = np.array([share(x, l3, 360) for x in r])
    progress(1.0)
    chart = Chart(SHARES_TITLE, same("r, m"), ORIENTATIONS, (Line(same(f"l₃ = {l3:g} m"), r, shares),))
    return Result(tuple(rows), (chart,), posed(ROBOT, _turning(l3), millimetres(l1=L1, l2=L2, l3=l3)))


def _edge(near: float, l3: float, inwards: int) -> float:
    """The distance, m, within 5 % of another, from which on all of 720 orientations are met, by halving."""
    out, into = near * (1 - 0.05 * inwards), near * (1 + 0.05 * inwards)
    for _ in range(20):
        middle = 0.5 * (out + into)
        out, into = (out, middle) if share(middle, l3, 720) == 1 else (middle, into)
    return into


def _size(rings: tuple[tuple[float, float], ...]) -> float:
    """The outer radius of a single ring, m."""
    ((_, outer),) = rings
    return outer


def _turning(l3: float) -> list[Array]:
    """Postures of the arm at 1 m with its hand turned all round, elbow bent one way, rad."""
    links, postures = Annulus(L1, L2), []
    for phi in np.linspace(0, 2 * np.pi, 25):
        x, y = 1.0 - l3 * np.cos(phi), -l3 * np.sin(phi)
        theta2 = float(np.arccos((x * x + y * y - links.l1**2 - links.l2**2) / (2 * links.l1 * links.l2)))
        theta1 = float(np.arctan2(y, x) - np.arctan2(links.l2 * np.sin(theta2), links.l1 + links.l2 * np.cos(theta2)))
        postures.append(np.array([theta1, theta2, phi - theta1 - theta2]))
    return postures


SHARE = Text(en="share of orientations at r = {r} m", pt_BR="fração das orientações em r = {r} m")
INNER = Text(en="inner edge of the dexterous ring", pt_BR="borda interna do anel destro")
OUTER = Text(en="outer edge of the dexterous ring", pt_BR="borda externa do anel destro")
UNEQUAL = Text(en="dexterous rings of two unequal links", pt_BR="anéis destros de dois elos desiguais")
EQUAL = Text(en="radius of the dexterous set of two equal links", pt_BR="raio do conjunto destro de dois elos iguais")
SHARES_TITLE = Text(en="Share of orientations by distance", pt_BR="Fração das orientações por distância")
ORIENTATIONS = Text(en="share of all orientations", pt_BR="fração de todas as orientações")
