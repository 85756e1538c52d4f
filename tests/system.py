"""System packages that some tests need. Such a test has the mark of its package.

`python -m tests.system browser` installs a missing package if it may, or else names it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass


@dataclass(frozen=True)
class System:
    """Commands, any one of which shows that the package is installed, and the Debian packages with them."""

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
    """Install by apt-get, as root or by sudo without a password; otherwise do nothing."""
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
    """The marks whose packages are missing and cannot be installed here, with the names of the packages."""
    for mark in marks:
        if not MARKS[mark].is_there():
            install(MARKS[mark].packages)
    return {mark: " ".join(MARKS[mark].packages) for mark in marks if not MARKS[mark].is_there()}


if __name__ == "__main__":
    lacking = missing(*sys.argv[1:])
    sys.exit("\n".join(f"The {mark} is missing: install {packages}." for mark, packages in lacking.items()) or 0)
