"""What every closed form makes its branches with: angles within the limits, and what the tool misses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.ik.postures.branches import branch_of

from helicoide.arrays import frozen
from helicoide.geometry import euler
from helicoide.ik.postures.branch import check_pose, sentences, tool_at, wrap
from helicoide.kinematics.library import load_robot
from helicoide.studies._campos_arms import with_joint_limits
from helicoide.text import HelicoideError, Text, untranslated

L3 = load_robot("motoman_l3")


@given(angle=st.floats(-1e3, 1e3))
def test_wrap_gives_the_same_angle_in_its_range(angle: float) -> None:
    assert -np.pi < wrap(angle) <= np.pi
    assert np.exp(1j * float(wrap(angle))) == pytest.approx(np.exp(1j * angle), abs=1e-12)


@pytest.mark.parametrize("angle", [np.pi, -np.pi, np.nextafter(np.pi, 4), np.nextafter(-np.pi, 0), 3 * np.pi])
def test_wrap_at_the_ends(angle: float) -> None:
    assert -np.pi < wrap(angle) <= np.pi
    assert abs(wrap(angle)) == pytest.approx(np.pi)


@pytest.mark.parametrize(
    ("lower", "upper", "given_deg", "expected", "within"),
    [
        (-10, 190, -175, 185, True),
        (-180, 180, 185, -175, True),
        (-360, 360, 350, -10, True),
        (300, 400, -20, 340, True),
        (-400, -300, 20, -340, True),
        (-90, 90, 175, 175, False),
        (-180, 180, 180, 180, True),
    ],
)
def test_angles_are_moved_into_the_limits_where_a_whole_turn_does_it(
    lower: float, upper: float, given_deg: float, expected: float, within: bool
) -> None:
    robot = with_joint_limits(L3, np.radians([lower, -180, -180, -180, -180]), np.radians([upper, 180, 180, 180, 180]))
    q = np.radians([given_deg, 0, 0, 0, 0])
    branch = branch_of(robot, untranslated("x"), q, tool_at(robot, q))
    assert np.degrees(branch.q[0]) == pytest.approx(expected)
    assert branch.within == within
    assert (branch.missed, branch.turned) == pytest.approx((0, 0), abs=1e-12)


def test_a_slide_is_left_where_it_is() -> None:
    robot = load_robot("polar_rp")
    branch = branch_of(robot, untranslated("x"), [7.0, 9.0], tool_at(robot, frozen([7.0, 9.0])))
    np.testing.assert_allclose(branch.q, [7 - 2 * np.pi, 9])
    assert not branch.within


def test_what_a_branch_misses_is_told() -> None:
    q = frozen([0.1, -1, 1, 1, 0.2])
    goal = tool_at(L3, q).copy()
    goal[:3, :3] = goal[:3, :3] @ euler.euler_matrix([0.3, 0, 0], "zyx")
    goal[:3, 3] += [0.03, 0.04, 0]
    branch = branch_of(L3, untranslated("x"), q, frozen(goal))
    assert (branch.missed, branch.turned) == pytest.approx((0.05, 0.3))


@pytest.mark.parametrize(
    "T", [np.eye(3), np.full((4, 4), np.nan), np.diag([1.0, 1, 1, 2]), np.diag([1.0, 1, -1, 1]), 1.01 * np.eye(4)]
)
def test_what_is_no_pose_is_refused(T: np.ndarray) -> None:
    with pytest.raises(HelicoideError, match="pose"):
        check_pose(T)


def test_sentences_are_joined_in_both_languages() -> None:
    assert sentences(Text("One.", "Um."), None, Text("Two.", "Dois.")) == Text("One. Two.", "Um. Dois.")
