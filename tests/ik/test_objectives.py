"""Every objective: its words and settings, its gradient against differences, and what is known of its value."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from latex2mathml.converter import convert
from tests.ik.secondary_runs import chosen, problem
from tests.kinematics.arms import MIXED, NAMES, arm, derivative, postures

from helicoide.arrays import Array
from helicoide.geometry import euler
from helicoide.ik import Problem, objectives
from helicoide.ik.arm_points import PER_LINK, along_links, watched
from helicoide.ik.method import OneOf, Quantity, changed, settings
from helicoide.ik.objective import Cost, posture_at
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import position_manipulability
from helicoide.studies.cerbaro_runs.setups import movemaster, orca
from helicoide.text import HelicoideError, Text

ARMS = ("movemaster", "puma560", "scara", "planar3r", "dia10", MIXED)
OTHERS = np.random.default_rng(5).normal(size=(6, 3))
ROWS = {"ellipsoid", "joint_barrier", "second_arm", "slab"}
each_objective = pytest.mark.parametrize("name", objectives.names())
each_arm = pytest.mark.parametrize("robot_name", ARMS)


def variants(name: str) -> list[Any]:
    """Options that are not the usual ones: each choice of words, and turned ellipsoids and slabs."""
    options = objectives.named(name).Options()
    found = [options]
    for setting, kind in settings(type(options)).items():
        if isinstance(kind, OneOf):
            found += [replace(options, **{setting: choice}) for choice in kind.choices]
    turned = {
        "ellipsoid": {"yaw": 0.4, "pitch": -0.7, "roll": 1.1, "a": 0.5, "b": 0.3, "c": 0.8},
        "slab": {"azimuth": 0.8, "elevation": 0.5, "half": 0.3},
    }
    return [replace(one, **turned.get(name, {})) for one in found]


def cost(problem: Problem, name: str, q: Array, **options: Any) -> Cost:
    ((objective, given),) = chosen(name, **options)
    return objective.cost(problem, posture_at(problem, q, OTHERS * problem.robot.reach / 2), given)


@each_objective
def test_an_objective_says_what_it_is(name: str) -> None:
    objective = objectives.named(name)
    assert isinstance(objective.TITLE, Text)
    assert objective.TITLE.en != objective.TITLE.pt_BR
    assert objective.SOURCE
    assert "<math" in convert(objective.EQUATION)
    assert (name in ROWS) == objective.AUGMENTS
    for robot_name in NAMES:
        assert objective.applies(arm(robot_name)) is None
    options = objective.Options()
    for setting, kind in settings(objective.Options).items():
        assert changed(options, setting, getattr(options, setting)) == options
        assert not isinstance(kind, Quantity) or kind.lower < kind.upper


def test_an_unknown_objective_is_refused_with_the_names_there_are() -> None:
    with pytest.raises(HelicoideError, match="joint_barrier, limit_distance"):
        objectives.named("joy")


@each_objective
@each_arm
def test_the_gradient_is_the_derivative_of_the_cost(robot_name: str, name: str) -> None:
    """In the joint variables without unit: a joint that slides is measured in ℓ."""
    here, objective = problem(robot_name), objectives.named(name)
    others = OTHERS * here.robot.reach / 2
    for options in variants(name):
        for q in postures(here.robot, 2, seed=3):
            found = objective.cost(here, posture_at(here, q, others), options)
            by_differences = here.joint_units * derivative(
                lambda x, options=options: np.array(objective.cost(here, posture_at(here, x, others), options).value),
                q,
                1e-4,
            )
            scale = np.abs(by_differences).max() + abs(found.value)
            np.testing.assert_allclose(found.gradient, by_differences, rtol=0, atol=1e-7 * scale + 1e-12)


@each_arm
@pytest.mark.parametrize("name", sorted(ROWS))
def test_what_may_be_a_row_is_never_negative(robot_name: str, name: str) -> None:
    here = problem(robot_name)
    for q in postures(here.robot, 10):
        assert cost(here, name, q).value >= 0


# Cerbaro 2022, eqs. 11, 12, 14, recomputed.


def test_the_manipulability_of_the_examples() -> None:
    mm, planar = movemaster(), orca()
    assert -cost(mm, "manipulability", mm.robot.poses["example"]).value == pytest.approx(7.23266155e7, rel=1e-8)
    assert -cost(planar, "manipulability", planar.robot.poses["example"]).value == pytest.approx(78868.179, rel=1e-8)


@pytest.mark.parametrize("robot_name", ["movemaster", "puma560", "dia10"])
def test_manipulability_is_that_of_the_kinematics(robot_name: str) -> None:
    """Of position, and of the whole pose with turning weighted by ℓ; each row of position has one length ℓ in it."""
    here = problem(robot_name)
    for q in postures(here.robot, 3):
        w = -cost(here, "manipulability", q).value
        assert w * here.length**3 == pytest.approx(position_manipulability(here.robot, q).w, rel=1e-9)


def test_a_push_of_manipulability_leaves_a_singular_posture() -> None:
    here = problem("planar3r")
    q = np.array([np.pi / 2, 0.0, 0.0])
    there = cost(here, "manipulability", q)
    assert there.value == pytest.approx(0, abs=1e-15)
    assert cost(here, "manipulability", q - 0.1 * there.gradient).value < -1e-3


def test_the_distance_from_limits_of_the_examples() -> None:
    here = movemaster()
    example = cost(here, "limit_distance", here.robot.poses["example"])
    assert -example.value == pytest.approx(-0.0206982, abs=5e-8)
    assert -cost(here, "limit_distance", np.zeros(5)).value == pytest.approx(-0.0322485, abs=5e-8)
    np.testing.assert_allclose(-example.gradient, [-0.0086, -0.0170, 0.0239, 0.0086, -0.0080], rtol=0, atol=5.1e-5)


def test_equation_14_for_three_joints() -> None:
    here = orca()
    lower, upper = here.limits.lower, here.limits.upper
    for q in postures(here.robot, 5):
        printed = (lower - 2 * q + upper) / (6 * (lower - upper) ** 2)
        np.testing.assert_allclose(-cost(here, "limit_distance", q).gradient, printed, rtol=0, atol=1e-15)


def test_the_distance_from_an_obstacle_is_that_of_the_nearest_point() -> None:
    here = problem("movemaster")
    obstacle = np.array([0.45, 0.1, 0.35])
    q = here.robot.poses["ready"]
    points = watched(here.robot, "guarded").at(link_poses(here.robot.chain, q))
    x, y, z = obstacle / here.length
    found = cost(here, "obstacle_distance", q, x=x, y=y, z=z)
    least = np.linalg.norm(points - obstacle, axis=1).min()
    assert -found.value * here.length == pytest.approx(least, rel=1e-12)
    x, y, z = points[2] / here.length
    on_it = cost(here, "obstacle_distance", q, x=x, y=y, z=z)
    assert on_it.value == pytest.approx(0, abs=1e-15)
    assert np.isfinite(on_it.gradient).all()


# Vargas 2013, eqs. 4.73, 4.74.


def test_the_barrier_is_flat_inside_and_steep_outside() -> None:
    """|Δq|/ζ = 3 and k = 10 give f = 3.5e9 α (recomputed); at the limit f = α, half way next to nothing."""
    here = problem("planar3r")
    zeta = (here.limits.upper - here.limits.lower) / 2
    middle = (here.limits.upper + here.limits.lower) / 2
    for share, f in ((3.0, 3.4867844e9), (1.0, 1.0), (0.5, 2.0**-20)):
        q = middle + share * zeta * [0, 1, 0]
        assert cost(here, "joint_barrier", q, weight=1.0).value == pytest.approx(f, rel=1e-7)
    narrow = cost(here, "joint_barrier", middle + 0.5 * zeta, weight=1.0, share=0.5)
    assert narrow.value == pytest.approx(3)


def test_an_ellipsoid_falls_to_1_over_e_at_its_semi_axes() -> None:
    here = problem("puma560")
    q = here.robot.poses["ready"]
    tool = watched(here.robot, "tool").at(link_poses(here.robot.chain, q))[0] / here.length
    angles, axes = (0.3, -0.5, 0.9), (0.1, 0.25, 0.4)
    R = euler.euler_matrix(angles, "zyx")
    names = dict(zip(("yaw", "pitch", "roll", "a", "b", "c"), (*angles, *axes), strict=True))
    for i in range(3):
        x, y, z = tool - R[:, i] * axes[i]
        found = cost(here, "ellipsoid", q, weight=2.0, x=x, y=y, z=z, where="tool", **names)
        assert found.value == pytest.approx(2 / np.e, rel=1e-12)


def test_a_second_arm_is_a_sum_of_round_ellipsoids() -> None:
    here = problem("dia10")
    q, others = here.robot.poses["ready"], OTHERS * here.robot.reach / 2
    whole = cost(here, "second_arm", q, radius=0.3)
    parts = [
        cost(here, "ellipsoid", q, x=x, y=y, z=z, a=0.3, b=0.3, c=0.3, where="links", per_link=4)
        for x, y, z in others / here.length
    ]
    assert whole.value == pytest.approx(sum(part.value for part in parts), rel=1e-12)
    np.testing.assert_allclose(whole.gradient, sum(part.gradient for part in parts), rtol=1e-12)


def test_a_slab_has_its_walls_at_zeta() -> None:
    """The stretched planar arm, 4 m, with its tool at y = ±0.3 and ζ = 0.3, in a slab across y: f = α."""
    here = problem("planar3r", scale=1.0)
    options = {"azimuth": np.pi / 2, "elevation": 0.0, "offset": 0.0, "half": 0.3, "weight": 5.0}
    for side in (1, -1):
        q = np.array([side * np.arcsin(0.3 / 4), 0, 0])
        assert cost(here, "slab", q, **options).value == pytest.approx(5, rel=1e-12)
        assert np.sign(cost(here, "slab", q, **options).gradient[0]) == side
        middle = cost(here, "slab", q, **{**options, "offset": side * 0.3})
        assert middle.value == pytest.approx(0, abs=1e-12)


# Points along links.


@pytest.mark.parametrize("name", NAMES)
def test_points_lie_evenly_on_the_line_through_the_arm(name: str) -> None:
    """Three on a link mark it off in equal steps and end where the next begins, the last at the tool; a slide counts.

    What moves them is their Jacobian.
    """
    here = problem(name)
    rounding = 8 * np.finfo(float).eps * max(1.0, here.robot.reach)
    q = postures(here.robot, 1, seed=8)[0].copy()
    three, one = along_links(here.robot, 3), along_links(here.robot, 1)
    poses = link_poses(here.robot.chain, q)
    points, ends = three.at(poses), one.at(poses)
    np.testing.assert_allclose(points[2::3], ends, rtol=0, atol=rounding)
    corners = np.vstack([poses[1, :3, 3], ends])
    for origin in poses[2:, :3, 3]:
        assert np.linalg.norm(corners - origin, axis=1).min() < 1e-12
    np.testing.assert_allclose(ends[-1], (poses[-1] @ here.robot.T_link_tool)[:3, 3], rtol=0, atol=rounding)
    np.testing.assert_allclose(points[1::3] - points[::3], points[2::3] - points[1::3], rtol=0, atol=rounding)
    p, J = three.moving(here, poses)
    np.testing.assert_allclose(p * here.length, points, rtol=0, atol=rounding)
    by_differences = derivative(lambda x: three.at(link_poses(here.robot.chain, x)), q) * here.joint_units
    np.testing.assert_allclose(J * here.length, by_differences, rtol=0, atol=1e-9)


def test_where_axes_of_a_wrist_cross_there_is_no_link() -> None:
    """Movemaster: pitch and roll meet, so that there are four links; the SCARA has its slide as a link of its own."""
    assert len(along_links(arm("movemaster"), 5).weights) == 20
    scara = arm("scara")
    ends = along_links(scara, 1).at(link_poses(scara.chain, np.array([0, 0, 0.1, 0])))
    np.testing.assert_allclose(ends[:3], [[0.325, 0, 0.34], [0.55, 0, 0.34], [0.55, 0, 0.24]], rtol=0, atol=1e-15)


def test_the_points_per_link_are_a_setting_with_whole_numbers() -> None:
    here = problem("planar3r")
    q = here.robot.poses["ready"]
    assert PER_LINK.lower == 1
    assert cost(here, "ellipsoid", q, per_link=7.6).value == cost(here, "ellipsoid", q, per_link=8).value
