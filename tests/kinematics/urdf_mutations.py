"""URDF texts that chance has changed: pieces lost, doubled, moved, and replaced by what wrong files have."""

from __future__ import annotations

import time
from collections import Counter
from pathlib import Path

import numpy as np
from tests.kinematics.urdfs import GOOD, chain_of

from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.kinematics.urdf_file import undrawn_remark
from helicoide.text import HelicoideError, Text

MIMIC = '<mimic joint="a-b" multiplier="-2" offset="0.5"/>'
BESIDE = chain_of(["base", "w", "x"]).replace('<link name="base"/>', "")
SEEDS = (
    GOOD.replace('velocity="0.5"/>', 'velocity="0.5"/><mimic joint="one" multiplier="-2" offset="0.5"/>'),
    GOOD.replace(
        '<link name="upper"/>',
        '<link name="upper"><visual><origin xyz="0 0 1"/><geometry><capsule radius="1" length="2"/></geometry>'
        '<material name="red"><color rgba="1 0 0 1"/></material></visual><visual><geometry><mesh filename="a.stl" '
        'scale="1 1 1"/></geometry></visual></link>',
    ),
    f'<robot name="r">{chain_of(["base", "a", "b", "c"])}{BESIDE}</robot>'.replace(
        '<child link="c"/>', f'<child link="c"/>{MIMIC}'
    ),
    GOOD.replace('name="end" type="fixed"', 'name="end" type="floating"'),
)
NUMBERS = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "1e16", "-1e16", "0", "-0", "1,5", "1e9", "-1e9", "9" * 400),
    *("0 0 0", "1 0 0", "1e9 -1e9 1e9", "1e-300 0 0", "0,1 0,2 0,3", "1 2", "3.14159 0 1e9", "-7", "0.5", "1e3", "1e6"),
)
NAMES = ("revolute", "prismatic", "fixed", "Continuous", "floating", "planar", "base", "a", "one", "a-b", "tool", "new")
PIECES = (
    *("", " ", "fixed", "floating", "planar", "Revolute", "prismatic", "continuous", "hinge", "${x}", "$(find a)"),
    *(
        "<",
        ">",
        "/>",
        '"',
        "'",
        "&",
        "&x;",
        "<!--",
        "-->",
        "<![CDATA[",
        "]]>",
        "<?xml?>",
        "<!DOCTYPE a>",
        "\0",
        "é",
        "𝕏",
    ),
    *(
        "xacro:",
        "xmlns:a='b'",
        "a:b",
        "one",
        "two",
        "base",
        "tool",
        "upper",
        "../../..",
        "package://",
        "\\",
        "{}",
        "%s",
    ),
    *('<mimic joint="one"/>', '<mimic joint="two"/>', '<axis xyz="0 0 0"/>', "<limit/>", "<origin/>", "<visual/>"),
)


def mutated(rng: np.random.Generator) -> bytes:
    """A text with a few changes, in an encoding that need not be the one it says."""
    text = SEEDS[rng.integers(len(SEEDS))]
    for _ in range(rng.integers(1, 4)):
        text = _changed(text, rng)
    encoding = str(rng.choice(["utf-8", "utf-8", "utf-8", "utf-16", "latin-1"]))
    content = bytearray(text.encode(encoding, errors="replace"))
    if content and rng.random() < 0.1:
        content[rng.integers(len(content))] = rng.integers(256)
    return bytes(content)


def _changed(text: str, rng: np.random.Generator) -> str:
    """The text with a word or a value exchanged, or a stretch lost, doubled or moved."""
    i, j = sorted(int(k) for k in rng.integers(len(text) + 1, size=2))
    kind = rng.integers(25)
    if kind == 0:
        return text[:i] + text[min(j, i + 40) :]
    if kind == 1:
        return text[:j] + text[i : min(j, i + 200)] + text[j:]
    if kind == 2:
        return text[:i] + str(rng.choice(PIECES)) + text[i:]
    quotes = [k for k, letter in enumerate(text) if letter == '"']
    if len(quotes) < 2:
        return text
    k = 2 * int(rng.integers(len(quotes) // 2))
    pieces = PIECES if rng.random() < 0.1 else NUMBERS if "0" <= text[quotes[k + 1] - 1] <= "9" else NAMES
    return text[: quotes[k] + 1] + str(rng.choice(pieces)) + text[quotes[k + 1] :]


def judged(folder: Path, seed: int, count: int) -> tuple[Counter[str], float]:
    """How many texts are robots and how many are refused, and how long the slowest took, s.

    Fails for any other end, for a reason of more lines than one, and for a robot with a number that is not finite.
    """
    rng, found, slowest = np.random.default_rng(seed), Counter[str](), 0.0
    path = folder / "mutated.urdf"
    for i in range(count):
        path.write_bytes(mutated(rng))
        begun = time.process_time()
        found[_end(path, f"{seed}, text {i}")] += 1
        slowest = max(slowest, time.process_time() - begun)
    return found, slowest


def _end(path: Path, which: str) -> str:
    try:
        robot = robot_from_urdf(path)
        undrawn_remark(path)
    except HelicoideError as error:
        return _refused(error.text, which)
    except Exception as error:
        raise AssertionError(which) from error
    for values in (robot.lower, robot.upper, robot.speed, robot.poses["ready"], robot.T_world_tool_0, robot.directions):
        assert np.isfinite(values).all(), which
    assert robot.reach > 0, which
    assert np.isfinite(robot.reach), which
    return "robot"


def _refused(text: Text, which: str) -> str:
    for words in (text.en, text.pt_BR):
        assert len(words.splitlines()) == 1, (which, words)
    assert text.en.partition(": ")[2] != text.pt_BR.partition(": ")[2], (which, text)
    return "refused"
