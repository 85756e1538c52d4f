"""Rigid motions as exponentials of screws: exp, log, the screw axis of Chasles and the way along it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Array
from helicoide.text import HelicoideError, Text

# Turns below this angle (rad) have their axis in rounding noise, far away: they count as translations.
SMALLEST_ROTATION = 1e-12


@dataclass(frozen=True, eq=False)
class ScrewDisplacement:
    """A motion as Chasles tells it: turn about an axis and advance along it; the fields broadcast.

    direction: unit (..., 3), right-hand sense of the turn; point: of the axis, nearest to the origin (..., 3), m;
    angle: (...) in [0, π], rad; displacement: along the direction (...), m.
    A translation has angle 0, its own direction and point 0. The identity has no axis: all four are zero.
    """

    direction: Array
    point: Array
    angle: Array
    displacement: Array

    @property
    def pitch(self) -> Array:
        """Advance for each radian, displacement/angle (...), m/rad: ∞ for a translation, 0 for the identity."""
        without_turn = np.where(self.displacement == 0, 0.0, np.inf)
        return np.asarray(np.divide(self.displacement, self.angle, out=without_turn, where=self.angle > 0))


def exp(B: Array) -> Array:
    """Exponential of a screw B = v + εu: exp B = cos θ + sinc θ B − ε sinc θ v·u + ε (cos θ − sinc θ)(n·u) n.

    θ = ‖v‖, n = v/θ, and v, u the coefficients of eq. 17. A turn by +α about a line L is exp(+αL/2), as with the lines
    of the sources; modern Cl(3,0,1) writes exp(−αL/2). Nothing cancels or divides near θ = 0.
    B: bivector (..., 16); returns a unit motor (..., 16).
    Source: Kavan et al. 2008, App. A, without its division by θ; Cerbaro 2022, eqs. 17, 98.
    """
    v, u = rigid.direction_and_moment(B)
    angle = _length(v)
    cos, sinc, n = np.cos(angle), np.sinc(angle / np.pi), _along(v)
    return _motor(cos, sinc * v, -sinc * _dot(v, u), sinc * u + (cos - sinc) * _dot(n, u) * n)


def log(M: Array) -> Array:
    """Logarithm of a motor, inverse of `exp` for the shorter turn: B = αL/2 + (half the advance), α in [0, π].

    For M = w + x + ε(w' + x') of M and −M the canonical: θ = atan2(‖x‖, w), n = x/‖x‖, v = x/sinc θ,
    u = x'/sinc θ + ((n·x')(cos θ − 1/sinc θ) − w' sin θ) n. So exp(log M) is `rigid.canonical(M)`, and at α = π
    the axis is the one of the two opposite whose first non-zero component is positive.
    M: unit motor (..., 16); returns a bivector (..., 16). Source: the equation of `exp` solved for v and u.
    """
    parts = rigid.dual_quaternion(rigid.canonical(M))
    w, x, dual_w, dual_x = (parts[..., k] for k in (slice(0, 1), slice(1, 4), slice(4, 5), slice(5, 8)))
    angle, n = np.arctan2(_length(x), w), _along(x)
    stretch = 1 / np.sinc(angle / np.pi)
    advance = _dot(n, dual_x) * (np.cos(angle) - stretch) - dual_w * np.sin(angle)
    zero = np.zeros_like(w)
    return _motor(zero, stretch * x, zero, stretch * dual_x + advance * n)


def normalize_motor(M: Array) -> Array:
    """Nearest motor of an even multivector that rounding has bent: M (1 − βI/2α)/√α with M M* = α + βI, I = e1e2e3e.

    M: (..., 16); returns (..., 16) with M M* = 1. Raises HelicoideError where M has odd blades or no rotation part.
    Source: Cerbaro 2022, eq. 97, as a condition.
    """
    square = CL031.product(M, CL031.conjugate(M))
    alpha, beta = square[..., :1], square[..., -1:]
    if np.any(M[..., CL031.grades % 2 == 1]) or not np.all(alpha > 0):
        raise HelicoideError(
            Text(
                en="this multivector is not close to a motor: its odd blades must be 0, "
                "and at least one of 1, e1e2, e1e3, e2e3 must not",
                pt_BR="este multivetor não está perto de um motor: as lâminas ímpares devem ser nulas, "
                "e ao menos uma de 1, e1e2, e1e3, e2e3 não",
            )
        )
    correction = CL031.blade("1") - beta / (2 * alpha) * CL031.blade("e1e2e3e")
    return np.asarray(CL031.product(M, correction) / np.sqrt(alpha))


def is_motor(M: Array, tolerance: float = 1e-9) -> NDArray[np.bool_]:
    """Whether M is a unit motor: even, with M M* = 1, each coefficient to the tolerance.

    M: (..., 16); returns (...). Source: Cerbaro 2022, eq. 97.
    """
    odd = M[..., CL031.grades % 2 == 1]
    excess = CL031.product(M, CL031.conjugate(M)) - CL031.blade("1")
    return np.asarray(np.max(np.abs(np.concatenate([odd, excess], axis=-1)), axis=-1) <= tolerance)


def sclerp(M0: Array, M1: Array, s: ArrayLike) -> Array:
    """Motor on the screw from M0 to M1, by the shorter turn: M0 exp(s log(M0* M1)).

    M0, M1: unit motors (..., 16), each the same pose as its negative; s: (...), 0 at M0, 1 at M1 or −M1.
    At exactly half a turn between them the axis is that of `log`. Source: Kavan et al. 2008 (ScLERP).
    """
    between = log(CL031.product(CL031.conjugate(M0), M1))
    return CL031.product(M0, exp(np.asarray(s, dtype=float)[..., None] * between))


def screw_from_motor(M: Array) -> ScrewDisplacement:
    """Screw of a motor (Chasles): log M = ½(α + εd)(n + ε r×n), so n = v/‖v‖, α = 2‖v‖, d = 2 n·u, r = v×u/‖v‖².

    M: unit motor (..., 16), M and −M give the same; returns fields of shape (..., 3) and (...). Turns below
    `SMALLEST_ROTATION` count as translations. Source: Selig 2005, ch. 2 (Chasles); Cerbaro 2022, eq. 62.
    """
    v, u = rigid.direction_and_moment(log(M))
    half = _length(v)
    turns = 2 * half > SMALLEST_ROTATION
    direction = _along(np.where(turns, v, u))
    point = np.divide(np.cross(v, u), half**2, out=np.zeros_like(v), where=turns)
    angle = np.where(turns, np.minimum(2 * half, np.pi), 0.0)
    return ScrewDisplacement(direction, point, angle[..., 0], 2 * _dot(direction, u)[..., 0])


def motor_from_screw(screw: ScrewDisplacement) -> Array:
    """Motor of a screw, inverse of `screw_from_motor`: (1 + ½ d n e) exp(αL/2), of shape (..., 16).

    Source: Cerbaro 2022, eqs. 17, 96–98.
    """
    turn = exp(screw.angle[..., None] / 2 * rigid.line(screw.direction, screw.point))
    return CL031.product(rigid.translator(screw.displacement[..., None] * screw.direction), turn)


def _motor(w: Array, x: Array, dual_w: Array, dual_x: Array) -> Array:
    """The even multivector w + x + ε(w' + x')."""
    return rigid.motor_from_dual_quaternion(np.concatenate([w, x, dual_w, dual_x], axis=-1))


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.sum(a * b, axis=-1, keepdims=True))


def _length(v: Array) -> Array:
    return np.asarray(np.linalg.norm(v, axis=-1, keepdims=True))


def _along(v: Array) -> Array:
    """v/‖v‖, zero where v is zero."""
    length = _length(v)
    return np.divide(v, length, out=np.zeros_like(v), where=length > 0)
