"""The URDF files of the packages in corpus.txt, each package in a folder of its own beside the peers."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from tests.benchmarks.peers import ENVIRONMENTS, HERE, LeftOut

FOLDER = ENVIRONMENTS / "corpus"
SKIPPED = ("random_urdfs",)  # a thousand objects without joints, all alike


def pins() -> list[str]:
    """The packages, name==version."""
    return (HERE / "corpus.txt").read_text("utf-8").split()


def files(pin: str) -> dict[str, Path]:
    """The URDF files of a package by their way in it; the package is installed when it is not there, and nothing else.

    Raises LeftOut when it cannot be had.
    """
    folder = FOLDER / pin.split("==")[0]
    _install(pin, folder)
    found = {file.relative_to(folder).as_posix(): file for file in sorted(folder.rglob("*.urdf"))}
    return {name: file for name, file in found.items() if not set(SKIPPED) & set(file.parts)}


def _install(pin: str, folder: Path) -> None:
    ready = folder / "ready"
    if ready.exists() and ready.read_text("utf-8") == pin:
        return
    print(f"  Installing {pin}; this happens once.", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    pip = [sys.executable, "-m", "pip", "install", "-qq", "--disable-pip-version-check", "--no-deps", "--no-compile"]
    made = subprocess.run(
        [*pip, "--only-binary", ":all:", "--target", str(folder), pin], capture_output=True, text=True
    )
    if made.returncode:
        raise LeftOut((made.stderr or made.stdout).strip().splitlines()[-1])
    ready.write_text(pin, "utf-8")
