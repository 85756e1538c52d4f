"""The moving joints of an arm, and the array in which the kernels take them."""

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
JointKind = Literal["revolute", "prismatic"]

# direction: unit vector of the axis; offset: from the point of the joint before, m; both at q = 0 in the base frame.
# The value of the joint is ratio · q[driver] + shift: an angle in rad, or a length in m if it slides.
CHAIN = np.dtype(
    [("direction", "f8", 3), ("offset", "f8", 3), ("ratio", "f8"), ("shift", "f8"), ("driver", "i8"), ("slides", "?")],
    align=True,
)


@dataclass(frozen=True)
class Mimic:
    """How a joint follows another one: its value is ratio · q[driver] + shift."""

    driver: int
    multiplier: float
    offset: float


@dataclass(frozen=True, eq=False)
class JointVariable:
    """One of the joint variables q: where a joint stands; limits in rad and rad/s, m and m/s where it slides.

    acceleration: rad/s² or m/s², infinite where none is given; assumed: whether the file that it comes from bounds it
    nowhere, so that its range says nothing of how large the arm is.
    """

    name: str
    title: Text
    kind: JointKind
    lower: float
    upper: float
    speed: float
    acceleration: float = math.inf
    assumed: bool = False

    @property
    def is_prismatic(self) -> bool:
        """Whether the joint is prismatic."""
        return self.kind == "prismatic"


@dataclass(frozen=True, eq=False, kw_only=True)
class Joint(JointVariable):
    """A moving joint of an arm: its axis when all joints stand at zero, base frame, and the link that it moves.

    mimic: the joint that it follows; None if it has a variable of its own.
    """

    link: str
    direction: Array
    point: Array
    mimic: Mimic | None = None


def chain_array(joints: Sequence[Joint]) -> Chain:
    """The joints, base first, as an array of `CHAIN`; joints that follow no other take the variables in order."""
    chain = np.zeros(len(joints), CHAIN)
    before, variables = np.zeros(3), 0
    for row, joint in zip(chain, joints, strict=True):
        mimic = joint.mimic or Mimic(variables, 1.0, 0.0)
        variables += joint.mimic is None
        row["direction"], row["offset"], row["slides"] = joint.direction, joint.point - before, joint.is_prismatic
        row["driver"], row["ratio"], row["shift"] = mimic.driver, mimic.multiplier, mimic.offset
        before = joint.point
    chain.flags.writeable = False
    return chain


def joint_positions(chain: Chain, q: Array) -> Array:
    """Values of all joints of the chain, xᵢ = ratioᵢ q[driverᵢ] + shiftᵢ, (m,), from the variables q (n,)."""
    return np.asarray(chain["ratio"] * q[chain["driver"]] + chain["shift"])
