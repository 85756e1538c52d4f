"""Packages of the system that some tests need; a test that needs one carries its mark.

`python -m tests.system browser` installs what is missing where that is allowed, and names it where it is not.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass


@dataclass(frozen=True)
class System:
    """Commands, any one of which shows that it is there, and the Debian packages that bring it."""

    commands: tuple[str, ...]
    packages: tuple[str, ...]

    def is_there(self) -> bool:
        return any(map(shutil.which, self.commands))


MARKS = {
    "browser": System(("chromium", "chromium-browser", "google-chrome"), ("chromium", "fonts-dejavu-core")),
    "firefox": System(("firefox-esr", "firefox"), ("firefox-esr", "xvfb", "libegl1")),
    "webkit": System(("WebKitWebDriver",), ("webkit2gtk-driver", "xvfb", "libegl1")),
}


def install(packages: tuple[str, ...]) -> None:
    """By apt-get, as root or by a sudo that asks for no password; elsewhere nothing happens."""
    root = [] if os.geteuid() == 0 else ["sudo", "-n"]
    if shutil.which("apt-get") is None or (root and subprocess.run([*root, "true"], capture_output=True).returncode):
        return
    print(f"Installing {' '.join(packages)} for the tests.", flush=True)
    quiet = [*root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq"]
    subprocess.run([*quiet, "update"], check=False)
    subprocess.run(
        [*quiet, "install", "-y", "--no-install-recommends", *packages], stdout=subprocess.DEVNULL, check=False
    )


def missing(*marks: str) -> dict[str, str]:
    """The marks whose package is not there and cannot be installed, each with what is to be installed."""
    for mark in marks:
        if not MARKS[mark].is_there():
            install(MARKS[mark].packages)
    return {mark: " ".join(MARKS[mark].packages) for mark in marks if not MARKS[mark].is_there()}


if __name__ == "__main__":
    lacking = missing(*sys.argv[1:])
    sys.exit("\n".join(f"The {mark} is missing: install {packages}." for mark, packages in lacking.items()) or 0)
