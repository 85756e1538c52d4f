"""Robots by name, by path and with settings; what cannot be loaded is said with what could be."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from dataclasses import replace
from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest
from tests.kinematics.urdfs import write

from helicoide import content
from helicoide.kinematics import library
from helicoide.kinematics.library import PACKAGES, load_robot, packaged_urdfs, register_robot, robot_names, robot_titles
from helicoide.text import HelicoideError, Text


def refused(robot: str, tip: str | None = None, settings: tuple[str, ...] = ()) -> Text:
    with pytest.raises(HelicoideError) as caught:
        load_robot(robot, tip, settings)
    text = caught.value.text
    assert text.en != text.pt_BR
    assert len(text.en.splitlines()) == len(text.pt_BR.splitlines()) == 1
    return text


def test_folders_come_before_packages_in_order() -> None:
    folders = sorted(content.content_folders("robots"))
    assert robot_names()[: len(folders)] == folders
    rest = robot_names()[len(folders) :]
    assert rest == sorted(rest)
    assert set(rest) == set(packaged_urdfs()) - set(folders)


def test_every_folder_has_its_title() -> None:
    assert list(robot_titles()) == sorted(content.content_folders("robots"))
    assert robot_titles()["movemaster"] == load_robot("movemaster").title


def test_a_broken_folder_has_no_title(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "robot.toml").write_text("broken", "utf-8")
    folders = {"broken": tmp_path, "movemaster": content.content_folder("robots", "movemaster")}
    monkeypatch.setattr(content, "content_folders", lambda kind: folders)
    monkeypatch.setattr(library, "_titles_of_folders", library._titles_of_folders.__wrapped__)
    assert list(robot_titles()) == ["movemaster"]


def test_a_guest_is_had_by_its_name_and_title(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(library, "_registered", {})
    long = load_robot("planar3r", settings=["l1=3000"])
    register_robot(long)
    assert load_robot("planar3r") is long
    assert load_robot("planar3r", settings=["l1=2000"]) is not long
    guest = replace(load_robot(str(write(tmp_path))), title=load_robot("movemaster").title)
    register_robot(guest)
    assert robot_titles()[guest.name].en == f"{guest.title.en} ({guest.name})"
    assert len(set(robot_titles().values())) == len(robot_titles())


def test_packaged_names_are_plain() -> None:
    assert all(path.suffix == ".urdf" and path.is_file() for path in packaged_urdfs().values())
    assert not [name for name in packaged_urdfs() if name.endswith(("_robot", ".urdf"))]


def test_a_robot_is_loaded_by_name_path_or_package(tmp_path: Path) -> None:
    assert load_robot("movemaster").urdf == content.content_folder("robots", "movemaster") / "movemaster.urdf"
    assert load_robot(str(path := write(tmp_path))).urdf == path
    assert load_robot("panda").tool_link == "panda_hand_tcp"


def test_a_tip_ends_the_arm(tmp_path: Path) -> None:
    assert load_robot(str(write(tmp_path)), "upper").tool_link == "upper"
    assert load_robot("panda", "panda_link4").tool_link == "panda_link4"


def test_an_arm_that_comes_back_is_the_same_one_until_its_files_change(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every change of arm made another one before, and kept its meshes and all that was worked out of it."""
    folder = tmp_path / "robots" / "mine"
    shutil.copytree(content.SHIPPED / "robots" / "planar2r", folder)
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    first = load_robot("mine")
    assert load_robot("mine") is first
    assert load_robot("movemaster") is load_robot("movemaster")
    assert load_robot("planar3r", None, ("l1=1500",)) is not load_robot("planar3r")
    file = folder / "robot.toml"
    os.utime(file, ns=(file.stat().st_atime_ns, file.stat().st_mtime_ns + 1))
    assert load_robot("mine") is not first


def test_settings_change_the_lengths() -> None:
    assert dict(load_robot("planar2r", settings=["l1=1500", "l2=250.5"]).parameters) == {"l1": 1.5, "l2": 0.2505}


@pytest.mark.parametrize(
    ("robot", "tip", "settings", "words"),
    [
        ("panda", None, ("l1=1",), ["--set", "panda"]),
        ("arm.urdf", None, ("l1=1",), ["--set", "arm.urdf"]),
        ("planar2r", "tool", (), ["--tip", "planar2r"]),
        ("planar2r", None, ("l1=abc",), ["'l1=abc'", "l1=1500"]),
        ("planar2r", None, ("l1",), ["'l1'", "l1=1500"]),
        ("planar2r", None, ("",), ["''", "l1=1500"]),
        ("planar2r", None, ("l9=1",), ["l9", "l1, l2"]),
        ("planar2r", None, ("l1=-5",), ["l1", "positive"]),
        ("planar2r", None, ("l1=nan",), ["l1", "positive"]),
        ("planar2r", None, ("l1=inf",), ["l1", "positive"]),
        ("movemaster", None, ("l1=1",), ["l1", "none"]),
        ("panda", "nowhere", (), ["'nowhere'", "panda_link4"]),
    ],
)
def test_what_does_not_go_together_is_said(
    robot: str, tip: str | None, settings: tuple[str, ...], words: list[str]
) -> None:
    said = refused(robot, tip, settings)
    assert [word for word in words if word not in said.en] == []


def test_an_unknown_name_lists_all_names() -> None:
    said = refused("pandas").en
    assert [name for name in robot_names() if name not in said] == []
    assert "'pandas'" in said
    assert "path of a URDF file" in said
    assert "pip install" not in said


def test_xacro_is_not_taken_for_a_name(tmp_path: Path) -> None:
    path = write(tmp_path, "</robot>", '<xacro:arm xmlns:xacro="http://ros.org/wiki/xacro"/></robot>')
    assert "is xacro" in refused(str(path.rename(tmp_path / "arm.urdf.xacro"))).en


def test_a_broken_file_of_a_package_does_not_hide_a_good_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = {PACKAGES[0]: [tmp_path / "arm.urdf"], PACKAGES[1]: [write(tmp_path).rename(tmp_path / "arm_robot.urdf")]}
    files[PACKAGES[0]][0].write_text("<robot name='arm'/>", "utf-8")
    monkeypatch.setattr(library, "_files", files.get)
    packaged_urdfs.cache_clear()
    try:
        assert load_robot("arm").urdf == tmp_path / "arm_robot.urdf"
        files[PACKAGES[1]] = []
        assert "it has no links" in refused("arm").en
    finally:
        packaged_urdfs.cache_clear()


@pytest.mark.parametrize("name", ["arm.URDF", "ARM.Xml"])
def test_the_suffix_of_a_path_may_be_in_capitals(tmp_path: Path, name: str) -> None:
    path = write(tmp_path).rename(tmp_path / name)
    assert load_robot(str(path), "tool", (), "upper").base_link == "upper"


@pytest.fixture
def without_packages(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    def missing(package: str) -> None:
        raise PackageNotFoundError(package)

    monkeypatch.setattr(library, "distribution", missing)
    packaged_urdfs.cache_clear()
    yield
    packaged_urdfs.cache_clear()


@pytest.mark.usefixtures("without_packages")
def test_without_the_packages_it_is_said_how_to_get_them() -> None:
    said = refused("panda")
    for words in (said.en, said.pt_BR):
        assert "'panda'" in words
        assert f"pip install {' '.join(PACKAGES)}" in words
    assert robot_names() == sorted(content.content_folders("robots"))
