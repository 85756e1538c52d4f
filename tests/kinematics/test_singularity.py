"""Singular postures by kind: the factors are those of the determinant, and each changes its sign where it should."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.kinematics import differential
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.singularity import singularity
from helicoide.kinematics.spherical_wrist import SingularityKind, determinant_factors, spherical_wrist

L1, L2 = 0.2794, 0.2286
SPHERICAL = [name for name in NAMES if spherical_wrist(arm(name)) is not None]


def at_wrist(robot: Robot, q: Array) -> Array:
    """J_G with the velocity of the wrist centre on the last link."""
    return differential.frame_jacobian(robot, q, robot.frames["wrist"])


def kinds(robot: Robot, q: Array, within: float = 1e-9) -> set[SingularityKind]:
    return {factor.kind for factor in singularity(robot, q).near_factors(within)}


def value(robot: Robot, q: Array, kind: SingularityKind) -> float:
    return next(factor.value for factor in singularity(robot, q).factors if factor.kind is kind)


def test_arms_with_a_spherical_wrist_are_recognised() -> None:
    assert {"zebra_zero", "puma560"} <= set(SPHERICAL)
    assert not {"movemaster", "orca", "dia10", "scara", "planar3r"} & set(SPHERICAL)
    robot = arm("zebra_zero")
    bent = replace(robot.joints[4], point=frozen(np.add(robot.joints[4].point, [0.1, 0, 0.1])))
    assert spherical_wrist(replace(robot, joints=(*robot.joints[:4], bent, robot.joints[5]))) is None


@pytest.mark.parametrize("name", SPHERICAL)
def test_the_product_of_the_factors_is_the_determinant(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 50):
        product = np.prod([factor.value for factor in singularity(robot, q).factors])
        assert product == pytest.approx(np.linalg.det(at_wrist(robot, q)), abs=1e-12)


@pytest.mark.parametrize("name", SPHERICAL)
def test_the_wrist_centre_is_moved_by_the_first_three_joints_alone(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 10):
        np.testing.assert_allclose(at_wrist(robot, q)[:3, 3:], 0, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", SPHERICAL)
def test_relative_factors_run_from_minus_one_to_one(name: str) -> None:
    robot = arm(name)
    relative = np.array([[f.relative for f in singularity(robot, q).factors] for q in postures(robot, 500)])
    assert (np.abs(relative) <= 1 + 1e-12).all()
    assert (np.abs(relative).max(axis=0) > 0.8).all()


def test_the_factors_of_the_zebra_zero() -> None:
    """det J_G = l₁l₂ cos q₃ (l₁c₂ − l₂s₂₃) sin q₅ (Vargas 2013, §3.2), in 50 postures."""
    robot = arm("zebra_zero")
    for q in postures(robot, 50, seed=5):
        shoulder, elbow, wrist = singularity(robot, q).factors
        assert shoulder.value == pytest.approx(L1 * np.cos(q[1]) - L2 * np.sin(q[1] + q[2]), abs=1e-12)
        assert elbow.value == pytest.approx(L1 * L2 * np.cos(q[2]), abs=1e-12)
        assert wrist.value == pytest.approx(np.sin(q[4]), abs=1e-12)


UPRIGHT = np.arctan2(L1, L2)  # with q₃ = −π the wrist centre is over the first axis where l₁ c₂ + l₂ s₂ = 0


@pytest.mark.parametrize(
    ("kind", "joint", "at"),
    [
        (SingularityKind.ELBOW, 2, [0.3, 0.4, -np.pi / 2, 0.2, 0.7, 0.1]),
        (SingularityKind.ELBOW, 2, [0.3, 0.4, np.pi / 2, 0.2, 0.7, 0.1]),
        (SingularityKind.SHOULDER, 1, [0.3, np.pi - UPRIGHT, -np.pi, 0.2, 0.7, 0.1]),
        (SingularityKind.WRIST, 4, [0.3, 0.4, -2.0, 0.2, 0.0, 0.1]),
        (SingularityKind.WRIST, 4, [0.3, 0.4, -2.0, 0.2, np.pi, 0.1]),
    ],
)
def test_each_factor_changes_its_sign_at_its_own_singularity(
    kind: SingularityKind, joint: int, at: list[float]
) -> None:
    robot, q, step = arm("zebra_zero"), np.array(at), 1e-3 * np.eye(6)[joint]
    before, after = singularity(robot, q - step), singularity(robot, q + step)
    assert value(robot, q - step, kind) * value(robot, q + step, kind) < 0
    for one, other in zip(before.factors, after.factors, strict=True):
        assert one.kind is kind or one.value * other.value > 0
    assert kinds(robot, q) == {kind}
    here = singularity(robot, q)
    assert (here.rank, here.generic_rank, here.singular) == (5, 6, True)
    assert not before.singular
    assert np.linalg.det(at_wrist(robot, q - step)) * np.linalg.det(at_wrist(robot, q + step)) < 0


def test_the_singular_starts_of_the_source() -> None:
    """At the start of simulation 11b all kinds are near; the folded starts of 10 and 14 differ by the wrist."""
    robot = arm("zebra_zero")
    assert kinds(robot, robot.poses["ill_conditioned"], within=0.15) == {
        SingularityKind.SHOULDER,
        SingularityKind.ELBOW,
        SingularityKind.WRIST,
    }
    assert kinds(robot, robot.poses["folded"], within=0.15) == {SingularityKind.WRIST}
    assert kinds(robot, robot.poses["folded_down"], within=0.15) == set()


def test_several_kinds_at_once_are_all_named_nearest_first() -> None:
    robot = arm("zebra_zero")
    here = singularity(robot, [0, 0.5, 0.01 - np.pi / 2, 0, 0.001, 0])
    assert [factor.kind for factor in here.near_factors(0.02)] == [SingularityKind.WRIST, SingularityKind.ELBOW]
    assert here.description(0.02).en.startswith("wrist: ")
    assert "; cotovelo: " in here.description(0.02).pt_BR
    upright = np.array([0, np.pi / 2, -np.pi / 2, 0, 0, 0])
    assert kinds(robot, upright) == {SingularityKind.SHOULDER, SingularityKind.ELBOW, SingularityKind.WRIST}


def test_lost_velocities_are_those_that_no_joint_gives() -> None:
    """With the arm stretched the wrist centre cannot go on outwards."""
    robot = arm("zebra_zero")
    q = np.array([0.0, 0.4, -np.pi / 2, 0.2, 0.7, 0.1])
    here = singularity(robot, q)
    assert here.lost_velocities.shape == (6, 1)
    outwards = differential.frame_pose(robot, q, robot.frames["wrist"])[:3, 3]
    way, to_wrist = outwards - differential.frame_pose(robot, q)[:3, 3], np.eye(6)
    to_wrist[:3, 3:] = -rotation.skew(way)  # v of the wrist = v + ω × way
    force = np.linalg.solve(to_wrist.T, here.lost_velocities[:, 0])  # yᵀ V_tool = fᵀ V_wrist
    np.testing.assert_allclose(np.cross(force[:3], outwards), 0, atol=1e-9)
    np.testing.assert_allclose(force[3:], 0, atol=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_the_rank_is_usual_in_random_postures(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 5, seed=7):
        here = singularity(robot, q)
        J = differential.frame_jacobian(robot, q)
        assert here.rank == here.generic_rank == np.linalg.matrix_rank(J, tol=1e-9)
        rows = 6 if counted_rows(robot)[3:].any() else 3
        assert here.lost_velocities.shape == (rows, rows - here.generic_rank)
        np.testing.assert_allclose(here.lost_velocities.T @ J[:rows], 0, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "q", "rank", "usual"),
    [
        ("planar3r", [0.3, 0.0, 0.0], 2, 3),
        ("orca", [0.3, 0.0, 0.0], 2, 3),
        ("movemaster", [0.2, 0.3, -0.5, 0.4, 0.1], 5, 5),
        ("movemaster", [0.2, 0.3, 0.0, 0.4, 0.1], 4, 5),
        ("dia10", [0.0] * 8, 3, 6),  # straight, its axes all along z or along the arm
    ],
)
def test_other_arms_say_their_rank(name: str, q: list[float], rank: int, usual: int) -> None:
    here = singularity(arm(name), q)
    assert here.factors == ()
    assert (here.rank, here.generic_rank) == (rank, usual)
    assert here.singular == (rank < usual)


def test_an_oblique_arm_has_its_first_three_joints_in_one_factor() -> None:
    """Where the second and third axes are not parallel, det J₁₁ is not split."""
    robot = arm("zebra_zero")
    oblique = replace(robot.joints[2], direction=frozen([0.6, -0.8, 0.0]))
    robot = replace(robot, joints=(*robot.joints[:2], oblique, *robot.joints[3:]))
    for q in postures(robot, 50):
        first_three, last_three = determinant_factors(robot, q, robot.frames["wrist"])
        assert (first_three.kind, last_three.kind) == (SingularityKind.ARM, SingularityKind.WRIST)
        assert first_three.value * last_three.value == pytest.approx(np.linalg.det(at_wrist(robot, q)), abs=1e-12)
        assert abs(first_three.relative) <= 1


def test_words_name_the_kind_in_both_languages() -> None:
    robot = arm("zebra_zero")
    stretched = singularity(robot, [0.3, 0.4, -np.pi / 2, 0.2, 0.7, 0.1]).description(0.05)
    assert stretched.en == "elbow: the arm is stretched or folded (factor at 0.0 % of its largest)"
    assert stretched.pt_BR == "cotovelo: o braço está esticado ou dobrado (fator a 0,0 % do máximo)"
    assert singularity(robot, robot.poses["ready"]).description(0.05).en == "none nearby"
    planar = singularity(arm("planar3r"), np.zeros(3)).description(0.05)
    assert planar.en == "the end effector moves in 2 of its 3 independent directions"


def test_an_arm_of_two_joints_is_singular_where_its_position_is() -> None:
    """Its two joints serve the position: that the tool still turns does not count."""
    robot = arm("planar2r")
    here = singularity(robot, [0.4, 0.0])
    assert here.singular
    assert (here.rank, here.generic_rank) == (1, 2)
    assert here.description(0.05).pt_BR == "o ponto do efetuador se move em 1 das suas 2 direções independentes"
    assert here.lost_velocities.shape == (3, 2)
    outwards = [np.cos(0.4), np.sin(0.4), 0]
    assert np.linalg.norm(here.lost_velocities.T @ outwards) == pytest.approx(1)


def test_without_orientation_the_position_alone_is_singular() -> None:
    """A straight wrist of the Movemaster takes a rotation away, and no direction of the position."""
    robot, q = arm("movemaster"), [0.2, 0.3, -0.5, 0.4, 0.1]
    assert singularity(robot, q, with_orientation=False).generic_rank == 3
    wrist = arm("zebra_zero")
    q = [0.3, 0.4, -0.8, 0.2, 0.0, 0.1]
    assert singularity(wrist, q).near_factors(0.05)[0].kind is SingularityKind.WRIST
    assert singularity(wrist, q, with_orientation=False).warning() is None


@pytest.mark.parametrize("name", NAMES)
def test_how_near_it_is_falls_to_nothing_at_a_singular_posture(name: str) -> None:
    """On the way from a posture to a singular one nearby; nothing is told where the arm is far from one."""
    robot = arm(name)
    assert singularity(robot, robot.poses["ready"]).warning() is None
    for q in postures(robot, 20, seed=3):
        assert 0 < singularity(robot, q).tool.relative_singular_value < 1.5
    if name in ("planar3r", "movemaster", "scara"):
        straight = np.zeros(len(robot.variables))
        parts = [
            singularity(robot, straight + x * robot.poses["ready"]).tool.relative_singular_value
            for x in (0, 1e-3, 0.01, 0.1)
        ]
        assert parts[0] < 1e-9 < parts[1] < parts[2] < parts[3]
        assert (
            "in its slowest direction"
            in singularity(robot, straight + 1e-3 * robot.poses["ready"]).description(0.05).en
        )
