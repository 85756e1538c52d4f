from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from tests.geometry.motions import angles, axes, poses, vectors

from helicoide.geometry import motor, pga, rigid
from helicoide.geometry.clifford import CL031, PGA, Array

elements = st.lists(st.floats(-2, 2), min_size=16, max_size=16).map(np.array)
evens = elements.map(lambda X: np.where(CL031.grades % 2 == 0, X, 0.0))


def modern(**blades: float) -> Array:
    """Multivector of Cl(3,0,1) by its coefficients in compact names, such as e031."""
    return np.asarray(sum(value * PGA.blade(name) for name, value in blades.items()))


def by_reverse(M: Array, X: Array) -> Array:
    """The motion of modern algebra, M X M~."""
    return PGA.product(PGA.product(M, X), PGA.reverse(M))


@given(vectors)
def test_points_are_those_of_modern_algebra(r: Array) -> None:
    x, y, z = r
    np.testing.assert_array_equal(pga.to_modern(rigid.point(r)), modern(e123=1, e032=x, e013=y, e021=z))


@given(axes, st.floats(-3, 3))
def test_planes_are_those_of_modern_algebra(n: Array, d: float) -> None:
    np.testing.assert_array_equal(pga.to_modern(rigid.plane(n, d)), modern(e1=n[0], e2=n[1], e3=n[2], e0=-d))


@given(axes, vectors)
def test_lines_are_those_of_modern_algebra(v: Array, r: Array) -> None:
    u = np.cross(r, v)
    expected = modern(e23=v[0], e31=v[1], e12=v[2], e01=u[0], e02=u[1], e03=u[2])
    np.testing.assert_array_equal(pga.to_modern(rigid.line(v, r)), expected)


@given(elements, elements)
def test_the_map_keeps_outer_products(a: Array, b: Array) -> None:
    together = PGA.outer(pga.to_modern(a), pga.to_modern(b))
    np.testing.assert_allclose(pga.to_modern(CL031.outer(a, b)), together, atol=1e-13)


@given(elements, elements)
def test_the_map_turns_regressive_products_over(a: Array, b: Array) -> None:
    together = PGA.regressive(pga.to_modern(a), pga.to_modern(b))
    np.testing.assert_allclose(pga.to_modern(CL031.regressive(a, b)), -together, atol=1e-13)


@given(evens, evens)
def test_the_even_algebras_are_isomorphic(a: Array, b: Array) -> None:
    together = PGA.product(pga.motor_to_modern(a), pga.motor_to_modern(b))
    np.testing.assert_allclose(pga.motor_to_modern(CL031.product(a, b)), together, atol=1e-13)


def test_over_the_complex_numbers_the_two_are_one_algebra() -> None:
    """Φ(X) = iᵏ ψ(X) keeps every product of blades, Φ(a) Φ(b) = Φ(a b)."""
    a, b, phases = np.eye(16)[:, None], np.eye(16), 1j**CL031.grades
    together = np.multiply.outer(phases, phases)[..., None] * PGA.product(pga.to_modern(a), pga.to_modern(b))
    np.testing.assert_allclose(phases * pga.to_modern(CL031.product(a, b)), together, atol=1e-15)


@given(elements, evens)
def test_both_maps_come_back(X: Array, M: Array) -> None:
    np.testing.assert_array_equal(pga.from_modern(pga.to_modern(X)), X)
    np.testing.assert_array_equal(pga.motor_from_modern(pga.motor_to_modern(M)), M)


@given(poses, elements)
def test_moving_and_mapping_change_places(T: Array, X: Array) -> None:
    M = rigid.motor_from_pose(T)
    moved = by_reverse(pga.motor_to_modern(M), pga.to_modern(X))
    np.testing.assert_allclose(pga.to_modern(rigid.move(M, X)), moved, atol=1e-12)


@given(axes, st.floats(-3, 3), elements)
def test_reflecting_and_mapping_change_places(n: Array, d: float, X: Array) -> None:
    mirror = rigid.plane(n, d)
    there = pga.to_modern(mirror)
    reflected = PGA.product(PGA.product(there, pga.to_modern(X)), there)
    np.testing.assert_allclose(pga.to_modern(rigid.move(mirror, X)), reflected, atol=1e-11)


@given(axes, vectors, angles)
def test_a_turn_by_plus_theta_is_the_exponential_of_minus_half_theta_l(v: Array, r: Array, angle: float) -> None:
    half = -angle / 2 * pga.to_modern(rigid.line(v, r))
    total = term = PGA.blade("1")
    for power in range(1, 40):
        term = PGA.product(term, half) / power
        total = total + term
    mapped = pga.motor_to_modern(motor.exp(angle / 2 * rigid.line(v, r)))
    np.testing.assert_allclose(mapped, total, atol=1e-12)


@given(poses, poses)
def test_modern_motors_compose_as_poses_do(T_a_b: Array, T_b_c: Array) -> None:
    M_a_b, M_b_c = (pga.motor_to_modern(rigid.motor_from_pose(T)) for T in (T_a_b, T_b_c))
    np.testing.assert_allclose(PGA.product(M_a_b, PGA.reverse(M_a_b)), PGA.blade("1"), atol=1e-14)
    T_a_c = rigid.pose_from_motor(pga.motor_from_modern(PGA.product(M_a_b, M_b_c)))
    np.testing.assert_allclose(T_a_c, T_a_b @ T_b_c, atol=1e-13)


@given(axes, st.floats(-3, 3), vectors)
def test_distances_agree(n: Array, d: float, r: Array) -> None:
    """π ∧ p = l e0123 in modern algebra, where ½(πp − pπ) = l e1e2e3e in the sources' (Cerbaro 2022, eq. 19)."""
    plane, point = rigid.plane(n, d), rigid.point(r)
    meeting = PGA.outer(pga.to_modern(plane), pga.to_modern(point))
    np.testing.assert_allclose(meeting, rigid.point_plane_distance(plane, point) * PGA.blade("e0123"), atol=1e-14)


@given(axes, vectors, axes, vectors)
def test_distances_and_angles_of_lines_agree(v1: Array, r1: Array, v2: Array, r2: Array) -> None:
    lines = rigid.line(v1, r1), rigid.line(v2, r2)
    a, b = map(pga.to_modern, lines)
    np.testing.assert_allclose(PGA.product(a, b)[0], CL031.product(*lines)[0], atol=1e-14)
    np.testing.assert_allclose(PGA.regressive(a, b)[0], -CL031.regressive(*lines)[0], atol=1e-13)
