"""Planes from user input: coefficients, three points, or a box."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.confinement.planes import Plane, Planes
from helicoide.geometry import rigid
from helicoide.text import HelicoideError, Text, numbers_text, untranslated

# Larger distances, m, are refused as a typing error or a wrong unit.
FARTHEST = 1000.0
# Smallest distance of a point from a plane, m, at which its side is certain.
LEAST_DISTANCE = 1e-6
BOX = ("+z", "+y", "-y", "-z")


def from_coefficients(coefficients: ArrayLike, inside: ArrayLike) -> Plane:
    """The plane a x + b y + c z = d, of any scale: n = ±(a, b, c)/‖·‖, l = n·r − d > 0 at the point inside.

    Args: coefficients (a, b, c, d) (4,), d in m if (a, b, c) has length one; inside: a point on the allowed side,
    (3,), m. Raises HelicoideError for a zero normal, invalid numbers, or a point on the plane.
    Source: Cerbaro 2022, eq. 18; its sign so that l > 0 inside.
    """
    a, b, c, d = map(float, _finite(coefficients, 4, Text(en="A plane", pt_BR="Um plano"), most=np.inf))
    scale = max(abs(a), abs(b), abs(c))
    if scale == 0 or abs(d / scale) > FARTHEST:
        raise HelicoideError(
            Text(
                en="The first three coefficients are the normal of the plane: they cannot be all zero, and the plane "
                "must pass within {far:g} m of the origin.",
                pt_BR="Os três primeiros coeficientes são a normal do plano: não podem ser todos zero, e o plano deve "
                "passar a até {far:g} m da origem.",
            ).format(far=FARTHEST)
        )
    normal = np.array([a, b, c]) / scale
    length = float(np.linalg.norm(normal))
    return plane_facing(normal / length, d / scale / length, inside)


def through_points(points: ArrayLike, inside: ArrayLike) -> Plane:
    """The plane through three points: π = ⋆σ/√((⋆σ)(⋆σ)*), with l > 0 at the point inside.

    Args: points (3, 3), m, one per row; inside: a point on the allowed side, (3,), m. Raises HelicoideError for
    collinear points, invalid numbers, or a point `inside` on the plane. Source: Cerbaro 2022, eqs. 25–26.
    """
    three = _finite(points, 9, Text(en="A plane through three points", pt_BR="Um plano por três pontos"))
    pi = rigid.plane_through(*rigid.point(three.reshape(3, 3)))
    if not pi.any():
        raise HelicoideError(
            Text(
                en="The three points lie on one line, so they do not define a plane: move one off the line.",
                pt_BR="Os três pontos estão numa reta e não definem um plano: afaste um deles da reta.",
            )
        )
    normal, offset = rigid.normal_and_offset(pi)
    return plane_facing(normal, float(offset), inside)


def box_planes(lower: ArrayLike, upper: ArrayLike) -> Planes:
    """The planes of a box: ceiling, left and right wall and bench, named by `BOX`; open to front and back.

    Args: lower, upper: opposite corners, (3,), m. Raises HelicoideError unless the first is below the second in x, y
    and z. Source: the enclosure of Cerbaro 2022, §6.1, whose planes perpendicular to x are out of reach.
    """
    corner = Text(en="A corner of the box", pt_BR="Um vértice da caixa")
    low, high = _finite(lower, 3, corner), _finite(upper, 3, corner)
    if not (low < high).all():
        raise HelicoideError(
            Text(
                en="Each coordinate of the lower corner must be less than that of the upper corner, not {low} and "
                "{high} m.",
                pt_BR="Cada coordenada do vértice inferior deve ser menor que a do superior, não {low} e {high} m.",
            ).format(low=_listed(low), high=_listed(high))
        )
    normals = np.array([[0, 0, -1], [0, -1, 0], [0, 1, 0], [0, 0, 1]], dtype=np.float64)
    centres = np.where(normals < 0, high, np.where(normals > 0, low, (low + high) / 2))
    return Planes(frozen(normals), frozen(centres))


def plane_facing(normal: Array, offset: float, inside: ArrayLike) -> Plane:
    """The plane with its normal towards a point: −π for π if l < 0. Raises HelicoideError if the point is on it.

    Args: normal (3,), unit; offset, m; inside (3,), m. Source: Cerbaro 2022, eqs. 18, 20.
    """
    point = _finite(inside, 3, Text(en="The interior point", pt_BR="O ponto interno"))
    distance = float(normal @ point) - offset
    if abs(distance) < LEAST_DISTANCE:
        raise HelicoideError(
            Text(
                en="The point {inside} m lies on the plane: give a point on the side of the arm.",
                pt_BR="O ponto {inside} m está no plano: dê um ponto do lado do braço.",
            ).format(inside=_listed(point))
        )
    return Plane(frozen(normal if distance > 0 else -normal), offset if distance > 0 else -offset)


def _finite(values: ArrayLike, n: int, what: Text, most: float = FARTHEST) -> Array:
    """The values as an array (n,); raises HelicoideError unless they are n finite numbers up to `most`."""
    try:
        array = np.asarray(values, dtype=np.float64).ravel()
    except (TypeError, ValueError, OverflowError):
        array = np.zeros(0)
    if array.shape != (n,) or not np.isfinite(array).all() or np.abs(array).max() > most:
        bound = Text(en=" up to {most:g} m", pt_BR=" de até {most:g} m").format(most=most) if np.isfinite(most) else ""
        raise HelicoideError(
            Text(
                en="{what} takes {n} finite numbers{bound}, not {given}.",
                pt_BR="{what} recebe {n} números finitos{bound}, não {given}.",
            ).format(what=what, n=n, bound=bound, given=values)
        )
    return array


def _listed(values: Array) -> Text:
    return untranslated("({values})").format(values=numbers_text(values))
