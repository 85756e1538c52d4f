"""What the studies of Campos' slides share: rows, settings of lengths, an arm that takes postures one after another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.study import Motion, Row
from helicoide.text import Text

Relation = Literal["=", "≥", "≤"]
NOT_PRINTED = Text(en="not printed", pt_BR="não impresso")
LENGTH_1 = Quantity(Text(en="length of the first link", pt_BR="comprimento do primeiro elo"), 0.2, 2.0, "m")
LENGTH_2 = Quantity(Text(en="length of the second link", pt_BR="comprimento do segundo elo"), 0.2, 2.0, "m")


def row(
    quantity: Text,
    ours: float,
    digest: float,
    tolerance: float = 0.0,
    unit: str = "",
    source: str | Text = NOT_PRINTED,
    relation: Relation = "=",
) -> Row:
    """A quantity beside the digest's: the slides print formulas and few numbers."""
    return Row(quantity, float(ours), float(digest), tolerance, unit, source, relation)


def posed(robot: str, postures: Sequence[Array], parameters: tuple[str, ...] = ()) -> Motion:
    """An arm that takes postures one after another, two seconds each."""
    return Motion(robot, np.arange(0.0, 2.0 * len(postures), 2.0), np.array(postures), parameters)


def millimetres(**lengths: float) -> tuple[str, ...]:
    """Lengths, m, as a robot's file takes them."""
    return tuple(f"{name}={1000 * length:g}" for name, length in lengths.items())
