"""`helicoide ik` as people run it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.kinematics.arms import arm
from tests.kinematics.urdfs import chain_of, write

from helicoide import __main__
from helicoide.geometry import euler, rotation
from helicoide.ik import methods
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.library import load_robot

APP = Path(__file__).parents[2] / "app"
EXAMPLE = ("--position", "0.4704294", "0.2716025", "0.3", "--quat", "0.683013", "0.5", "0.5", "-0.183013")


def printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    monkeypatch.setattr(sys, "argv", ["helicoide", "ik", *arguments])
    __main__.main()
    return capsys.readouterr().out


def answered(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    answer: dict[str, Any] = json.loads(printed(monkeypatch, capsys, *arguments, "--json"))
    return answer


def test_the_example_of_the_source_from_the_shell() -> None:
    """Cerbaro 2022, eqs. 4-6: the pose of (30, 60, -90, -30, 90)°."""
    environment = {**os.environ, "PYTHONPATH": str(APP), "LC_ALL": "C.UTF-8"}
    command = [sys.executable, "-m", "helicoide", "ik", "movemaster", *EXAMPLE, "--all", "--json"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    postures = [np.degrees(branch["q"]) for branch in json.loads(done.stdout)["branches"]]
    assert any(q == pytest.approx([30, 60, -90, -30, 90], abs=1e-3) for q in postures)


def is_text(value: Any) -> bool:
    return set(value) == {"en", "pt_BR"} and all(isinstance(words, str) for words in value.values())


def test_the_json_has_its_keys_and_the_numbers_lead_to_the_goal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    goal = ("--position", "0.4", "0.2", "0.3", "--rpy", "3.0", "0.1", "-0.2")
    answer = answered(monkeypatch, capsys, "puma560", *goal, "--all")
    keys = {"robot", "joints", "goal", "solved", "moved", "turned", "reached", "short", "status", "words", "branches"}
    keys |= {"base", "tip", "remarks", "solvability"}
    assert set(answer) == keys
    assert answer["reached"] is True
    assert answer["robot"] == "puma560"
    assert answer["joints"] == [joint.name for joint in arm("puma560").variables]
    assert answer["goal"]["position"] == [0.4, 0.2, 0.3]
    assert answer["solved"]["quaternion_wxyz"] == pytest.approx(answer["goal"]["quaternion_wxyz"])
    assert is_text(answer["status"])
    assert is_text(answer["words"])
    assert answer["status"] == {"en": "reached", "pt_BR": "alcançado"}
    assert answer["solvability"]["closed"] is True
    assert answer["solvability"]["axes"] == [4, 5, 6]
    assert len(answer["branches"]) == 8
    R = euler.euler_matrix([3.0, 0.1, -0.2], "extrinsic xyz")
    np.testing.assert_allclose(rotation.to_matrix(np.array(answer["goal"]["quaternion_wxyz"])), R, atol=1e-12)
    for branch in answer["branches"]:
        assert set(branch) == {"name", "q", "missed", "turned", "within", "cost", "dropped", "screws"}
        assert (branch["dropped"] is None) == branch["within"]
        assert is_text(branch["name"])
        T = tool_at(arm("puma560"), np.array(branch["q"]))
        np.testing.assert_allclose(T[:3, 3], [0.4, 0.2, 0.3], atol=1e-9)
        np.testing.assert_allclose(T[:3, :3], R, atol=1e-9)
        assert branch["within"] in (True, False)


def test_without_an_orientation_the_position_counts_alone(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answer = answered(monkeypatch, capsys, "puma560", "--position", "0.4", "0.2", "0.3")
    assert answer["goal"]["quaternion_wxyz"] is None
    assert len(answer["branches"]) == 1
    branch = answer["branches"][0]
    assert tool_at(arm("puma560"), np.array(branch["q"]))[:3, 3] == pytest.approx([0.4, 0.2, 0.3], abs=1.1e-6)
    assert branch["turned"] < 1e-12
    assert branch["within"]


def test_the_posture_nearest_to_where_the_arm_is_comes_alone(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    goal = ("puma560", "--position", "0.4", "0.2", "0.3", "--rpy", "3.0", "0.1", "-0.2")
    kept = [one for one in answered(monkeypatch, capsys, *goal, "--all")["branches"] if one["within"]]
    assert len(kept) >= 2
    for one in kept:
        there = [f"{value:.9f}" for value in one["q"]]
        found = answered(monkeypatch, capsys, *goal, "--from", *there)["branches"]
        assert len(found) == 1
        assert found[0]["q"] == pytest.approx(one["q"], abs=1e-6)


def test_degrees_are_read_and_printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    q = [10.0, -80.0, 20.0, 30.0, 50.0, -40.0]
    T = tool_at(arm("puma560"), np.radians(q))
    place = [f"{value:.12f}" for value in T[:3, 3]]
    rpy = [f"{value:.12f}" for value in np.degrees(euler.euler_angles(T[:3, :3], "extrinsic xyz").values)]
    goal = ("puma560", "--position", *place, "--rpy", *rpy, "--deg", "--from", *map(str, q))
    out = printed(monkeypatch, capsys, *goal)
    assert "reached" in out.splitlines()[0]
    assert "J1 10.00000°, J2 -80.00000°, J3 20.00000°, J4 30.00000°, J5 50.00000°, J6 -40.00000°" in out
    assert "0.0000 mm and 0.0000° from the target; within the joint limits" in out
    assert answered(monkeypatch, capsys, *goal)["branches"][0]["q"] == pytest.approx(np.radians(q), abs=1e-6)


def test_a_slide_is_printed_in_metres(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    robot = arm("scara")
    x, y, z = (f"{value:.12f}" for value in tool_at(robot, robot.poses["ready"])[:3, 3])
    out = printed(monkeypatch, capsys, "scara", "--position", x, y, z, "--deg")
    assert "J3 0.0700000 m" in out


@pytest.mark.parametrize("method", ["numeric", "puma560", *methods.names()])
def test_a_method_by_its_name(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], method: str) -> None:
    T = tool_at(arm("puma560"), arm("puma560").poses["ready"] + 0.1)
    place, quat = ([f"{x:.12f}" for x in values] for values in (T[:3, 3], rotation.from_matrix(T[:3, :3])))
    goal = ("puma560", "--position", *place, "--quat", *quat, "--method", method)
    answer = answered(monkeypatch, capsys, *goal)
    assert answer["status"]["en"] == "reached"
    np.testing.assert_allclose(tool_at(arm("puma560"), np.array(answer["branches"][0]["q"])), T, atol=2e-5)


def test_infinitely_many_postures_are_said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    goal = ("panda", "--position", "0.4", "0.2", "0.3", "--quat", "0", "1", "0", "0", "--all")
    assert "infinitely many" in printed(monkeypatch, capsys, *goal)


BEYOND = ("puma560", "--position", "0.4", "0.2", "0.3", "--rpy", "3.0", "0.1", "-0.2", "--method", "pseudoinverse")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("puma560", "--position", "9", "0", "0"), "out of reach by 8"),
        (("puma560", "--position", "9", "0", "0", "--all"), "out of reach by 8"),
        (("movemaster", "--position", "0.5", "0.1", "0.3", "--quat", "1", "0", "0", "0"), "projected by 11.310°"),
        ((*BEYOND, "--from", "-6", "-2", "3", "4", "3", "6"), "reached only outside the joint limits"),
    ],
)
def test_what_is_not_reached_is_said_and_ends_with_three(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], words: str
) -> None:
    outputs: list[str] = []
    for form in ((), ("--json",)):
        with pytest.raises(SystemExit) as caught:
            printed(monkeypatch, capsys, *arguments, *form)
        out, err = capsys.readouterr()
        assert (caught.value.code, err) == (3, "")
        outputs.append(out)
    answer = json.loads(outputs[1])
    assert words in outputs[0]
    assert words in answer["status"]["en"]
    assert answer["reached"] is False


def test_the_answer_is_there_in_portuguese(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    out = printed(monkeypatch, capsys, "puma560", "--position", "0.4", "0.2", "0.3")
    for words in ("alcançado", "postura 1:", "do alvo; dentro dos limites das juntas"):
        assert words in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["puma560", "--position", "0.4", "0.2"], ["--position", "3 finite numbers", "0.4, 0.2"]),
        (["puma560", "--position", "0.4", "0.2", "nan"], ["--position", "3 finite numbers"]),
        (["puma560", "--position", "inf", "0.2", "0"], ["--position", "3 finite numbers"]),
        (["puma560", "--position", "0.4", "0", "0.3", "--quat", "0", "0", "0", "0"], ["--quat", "zero"]),
        (["puma560", "--position", "0.4", "0", "0.3", "--quat", "1", "0", "0"], ["--quat", "4 finite numbers"]),
        (["puma560", "--position", "0.4", "0", "0.3", "--quat", "1", "nan", "0", "0"], ["--quat", "4 finite numbers"]),
        (["puma560", "--position", "0.4", "0", "0.3", "--rpy", "1", "0"], ["--rpy", "3 finite numbers"]),
        (
            ["puma560", "--position", "0.4", "0", "0.3", "--rpy", "1", "0", "0", "--quat", "1", "0", "0", "0"],
            ["--quat or --rpy"],
        ),
        (["puma560", "--position", "0.4", "0", "0.3", "--from", "1", "2"], ["6 finite joint values"]),
        (["puma560", "--position", "0.4", "0", "0.3", "--method", "magic"], ["'magic'", "numeric", "puma560"]),
        (
            ["panda", "--position", "0.4", "0", "0.3", "--quat", "1", "0", "0", "0", "--method", "puma560"],
            ["puma560 does not apply", "numeric", "pseudoinverse"],
        ),
        (["planar2r", "--position", "1", "0", "0", "--weights", "1", "2", "3"], ["2 finite numbers", "1, 2, 3"]),
        (["planar2r", "--position", "1", "0", "0", "--obstacle", "1", "2", "3"], ["--obstacle", "4 finite numbers"]),
        (["planar2r", "--position", "1", "0", "0", "--obstacle", "1", "2", "3", "0"], ["--obstacle", "positive"]),
        (["puma", "--position", "0.4", "0", "0.3"], ["'puma'", "movemaster"]),
        (["{arm}", "--tip", "nowhere", "--position", "0.4", "0", "0.3"], ["{arm}", "'nowhere'"]),
        (["planar2r", "--set", "l1=abc", "--position", "1", "0", "0"], ["l1=abc"]),
    ],
)
def test_wrong_input_ends_in_one_line(
    tmp_path: Path, refused: Callable[..., str], arguments: list[str], words: list[str]
) -> None:
    path = str(write(tmp_path))
    said = refused("ik", *(argument.format(arm=path) for argument in arguments))
    assert [word for word in words if word.format(arm=path) not in said] == []


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        ("puma560", "Closed form: axes 4, 5, 6 intersect at a point (Pieper). At most 8 postures"),
        ("movemaster", "Closed form: axes 2, 3, 4 are parallel"),
        ("planar2r", "Closed form: with 2 joints"),
        ("panda", "Numerically only: 7 joints have infinitely many postures"),
    ],
)
def test_piepers_verdict_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], robot: str, words: str
) -> None:
    place = [f"{x:.9f}" for x in tool_at(load_robot(robot), load_robot(robot).poses["ready"])[:3, 3]]
    assert printed(monkeypatch, capsys, robot, "--position", *place).splitlines()[2].strip().startswith(words)


# Campos 1998, s.17: the third axis at (−0.7, −1.1) m, the hand towards −1.4 rad, of links of 1, 0.7 and 0.2 m
CHOICE = ("planar3r", "--set", "l1=1000", "l2=700", "l3=200", "--from", "0.5", "0.2", "-1", "--rpy", "0", "0", "-1.4")
CHOICE = (*CHOICE, "--position", "-0.6660066", "-1.2970899", "0")
UP, DOWN = [-1.57798, -1.42023, 1.59821], [3.58611, 1.42023, -0.12316]


@pytest.mark.parametrize(
    ("asked", "q", "cost"),
    [
        (["--weights", "1", "1", "1"], DOWN, 5.183),
        (["--weights", "3", "2", "1"], UP, 12.073),
        (["--weights", "3", "2", "1", "--obstacle", "0", "-1", "0", "0.1"], DOWN, 12.576),
        (["--obstacle", "0.05", "1.2", "0", "0.1"], DOWN, 5.183),
        (["--obstacle", "-0.9", "-0.4", "0", "0.1"], UP, 6.296),
    ],
)
def test_the_choice_follows_weights_and_obstacle(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], asked: list[str], q: list[float], cost: float
) -> None:
    (branch,) = answered(monkeypatch, capsys, *CHOICE, *asked)["branches"]
    assert branch["q"] == pytest.approx(q, abs=2e-5)
    assert branch["cost"] == pytest.approx(cost, abs=6e-4)
    assert f"cost {cost:.3f}" in printed(monkeypatch, capsys, *CHOICE, *asked)


def test_what_an_obstacle_rules_out_is_shown_among_all_and_ends_with_three_where_none_is_left(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = printed(monkeypatch, capsys, *CHOICE, "--all", "--obstacle", "0", "-1", "0", "0.1")
    assert out.splitlines()[-1].endswith("ruled out: touches an obstacle")
    with pytest.raises(SystemExit) as caught:
        printed(monkeypatch, capsys, *CHOICE, "--obstacle", "-0.6", "-1.2", "0", "0.3")
    assert caught.value.code == 3
    assert "every posture found touches the obstacle" in capsys.readouterr().out


def test_the_screws_of_the_l3_are_shown(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    robot = load_robot("motoman_l3")
    T = tool_at(robot, robot.poses["ready"])
    place, quat = ([f"{x:.12f}" for x in values] for values in (T[:3, 3], rotation.from_matrix(T[:3, :3])))
    goal = ("motoman_l3", "--position", *place, "--quat", *quat)
    assert "A2 (J2) -8504 pulses, screw 239.5 mm long" in printed(monkeypatch, capsys, *goal)
    (branch,) = answered(monkeypatch, capsys, *goal)["branches"]
    assert branch["screws"] == [None, pytest.approx(0.23948, abs=1e-5), pytest.approx(0.36242, abs=1e-5), None, None]
    out = printed(monkeypatch, capsys, *goal, "--weights", "1", "1", "1", "1", "1")
    assert "pulses" in out


def test_lengths_and_tips_are_set(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    goal = ("planar2r", "--set", "l1=1500", "l2=250", "--position", "1.75", "0", "0")
    assert answered(monkeypatch, capsys, *goal)["branches"][0]["q"] == pytest.approx([0, 0], abs=3e-3)
    answer = answered(monkeypatch, capsys, str(write(tmp_path)), "--tip", "lower", "--position", "0.3", "0", "0.3")
    assert answer["joints"] == ["one", "two"]


def test_what_only_turns_is_driven_by_orientation(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A turntable whose tool does not move away from its axis."""
    text = chain_of(["base", "plate"]).replace('xyz="0.1 0 0"', 'xyz="0 0 0.3"')
    (path := tmp_path / "plate.urdf").write_text(f'<robot name="plate">{text}</robot>', "utf-8")
    answer = answered(monkeypatch, capsys, str(path), "--position", "0", "0", "0.3", "--rpy", "0", "0", "0.7")
    assert answer["reached"]
    assert answer["branches"][0]["q"] == pytest.approx([0.7], abs=1e-6)
