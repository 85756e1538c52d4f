from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.geometry.motions import angles, axes, of, pose, poses, vectors

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Array
from helicoide.text import HelicoideError

ONE = CL031.blade("1")

# Cerbaro 2022, §5.2.4, with cyclic names turned to the order of the blades.
HODGE = {
    "1": "e1e2e3e",
    "e1": "e2e3e",
    "e2": "-e1e3e",
    "e3": "e1e2e",
    "e": "-e1e2e3",
    "e1e2": "e3e",
    "e1e3": "-e2e",
    "e2e3": "e1e",
    "e1e": "e2e3",
    "e2e": "-e1e3",
    "e3e": "e1e2",
    "e1e2e3": "e",
    "e1e2e": "-e3",
    "e1e3e": "e2",
    "e2e3e": "-e1",
    "e1e2e3e": "1",
}


def same_motor(a: Array, b: Array) -> None:
    np.testing.assert_allclose(a * np.sign(a @ b), b, atol=1e-14)


@pytest.mark.parametrize("name", CL031.names)
def test_hodge_star_of_each_blade(name: str) -> None:
    blade, dual = CL031.blade(name), HODGE[name]
    sign = -1 if dual.startswith("-") else 1
    np.testing.assert_array_equal(rigid.hodge(blade), sign * CL031.blade(dual.strip("-")))
    np.testing.assert_array_equal(CL031.product(blade, rigid.hodge(blade)), CL031.blade("e1e2e3e"))


