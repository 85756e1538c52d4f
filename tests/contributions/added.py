"""A copy of the checkout and a user's folder, to which `helicoide new` adds what a newcomer would."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

CHECKOUT = Path(__file__).parents[2]
PARTS = ("app", "lessons", "robots", "static")
# Kind and name of what is added, and whether into the user's own folder, outside the repository.
ADDED = (
    ("robot", "stranger_arm", False),
    ("robot", "stranger_outside", True),
    ("method", "stranger_method", False),
    ("lesson", "stranger_lesson", False),
    ("study", "stranger_study", False),
)


@dataclass(frozen=True)
class Copy:
    """A checkout and a user's folder in one place."""

    root: Path

    @property
    def environment(self) -> dict[str, str]:
        """Compiled kernels are those of the checkout: none of them is changed."""
        mine = {"PYTHONPATH": str(self.root / "app"), "XDG_DATA_HOME": str(self.root / "home"), "LC_ALL": "C.UTF-8"}
        return {**os.environ, **mine, "LANGUAGE": ""}

    def command(self, *arguments: str) -> list[str]:
        """A command of the copy."""
        return [sys.executable, "-m", "helicoide", *arguments]

    def run(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Run a command of the copy to its end."""
        command = self.command(*arguments)
        return subprocess.run(command, cwd=self.root, env=self.environment, capture_output=True, encoding="utf-8")


def copied(root: Path) -> Copy:
    """A copy of the checkout with nothing added."""
    for part in PARTS:
        shutil.copytree(CHECKOUT / part, root / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(CHECKOUT / "pyproject.toml", root)
    return Copy(root)


def with_additions(root: Path) -> Copy:
    """The same with all of `ADDED`."""
    copy = copied(root)
    for kind, name, outside in ADDED:
        done = copy.run("new", kind, name, *["--user"] * outside)
        assert done.returncode == 0, done.stderr
    return copy
