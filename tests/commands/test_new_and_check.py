"""A contribution begun and checked from the command line: what is printed, and how it ends."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from helicoide import __main__, content

Refused = Callable[..., str]


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    return tmp_path


def ran(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    """The code with which a command ends."""
    monkeypatch.setattr(sys, "argv", ["helicoide", *arguments])
    try:
        __main__.main()
    except SystemExit as end:
        return int(end.code or 0)
    return 0


def test_a_robot_is_written_checked_and_broken(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = home / "robots" / "my_arm" / "robot.toml"
    assert ran(monkeypatch, "new", "robot", "my_arm", "--user") == 0
    *paths, last = capsys.readouterr().out.splitlines()
    assert set(paths) == {str(path) for path in file.parent.iterdir()}
    assert last.endswith("helicoide check my_arm")
    assert ran(monkeypatch, "check", "my_arm") == 0
    assert capsys.readouterr().out == "robot my_arm: no faults\n"
    file.write_text(file.read_text("utf-8").replace("joints = [20, 60]", "joints = [20, 160]"), "utf-8")
    assert ran(monkeypatch, "check", "my_arm") == 3
    assert capsys.readouterr().out == "robot my_arm:\n   pose ready is outside the limits of: J2\n"
    monkeypatch.setenv("LC_ALL", "pt_BR.UTF-8")
    assert ran(monkeypatch, "check", "my_arm") == 3
    assert "a postura ready sai dos limites de: J2" in capsys.readouterr().out


def test_a_name_that_nothing_has_is_refused_with_all_there_are(refused: Refused) -> None:
    line = refused("check", "nobody")
    assert "no robot, lesson, method or study named 'nobody'" in line
    assert [name for name in ("scara", "drive_the_arm", "damped", "vargas_01") if name not in line] == []


def test_a_name_that_is_taken_or_none_is_refused(refused: Refused, home: Path) -> None:
    assert "already a robot named scara" in refused("new", "robot", "scara", "--user")
    assert "small letters" in refused("new", "study", "My-Study", "--user")
    assert list(home.iterdir()) == []
