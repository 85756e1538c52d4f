"""The moving axes of an arm as one array, in the form that the kernels take."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.text import Text

Chain = NDArray[np.void]
Kind = Literal["revolute", "prismatic"]

# direction: unit, and offset from the axis point before, m, both at q = 0 in the base frame; the joint stands at
# ratio · q[driver] + shift, an angle or, where it slides, a length.
CHAIN = np.dtype(
    [("direction", "f8", 3), ("offset", "f8", 3), ("ratio", "f8"), ("shift", "f8"), ("driver", "i8"), ("slides", "?")],
    align=True,
)


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another one: it stands at ratio · q[driver] + shift."""

    driver: int
    ratio: float
    shift: float


@dataclass(frozen=True, eq=False)
class Variable:
    """One of the joint variables q: where a joint stands; limits in rad and rad/s, m and m/s where it slides.

    acceleration: rad/s² or m/s², infinite where none is given; assumed: whether the file that it comes from bounds it
    nowhere, so that its range says nothing of how large the arm is.
    """

    name: str
    title: Text
    kind: Kind
    lower: float
    upper: float
    speed: float
    acceleration: float = math.inf
    assumed: bool = False

    @property
    def slides(self) -> bool:
        """Whether the joint is prismatic."""
        return self.kind == "prismatic"


@dataclass(frozen=True, eq=False, kw_only=True)
class Joint(Variable):
    """A moving joint of an arm: its axis when all joints stand at zero, base frame, and the link that it moves.

    mimic: what it follows instead of a variable of its own.
    """

    link: str
    direction: Array
    point: Array
    mimic: Mimic | None = None


def chain_of(joints: Sequence[Joint]) -> Chain:
    """The joints, base first, as an array of `CHAIN`; those that follow no other take the variables in turn."""
    chain = np.zeros(len(joints), CHAIN)
    before, variables = np.zeros(3), 0
    for row, joint in zip(chain, joints, strict=True):
        mimic = joint.mimic or Mimic(variables, 1.0, 0.0)
        variables += joint.mimic is None
        row["direction"], row["offset"], row["slides"] = joint.direction, joint.point - before, joint.slides
        row["driver"], row["ratio"], row["shift"] = mimic.driver, mimic.ratio, mimic.shift
        before = joint.point
    chain.flags.writeable = False
    return chain


def spread(chain: Chain, q: Array) -> Array:
    """Where every joint of the chain stands, xᵢ = ratioᵢ q[driverᵢ] + shiftᵢ, (m,), for the variables q (n,)."""
    return np.asarray(chain["ratio"] * q[chain["driver"]] + chain["shift"])
