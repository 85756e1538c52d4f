"""Joint space and actuator space: there and back, the numbers of the sources, and what a mechanism does."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics import library
from helicoide.kinematics.actuators import Actuators, BallScrew, Gear
from helicoide.kinematics.forward import screw_displacements
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

ROBOTS = ("movemaster", "orca", "motoman_l3")


def parts(n: int) -> st.SearchStrategy[Array]:
    """Where in each of n ranges, 0 to 1; the ends are drawn often."""
    return st.lists(st.floats(0, 1), min_size=n, max_size=n).map(np.array)


@cache
def load(name: str) -> Robot:
    return library.load_robot(name)


def actuators_of(robot: Robot) -> Actuators:
    assert robot.actuators
    return robot.actuators


def margin(actuators: Actuators, q: Array) -> float:
    """How far inside its range the driven angle is that is nearest to an end, rad; negative outside."""
    ends = zip(actuators.coupling @ q, actuators.drives, strict=True)
    return min(min(float(angle) - drive.angles[0], drive.angles[1] - float(angle)) for angle, drive in ends)


def postures(name: str) -> list[Array]:
    """A grid over the whole range of every joint, both limits among it."""
    robot = load(name)
    sides = [np.linspace(low, high, 5) for low, high in zip(robot.lower, robot.upper, strict=True)]
    return list(np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, len(sides)))


@pytest.mark.parametrize("name", ROBOTS)
@given(data=st.data())
def test_every_posture_comes_back_from_its_pulses(name: str, data: st.DataObject) -> None:
    robot = load(name)
    actuators = actuators_of(robot)
    q = robot.lower + data.draw(parts(len(robot.lower))) * (robot.upper - robot.lower)
    if margin(actuators, q) < -1e-6:
        with pytest.raises(HelicoideError):
            actuators.from_joints(q)
    else:
        assume(margin(actuators, q) > 1e-3)  # a triangle that is all but flat hardly moves its screw
        np.testing.assert_allclose(actuators.to_joints(actuators.from_joints(q)), q, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "refused"), [("movemaster", {}), ("orca", {}), ("motoman_l3", {"over_the_back": "A3"})]
)
def test_the_named_postures_are_held_but_for_those_beyond_a_screw(name: str, refused: dict[str, str]) -> None:
    robot = load(name)
    actuators = actuators_of(robot)
    for pose, q in robot.poses.items():
        if pose in refused:
            with pytest.raises(HelicoideError, match=refused[pose]):
                actuators.from_joints(q)
        else:
            np.testing.assert_allclose(actuators.to_joints(actuators.from_joints(q)), q, rtol=0, atol=1e-9)


@given(part=parts(5))
def test_pulses_come_back_from_the_posture_they_make(part: Array) -> None:
    """Relative to the actuator's range, without the last thousandth, where a flat triangle hardly moves the screw."""
    actuators = actuators_of(load("motoman_l3"))
    low, high = np.array([np.sort(drive.pulses(np.clip(drive.angles, -10, 10))) for drive in actuators.drives]).T
    pulses = low + (0.001 + 0.998 * part) * (high - low)
    back = actuators.from_joints(actuators.to_joints(pulses))
    np.testing.assert_allclose((back - pulses) / (high - low), 0, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "pulses"), [("movemaster", [185, 228, 186, 155, 116]), ("orca", [200, 290, 148])], ids=["tab4", "tab1"]
)
def test_a_driven_degree_is_the_pulses_of_the_table(name: str, pulses: list[float]) -> None:
    actuators = actuators_of(load(name))
    q = actuators.inverse_coupling @ np.radians(np.ones(len(pulses)))
    np.testing.assert_allclose(actuators.from_joints(q), pulses, rtol=0, atol=1e-9)


def test_the_movemaster_is_sent_what_the_pitch_leaves_of_the_roll(robot: Robot) -> None:
    """Cerbaro 2022, fig. 20: 45° and 60° are sent as 45° and 15°, and the pitch is added to what is read back."""
    actuators = actuators_of(robot)
    pulses = actuators.from_joints(np.radians([0, 0, 0, 45, 60]))
    np.testing.assert_allclose(pulses, [0, 0, 0, 6975, 1740], rtol=0, atol=1e-9)
    np.testing.assert_allclose(np.degrees(actuators.to_joints([0, 0, 0, 155 * 20, 116 * 30]))[3:], [20, 50], atol=1e-12)
    assert actuators.labels[3:] == ("A4 (J4)", "A5 (− J4 + J5)")


