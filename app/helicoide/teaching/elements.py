"""Points, lines, planes and motions as multivectors of Cl(0,3,1), made from numbers and from each other.

Each function has the name of a function in `geometry/`, which computes the same from arrays. Lengths are in metres,
angles in radians. `M >> X` moves X by the motor M, `a * b` is the geometric product, `a ^ b` the outer one, `a & b` the
regressive one, `a | b` the left contraction, `~a` the reverse.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.geometry import incidence, rigid, rotation
from helicoide.geometry import motor as screws
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.ik.postures.branch import check_pose
from helicoide.text import HelicoideError, Text

KINDS = {
    1: Text(en="a plane", pt_BR="um plano"),
    2: Text(en="a line", pt_BR="uma reta"),
    3: Text(en="a point", pt_BR="um ponto"),
}
OTHER = Text(
    en="A distance is between points, lines and planes, not {given!r}.",
    pt_BR="Uma distância é entre pontos, retas e planos, não {given!r}.",
)
NO_PLANE = Text(
    en="{given!r} is no plane: make one with plane(normal, offset).",
    pt_BR="{given!r} não é um plano: faça um com plane(normal, offset).",
)
NO_RADIUS = Text(en="A radius is positive, not {given!r}.", pt_BR="Um raio é positivo, não {given!r}.")
NOT_NUMBERS = Text(en="Give {n} finite numbers, not {given!r}.", pt_BR="Dê {n} números finitos, não {given!r}.")
NOT_CL031 = Text(
    en="Give a multivector of Cl(0,3,1), as point, line, plane and motor make them, not {given!r}.",
    pt_BR="Dê um multivetor de Cl(0,3,1), como os de point, line, plane e motor, não {given!r}.",
)


def point(x: float, y: float, z: float) -> Multivector:
    """The point p = e1e2e3 + x e2e3e + y e3e1e + z e1e2e; x, y, z in m. Source: Cerbaro 2022, eq. 16."""
    return Multivector(rigid.point(_numbers((x, y, z), 3)), CL031)


def line(direction: ArrayLike, through: ArrayLike | Multivector) -> Multivector:
    """The line through a point, (3,) m or a multivector, along a direction (3,) of any length but zero.

    ℓ = v_x e2e3 + v_y e3e1 + v_z e1e2 + u_x e1e + u_y e2e + u_z e3e with |v| = 1 and u = r × v.
    Source: Cerbaro 2022, eq. 17.
    """
    return Multivector(rigid.line(_direction(direction), as_place(through)), CL031)


def plane(normal: ArrayLike, offset: float) -> Multivector:
    """The plane n·r = d with a normal (3,) of any length but zero, scaled to one, and the offset d in m.

    π = n_x e1 + n_y e2 + n_z e3 + d e. Source: Cerbaro 2022, eq. 18.
    """
    return Multivector(rigid.plane(_direction(normal), _numbers(offset, 1)[0]), CL031)


def quaternion(w: float, x: float, y: float, z: float) -> Multivector:
    """The quaternion w + x i + y j + z k, with i = e2e3, j = e3e1, k = e1e2: i² = j² = k² = ijk = −1.

    One of length one rotates by q >> p, as q p q* does.
    """
    values = [*_numbers((w, x, y, z), 4), 0.0, 0.0, 0.0, 0.0]
    return Multivector(rigid.motor_from_dual_quaternion(np.array(values)), CL031)


def rotor(axis: ArrayLike, angle: float) -> Multivector:
    """The rotation by an angle, rad, about an axis (3,) through the origin: cos(φ/2) + sin(φ/2) (n_x e2e3 + …)."""
    return Multivector(rigid.rotor(_direction(axis), _numbers(angle, 1)[0]), CL031)


def translator(t: ArrayLike) -> Multivector:
    """The translation by t (3,), m: 1 + ½ t e. Source: Cerbaro 2022, eqs. 96 and 99."""
    return Multivector(rigid.translator(_numbers(t, 3)), CL031)


def screw(direction: ArrayLike, through: ArrayLike | Multivector, angle: float, pitch: float = 0.0) -> Multivector:
    """The motor of a screw: a rotation by an angle, rad, about a line, and pitch · angle along it; pitch in m/rad.

    direction (3,), any length but zero; through: a point of the line, (3,) m or a multivector.
    """
    turn, advance = _numbers((angle, pitch), 2)
    return Multivector(rigid.screw_motor(_direction(direction), as_place(through), turn, advance), CL031)


def motor(T: ArrayLike) -> Multivector:
    """The motor of a pose T (4, 4), m, of the two with the positive scalar part. Source: Cerbaro 2022, eq. 96."""
    return Multivector(rigid.motor_from_pose(check_pose(T)), CL031)


def pose(M: Multivector) -> Array:
    """The pose (4, 4), m, of a motor, the inverse of `motor`."""
    return rigid.pose_from_motor(screws.normalize_motor(_values(M)))


def pose_of(given: ArrayLike | Multivector) -> Array:
    """A pose (4, 4), m, given as such or as a motor; raises HelicoideError for anything else."""
    return pose(given) if isinstance(given, Multivector) else check_pose(given)


def join(*elements: Multivector) -> Multivector:
    """What points and lines span, scaled to size one: the line from p to q, the plane through three points.

    Zero where they span nothing, as equal points do. Source: Cerbaro 2022, §5.2.4.
    """
    return Multivector(incidence.join(*map(_values, elements)), CL031)


def meet(*elements: Multivector) -> Multivector:
    """Where planes and lines meet, scaled to size one: the line of two planes, the point of a line and a plane.

    Parallel ones meet at infinity: the blades without e are zero.
    """
    return Multivector(incidence.meet(*map(_values, elements)), CL031)


def exp(B: Multivector) -> Multivector:
    """The motor of a bivector: exp(½ θ L) rotates by θ, rad, about the line L."""
    return Multivector(screws.exp(_values(B)), CL031)


def log(M: Multivector) -> Multivector:
    """The bivector of a motor: half the angle times its screw axis, and half the translation along it."""
    return Multivector(screws.log(screws.normalize_motor(_values(M))), CL031)


def distance(a: Multivector, b: Multivector) -> float:
    """The distance of two points, lines or planes, m; signed from a plane, positive on the side of its normal.

    0 where they meet. The elements are of size one, as the functions here make them. Source: Cerbaro 2022, eqs. 19–20.
    """
    first, second = sorted((a, b), key=_kind)
    return float(DISTANCES[_kind(first), _kind(second)](_values(first), _values(second)))


def as_plane(given: Multivector) -> tuple[Array, float]:
    """The unit normal (3,) and the offset, m, of a plane; raises HelicoideError for anything else."""
    if _kind(given) != 1:
        raise HelicoideError(NO_PLANE.format(given=given))
    normal, offset = rigid.normal_and_offset(_values(given))
    length = float(np.linalg.norm(normal))
    if length == 0:
        raise HelicoideError(NO_PLANE.format(given=given))
    return np.asarray(normal / length), float(offset) / length


def as_place(given: ArrayLike | Multivector) -> Array:
    """The coordinates (3,), m, of a point, given as such or as a multivector."""
    return rigid.coordinates(_values(given)) if isinstance(given, Multivector) else _numbers(given, 3)


def as_radius(given: float) -> float:
    """A positive number, m; raises HelicoideError for anything else."""
    (radius,) = _numbers(given, 1)
    if radius <= 0:
        raise HelicoideError(NO_RADIUS.format(given=given))
    return float(radius)


def _between_planes(a: Array, b: Array) -> Array:
    if incidence.is_finite(incidence.meet(a, b)):
        return np.zeros(())
    foot = incidence.perpendicular_foot(rigid.point((0.0, 0.0, 0.0)), b)
    return np.abs(rigid.point_plane_distance(a, foot))


def _between_points(a: Array, b: Array) -> Array:
    return np.asarray(np.linalg.norm(rigid.coordinates(b) - rigid.coordinates(a)))


# By grade: 1 is a plane, 2 a line, 3 a point.
DISTANCES: dict[tuple[int, int], Callable[[Array, Array], Array]] = {
    (1, 1): _between_planes,
    (1, 2): lambda plane, line: incidence.line_plane_distance(line, plane),
    (1, 3): rigid.point_plane_distance,
    (2, 2): incidence.line_distance,
    (2, 3): incidence.point_line_distance,
    (3, 3): _between_points,
}


def _kind(X: Multivector) -> int:
    """The grade of a point, line or plane; raises HelicoideError for anything else."""
    values = np.abs(_values(X))
    for grade in KINDS:
        if values.max() > 0 and values[np.array(CL031.grades) != grade].max() <= rigid.COLLINEAR * values.max():
            return grade
    raise HelicoideError(OTHER.format(given=X))


def _values(X: Multivector) -> Array:
    if not isinstance(X, Multivector) or X.algebra != CL031:
        raise HelicoideError(NOT_CL031.format(given=X))
    return X.values


def _direction(given: ArrayLike) -> Array:
    """A vector (3,) scaled to length one; raises HelicoideError for zero."""
    return rotation.unit_vector(_numbers(given, 3))


def _numbers(given: ArrayLike, n: int) -> Array:
    """n finite numbers as an array (n,); raises HelicoideError otherwise."""
    try:
        values = np.atleast_1d(np.asarray(given, dtype=np.float64))
    except (TypeError, ValueError) as error:
        raise HelicoideError(NOT_NUMBERS.format(n=n, given=given)) from error
    if values.shape != (n,) or not np.isfinite(values).all():
        raise HelicoideError(NOT_NUMBERS.format(n=n, given=given))
    return values