@given(poses)
def test_motors_are_unit_and_even(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    np.testing.assert_allclose(CL031.product(M, CL031.conjugate(M)), ONE, atol=2e-15)
    np.testing.assert_array_equal(M[CL031.grades % 2 == 1], 0)


@given(poses)
def test_poses_come_back_from_both_motors(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    np.testing.assert_allclose(rigid.pose_from_motor(M), T, atol=5e-15)
    np.testing.assert_allclose(rigid.pose_from_motor(-3 * M), T, atol=5e-15)


@given(poses, poses)
def test_motors_multiply_as_poses_do(T_a_b: Array, T_b_c: Array) -> None:
    product = CL031.product(rigid.motor_from_pose(T_a_b), rigid.motor_from_pose(T_b_c))
    np.testing.assert_allclose(rigid.pose_from_motor(product), T_a_b @ T_b_c, atol=2e-14)


@given(poses)
def test_a_motor_is_rotor_plus_half_t_g_e(T: Array) -> None:
    """Cerbaro 2022, eq. 96 term by term."""
    M = rigid.motor_from_pose(T)
    g = np.where([name.endswith("e") for name in CL031.names], 0, M)
    t = of(e1=T[0, 3], e2=T[1, 3], e3=T[2, 3])
    dual = CL031.product(CL031.product(t, g), CL031.blade("e")) / 2
    np.testing.assert_allclose(M, g + dual, atol=1e-15)


@given(poses)
def test_the_two_conjugates_of_a_motor(T: Array) -> None:
    """h h* = 1, while h h† = 1 + t e (Cerbaro 2022, eqs. 97 and 101)."""
    M = rigid.motor_from_pose(T)
    t_e = of(e1e=T[0, 3], e2e=T[1, 3], e3e=T[2, 3])
    np.testing.assert_allclose(CL031.product(M, rigid.dual_conjugate(M)), ONE + t_e, atol=1e-14)


@given(poses, vectors)
def test_even_points_move_with_the_dual_conjugate(T: Array, r: Array) -> None:
    M = rigid.motor_from_pose(T)
    moved = CL031.product(CL031.product(M, ONE + of(e1e=r[0], e2e=r[1], e3e=r[2])), rigid.dual_conjugate(M))
    x, y, z = T[:3, :3] @ r + T[:3, 3]
    np.testing.assert_allclose(moved, ONE + of(e1e=x, e2e=y, e3e=z), atol=2e-14)


@given(poses, vectors)
def test_points_move_as_the_matrix_moves_them(T: Array, r: Array) -> None:
    moved = rigid.move(rigid.motor_from_pose(T), rigid.point(r))
    np.testing.assert_allclose(moved, rigid.point(T[:3, :3] @ r + T[:3, 3]), atol=2e-14)
    np.testing.assert_allclose(rigid.coordinates(-2 * moved), T[:3, :3] @ r + T[:3, 3], atol=2e-14)


@given(poses, axes, vectors)
def test_lines_move_as_the_matrix_moves_them(T: Array, v: Array, r: Array) -> None:
    moved = rigid.move(rigid.motor_from_pose(T), rigid.line(v, r))
    R, t = T[:3, :3], T[:3, 3]
    np.testing.assert_allclose(moved, rigid.line(R @ v, R @ r + t), atol=4e-14)
    direction, moment = rigid.direction_and_moment(moved)
    np.testing.assert_allclose(direction, R @ v, atol=4e-14)
    np.testing.assert_allclose(moment, np.cross(R @ r + t, R @ v), atol=4e-14)


@given(poses, axes, st.floats(-3, 3))
def test_planes_move_as_the_matrix_moves_them(T: Array, n: Array, d: float) -> None:
    moved = rigid.move(rigid.motor_from_pose(T), rigid.plane(n, d))
    normal, offset = rigid.normal_and_offset(moved)
    np.testing.assert_allclose(normal, T[:3, :3] @ n, atol=2e-14)
    np.testing.assert_allclose(offset, d + normal @ T[:3, 3], atol=2e-14)
    np.testing.assert_allclose(moved, rigid.plane(normal, offset), atol=2e-14)


@given(axes, vectors, angles, st.floats(-1, 1))
def test_screw_motor_turns_by_plus_theta_about_the_line(v: Array, r: Array, angle: float, pitch: float) -> None:
    """exp(+θL/2) with the lines of Cerbaro 2022, eq. 17; displacement d = t s + (I − R) s0 of its eq. 62."""
    T = pose(v, angle, np.zeros(3))
    T[:3, 3] = pitch * angle * v + r - T[:3, :3] @ r
    np.testing.assert_allclose(rigid.pose_from_motor(rigid.screw_motor(5 * v, r, angle, pitch)), T, atol=1e-14)


@given(axes, vectors, st.floats(-3, 3))
def test_screw_motor_is_the_exponential_of_half_theta_l(v: Array, r: Array, angle: float) -> None:
    half = angle / 2 * rigid.line(v, r)
    exponential, term = ONE, ONE
    for power in range(1, 40):
        term = CL031.product(term, half) / power
        exponential = exponential + term
    np.testing.assert_allclose(rigid.screw_motor(v, r, angle), exponential, atol=1e-12)


@given(axes, vectors, angles)
def test_a_screw_leaves_its_own_axis_where_it_is(v: Array, r: Array, angle: float) -> None:
    axis = rigid.line(v, r)
    np.testing.assert_allclose(rigid.move(rigid.screw_motor(v, r, angle, 0.3), axis), axis, atol=2e-14)


@given(axes, angles, vectors)
def test_rotor_then_translator_is_the_motor_of_the_pose(axis: Array, angle: float, t: Array) -> None:
    composed = CL031.product(rigid.translator(t), rigid.rotor(axis, angle))
    same_motor(composed, rigid.motor_from_pose(pose(axis, angle, t)))


@given(poses)
def test_canonical_is_the_same_for_both_signs(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    np.testing.assert_array_equal(rigid.canonical(M), rigid.canonical(-M))
    assert rigid.canonical(-M)[0] >= 0


def test_canonical_of_a_half_turn() -> None:
    M = of(e1e2=-1, e1e=2)
    np.testing.assert_array_equal(rigid.canonical(M), -M)
    np.testing.assert_array_equal(rigid.canonical(-M), -M)


@given(axes, st.floats(-3, 3), vectors)
def test_distance_is_n_dot_r_minus_d(n: Array, d: float, r: Array) -> None:
    distance = rigid.point_plane_distance(rigid.plane(n, d), rigid.point(r))
    np.testing.assert_allclose(distance, n @ r - d, atol=1e-14)


def test_distance_example() -> None:
    """Cerbaro 2022, eqs. 22–24."""
    plane, point = rigid.plane((0, 0, -1), -4), rigid.point((3, 2, 2))
    np.testing.assert_array_equal(plane, of(e3=-1, e=-4))
    np.testing.assert_array_equal(point, of(e1e2e3=1, e1e2e=2, e1e3e=-2, e2e3e=3))
    commutator = CL031.product(plane, point) - CL031.product(point, plane)
    np.testing.assert_array_equal(commutator, of(e1e2e3e=4))
    assert rigid.point_plane_distance(plane, point) == 2


def test_plane_through_three_points_example() -> None:
    """Cerbaro 2022, eqs. 27–30, with σ summed over the six orders of eq. 25."""
    points = rigid.point([(1, 2, 3), (2, -2, 3), (-1, 1, 0)])
    sigma = np.zeros(16)
    for order in permutations(range(3)):
        i, j, k = (rigid.hodge(points[place]) for place in order)
        sign = np.linalg.det(np.eye(3)[list(order)])
        sigma += sign * CL031.product(CL031.product(i, j), k)
    np.testing.assert_allclose(sigma, of(e1e2e3=54, e1e2e=-54, e1e3e=-18, e2e3e=72), atol=1e-12)
    dual = rigid.hodge(sigma)
    np.testing.assert_allclose(CL031.product(dual, CL031.conjugate(dual)), 8424 * ONE, atol=1e-9)
    plane = rigid.plane_through(*points)
    np.testing.assert_allclose(plane, dual / np.sqrt(8424), atol=1e-15)
    np.testing.assert_allclose(plane, of(e1=-0.7845, e2=-0.1961, e3=0.5883, e=0.5883), atol=1e-4)
    np.testing.assert_allclose(rigid.point_plane_distance(plane, points), 0, atol=1e-15)


@given(vectors, vectors, vectors)
def test_plane_through_has_the_normal_of_the_cross_product(p1: Array, p2: Array, p3: Array) -> None:
    cross = -np.cross(p2 - p1, p3 - p1)
    edges = max(np.linalg.norm(p2 - p1), np.linalg.norm(p3 - p1), np.linalg.norm(p3 - p2))
    found = rigid.plane_through(rigid.point(p1), rigid.point(p2), rigid.point(p3))
    if np.linalg.norm(cross) > 1e-4 * edges**2:
        n = cross / np.linalg.norm(cross)
        np.testing.assert_allclose(found, rigid.plane(n, n @ p1), atol=1e-9)
        swapped = rigid.plane_through(rigid.point(p2), rigid.point(p1), rigid.point(p3))
        np.testing.assert_allclose(swapped, -found, atol=1e-9)


@given(vectors, axes, st.floats(-3, 3), st.floats(-3, 3))
def test_collinear_points_have_no_plane(r: Array, v: Array, a: float, b: float) -> None:
    on_the_line = [rigid.point(1000 * (r + s * v)) for s in (0, round(a, 2), round(b, 2))]
    np.testing.assert_array_equal(rigid.plane_through(*on_the_line), 0)


def test_planes_of_many_triples_at_once() -> None:
    points = rigid.point(np.random.default_rng(3).normal(size=(3, 7, 3)))
    points[1, 4] = points[0, 4]
    planes = rigid.plane_through(*points)
    np.testing.assert_array_equal(planes[4], 0)
    np.testing.assert_allclose(rigid.point_plane_distance(planes, points)[:, [0, 1, 2, 3, 5, 6]], 0, atol=1e-14)


def test_quarter_turn_and_shift_example() -> None:
    """Cerbaro 2022, eqs. 16–18 and 96: a quarter turn about z, then 100 mm along x."""
    M = CL031.product(rigid.translator((100, 0, 0)), rigid.rotor((0, 0, 1), np.pi / 2))
    np.testing.assert_allclose(M, of(one=0.70711, e1e2=0.70711, e1e=35.3553, e2e=-35.3553), atol=5e-5)
    np.testing.assert_allclose(rigid.move(M, rigid.plane((1, 0, 0), 50)), of(e2=1, e=50), atol=1e-12)
    np.testing.assert_allclose(rigid.coordinates(rigid.move(M, rigid.point((50, 10, 5)))), (90, 50, 5), atol=1e-12)
    line = rigid.line((0, 0, 1), (50, 10, 5))
    np.testing.assert_allclose(line, of(e1e2=1, e1e=10, e2e=-50), atol=1e-15)
    np.testing.assert_allclose(rigid.move(M, line), of(e1e2=1, e1e=50, e2e=-90), atol=1e-12)


# Cerbaro 2022, App. F: row × column, as i j = k, i ε = iε and ε ε = 0.
UNITS = ("1", "i", "j", "k", "ε", "iε", "jε", "kε")
TABLE = """
1  i   j   k   ε   iε  jε  kε
i  -1  k   -j  iε  -ε  kε  -jε
j  -k  -1  i   jε  -kε -ε  iε
k  j   -i  -1  kε  jε  -iε -ε
ε  iε  jε  kε  0   0   0   0
iε -ε  kε  -jε 0   0   0   0
jε -kε -ε  iε  0   0   0   0
kε jε  -iε -ε  0   0   0   0
"""


def test_dual_quaternions_multiply_by_the_table_of_appendix_f() -> None:
    """With i = e2e3, j = e3e1, k = e1e2, iε = e1e, jε = e2e, kε = e3e and ε = −e1e2e3e."""
    names = ["1", "e2e3", "e3e1", "e1e2", "e1e2e3e", "e1e", "e2e", "e3e"]
    signs = np.array([1, 1, 1, 1, -1, 1, 1, 1])
    units = signs[:, None] * np.array([CL031.blade(name) for name in names])
    np.testing.assert_array_equal(rigid.motor_from_dual_quaternion(np.eye(8)), units)
    value = {"0": np.zeros(16), **dict(zip(UNITS, units, strict=True))}
    expected = [
        [-value[cell[1:]] if cell[0] == "-" else value[cell] for cell in row.split()]
        for row in TABLE.strip().split("\n")
    ]
    np.testing.assert_array_equal(CL031.product(units[:, None], units), expected)


@given(poses)
def test_dual_quaternions_come_back(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    np.testing.assert_array_equal(rigid.motor_from_dual_quaternion(rigid.dual_quaternion(M)), M)


# Cerbaro 2022, tabs. 7 and 8: axis and point of each joint (mm), tool at the reference pose.
MOVEMASTER = (
    [(0, 0, 1), (0, -1, 0), (0, -1, 0), (0, -1, 0), (1, 0, 0)],
    [(0, 0, 400), (120, 0, 400), (370, 0, 400), (570, 0, 400), (570, 0, 400)],
    (820, 0, 400),
)
ORCA = ([(0, 0, 1)] * 3, [(0, 0, 0), (245, 0, 0), (485, 0, 0)], (655, 0, 0))
MOVEMASTER_EXAMPLE = (
    (0.683013, 0.5, 0.5, -0.183013, 10.341380, -319.233938, 385.836478, 220.556080),
    (-158.056080, 60.801270, 210.801270, 152.158620),
)
MOVEMASTER_HOME = (
    (0.989016, 0, 0.147809, 0, 0, -234.587403, 0, 149.958465),
    (0, 200.470984, 0, 287.159779),
)
ORCA_EXAMPLE = ((1, 0, 0, 0, 0, -168.430071, 154.660582, 0), (0, 159.069929, 154.660582, 0))


@pytest.mark.parametrize(
    ("arm", "q_deg", "products"),
    [
        (MOVEMASTER, (30, 60, -90, -30, 90), MOVEMASTER_EXAMPLE),
        (MOVEMASTER, (0, 106, -123, 0, 0), MOVEMASTER_HOME),
        (ORCA, (20, 90, -110), ORCA_EXAMPLE),
    ],
)
def test_products_of_the_joint_screws(
    arm: tuple[list[tuple[int, ...]], list[tuple[int, ...]], tuple[int, ...]],
    q_deg: tuple[int, ...],
    products: tuple[tuple[float, ...], tuple[float, ...]],
) -> None:
    """Cerbaro 2022, eq. 103 with joint n innermost: h1 h2 … hn, then times the tool's 1 + ½ p e."""
    directions, points, tool = arm
    M = ONE
    for h in rigid.screw_motor(directions, points, np.radians(q_deg)):
        M = CL031.product(M, h)
    np.testing.assert_allclose(rigid.dual_quaternion(M), products[0], atol=6e-7)
    at_tool = rigid.dual_quaternion(CL031.product(M, rigid.translator(tool)))
    np.testing.assert_allclose(at_tool, [*products[0][:4], *products[1]], atol=6e-7)


@pytest.mark.parametrize(
    ("order", "place", "precision"),
    [((4, 3, 2, 1, 0), (470.429399, 271.602540, 300.000000), 6e-7), ((0, 1, 2, 3, 4), (816.9, 194.6, 810.0), 0.05)],
)
def test_the_joint_nearest_to_the_tool_moves_the_point_first(
    order: tuple[int, ...], place: tuple[float, ...], precision: float
) -> None:
    """Cerbaro 2022, eqs. 15 and 103, of the example of eq. 5; the order as printed leads elsewhere."""
    directions, points, tool = MOVEMASTER
    screws = rigid.screw_motor(directions, points, np.radians((30, 60, -90, -30, 90)))
    even, p = ONE + rigid.null_part(2 * rigid.translator(tool)), rigid.point(tool)
    for joint in order:
        even = CL031.product(CL031.product(screws[joint], even), rigid.dual_conjugate(screws[joint]))
        p = rigid.move(screws[joint], p)
    np.testing.assert_allclose(rigid.coordinates(p), place, atol=precision)
    np.testing.assert_allclose(even, ONE + rigid.null_part(2 * rigid.translator(rigid.coordinates(p))), atol=1e-9)


def test_a_sandwich_does_not_compose_poses() -> None:
    """It leaves the pose 1 as it is: the product from the left moves poses (Cerbaro 2022, eqs. 95, 102)."""
    turn = rigid.rotor((0, 0, 1), 1.0)
    np.testing.assert_allclose(CL031.product(CL031.product(turn, ONE), rigid.dual_conjugate(turn)), ONE, atol=1e-15)
    T = rigid.pose_from_motor(CL031.product(turn, ONE))
    np.testing.assert_allclose(T, pose(np.array([0.0, 0.0, 1.0]), 1.0, np.zeros(3)), atol=1e-15)


def test_everything_broadcasts() -> None:
    rng = np.random.default_rng(4)
    T = np.array([[pose(np.eye(3)[i], j / 2, rng.normal(size=3)) for j in range(8)] for i in range(3)])
    M = rigid.motor_from_pose(T)
    np.testing.assert_allclose(rigid.pose_from_motor(M), T, atol=1e-14)
    r = rng.normal(size=(8, 3))
    moved = rigid.coordinates(rigid.move(M, rigid.point(r)))
    np.testing.assert_allclose(moved, np.einsum("abij,bj->abi", T[..., :3, :3], r) + T[..., :3, 3], atol=1e-14)
    screws = rigid.screw_motor(np.eye(3), r[:3], [0.1, 0.2, 0.3], [0, 1, 2])
    np.testing.assert_allclose(screws[2], rigid.screw_motor((0, 0, 1), r[2], 0.3, 2.0), atol=1e-15)


def test_a_screw_needs_a_direction() -> None:
    with pytest.raises(HelicoideError, match="has no direction"):
        rigid.screw_motor((0, 0, 0), (1, 2, 3), 1.0)