def turned(actuator: int, pulses: float) -> list[Array]:
    """How far each link of the Motoman L-3 turns, as rotations (3, 3), when one of its actuators alone counts on."""
    robot = load("motoman_l3")
    before = robot.poses["ready"]
    counted = actuators_of(robot).from_joints(before)
    counted[actuator - 1] += pulses
    after = actuators_of(robot).to_joints(counted)
    links = zip(screw_displacements(robot, before), screw_displacements(robot, after), strict=True)
    return [(now @ np.linalg.inv(then))[:3, :3] for then, now in links]


@given(pulses=st.floats(500, 5000))
def test_turning_actuator_2_keeps_the_direction_of_the_forearm(pulses: float) -> None:
    """Campos 1998, s.55: the screws are held by the base, so that they set directions, not angles between links."""
    links = turned(2, pulses)
    assert np.abs(links[2] - np.eye(3)).max() > 1e-3
    np.testing.assert_allclose(links[3:], [np.eye(3)] * 3, rtol=0, atol=1e-9)


@given(pulses=st.floats(500, 5000))
def test_turning_actuator_3_keeps_the_directions_of_upper_arm_and_wrist(pulses: float) -> None:
    links = turned(3, pulses)
    assert np.abs(links[3] - np.eye(3)).max() > 1e-3
    np.testing.assert_allclose([links[i] for i in (1, 2, 4, 5)], [np.eye(3)] * 4, rtol=0, atol=1e-9)


@given(a=st.floats(0.05, 1), b=st.floats(0.05, 1), opening=st.floats(0.01, math.pi - 0.01), zero=st.floats(-3, 3))
def test_the_screw_is_the_third_side_of_the_triangle(a: float, b: float, opening: float, zero: float) -> None:
    screw = BallScrew((a, b), -1000.0, 0.3, zero)
    length = math.dist((a, 0), (b * math.cos(opening), b * math.sin(opening)))
    pulses = screw.pulses(zero + opening)
    np.testing.assert_allclose(0.3 - pulses / 1000, length, rtol=0, atol=1e-12)
    np.testing.assert_allclose(screw.angle(pulses), zero + opening, rtol=0, atol=1e-9)


@given(a=st.floats(0.05, 1), b=st.floats(0.05, 1))
@example(a=0.3, b=0.3)
def test_both_ends_of_a_screw_are_held_and_read(a: float, b: float) -> None:
    actuators = Actuators(("J1",), np.eye(1), (BallScrew((a, b), 1e5, 0.5, -1.0),))
    for end in (-1.0, -1.0 + math.pi):
        assert actuators.to_joints(actuators.from_joints([end])) == pytest.approx([end], abs=1e-5)


TWO = Actuators(("J1", "J2"), np.array([[1, 0], [1, 1]]), (Gear(1, 0), BallScrew((0.4, 0.3), 1e4, 0.5, 0)))


@pytest.mark.parametrize(
    ("there", "values", "valid"),
    [
        (TWO.from_joints, [0.5, -0.51], ("0°", "180°")),
        (TWO.from_joints, [0.5, math.pi - 0.49], ("0°", "180°")),
        (TWO.to_joints, [0.5, -4001], ("-4000", "2000")),
        (TWO.to_joints, [0.5, 2001], ("-4000", "2000")),
        (TWO.to_joints, [[0.5, 0], [0.5, 9999]], ("-4000", "2000", "9999")),
    ],
)
def test_a_screw_that_cannot_close_its_triangle_says_how_far_it_goes(
    there: Callable[[ArrayLike], Array], values: ArrayLike, valid: tuple[str, ...]
) -> None:
    with pytest.raises(HelicoideError) as caught:
        there(values)
    text = caught.value.text
    for words in (text.en, text.pt_BR):
        assert [word for word in ("A2 (J1 + J2)", *valid) if word not in words] == []
        assert "\n" not in words
    assert "ball screw" in text.en
    assert "fuso" in text.pt_BR


@pytest.mark.parametrize("values", [[0.0] * 4, [0.0] * 6, [0, 0, math.nan, 0, 0], [math.inf, 0, 0, 0, 0], 1.0])
def test_values_are_counted_and_finite(robot: Robot, values: list[float]) -> None:
    for there in (actuators_of(robot).from_joints, actuators_of(robot).to_joints):
        with pytest.raises(HelicoideError, match="5 finite values"):
            there(values)


@pytest.mark.parametrize("name", ROBOTS)
def test_many_postures_at_once_are_as_one_by_one(name: str) -> None:
    actuators = actuators_of(load(name))
    many = np.array([q for q in postures(name) if margin(actuators, q) > 0.1][:24]).reshape(2, 3, 4, -1)
    pulses = actuators.from_joints(many)
    one_by_one = [actuators.from_joints(q) for q in many.reshape(24, -1)]
    np.testing.assert_allclose(pulses.reshape(24, -1), one_by_one, rtol=1e-15, atol=1e-9)
    np.testing.assert_allclose(actuators.to_joints(pulses), many, rtol=0, atol=1e-9)
