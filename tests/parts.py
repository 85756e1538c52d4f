"""The parts of `make check` and `make test`: each one is run, and the last lines say how each ended.

Tests that need a system package have its mark (`system.py`). If the package is missing, all other tests run, these are
listed, and the exit code is an error.
"""

from __future__ import annotations

import shlex
import subprocess
import sys

from tests import system

Parts = dict[str, list[str]]
CODE: Parts = {
    "lint": ["ruff", "check"],
    "format": ["ruff", "format", "--check"],
    "types": ["mypy", "--strict", "app", "lessons", "robots"],
}
PYTEST = ["pytest", "-n", "2", "--dist", "loadfile", "--no-loadscope-reorder"]  # in the order of conftest.py
NO_TEST_CHOSEN = 5  # the exit code of pytest if its arguments select no test


def to_check(arguments: list[str]) -> Parts:
    """The checks of the code, and at most six tests of a file; none in a browser, none that compiles all kernels."""
    return {**CODE, "tests": [*PYTEST, "-m", "not soak and not browser and not compiles", "--sample", "6", *arguments]}


def to_test(arguments: list[str], lacking: dict[str, str]) -> Parts:
    """Everything that can run. The browser tests run apart, because two browsers use two processors fully."""
    others = " and ".join(f"not {mark}" for mark in sorted({"soak", "browser", *lacking}))
    parts = {**CODE, "tests": [*PYTEST, "-m", others, *arguments]}
    if "browser" not in lacking:
        parts["browser"] = [*PYTEST, "-m", "browser and not soak", *arguments]
    return parts


def run(parts: Parts, lacking: dict[str, str], some_chosen: bool) -> int:
    """Run every part; 1 if one failed or tests were left out."""
    fine = {0: "passed", **({NO_TEST_CHOSEN: "no test chosen"} if some_chosen else {})}
    ends: dict[str, int] = {}
    for name, command in parts.items():
        print(f"\n{name}: {shlex.join(command)}", flush=True)
        ends[name] = subprocess.run([sys.executable, "-m", *command], check=False).returncode
    for mark in lacking:
        print(f"\nNot run for want of {lacking[mark]}, files and numbers of tests:", flush=True)
        subprocess.run([sys.executable, "-m", "pytest", "--collect-only", "-qq", "-m", mark], check=False)
    print()
    for name, end in ends.items():
        print(f"{name}: {fine.get(end, 'FAILED')}")
    for mark, packages in lacking.items():
        print(f"{mark}: NOT RUN, install {packages}")
    return int(bool(lacking) or any(end not in fine for end in ends.values()))


if __name__ == "__main__":
    which, *arguments = sys.argv[1:]
    if which == "check":
        sys.exit(run(to_check(arguments), {}, bool(arguments)))
    lacking = system.missing("browser")
    sys.exit(run(to_test(arguments, lacking), lacking, bool(arguments)))
