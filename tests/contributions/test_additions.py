"""What a newcomer adds with `helicoide new` is one file or folder, and holds to all that is asked of it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from tests.contributions.added import ADDED, CHECKOUT, PARTS, Copy, with_additions


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    return with_additions(tmp_path_factory.mktemp("copy"))


def files(root: Path) -> set[str]:
    found = (file for part in PARTS for file in (root / part).rglob("*") if file.is_file())
    return {str(file.relative_to(root)) for file in found if "__pycache__" not in file.parts}


def test_each_is_one_new_file_or_folder(copy: Copy) -> None:
    new = files(copy.root) - files(CHECKOUT)
    assert new == {
        "robots/stranger_arm/robot.toml",
        "robots/stranger_arm/stranger_arm.urdf",
        "app/helicoide/ik/methods/stranger_method.py",
        "app/helicoide/studies/stranger_study.py",
        "lessons/stranger_lesson/lesson.py",
        "lessons/stranger_lesson/en.md",
        "lessons/stranger_lesson/pt_BR.md",
    }
    assert all((copy.root / file).read_bytes() == (CHECKOUT / file).read_bytes() for file in files(CHECKOUT))
    outside = copy.root / "home" / "helicoide" / "robots" / "stranger_outside"
    assert {file.name for file in outside.iterdir()} == {"robot.toml", "stranger_outside.urdf"}


@pytest.mark.parametrize(("kind", "name"), [(kind, name) for kind, name, _ in ADDED])
def test_it_holds_to_all_that_is_asked(copy: Copy, kind: str, name: str) -> None:
    done = copy.run("check", name)
    assert (done.returncode, done.stdout, done.stderr) == (0, f"{kind} {name}: no faults\n", "")


def test_a_robot_is_small(copy: Copy) -> None:
    assert len((copy.root / "robots" / "stranger_arm" / "robot.toml").read_text("utf-8").splitlines()) <= 40


def test_what_is_changed_for_the_worse_is_said_and_ends_with_3(copy: Copy) -> None:
    folder = copy.root / "home" / "helicoide" / "robots" / "stranger_outside"
    text = (folder / "robot.toml").read_text("utf-8")
    (folder / "robot.toml").write_text(text.replace("a_mm = 400", "a_mm = 410"), "utf-8")
    try:
        done, said = copy.run("check", "stranger_outside"), copy.run("robots", "stranger_outside").stderr
    finally:
        (folder / "robot.toml").write_text(text, "utf-8")
    assert done.returncode == 3
    assert "the DH rows and the screw of joint J2 give different axes" in done.stdout
    assert "the DH rows and the screw of joint J2 give different axes" in said


TESTS = ("tests/robots/test_every_robot.py", "tests/ik/test_method_contract.py", "tests/test_lessons.py",
         "tests/studies/test_every_study.py")  # fmt: skip


def test_the_tests_of_the_repository_pass_with_them(copy: Copy) -> None:
    """Those that go through all robots, methods, lessons and studies: what is new in them."""
    (copy.root / "tests").symlink_to(CHECKOUT / "tests")
    options = ("-v", "-p", "no:cacheprovider", "-k", "stranger")
    command = [*copy.command()[:1], "-m", "pytest", *options, *TESTS]
    done = subprocess.run(command, cwd=copy.root, env=copy.environment, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout[-3000:]
    for _, name, _ in ADDED:
        assert any(name in line and "PASSED" in line for line in done.stdout.splitlines()), name
