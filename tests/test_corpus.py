"""The benchmark on other projects' URDF files distinguishes right answers from wrong ones."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yourdfpy
from tests.benchmarks.corpus import is_right, report
from tests.benchmarks.corpus_findings import reason_of, words_of
from tests.benchmarks.corpus_look import POSES, look
from tests.benchmarks.corpus_tree import Tree
from tests.kinematics.urdfs import write

from helicoide.arrays import Array
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.solve import solve
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

AMPLE = 600.0


def lying(robot: Robot, T: Array, q: Array) -> Answer:
    """A wrong solver: it returns the current posture as an exact answer."""
    answer = solve(robot, T, q)
    rows = answer.rows[:1].copy()
    rows[:, : len(q)] = q
    return replace(answer, rows=rows)


def failing(robot: Robot, T: Array, q: Array) -> Answer:
    raise ZeroDivisionError("no length")


def lasting(robot: Robot, T: Array, q: Array) -> Answer:
    while True:
        solve(robot, T, q)


def refusal(path: Path) -> str:
    with pytest.raises(HelicoideError) as caught:
        load_robot(str(path))
    return reason_of(words_of(caught.value))


def test_our_own_reading_is_that_of_the_parser(tmp_path: Path) -> None:
    path = write(tmp_path)
    tree, urdf = Tree.of(path), yourdfpy.URDF.load(str(path), build_scene_graph=True, load_meshes=False)
    assert tree.tips() == ["tool"]
    for q in np.random.default_rng(0).uniform(-1, 1, (5, 2)):
        urdf.update_cfg(values := dict(zip(("one", "two"), q.tolist(), strict=True)))
        np.testing.assert_allclose(tree.pose("tool", values), urdf.get_transform("tool"), atol=1e-12)
    assert tree.beyond("tool", {"one": 0.0, "two": 2.5}) == 0.5


def test_our_own_reading_takes_what_others_write(tmp_path: Path) -> None:
    """Undeclared prefixes, an XML declaration that is not at the start, commas between numbers."""
    plain = Tree.of(path := write(tmp_path))
    text = "\n" + path.read_text("utf-8").replace('"0 1 0"', '"0, 1, 0"').replace("<limit ", '<limit drake:a="1" ')
    other = Tree(text.replace("</robot>", '<ros2:control name="a:b"><ros2:joint/></ros2:control></robot>'))
    values = {"one": 0.3, "two": 0.4}
    np.testing.assert_array_equal(other.pose("tool", values), plain.pose("tool", values))
    assert other.beyond("tool", {"one": 0.0, "two": 2.5}) == 0.5


def test_an_arm_that_answers_rightly_is_not_listed(tmp_path: Path) -> None:
    found = look(write(tmp_path), patience=AMPLE)
    assert (found.arms, found.asked, found.refusal) == (["tool"], POSES, "")
    assert [found.missed, found.false, found.faults, found.late] == [[], [], [], ""]
    assert found.worst[0] < 1e-12
    assert found.picture > 0


def test_what_is_falsely_said_to_be_reached_is_listed_loudly(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    report({"small: arm.urdf": look(write(tmp_path), lying, AMPLE)})
    said = capsys.readouterr().out
    assert f'FALSE "reached": {POSES}\n    small: arm.urdf: tool: reached; q = [' in said
    assert f'false "reached": {POSES}.00 · goal at most 0 · MISSED' in said


def test_an_exception_is_listed_with_its_last_line_and_stops_nothing(tmp_path: Path) -> None:
    found = look(write(tmp_path), failing, AMPLE)
    (fault,) = found.faults
    assert "ZeroDivisionError: no length (tests/test_corpus.py:" in fault
    assert found.picture > 0


def test_a_file_that_takes_too_long_is_left(tmp_path: Path) -> None:
    assert look(write(tmp_path), lasting, patience=0.5).late


def test_refusals_of_one_kind_are_one_reason(tmp_path: Path) -> None:
    one = write(tmp_path)
    (two := tmp_path / "two.urdf").write_text(one.read_text("utf-8").replace('"one"', '"another"'), "utf-8")
    for path in (one, two):
        path.write_text(path.read_text("utf-8").replace('upper="', 'upper="-9'), "utf-8")
    assert refusal(one) == refusal(two) == "the limits of joint … are # to #; lower must be below upper"


def test_an_arm_that_its_limits_hold_is_rightly_refused(tmp_path: Path) -> None:
    path = write(tmp_path)
    text = path.read_text("utf-8").replace('upper="1.5"', 'upper="-1.5"').replace('upper="2"', 'upper="-1"')
    path.write_text(text, "utf-8")
    found = look(path, patience=AMPLE)
    assert is_right(found.refusal)
    path.write_text(text.replace("revolute", "continuous"), "utf-8")
    assert look(path, patience=AMPLE).arms == ["tool"]


def test_an_object_is_rightly_refused(tmp_path: Path) -> None:
    (path := tmp_path / "cup.urdf").write_text('<robot name="cup"><link name="cup"/></robot>', "utf-8")
    found = look(path, patience=AMPLE)
    assert found.refusal
    assert is_right(found.refusal)
