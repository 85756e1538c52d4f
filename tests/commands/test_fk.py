"""`helicoide fk` as people run it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.kinematics.urdfs import MISTAKES, write

from helicoide import __main__
from helicoide.kinematics.library import load_robot

APP = Path(__file__).parents[2] / "app"


def fk(*arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(APP), "LC_ALL": "C.UTF-8"}
    command = [sys.executable, "-m", "helicoide", "fk", *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)


def test_the_example_of_the_source_by_all_roads() -> None:
    """Cerbaro 2022, eqs. 4-6: (470.429, 271.602, 300.000) mm; more digits recomputed."""
    done = fk("movemaster", "--q", "30", "60", "-90", "-30", "90", "--deg", "--json")
    assert done.returncode == 0, done.stderr
    roads = json.loads(done.stdout)["roads"]
    assert set(roads) == {"dh", "screws", "dual_quaternions"}
    for pose in roads.values():
        assert pose["position"] == pytest.approx([0.4704294, 0.2716025, 0.3000000], abs=5e-8)
        assert pose["matrix"][0][:3] == pytest.approx([0.4330, 0.75, 0.5], abs=5.1e-5)
        assert pose["quaternion_wxyz"] == pytest.approx([0.683013, 0.5, 0.5, -0.183013], abs=6e-7)
        assert pose["motor"]["e1e"] == pytest.approx(0.060801270, abs=1e-9)


def test_a_pose_says_of_what_and_in_what_frame_it_is(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    example = ("--q", "30", "60", "-90", "-30", "90", "--deg", "--json")
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", "movemaster", *example])
    __main__.main()
    told = json.loads(capsys.readouterr().out)
    assert {(pose["frame"], pose["in"]) for pose in told["roads"].values()} == {("tool", "base_link")}
    assert [motor["pulses"] for motor in told["motors"]] == pytest.approx([5550, 13680, -16740, -4650, 13920])
    assert told["motors"][4]["motor"] == "A5 (− J4 + J5)"
    assert "frames" not in told


@pytest.mark.parametrize(("units", "scale"), [(["--as", "source"], 1.0), ([], 1e-3)])
@pytest.mark.parametrize(
    ("kind", "ends", "says"),
    [("dh", [470.429, 271.603, 300.0], "DH frame"), ("screws", [-84.641, 413.013, 1010.141], "displacement")],
)
def test_the_matrices_of_the_source_in_its_units_and_in_ours(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    units: list[str],
    scale: float,
    kind: str,
    ends: list[float],
    says: str,
) -> None:
    """Cerbaro 2022, eqs. 4 and 8."""
    asked = ["movemaster", "--q", "30", "60", "-90", "-30", "90", "--deg", "--frames", kind, *units]
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *asked, "--json"])
    __main__.main()
    frames = json.loads(capsys.readouterr().out)["frames"]
    assert says in frames["partial"]
    assert [row[3] for row in frames["joints"][-1]["partial"][:3]] == pytest.approx(
        [scale * value for value in ends], abs=6e-4 * scale
    )
    assert frames["position"] == pytest.approx([scale * value for value in (470.429, 271.603, 300)], abs=6e-4 * scale)


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("dh", ["J5: θ = 90.000, α = 0.000, d = 250.000", "-0.866 ", "470.429", "-60.000, 0.000, -150.000"]),
        (
            "screws",
            ["s = (0.000, -1.000, 0.000)", "1010.141", "The end effector, at 820.000, 0.000, 400.000 for q = 0"],
        ),
        ("products", ["ε", "0.683", "10.341", "220.556"]),
    ],
)
def test_joint_by_joint_in_words(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], kind: str, words: list[str]
) -> None:
    asked = ["movemaster", "--q", "30", "60", "-90", "-30", "90", "--deg", "--frames", kind, "--as", "source"]
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *asked])
    __main__.main()
    said = capsys.readouterr().out
    assert [word for word in words if word not in said] == []
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    __main__.main()
    assert "470,429; 271,603; 300,000" in capsys.readouterr().out


def test_the_kind_of_singularity_is_named(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    asked = ["puma560", "--deg", "--q", "0", "90", "-87", "0", "1", "0"]
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *asked])
    __main__.main()
    said = capsys.readouterr().out
    assert all(word in said for word in ("singularity: shoulder: ", "; elbow: ", "; wrist: "))
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *asked, "--json"])
    __main__.main()
    told = json.loads(capsys.readouterr().out)["singularity"]
    assert (told["rank"], told["usual"]) == (6, 6)
    assert told["factors"]["wrist"] == pytest.approx(np.sin(np.radians(1)))
    assert told["words"]["pt_BR"].startswith("ombro: ")


def test_a_motor_that_cannot_hold_its_angle_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", "motoman_l3", "--deg", "--q", "0", "170", "0", "0", "0"])
    __main__.main()
    assert "ball screw" in capsys.readouterr().out


def test_wrong_input_ends_in_one_line_without_a_traceback(tmp_path: Path) -> None:
    path = write(tmp_path, 'velocity="0.5"/>', 'velocity="0.5"/><mimic joint="three"/>')
    done = fk(str(path), "--q", "0", "0")
    assert done.returncode == 2
    assert done.stdout == ""
    assert len(done.stderr.splitlines()) == 1
    assert str(path) in done.stderr
    assert "'three'" in done.stderr


@pytest.mark.parametrize("arguments", [["movemaster", "--q", "one"], ["movemaster"]])
def test_what_cannot_be_read_ends_without_a_traceback(arguments: list[str]) -> None:
    done = fk(*arguments)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr


def test_the_words_for_people_carry_the_same_numbers(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    turns = ("0.5235987755982988", "1.0471975511965976", "-1.5707963267948966", "-0.5235987755982988")
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", "movemaster", "--q", *turns, "1.5707963267948966"])
    __main__.main()
    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == ["movemaster:", f"   from link {load_robot('movemaster').base_link} to link tool"]
    assert all("0.4704294, 0.2716025, 0.3000000 m" in line for line in lines[2:5])
    assert len(lines) == 5 + 1 + 1 + 5
    assert lines[-1].split() == ["A5", "(−", "J4", "+", "J5):", "120°,", "13920", "pulses"]


def test_the_ball_screws_of_the_l3_have_lengths(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["helicoide", "fk", "motoman_l3", "--deg", "--q", "0", "-75", "80", "105", "0"]
    monkeypatch.setattr(sys, "argv", arguments)
    __main__.main()
    assert "A2 (J2): -75°, -8504.21 pulses, screw 239.5 mm long" in capsys.readouterr().out
    monkeypatch.setattr(sys, "argv", [*arguments, "--json"])
    __main__.main()
    screws = [motor["screw"] for motor in json.loads(capsys.readouterr().out)["motors"]]
    assert screws == [None, pytest.approx(0.23948, abs=1e-5), pytest.approx(0.36242, abs=1e-5), None, None]


@pytest.mark.parametrize("mistake", MISTAKES)
def test_every_mistake_in_a_urdf_ends_the_command_alike(
    tmp_path: Path, refused: Callable[..., str], caplog: pytest.LogCaptureFixture, mistake: str
) -> None:
    old, new, place = MISTAKES[mistake]
    said = refused("fk", str(write(tmp_path, old, new)), "--tip", "tool", "--q", "0", "0")
    assert [word for word in place if word not in said] == []
    assert caplog.records == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["movemaster", "--q", "1", "2", "3"], ["5 finite joint values"]),
        (["movemaster", "--q", *["0.1234567"] * 12], ["5 finite joint values"]),
        (["movemaster", "--q", "nan", "0", "0", "0", "0"], ["5 finite joint values"]),
        (["movemaster", "--q", "inf", "0", "0", "0", "0", "--deg"], ["5 finite joint values"]),
        (["puma", "--q", "0", "0", "0", "0", "0"], ["movemaster"]),
        (["../../etc", "--q", "0", "0", "0", "0", "0"], ["movemaster"]),
        (["{arm}", "--tip", "nowhere", "--q", "0", "0"], ["{arm}", "'nowhere'", "base, upper, lower, tool"]),
        (["{arm}", "--q", "0"], ["2 finite joint values", "one, two"]),
        (["{arm}", "--set", "l1=1", "--q", "0", "0"], ["--set"]),
        (["{arm}x.urdf", "--q", "0", "0"], ["{arm}x.urdf", "no such file"]),
        (["planar2r", "--tip", "tool", "--q", "0", "0"], ["--tip"]),
        (["planar2r", "--as", "source", "--q", "0", "0"], ["--frames dh, screws"]),
        (["planar2r", "--set", "l1=abc", "--q", "0", "0"], ["l1=abc", "l1=1500"]),
    ],
)
def test_options_that_do_not_fit_end_in_one_line(
    tmp_path: Path, refused: Callable[..., str], arguments: list[str], words: list[str]
) -> None:
    arm = str(write(tmp_path))
    said = refused("fk", *(argument.format(arm=arm) for argument in arguments))
    assert [word for word in words if word.format(arm=arm) not in said] == []


def printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> list[float]:
    """Where the tool is by the first road, m."""
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *arguments, "--json"])
    __main__.main()
    poses = list(json.loads(capsys.readouterr().out)["roads"].values())
    for pose in poses[1:]:
        assert pose["position"] == pytest.approx(poses[0]["position"], abs=1e-9)
    position: list[float] = poses[0]["position"]
    return position


def test_degrees_leave_a_slide_in_metres(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = str(write(tmp_path))
    in_degrees = printed(monkeypatch, capsys, arm, "--tip", "lower", "--q", "90", "0.5", "--deg")
    assert in_degrees == printed(monkeypatch, capsys, arm, "--tip", "lower", "--q", "1.5707963267948966", "0.5")
    assert in_degrees != printed(monkeypatch, capsys, arm, "--tip", "lower", "--q", "1.5707963267948966", "0")


def test_lengths_are_set_in_millimetres(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    straight = printed(monkeypatch, capsys, "planar2r", "--set", "l1=1500", "l2=250", "--q", "0", "0")
    assert straight == pytest.approx([1.75, 0, 0])


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["movemaster", "--deg", "--q", "0", "300", "-75", "-15", "0"], ["J2 is at 300°", "-30° … 100°"]),
        (["scara", "--q", "0", "-3", "0.5", "0"], ["J2 is at -3 rad", "-2.35619 rad", "J3 is at 0.5 m", "0 m … 0.2 m"]),
    ],
)
def test_joints_outside_their_limits_are_named_beside_the_pose(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], arguments: list[str], words: list[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", *arguments])
    __main__.main()
    out, err = capsys.readouterr()
    assert len(out.splitlines()) == (12 if arguments[0] == "movemaster" else 6)
    assert [word for word in words if word not in err] == []
    assert "is at" not in out
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    __main__.main()
    out, err = capsys.readouterr()
    assert "posição" in out
    assert "fora dos limites" in err


def test_json_lists_the_joints_that_are_outside(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = load_robot("scara")
    for values, expected in ((arm.upper, []), (arm.lower, []), (arm.upper + np.array([0, 0.1, 0, 0.1]), ["J2", "J4"])):
        monkeypatch.setattr(sys, "argv", ["helicoide", "fk", "scara", "--json", "--q", *map(str, values)])
        __main__.main()
        out, err = capsys.readouterr()
        outside = json.loads(out)["outside"]
        assert [one["joint"] for one in outside] == expected
        assert all(one["lower"] < one["upper"] < one["value"] for one in outside)
        assert err == ""


def test_what_of_a_file_is_ours_is_said_beside_the_pose(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = str(write(tmp_path, 'lower="-1" upper="2" ', ""))
    monkeypatch.setattr(sys, "argv", ["helicoide", "fk", path, "--tip", "lower", "--base", "upper", "--q", "0.5"])
    __main__.main()
    out, err = capsys.readouterr()
    assert "from link upper to link lower" in out
    assert err.count("assumed ranges") == 1
