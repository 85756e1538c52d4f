"""The wheel: which files it contains, and that it works outside the checkout."""

from __future__ import annotations

import gzip
import json
import os
import signal
import subprocess
import sys
import sysconfig
import threading
import urllib.request
import venv
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from helicoide import content

CHECKOUT = Path(__file__).parents[1]
PATIENCE = 60  # s, for what takes one or two
PIP = (sys.executable, "-m", "pip", "--disable-pip-version-check", "-qq")


@dataclass(frozen=True)
class Installed:
    """A virtual environment with the wheel installed, and a folder outside the checkout."""

    bin: Path
    elsewhere: Path
    environment: dict[str, str]

    def run(self, *arguments: str) -> str:
        """What a command of the installed package prints."""
        done = subprocess.run(
            [self.bin / arguments[0], *arguments[1:]],
            cwd=self.elsewhere,
            env=self.environment,
            capture_output=True,
            encoding="utf-8",
        )
        assert done.returncode == 0, done.stderr
        assert done.stderr == ""
        return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    command = [*PIP, "wheel", "--no-deps", "--no-index", "--no-build-isolation", "--wheel-dir", folder, CHECKOUT]
    subprocess.run(command, check=True)
    (file,) = folder.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """The package comes from the wheel; its dependencies, to save minutes, from the environment that runs the tests.

    A .pth file adds their folder. Python ignores .pth files in a folder that is added in this way, so the checkout,
    which is installed there as editable, is not found.
    """
    root = tmp_path_factory.mktemp("installed")
    venv.create(root, with_pip=False)
    python = root / "bin" / "python"
    subprocess.run([*PIP, "--python", python, "install", "--no-deps", "--no-index", wheel], check=True)
    places = {"base": str(root), "platbase": str(root)}
    lent = {sysconfig.get_path(kind) for kind in ("purelib", "platlib")}
    Path(sysconfig.get_path("purelib", vars=places), "lent.pth").write_text("\n".join(lent), encoding="utf-8")
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    environment |= {"NUMBA_CACHE_DIR": str(root / "kernels"), "XDG_DATA_HOME": str(root / "data")}
    return Installed(root / "bin", elsewhere, environment)


def test_wheel_carries_robots_lessons_and_static(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    for file in content.STATIC.rglob("*"):
        if file.is_file():
            assert f"helicoide/static/{file.relative_to(content.STATIC).as_posix()}" in names
    for robot in (CHECKOUT / "robots").glob("*/robot.toml"):
        assert f"helicoide/robots/{robot.parent.name}/robot.toml" in names
    for lesson in (CHECKOUT / "lessons").glob("*/lesson.py"):
        assert {
            f"helicoide/lessons/{lesson.parent.name}/{page}" for page in ("lesson.py", "en.md", "pt_BR.md")
        } <= names


def test_wheel_carries_nothing_that_only_a_checkout_needs(wheel: Path) -> None:
    for name in zipfile.ZipFile(wheel).namelist():
        assert name.startswith("helicoide"), name
        assert "__pycache__" not in name
        assert not name.endswith("/build.py")
        assert "/firmware/" not in name


def test_package_is_the_one_in_the_wheel(installed: Installed) -> None:
    where = installed.run("python", "-c", "import helicoide; print(helicoide.__file__)").strip()
    assert Path(where).is_relative_to(installed.bin.parent)


def test_fk_from_another_folder(installed: Installed) -> None:
    told = json.loads(installed.run("helicoide", "fk", "movemaster", "--q", "0", "0", "0", "0", "0", "--json"))
    for name, pose in told["roads"].items():
        np.testing.assert_allclose(pose["position"], [0.82, 0, 0.4], atol=1e-12, err_msg=name)


def test_what_is_new_goes_into_the_users_folder(installed: Installed) -> None:
    """Without a checkout, `helicoide new` writes there."""
    for kind in ("robot", "lesson", "method", "study"):
        *files, _ = installed.run("helicoide", "new", kind, f"new_{kind}").splitlines()
        assert all(Path(file).is_relative_to(installed.environment["XDG_DATA_HOME"]) for file in files)
    told = json.loads(installed.run("helicoide", "fk", "new_robot", "--q", "0", "0", "--json"))
    np.testing.assert_allclose(told["roads"]["dh"]["position"], [0.7, 0, 0], atol=1e-12)


def test_doctor_finds_what_was_shipped(installed: Installed) -> None:
    told = installed.run("helicoide", "doctor")
    assert "missing" not in told
    assert f"robots: {', '.join(sorted(f.parent.name for f in (CHECKOUT / 'robots').glob('*/robot.toml')))}" in told


def test_serves_and_stops_cleanly(installed: Installed) -> None:
    server = subprocess.Popen(
        [installed.bin / "helicoide", "--port", "0"],
        cwd=installed.elsewhere,
        env=installed.environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )
    guard = threading.Timer(PATIENCE, server.kill)  # ends all calls that wait for the server
    guard.start()
    try:
        assert server.stdout is not None
        address = server.stdout.readline().removeprefix("Helicoide: ").strip()
        assert address.startswith("http://127.0.0.1:"), address
        with urllib.request.urlopen(f"{address}/healthz") as answer:
            assert answer.read().strip() == b"ok"
        with urllib.request.urlopen(f"{address}/") as page:
            assert b"helicoide.css" in gzip.decompress(page.read())
        server.send_signal(signal.SIGTERM)
        said = server.communicate(timeout=PATIENCE)
    finally:
        guard.cancel()
        server.kill()
        server.wait()
    assert server.returncode == 0, said
    assert said[1] == ""
