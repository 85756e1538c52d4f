"""What a page may send for the playground: only numbers are taken."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helicoide.seat import AxisAngle, Playground, Seat, Selection

NO_NUMBERS: list[Any] = [float("nan"), float("inf"), -float("inf"), "1", None, [1.0]]


@pytest.mark.parametrize("value", NO_NUMBERS)
def test_what_is_no_number_changes_nothing(value: Any) -> None:
    play = Playground()
    assert play.at(value) == play
    assert play.first.turned_by(value) == play.first
    assert play.first.about((value, 0.0, 1.0)) == play.first


def test_axes_get_length_one_and_zero_ones_are_refused() -> None:
    one = AxisAngle((0.0, 0.0, 1.0), 1.0)
    assert one.about((3.0, 0.0, 4.0)) == AxisAngle((0.6, 0.0, 0.8), 1.0)
    assert one.about((0.0, 0.0, 0.0)) == one
    assert one.about((1e200, 1e200, 0.0)).axis == pytest.approx((0.5**0.5, 0.5**0.5, 0.0))
    assert one.turned_by(1e6) == one
    assert Playground().at(2.0) == Playground()


def test_the_quaternions_are_those_of_scipy_and_the_opposite_is_the_same_rotation() -> None:
    for opposite in (False, True):
        play = Playground(AxisAngle((0.6, 0.0, 0.8), 1.2), AxisAngle((0.0, 1.0, 0.0), -0.7), opposite=opposite)
        for q, one in zip(play.quaternions, (play.first, play.second), strict=True):
            peer = Rotation.from_rotvec(one.angle * np.array(one.axis))
            assert (Rotation.from_quat(q, scalar_first=True).inv() * peer).magnitude() < 1e-12


def test_another_object_has_no_coefficient_chosen_yet() -> None:
    seat = Seat("", "en", selected=Selection("tool"), coefficient="e1e", term_joint=2)
    other = seat.inspecting(Selection("plane", 1))
    assert (other.selected, other.coefficient, other.term_joint) == (Selection("plane", 1), None, None)
