"""Points, lines and planes: making them, joining and intersecting them, distances and angles."""

from __future__ import annotations

import numpy as np

from helicoide.console.functions import Example, console_function
from helicoide.console.kinds import kind_of
from helicoide.console.parameters import ELEMENT, FLAT, INCIDENT, LINE, NUMBER, POINT
from helicoide.console.values import Value, multivector_value
from helicoide.geometry import incidence, rigid
from helicoide.geometry.clifford import Array
from helicoide.geometry.rotation import unit_vector
from helicoide.text import HelicoideError, Text

NOTHING = Text(
    en="these span nothing: two of them are the same, or lie in each other",
    pt_BR="eles não geram nada: dois são iguais ou um está contido no outro",
)
NOTHING_MEETS = Text(
    en="these have no meet: two of them are the same, or lie in each other",
    pt_BR="eles não têm interseção definida: dois são iguais ou um está contido no outro",
)
LOST = Text(
    en="one of these is no point, line or plane any more, by the rounding of its very large or small coefficients",
    pt_BR="um deles já não é ponto, reta ou plano, pelo arredondamento de coeficientes grandes ou pequenos demais",
)
NO_DISTANCE = Text(
    en="there is no distance between planes that intersect; angle(A, B) gives their angle",
    pt_BR="não há distância entre planos que se cortam; angle(A, B) dá o ângulo entre eles",
)


@console_function(
    "point(x, y, z)", (NUMBER, NUMBER, NUMBER),
    Text(en="the point with these coordinates, m", pt_BR="o ponto com estas coordenadas, m"),
    Example("point(1, 2, 3)", "e1e2e3 + 1*e2e3e + 2*e3e1e + 3*e1e2e"),
)  # fmt: skip
def _point(x: float, y: float, z: float) -> Value:
    return multivector_value(rigid.point((x, y, z)))


@console_function(
    "direction(x, y, z)", (NUMBER, NUMBER, NUMBER),
    Text(en="a direction: the point at infinity along (x, y, z)", pt_BR="direção: o ponto no infinito em (x, y, z)"),
    Example("direction(0, 0, 1)", "point(1, 2, 4) - point(1, 2, 3)"),
)  # fmt: skip
def _direction(x: float, y: float, z: float) -> Value:
    return multivector_value(rigid.null_part(rigid.point((x, y, z))))


@console_function(
    "line(p, q)", (POINT, INCIDENT),
    Text(
        en="the line from p to q, or through p along a direction q", pt_BR="a reta de p a q, ou por p na direção q"
    ),
    Example("line(point(0, 0, 1), direction(1, 0, 0))", "e23 + e2e"),
    work=4,
)  # fmt: skip
def _line(p: Array, q: Array) -> Value:
    return _joined(p, q)


@console_function(
    "plane(nx, ny, nz, d)", (NUMBER, NUMBER, NUMBER, NUMBER),
    Text(
        en="the plane n·r = d, m, with the normal (nx, ny, nz) made of length 1",
        pt_BR="o plano n·r = d, m, com a normal (nx, ny, nz) de comprimento 1",
    ),
    Example("plane(0, 0, 2, 0.5)", "e3 + 0.5*e"),
)  # fmt: skip
def _plane(nx: float, ny: float, nz: float, d: float) -> Value:
    return multivector_value(rigid.plane(unit_vector((nx, ny, nz)), d))


@console_function(
    "plane_through(p, q, r)", (POINT, POINT, POINT),
    Text(
        en="the plane through three points with the sign of Cerbaro's eqs. 25–26, opposite to join",
        pt_BR="o plano por três pontos com o sinal das eqs. 25–26 de Cerbaro, oposto ao de join",
    ),
    Example("plane_through(point(0,0,0), point(1,0,0), point(0,1,0))", "-e3"),
    work=6,
)  # fmt: skip
def _plane_through(p: Array, q: Array, r: Array) -> Value:
    return _not_zero(rigid.plane_through(p, q, r), NOTHING)


@console_function(
    "join(A, B, …)", (INCIDENT, INCIDENT),
    Text(
        en="what all of these span, of unit size: a line through points, a plane through a line and a point",
        pt_BR="o que eles geram juntos, unitário: reta por pontos, plano por uma reta e um ponto",
    ),
    Example("join(point(0,0,0), point(1,0,0), point(0,1,0))", "e3"),
    least=2, work=4,
)  # fmt: skip
def _join(*elements: Array) -> Value:
    return _joined(*elements)


