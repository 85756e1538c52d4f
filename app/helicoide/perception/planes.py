"""Fits a plane with a given orientation to a point cloud, by random sampling and least squares."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.arrays import Array, frozen
from helicoide.confinement import Plane
from helicoide.geometry import rigid
from helicoide.kernels import kernel
from helicoide.text import HelicoideError, Text

# The source uses 5 mm and 4°; the planes it prints are tilted by up to 5.5° from their axes.
DISTANCE, ANGLE = 0.005, np.radians(10)
MOST_DISTANCE = 0.1
# Any cloud has this many points, or this share, near some plane, even without a wall: more are needed.
FEWEST, LEAST_SHARE = 50, 0.05
# Number of planes through three random points; the chance to miss a wall with a tenth of the points is below 10⁻⁸.
DRAWS = 20_000
# Each plane is scored on this many points of the cloud; the best one is then fitted to all points near it.
SCORED_POINTS = 8000
# Scoring checks after this many points whether a plane is already worse than the best.
BLOCK = 500
REFITS = 30
# The area of a plane is counted in occupied cubes of this size, m; a plane with WIDER times as many is preferred.
CELL, WIDER_RATIO = 0.02, 1.5
THINNED = 100_000
# Points whose smaller spread along the plane is less than this multiple of the spread across it lie on a line.
NARROW = 3.0


@dataclass(frozen=True, eq=False)
class FoundPlane:
    """A plane fitted to a cloud of k points.

    on_plane (k,): whether each point lies within the given distance; share: fraction of such points; rms: of their
    distances, m; angle: between the normal and the given direction, rad; centre: of these points, (3,), m.
    """

    plane: Plane
    on_plane: NDArray[np.bool_]
    share: float
    rms: float
    angle: float
    centre: Array

    @property
    def multivector(self) -> Array:
        """π = n_x e1 + n_y e2 + n_z e3 + d e, (16,). Source: Cerbaro 2022, eq. 18."""
        return rigid.plane(self.plane.normal, self.plane.offset)


def find_plane(
    points: Array,
    towards: ArrayLike,
    inside: ArrayLike,
    distance: float = DISTANCE,
    angle: float = ANGLE,
    seed: int = 0,
) -> FoundPlane | Text:
    """The plane with the most points near it whose inward normal is within `angle` of `towards`; else the reason.

    A plane that covers a larger area is preferred, as a small object may have more points than a wall.

    Planes through three random points (π = ⋆σ/‖⋆σ‖) with l > 0 at the point inside are scored by Σ min(l², t²); the
    best is fitted by least squares to the points with |l| ≤ t until these do not change.
    Args: points (k, 3), m; towards: approximate inward normal, (3,), any length; inside: a point on the inner side,
    (3,), m; distance: t, m; angle: largest deviation, rad; seed: the same seed gives the same plane.
    Raises HelicoideError for an invalid direction, point, distance or angle.
    Source: Cerbaro 2022, §6.1 and eqs. 20, 25–26, with a least-squares fit in place of the last three points.
    """
    if len(points) < FEWEST:
        return Text(
            en="{k} points are too few for a plane: at least {fewest} are needed.",
            pt_BR="{k} pontos são poucos para um plano: são necessários {fewest}.",
        ).format(k=len(points), fewest=FEWEST)
    point, n0 = np.array(inside, dtype=np.float64), np.asarray(towards, dtype=np.float64)
    _check(n0, point, distance, angle)
    n0 = n0 / np.linalg.norm(n0)
    points = np.ascontiguousarray(points, dtype=np.float64)  # kernels are compiled for one order
    rng, cone = np.random.default_rng(seed), np.append(n0, np.cos(angle))
    triples, order = points[rng.integers(len(points), size=(DRAWS, 3))], rng.permutation(len(points))
    dense = best_plane(triples, points[order[:SCORED_POINTS]], cone, point, distance)
    thin = thin_cloud(points[order[:THINNED]])
    wide = best_plane(thin[rng.integers(len(thin), size=(DRAWS, 3))], thin[:SCORED_POINTS], cone, point, distance)

    def answered(drawn: Array) -> FoundPlane | Text:
        if not drawn.any():
            return _no_plane(angle)
        fit, on_it = _fitted(points, drawn, point, distance)
        return _accepted(points, fit, on_it, n0, angle, _share(thin, fit, distance))

    def is_wider(other: Plane) -> bool:
        if not wide.any():
            return False
        return _share(thin, _fitted(thin, wide, point, distance)[0], distance) > WIDER_RATIO * _share(
            thin, other, distance
        )

    first = answered(dense)  # the fit to all points takes longest; the wide plane is fitted only if it is needed
    if isinstance(first, FoundPlane) and not is_wider(first.plane):
        return first
    second = answered(wide)
    return second if isinstance(second, FoundPlane) else first


def thin_cloud(points: Array) -> Array:
    """One point from each cube of edge `CELL`, so that an object counts by its size and not by its point density."""
    cubes = np.floor(points / CELL).astype(np.int64)
    cubes -= cubes.min(axis=0)
    size = cubes.max(axis=0) + 1
    _, first = np.unique((cubes[:, 0] * size[1] + cubes[:, 1]) * size[2] + cubes[:, 2], return_index=True)
    return points[np.sort(first)]  # in the original, random order


def _share(points: Array, plane: Plane | _Fit, distance: float) -> float:
    """Fraction of the points within a distance of a plane."""
    return float(np.mean(np.abs(points @ plane.normal - plane.offset) <= distance))


def _check(towards: Array, inside: Array, distance: float, angle: float) -> None:
    vectors = towards.shape == inside.shape == (3,) and np.isfinite([*towards, *inside]).all() and towards.any()
    if not (vectors and 0 < distance <= MOST_DISTANCE and 0 < angle <= np.pi / 2):
        raise HelicoideError(
            Text(
                en="The search for a plane needs a nonzero direction, an interior point, a distance of 0 to "
                "{most:.0f} mm and a tilt of 0 to 90°, both positive.",
                pt_BR="A busca de um plano precisa de uma direção diferente de zero, um ponto interno, uma distância "
                "de 0 a {most:.0f} mm e uma inclinação de 0 a 90°, ambas positivas.",
            ).format(most=1000 * MOST_DISTANCE)
        )


@kernel
def best_plane(triples: Array, scored: Array, cone: Array, inside: Array, distance: float) -> Array:
    """The plane through a triple of points with the least Σ min(l², t²), (n_x, n_y, n_z, d); zero if none is valid.

    n = ∓(p2 − p1)×(p3 − p1)/‖·‖, l = n·r − d. Collinear triples and planes outside the cone of normals are skipped.
    Args: triples (k, 3, 3), m; scored (m, 3), m: points of the score; cone (4,): axis and least cosine of the normal;
    inside (3,), m; distance: t, m. Source: Cerbaro 2022, eqs. 20, 25–26; the score: Torr & Zisserman 2000.
    """
    best, found = np.inf, np.zeros(4)
    square = distance * distance
    for t in range(triples.shape[0]):
        ax, ay, az = triples[t, 0, 0], triples[t, 0, 1], triples[t, 0, 2]
        ux, uy, uz = triples[t, 1, 0] - ax, triples[t, 1, 1] - ay, triples[t, 1, 2] - az
        vx, vy, vz = triples[t, 2, 0] - ax, triples[t, 2, 1] - ay, triples[t, 2, 2] - az
        nx, ny, nz = uz * vy - uy * vz, ux * vz - uz * vx, uy * vx - ux * vy
        length = np.sqrt(nx * nx + ny * ny + nz * nz)
        longest = max(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz)
        if length <= 1e-9 * longest:
            continue
        nx, ny, nz = nx / length, ny / length, nz / length
        d = nx * ax + ny * ay + nz * az
        if nx * inside[0] + ny * inside[1] + nz * inside[2] < d:
            nx, ny, nz, d = -nx, -ny, -nz, -d
        if nx * cone[0] + ny * cone[1] + nz * cone[2] < cone[3]:
            continue
        total = 0.0
        for start in range(0, scored.shape[0], BLOCK):
            for j in range(start, min(start + BLOCK, scored.shape[0])):
                offset = nx * scored[j, 0] + ny * scored[j, 1] + nz * scored[j, 2] - d
                total += min(offset * offset, square)
            if total >= best:
                break
        if total < best:
            best = total
            found[0], found[1], found[2], found[3] = nx, ny, nz, d
    return found


@dataclass(frozen=True, eq=False)
class _Fit:
    """A plane (n, d) fitted to points, their centre, and their rms across the plane and in its narrowest direction."""

    normal: Array
    offset: float
    centre: Array
    across: float
    along: float


def _fitted(points: Array, drawn: Array, inside: Array, distance: float) -> tuple[_Fit, NDArray[np.bool_]]:
    """Least-squares fit to the points near a plane, repeated until the set of near points does not change."""
    origin = drawn[3] * drawn[:3]
    sums, plane = np.zeros(10), drawn
    for _ in range(REFITS):
        before, sums = sums, near_sums(points, plane, origin, distance)
        if (sums == before).all():
            break
        fit = _least_squares(sums, origin, inside)
        plane = np.append(fit.normal, fit.offset)
    return fit, np.abs(points @ fit.normal - fit.offset) <= distance


@kernel
def near_sums(points: Array, plane: Array, origin: Array, distance: float) -> Array:
    """Moments of the points with |l| ≤ t: count, Σ r, and Σ of xx, xy, xz, yy, yz, zz, r relative to origin; (10,).

    Args: points (k, 3), m; plane (n_x, n_y, n_z, d); origin (3,), m, near the points, to avoid cancellation; distance:
    t, m.
    """
    sums = np.zeros(10)
    a, b, c, d = plane[0], plane[1], plane[2], plane[3]
    for j in range(points.shape[0]):
        px, py, pz = points[j, 0], points[j, 1], points[j, 2]
        if abs(a * px + b * py + c * pz - d) <= distance:
            x, y, z = px - origin[0], py - origin[1], pz - origin[2]
            sums[0] += 1.0
            sums[1], sums[2], sums[3] = sums[1] + x, sums[2] + y, sums[3] + z
            sums[4], sums[5], sums[6] = sums[4] + x * x, sums[5] + x * y, sums[6] + x * z
            sums[7], sums[8], sums[9] = sums[7] + y * y, sums[8] + y * z, sums[9] + z * z
    return sums


def _least_squares(sums: Array, origin: Array, inside: Array) -> _Fit:
    """The least-squares plane: its normal is the eigenvector of the smallest eigenvalue of Σ r rᵀ about the centre.

    Args: sums (10,) of `near_sums` with that origin; inside (3,), m: the normal points to its side.
    """
    mean = sums[1:4] / sums[0]
    products = sums[[4, 5, 6, 5, 7, 8, 6, 8, 9]].reshape(3, 3) / sums[0]
    values, vectors = np.linalg.eigh(products - np.outer(mean, mean))
    centre = origin + mean
    normal = vectors[:, 0] if vectors[:, 0] @ (inside - centre) >= 0 else -vectors[:, 0]
    across, along = np.sqrt(np.maximum(values[:2], 0.0))
    return _Fit(normal, float(normal @ centre), centre, float(across), float(along))


def _accepted(
    points: Array, fit: _Fit, on_it: NDArray[np.bool_], towards: Array, angle: float, covered: float
) -> FoundPlane | Text:
    """The fitted plane, or the reason to reject it; covered: its share of all cubes with points."""
    if fit.along <= NARROW * fit.across or fit.along < 1e-9:
        return Text(
            en="No plane: the points lie along a line, which does not define a plane.",
            pt_BR="Nenhum plano: os pontos estão ao longo de uma reta, que não define um plano.",
        )
    turned = float(np.arctan2(np.linalg.norm(np.cross(fit.normal, towards)), fit.normal @ towards))
    if turned > angle:
        return _no_plane(angle)
    share = float(on_it.mean())
    if max(share, covered) < LEAST_SHARE or on_it.sum() < FEWEST:
        return Text(
            en="No plane: the best has {n} of {k} points near it; {least:.0f} % and {fewest} are needed.",
            pt_BR="Nenhum plano: o melhor tem {n} de {k} pontos perto; são necessários {least:.0f} % e {fewest}.",
        ).format(n=int(on_it.sum()), k=len(points), least=100 * LEAST_SHARE, fewest=FEWEST)
    on_it.flags.writeable = False
    plane = Plane(frozen(fit.normal), fit.offset)
    return FoundPlane(plane, on_it, share, fit.across, turned, frozen(fit.centre))


def _no_plane(angle: float) -> Text:
    return Text(
        en="No plane: none through the points is within {angle:.0f}° of the direction asked for.",
        pt_BR="Nenhum plano: nenhum que passe pelos pontos está a menos de {angle:.0f}° da direção pedida.",
    ).format(angle=np.degrees(angle))
