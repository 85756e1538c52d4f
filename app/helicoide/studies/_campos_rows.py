"""What the studies of Campos 1998 share: statements, length settings, charts and motions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.method import Quantity
from helicoide.studies.study import (
    SINGLE_RUN,
    Chart,
    ChartLine,
    Interpretation,
    Motion,
    Relation,
    Result,
    Row,
    Statement,
)
from helicoide.text import Text, untranslated

LENGTH_1 = Quantity(Text(en="length of the first link", pt_BR="comprimento do primeiro elo"), 0.2, 2.0, "m")
LENGTH_2 = Quantity(Text(en="length of the second link", pt_BR="comprimento do segundo elo"), 0.2, 2.0, "m")
POSES = Quantity(Text(en="random poses", pt_BR="poses aleatórias"), 100, 100_000, decades=True)
# Choices where the lecture slides of Campos 1998 give no value: entries 5 and 7 of static/pages/en/sources.md.
PUMA_LENGTHS = Interpretation(
    Text(en="lengths of the PUMA as published", pt_BR="comprimentos publicados do PUMA"),
    Text(en="the same counts with three other sets", pt_BR="as mesmas contagens com três outros conjuntos"),
)
NEAR_POSE = Interpretation(
    Text(
        en="near: the position first, then the least rotation",
        pt_BR="perto: primeiro a posição, depois a menor rotação",
    ),
    Text(
        en="if the point might move as well, the direction could be kept",
        pt_BR="se o ponto também pudesse mover-se, a direção poderia ser mantida",
    ),
)
JOINT, DEGREES = Text(en="joint", pt_BR="junta"), untranslated("θ, °")


def slide_statement(
    en: str, pt_BR: str, place: str, value: float, relation: Relation = "=", within: float = 0.0
) -> Statement:
    """A sentence of the slides as a condition on a computed number. Args: as the fields of `Statement`."""
    return Statement(Text(en=en, pt_BR=pt_BR), place, value, relation, within)


def campos_result(rows: Sequence[Row], charts: Sequence[Chart], motions: Sequence[Motion] = ()) -> Result:
    """The result of a study. Integer counts are converted to floats."""
    return Result(tuple(replace(row, computed=float(row.computed)) for row in rows), tuple(charts), tuple(motions))


def posture_motion(
    robot: str, postures: Sequence[Array], parameters: tuple[str, ...] = (), title: Text = SINGLE_RUN
) -> Motion:
    """A motion through postures (n,), rad or m, with two seconds from each to the next."""
    return Motion(robot, np.arange(0.0, 2.0 * len(postures), 2.0), np.array(postures), parameters, title)


def posture_chart(title: Text, postures: Sequence[tuple[Text, Array]]) -> Chart:
    """A chart with one curve per posture (n,), rad: joint value, °, over joint number."""
    lines = (ChartLine(name, np.arange(1.0, len(q) + 1), np.degrees(q)) for name, q in postures)
    return Chart(title, JOINT, DEGREES, tuple(lines))


def length_settings(**lengths: float) -> tuple[str, ...]:
    """Lengths, given in m, as parameters of a robot file, "name=value" in mm."""
    return tuple(f"{name}={1000 * length:g}" for name, length in lengths.items())