@console_function(
    "meet(A, B, …)", (INCIDENT, INCIDENT),
    Text(
        en="the intersection, of unit size: a line of planes, a point of a line and a plane",
        pt_BR="a interseção, unitária: reta de dois planos, ponto de uma reta e um plano",
    ),
    Example("meet(plane(1,0,0,2), plane(0,1,0,3), plane(0,0,1,4))", "point(2, 3, 4)"),
    least=2, work=4,
)  # fmt: skip
def _meet(*elements: Array) -> Value:
    return _not_zero(incidence.meet(*elements), NOTHING_MEETS)


@console_function(
    "project(p, X)", (POINT, FLAT),
    Text(en="foot of the perpendicular from p on a line or plane", pt_BR="pé da perpendicular de p à reta ou ao plano"),
    Example("project(point(1, 2, 3), plane(0, 0, 1, 0))", "point(1, 2, 0)"),
    work=5,
)  # fmt: skip
def _project(p: Array, X: Array) -> Value:
    return multivector_value(incidence.perpendicular_foot(p, X))


@console_function(
    "distance(A, B)", (ELEMENT, ELEMENT),
    Text(
        en="distance, m; from a plane it is positive on the side of the normal",
        pt_BR="distância, m; a de um plano é positiva do lado da normal",
    ),
    Example("distance(point(0, 0, 0), point(3, 4, 0))", "5"),
    work=4,
)  # fmt: skip
def _distance(A: Array, B: Array) -> Value:
    match _kind(A), _kind(B):
        case "point", "point":
            return float(np.linalg.norm(rigid.coordinates(A) - rigid.coordinates(B)))
        case "line", "point":
            return float(incidence.point_line_distance(A, B))
        case "plane", "point":
            return float(rigid.point_plane_distance(A, B))
        case "line", "line":
            return float(incidence.line_distance(A, B))
        case "line", "plane":
            return float(incidence.line_plane_distance(A, B))
        case "plane", "plane":
            return _between_planes(A, B)
    return _distance(*_swapped(A, B))


@console_function(
    "angle(A, B)", (FLAT, FLAT),
    Text(
        en="angle in radians between the directions of lines or the normals of planes, or of a line with a plane",
        pt_BR="ângulo em radianos entre direções de retas ou normais de planos, ou de uma reta com um plano",
    ),
    Example("angle(plane(1, 0, 0, 0), plane(0, 1, 0, 5))", "pi/2"),
    work=6,
)  # fmt: skip
def _angle(A: Array, B: Array) -> Value:
    match _kind(A), _kind(B):
        case "line", "line":
            return float(incidence.line_angle(A, B))
        case "line", "plane":
            return float(incidence.line_plane_angle(A, B))
        case "plane", "plane":
            (m, _), (n, _) = rigid.normal_and_offset(A), rigid.normal_and_offset(B)
            return float(np.arctan2(np.linalg.norm(np.cross(m, n)), m @ n))
    return _angle(*_swapped(A, B))


@console_function(
    "common_normal(K, L)", (LINE, LINE),
    Text(
        en="the line that meets both lines at a right angle, from K to L",
        pt_BR="a reta que corta as duas em ângulo reto, de K a L",
    ),
    Example("common_normal(e12, line(point(1,0,0), direction(0,1,0)))", "-e23"),
    work=16,
)  # fmt: skip
def _common_normal(K: Array, L: Array) -> Value:
    normal, _, _ = incidence.common_normal(K, L)
    return _not_zero(normal, NOTHING)


def _swapped(A: Array, B: Array) -> tuple[Array, Array]:
    """B and A, whose order is the one that is computed. Raises HelicoideError if neither order is."""
    if (_kind(B), _kind(A)) not in (("line", "point"), ("plane", "point"), ("line", "plane")):
        raise HelicoideError(LOST)
    return B, A


def _joined(*elements: Array) -> Value:
    return _not_zero(incidence.join(*elements), NOTHING)


def _not_zero(X: Array, why: Text) -> Value:
    if not X.any():
        raise HelicoideError(why)
    return multivector_value(X)


def _kind(X: Array) -> str:
    return kind_of(multivector_value(X)).name


def _between_planes(A: Array, B: Array) -> float:
    """Distance of two parallel planes, on the side of the first one's normal. Raises HelicoideError for others."""
    if incidence.is_finite(incidence.meet(A, B)):
        raise HelicoideError(NO_DISTANCE)
    normal, offset = rigid.normal_and_offset(B)
    return float(rigid.point_plane_distance(A, rigid.point(normal * offset)))
