"""Motors and planes in which one coefficient is given, and the others change as little as a valid one allows."""

from __future__ import annotations

import numpy as np

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Array
from helicoide.text import HelicoideError, Text

# Below this length there is no direction left to scale.
SMALLEST = 1e-9
NOT_IN_MOTOR = Text(
    en="A motor has only the blades 1, e23, e31, e12, e01, e02, e03 and e0123.",
    pt_BR="Um motor só tem as lâminas 1, e23, e31, e12, e01, e02, e03 e e0123.",
)
NOT_IN_PLANE = Text(
    en="A plane has only the blades e1, e2, e3 and e.", pt_BR="Um plano só tem as lâminas e1, e2, e3 e e."
)
BEYOND_ONE = Text(
    en="This coefficient is a sine, a cosine or a component of a unit vector: it must be from −1 to 1.",
    pt_BR="Este coeficiente é um seno, um cosseno ou uma componente de um vetor unitário: vai de −1 a 1.",
)
UNDETERMINED = Text(
    en="The other coefficients of its group are all zero, so they cannot make up the difference: change one of them "
    "first.",
    pt_BR="Os outros coeficientes do grupo são todos nulos e não podem compensar a diferença: mude um deles antes.",
)


def motor_with_coefficient(M: Array, blade: str, value: float) -> Array:
    """A unit motor near M with this coefficient, M = g + ½ t g e.

    A coefficient of g: the others of g are scaled so that ‖g‖ = 1, and t stays. One of the dual part d = ½ t g e: the
    others move along g so that M M* = 1, that is g · d = 0 as vectors of four numbers; g stays.
    M: unit motor (16,) of `CL031`; value: m for a blade with e. Raises HelicoideError where there is no such motor.
    Source: Cerbaro 2022, eqs. 96–97.
    """
    index, sign = CL031.parse_blade(blade)
    g, d = np.split(rigid.dual_quaternion(M), 2)
    of_blade = rigid.dual_quaternion(sign * np.eye(16)[index])
    if not of_blade.any():
        raise HelicoideError(NOT_IN_MOTOR)
    (k,) = np.flatnonzero(of_blade)
    given = value * float(of_blade[k])
    if k < 4:
        rotor = rigid.motor_from_dual_quaternion(np.concatenate([_unit_with(g, int(k), given), np.zeros(4)]))
        return CL031.product(rigid.translator(rigid.pose_from_motor(M)[:3, 3]), rotor)
    j = int(k) - 4
    d[j] = given
    free = g * (np.arange(4) != j)
    if float(free @ free) < SMALLEST:
        if abs(given * g[j]) > SMALLEST:
            raise HelicoideError(UNDETERMINED)
    else:
        d -= (g @ d) / (free @ free) * free
    return rigid.motor_from_dual_quaternion(np.concatenate([g, d]))


def plane_with_coefficient(plane: Array, blade: str, value: float) -> Array:
    """A unit plane near π with this coefficient: the other components of its normal are scaled; d stays, or is given.

    plane: unit π (16,) of `CL031`; value: d in m. Raises HelicoideError where there is no such plane.
    Source: Cerbaro 2022, eq. 18.
    """
    index, sign = CL031.parse_blade(blade)
    n, d = rigid.normal_and_offset(plane)
    if index == CL031.parse_blade("e")[0]:
        return rigid.plane(n, sign * value)
    axis = [CL031.parse_blade(name)[0] for name in ("e1", "e2", "e3")]
    if index not in axis:
        raise HelicoideError(NOT_IN_PLANE)
    return rigid.plane(_unit_with(n, axis.index(index), sign * value), d)


def _unit_with(v: Array, k: int, value: float) -> Array:
    """The unit vector with component k given and the others in proportion; v: unit (n,)."""
    if abs(value) > 1:
        raise HelicoideError(BEYOND_ONE)
    rest = v * (np.arange(len(v)) != k)
    length, wanted = float(np.linalg.norm(rest)), float(np.sqrt(1 - value * value))
    if length < SMALLEST < wanted:
        raise HelicoideError(UNDETERMINED)
    unit = rest * (wanted / length) if length >= SMALLEST else np.zeros_like(v)
    unit[k] = value
    return np.asarray(unit)
