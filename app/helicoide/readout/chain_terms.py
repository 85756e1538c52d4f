"""Why a coefficient of a motor has its value: the product of the joint motors, expanded into its terms."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import joint_positions
from helicoide.kinematics.forward import joint_motor
from helicoide.kinematics.robot import Robot
from helicoide.readout.elements import Element
from helicoide.seat import Selection
from helicoide.state import State

# Joints that are expanded; 2ⁿ terms. The first joints of a longer chain stay together as one factor.
MOST_EXPANDED = 10
# A term smaller than this, as a fraction of the sum of all sizes, is rounding noise.
NOISE = 1e-15


@dataclass(frozen=True, eq=False)
class Chain:
    """A motor as a product: M = ± e^{θ₁ℓ₁/2} … e^{θₖℓₖ/2} M₀, the joints and the frame at q = 0.

    values (k,): the joint values, rad or m; at_zero: M₀ (16,), m; sign: that of the canonical M.
    """

    robot: Robot
    values: Array
    at_zero: Array
    sign: float = 1.0

    @property
    def motor(self) -> Array:
        """The product with its sign, (16,), m."""
        product = CL031.blade("1")
        for joint, value in zip(self.robot.joints, self.values, strict=False):
            product = CL031.product(product, joint_motor(joint, float(value)))
        return self.sign * CL031.product(product, self.at_zero)


@dataclass(frozen=True)
class Term:
    """One term of a coefficient: the constant times the factors of the joints, numbered from 0.

    sines: the joints that contribute sin(θ/2), or half their displacement; cosines: those that contribute cos(θ/2).
    """

    value: float
    constant: float
    sines: tuple[int, ...]
    cosines: tuple[int, ...]


@dataclass(frozen=True)
class ChainTerms:
    """The terms that are not zero, the largest first. together: how many first joints are one factor, mostly 0."""

    terms: tuple[Term, ...]
    together: int = 0


def chain_of(state: State, element: Element) -> Chain | None:
    """The product of which an element is the result; None if it is not carried by the arm."""
    robot, selection = state.robot, element.selection
    count = joints_before(robot, selection)
    match selection.kind:
        case "tool":
            at_zero = robot.T_world_tool_0
        case "link":
            at_zero = _shifted(np.eye(4), robot.points[selection.index])
        case "frame":
            at_zero = list(robot.frames.values())[selection.index].T_link_frame
            at_zero = _shifted(at_zero, robot.points[count - 1]) if count else at_zero
        case _:
            return None
    values = joint_positions(robot.chain, state.arm.q)[:count]
    chain = Chain(robot, values, rigid.motor_from_pose(at_zero))
    return replace(chain, sign=float(np.sign(chain.motor @ element.values(state))) or 1.0)


def joints_before(robot: Robot, selection: Selection) -> int:
    """How many joints carry a tool, a link or a frame; 0 for other objects."""
    match selection.kind:
        case "tool":
            return len(robot.joints)
        case "link":
            return selection.index + 1
        case "frame":
            return list(robot.frames.values())[selection.index].link
        case _:
            return 0


def _shifted(T: Array, by: Array) -> Array:
    shifted = T.copy()
    shifted[:3, 3] += by
    return shifted


def chain_terms(chain: Chain, place: int) -> ChainTerms:
    """The coefficient of one blade, before the sign of the chain, as a sum over the joints' cosines and sines.

    e^{θℓ/2} = cos(θ/2) + sin(θ/2) ℓ for each joint that turns, 1 + ½ x s e for one that slides. The product has a term
    for each choice of the first or second summand, Π cos · Π sin · ⟨ℓᵢ ℓⱼ … M₀⟩, whose sum is the coefficient.
    place: of the blade in `CL031`. Source: Cerbaro 2022, eqs. 96–99, multiplied out.
    """
    together = max(0, len(chain.values) - MOST_EXPANDED)
    first = replace(chain, values=chain.values[:together], at_zero=CL031.blade("1"), sign=1.0).motor
    products, chosen = _products(chain.robot, together, len(chain.values))
    constants = CL031.product(CL031.product(first[None], products), chain.at_zero)[:, place]
    halves = chain.values[together:] / 2
    slides = chain.robot.chain["slides"][together : len(chain.values)]
    sines, cosines = np.where(slides, halves, np.sin(halves)), np.where(slides, 1.0, np.cos(halves))
    values = constants * np.where(chosen, sines, cosines).prod(axis=1)
    kept = np.flatnonzero(np.abs(values) > NOISE * np.abs(values).sum())
    order = kept[np.argsort(-np.abs(values[kept]), kind="stable")]
    return ChainTerms(
        tuple(_term(chain, float(values[k]), float(constants[k]), chosen[k], together) for k in order), together
    )


@lru_cache(maxsize=128)
def _products(robot: Robot, first: int, end: int) -> tuple[Array, NDArray[np.bool_]]:
    """The products of lines ℓᵢ ℓⱼ … for each choice among the joints from `first` to `end`: (2ⁿ, 16), and (2ⁿ, n).

    A joint that slides has s e instead of a line. They do not depend on the joint values.
    """
    products, chosen = CL031.blade("1")[None], np.zeros((1, 0), dtype=bool)
    for joint in robot.joints[first:end]:
        slide = 2 * rigid.null_part(rigid.translator(joint.direction))
        bivector = slide if joint.is_prismatic else rigid.line(joint.direction, joint.point)
        products = np.concatenate([products, CL031.product(products, bivector)])
        without, within = np.zeros((len(chosen), 1), bool), np.ones((len(chosen), 1), bool)
        chosen = np.block([[chosen, without], [chosen, within]])
    return products, chosen


def _term(chain: Chain, value: float, constant: float, chosen: NDArray[np.bool_], together: int) -> Term:
    sines = tuple(int(i) + together for i in np.flatnonzero(chosen))
    cosines = tuple(
        int(i) + together
        for i in np.flatnonzero(~chosen)
        if not chain.robot.joints[i + together].is_prismatic and chain.values[i + together] != 0
    )
    return Term(value, constant, sines, cosines)
