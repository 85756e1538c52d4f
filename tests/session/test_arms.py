"""A robot whose files contradict each other says so as soon as it stands there."""

from __future__ import annotations

import shutil
from pathlib import Path

from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.session.arms import begun
from helicoide.state import initial_state


def test_a_sound_robot_has_no_notice() -> None:
    assert begun(load_robot("scara")).notice == initial_state(load_robot("scara")).notice is None


def test_a_contradiction_is_the_notice(tmp_path: Path) -> None:
    folder = Path(shutil.copytree(load_robot("scara").urdf.parent, tmp_path / "scara"))
    text = (folder / "robot.toml").read_text("utf-8")
    (folder / "robot.toml").write_text(text.replace('name = "J2"', 'name = "K2"', 1), "utf-8")
    notice = begun(robot_from_folder(folder)).notice
    assert notice is not None
    assert "no joint K2" in notice.en
    assert "não tem a junta K2" in notice.pt_BR
