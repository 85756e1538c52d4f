"""`helicoide fk` as people run it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

APP = Path(__file__).parents[2] / "app"


def fk(*arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(APP), "LC_ALL": "C.UTF-8"}
    command = [sys.executable, "-m", "helicoide", "fk", *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)


def test_the_example_of_the_source_by_all_roads() -> None:
    """Cerbaro 2022, eqs. 4-6: (470.429, 271.602, 300.000) mm; more digits in the digest, section 8."""
    done = fk("movemaster", "--q", "30", "60", "-90", "-30", "90", "--deg", "--json")
    assert done.returncode == 0, done.stderr
    roads = json.loads(done.stdout)["roads"]
    assert set(roads) == {"dh", "screws", "dual_quaternions"}
    for pose in roads.values():
        assert pose["position"] == pytest.approx([0.4704294, 0.2716025, 0.3000000], abs=5e-8)
        assert pose["matrix"][0][:3] == pytest.approx([0.4330, 0.75, 0.5], abs=5.1e-5)
        assert pose["quaternion_wxyz"] == pytest.approx([0.683013, 0.5, 0.5, -0.183013], abs=6e-7)
        assert pose["motor"]["e1e"] == pytest.approx(0.060801270, abs=1e-9)


def test_the_words_for_people_carry_the_same_numbers() -> None:
    done = fk("movemaster", "--q", "0.5235987755982988", "1.0471975511965976", "-1.5707963267948966",
              "-0.5235987755982988", "1.5707963267948966")  # fmt: skip
    lines = done.stdout.splitlines()
    assert done.returncode == 0
    assert len(lines) == 3
    assert all("0.4704294, 0.2716025, 0.3000000 m" in line for line in lines)


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["movemaster", "--q", "1", "2", "3"], "5 finite joint values"),
        (["movemaster", "--q", *["0.1234567"] * 12], "5 finite joint values"),
        (["movemaster", "--q", "nan", "0", "0", "0", "0"], "5 finite joint values"),
        (["movemaster", "--q", "inf", "0", "0", "0", "0", "--deg"], "5 finite joint values"),
        (["puma", "--q", "0", "0", "0", "0", "0"], "movemaster"),
        (["../../etc", "--q", "0", "0", "0", "0", "0"], "movemaster"),
    ],
)
def test_wrong_input_is_one_clear_line(arguments: list[str], word: str) -> None:
    done = fk(*arguments)
    assert done.returncode != 0
    assert done.stdout == ""
    assert "Traceback" not in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert word in done.stderr


@pytest.mark.parametrize("arguments", [["movemaster", "--q", "one"], ["movemaster"], []])
def test_what_cannot_be_read_ends_without_a_traceback(arguments: list[str]) -> None:
    done = fk(*arguments)
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
