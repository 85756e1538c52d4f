"""`helicoide robots` tells of every robot in a folder, and its roads agree."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.kinematics.urdfs import write

from helicoide import __main__, content
from helicoide.commands.robots import POSTURES
from helicoide.kinematics.library import load_robot, packaged_urdfs

APP = Path(__file__).parents[2] / "app"
FIELDS = {"name", "title", "source", "base", "tip", "remarks", "assumed", "reach", "disagreement", "planes", "joints"}


@pytest.fixture(scope="module")
def tables() -> list[dict[str, Any]]:
    environment = {**os.environ, "PYTHONPATH": str(APP), "LC_ALL": "C.UTF-8"}
    command = [sys.executable, "-m", "helicoide", "robots", "--json"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=True)
    assert done.stderr == ""
    found: list[dict[str, Any]] = json.loads(done.stdout)
    return found


def words(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    monkeypatch.setattr(sys, "argv", ["helicoide", "robots", *arguments])
    __main__.main()
    return capsys.readouterr().out


def test_every_robot_in_a_folder_is_told_of(tables: list[dict[str, Any]]) -> None:
    assert [table["name"] for table in tables] == sorted(content.content_folders("robots"))


def test_the_roads_of_every_robot_agree(tables: list[dict[str, Any]]) -> None:
    assert {table["name"]: table["disagreement"] for table in tables if not 0 <= table["disagreement"] <= 1e-9} == {}


def test_a_table_says_what_the_robot_is(tables: list[dict[str, Any]]) -> None:
    for table in tables:
        robot = load_robot(table["name"])
        assert set(table) == FIELDS
        assert (table["title"], table["source"]) == (robot.title.en, robot.source)
        assert table["assumed"] == list(robot.assumed)
        assert [joint["name"] for joint in table["joints"]] == [joint.name for joint in robot.variables]
        assert [joint["kind"] for joint in table["joints"]] == [joint.kind for joint in robot.variables]
        for key, values in (("lower", robot.lower), ("upper", robot.upper), ("speed", robot.speed)):
            np.testing.assert_array_equal([joint[key] for joint in table["joints"]], values)


def test_people_read_joints_limits_source_and_agreement(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    said = words(monkeypatch, capsys, "scara", "movemaster")
    first, links, joints, source, agreement, *rest = said.splitlines()
    assert first.startswith("scara: ")
    assert "4 joints" in first
    assert f"from link {load_robot('scara').base_link} to link {load_robot('scara').tool_link}" in links
    assert [load_robot("scara").joints[i].name in joints for i in range(4)] == [True] * 4
    assert "°" in joints
    assert " mm" in joints
    assert load_robot("scara").source in source
    assert f"over {POSTURES} random postures" in agreement
    assert rest[0].startswith("movemaster: ")
    assert "printed −y: 0.0577 e₁" in rest[6]
    assert len(rest) == 9


def test_the_whole_list_ends_with_the_names_of_packages(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        content, "content_folders", lambda kind: {"movemaster": content.SHIPPED / "robots" / "movemaster"}
    )
    last = words(monkeypatch, capsys).splitlines()[-1]
    assert [name for name in packaged_urdfs() if name not in last] == []


def test_a_urdf_is_told_of_by_its_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    [table] = json.loads(words(monkeypatch, capsys, str(write(tmp_path)), "--json"))
    assert (table["name"], table["source"]) == ("arm", "arm.urdf: tool")
    assert [joint["kind"] for joint in table["joints"]] == ["revolute", "prismatic"]
    assert table["disagreement"] <= 1e-9


def test_an_unknown_robot_is_one_line(refused: Callable[..., str]) -> None:
    assert re.search(r"'nobody'.*movemaster", refused("robots", "nobody"))


def test_tip_and_base_may_be_chosen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = str(write(tmp_path))
    [table] = json.loads(words(monkeypatch, capsys, path, "--tip", "lower", "--base", "upper", "--json"))
    assert (table["base"], table["tip"], table["remarks"]) == ("upper", "lower", [])
    assert [joint["name"] for joint in table["joints"]] == ["two"]
    [table] = json.loads(words(monkeypatch, capsys, path, "--json"))
    assert (table["base"], table["tip"]) == ("base", "tool")


def test_a_range_that_is_ours_is_marked_and_said_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = str(write(tmp_path, 'lower="-1" upper="2" ', ""))
    monkeypatch.setattr(sys, "argv", ["helicoide", "robots", path])
    __main__.main()
    out, err = capsys.readouterr()
    assert "two -10000…10000 mm (assumed)" in out
    assert err.count("two -10…10 m") == 1
    [table] = json.loads(words(monkeypatch, capsys, path, "--json"))
    assert [joint["assumed"] for joint in table["joints"]] == [False, True]
    assert set(table["remarks"][0]) == {"en", "pt_BR"}
    assert table["assumed"] == ["limits"]


@pytest.mark.parametrize(("spoken", "said"), [("C.UTF-8", "cannot be read"), ("pt_BR.UTF-8", "não dá para ler")])
def test_a_mesh_that_cannot_be_drawn_is_said_once(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
    spoken: str,
    said: str,
) -> None:
    visual = '<visual><geometry><mesh filename="upper.glb"/></geometry></visual>'
    path = write(tmp_path, '<link name="upper"/>', f'<link name="upper">{visual}</link>')
    (tmp_path / "upper.glb").write_bytes(b"nothing")
    monkeypatch.setenv("LC_ALL", spoken)
    monkeypatch.setattr(sys, "argv", ["helicoide", "robots", str(path)])
    __main__.main()
    [line] = capfd.readouterr().err.splitlines()
    assert "upper.glb" in line
    assert said in line
