"""What comes of a typed line: accepted, wrong at some characters, or refused like a line of the console."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.lines.exercises import EXERCISES, exercise, given

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.lines import Accepted, LineExercise, Refused, WrongTerm, check_line, line_faults
from helicoide.sheet import LONGEST_LINE
from helicoide.text import HelicoideError

ROTOR = EXERCISES["rotor about z"]
DOUBLE = LineExercise("motor", ROTOR.names, ROTOR.expected, sign_counts=False)


def wrong(task: LineExercise, text: str) -> WrongTerm:
    verdict = check_line(task, text)
    assert isinstance(verdict, WrongTerm), verdict
    return verdict


@pytest.mark.parametrize("task", EXERCISES.values(), ids=EXERCISES)
def test_the_exercises_have_no_faults(task: LineExercise) -> None:
    assert line_faults(task) == []


@pytest.mark.parametrize(
    ("text", "start", "says"),
    [
        ("", 0, "type an expression"),
        ("# nothing", 0, "type an expression"),
        ("cos(theta/2) +", 14, "ends too early"),
        ("cos(thet/2)", 4, "similar: theta"),
        ("cso(theta)", 0, "similar: cos"),
        ("pi = theta", 0, "already has a meaning"),
        ("1/(theta - theta)", 1, "division by zero"),
        ("cos(theta, 1)", 0, "cos(x)"),
        ("theta" + " " * LONGEST_LINE, LONGEST_LINE, "400"),
    ],
)
def test_a_line_is_refused_as_the_console_does(text: str, start: int, says: str) -> None:
    verdict = check_line(ROTOR, text)
    assert isinstance(verdict, Refused)
    assert verdict.error.start == start
    assert says in verdict.error.text.en
    assert verdict.error.text.pt_BR != verdict.error.text.en


def test_a_line_may_define_a_name_and_have_a_comment() -> None:
    assert check_line(ROTOR, "M = rotor(0, 0, 1, theta)  # half of it acts from each side") == Accepted()


def test_a_function_that_is_the_whole_answer_can_be_forbidden() -> None:
    task = LineExercise("motor", ROTOR.names, ROTOR.expected, without=("rotor", "exp"))
    assert check_line(task, ROTOR.expected) == Accepted()
    verdict = check_line(task, "1*rotor(0, 0, 1, theta)")
    assert isinstance(verdict, Refused)
    assert (verdict.error.start, verdict.error.end) == (2, 7)


def test_the_sign_of_a_motor_counts_unless_the_exercise_says_otherwise() -> None:
    negative = "-rotor(0, 0, 1, theta)"
    assert "same motion" in wrong(ROTOR, negative).title.en
    assert check_line(DOUBLE, negative) == Accepted()
    assert wrong(DOUBLE, "rotor(0, 0, 1, -theta)").slip == "sense"


def test_a_plane_may_have_any_size_but_not_the_other_side() -> None:
    plane = EXERCISES["plane of three points"]
    assert check_line(plane, "3*join(p, q, r)") == Accepted()
    assert "other side" in wrong(plane, "-3*join(p, q, r)").title.en
    assert isinstance(check_line(plane, "0*join(p, q, r)"), WrongTerm)


def test_a_distance_has_one_size() -> None:
    assert wrong(EXERCISES["distance from a plane"], "2*distance(p, A)").slip == "half"


@pytest.mark.parametrize(
    "text", ["cos(theta/2) + 1e+300*e1e2", "1e+200*rotor(0, 0, 1, theta)", "1e-300*e1e2", "0*e1e2"]
)
def test_very_large_and_small_values_are_wrong(text: str) -> None:
    assert isinstance(check_line(ROTOR, text), WrongTerm)


def test_what_does_not_depend_on_the_angle_is_wrong_even_where_it_fits_one_value() -> None:
    assert isinstance(check_line(ROTOR, "cos(0.3) + sin(0.3)*e1e2"), WrongTerm)


def test_a_rounded_number_is_named() -> None:
    quarter = exercise("motor", "", "rotor(0, 0, 1, pi/2)")
    verdict = wrong(quarter, "0.7071 + 0.7071*e1e2")
    assert (verdict.slip, verdict.span.start, verdict.span.end) == ("rounded", 0, 6)
    assert check_line(quarter, "sqrt(2)/2*(1 + e1e2)") == Accepted()


def test_a_name_of_no_use_is_a_slip_of_its_place_among_others() -> None:
    """The first of two wrong factors is named."""
    verdict = wrong(EXERCISES["successive screws"], "screw(L1, -q1)*screw(L2, q3)*screw(L3, q3)*M0")
    assert (verdict.slip, verdict.span.start, verdict.span.end) == ("sense", 10, 13)


def test_a_wrong_motion_is_shown_beside_the_right_one() -> None:
    at = {"theta": math.pi / 2}
    verdict = check_line(ROTOR, "cos(theta) + sin(theta)*e1e2", at)
    assert isinstance(verdict, WrongTerm)
    assert verdict.wrong_pose is not None
    assert verdict.right_pose is not None
    np.testing.assert_allclose(verdict.right_pose[:3, :3], [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-12)
    np.testing.assert_allclose(verdict.wrong_pose[:3, :3], np.diag([-1, -1, 1]), atol=1e-12)


def test_a_wrong_order_of_motors_is_shown_where_it_leads() -> None:
    task = EXERCISES["planar 2R"]
    at = {"q1": 0.3, "q2": 0.5, "a1": 0.4, "a2": 0.2}
    verdict = check_line(task, "translator(a1, 0, 0)*rotor(0, 0, 1, q1)*translator(a2, 0, 0)*rotor(0, 0, 1, q2)", at)
    assert isinstance(verdict, WrongTerm)
    product = CL031.product(rigid.translator((0.4, 0, 0)), rigid.rotor((0, 0, 1), 0.3))
    product = CL031.product(product, CL031.product(rigid.translator((0.2, 0, 0)), rigid.rotor((0, 0, 1), 0.5)))
    np.testing.assert_allclose(verdict.wrong_pose, rigid.pose_from_motor(product), atol=1e-12)


@pytest.mark.parametrize(
    ("name", "text"),
    [("rotate a vector", "conj(q)*v*q"), ("line of two points", "join(q, p)"), ("dx by dq1", "a1*sin(q1)")],
)
def test_what_is_no_motion_has_no_pose(name: str, text: str) -> None:
    verdict = wrong(EXERCISES[name], text)
    assert verdict.wrong_pose is None
    assert verdict.right_pose is None


def test_a_line_that_is_no_motion_has_no_pose_beside_the_right_one() -> None:
    for text in ("theta", "0*e1e2", "e1", "e1e"):
        verdict = wrong(ROTOR, text)
        assert verdict.wrong_pose is None
        assert verdict.right_pose is not None


def test_the_lines_of_an_exercise_use_the_names_of_those_before() -> None:
    task = LineExercise(
        "chain", given("angle: q1 q2; line: L1 L2; point: p"), "M2 >> p",
        steps=(("M1", "exp(q1/2*L1)"), ("M2", "M1*exp(q2/2*L2)")),
    )  # fmt: skip
    first, second, last = task.lines()
    assert line_faults(task) == []
    assert isinstance(check_line(first, "M1*exp(q1/2*L1)"), Refused)
    assert check_line(second, "M2 = M1*screw(L2, q2)") == Accepted()
    assert check_line(last, "M1*exp(q2/2*L2) >> p") == check_line(task, "M2 >> p") == Accepted()


@pytest.mark.parametrize(
    ("task", "says"),
    [
        (exercise("motor", "angle: i", "1"), "already has a meaning"),
        (exercise("motor", "angle: a", "b"), "no value"),
        (exercise("motor", "angle: a", "b = a"), "no expression"),
        (exercise("motor", "angle: a", "1 +"), "ends too early"),
        (exercise("motor", "g = a*b", "g"), "no value"),
    ],
)
def test_a_fault_of_an_exercise_is_said(task: LineExercise, says: str) -> None:
    (fault,) = line_faults(task)
    assert says in fault.en


def test_a_fault_of_the_exercise_is_not_said_of_the_line() -> None:
    with pytest.raises(HelicoideError):
        check_line(exercise("motor", "angle: a", "b"), "a")
