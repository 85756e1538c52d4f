"""Mutated files: a value replaced, a line lost or doubled, a character inserted, a part cut out."""

from __future__ import annotations

import random
import re
import time
from collections.abc import Callable, Sequence

from helicoide.text import HelicoideError, Text

# Replacements for values.
WORDS = (
    "nan", "inf", "-inf", "1e999", "1e308", "-1e308", "1e-320", "0", "-1", "-0.0", "true", '""', '"x"', '"\\u0000"',
    '"J1"', '"l1 + l1"', "[]", "{}", "[[1]]", "[0, 0, 0]", "[[0,0,0],[0,0,0],[0,0,0]]", '["a", "a"]', "1979-05-27",
    "07:32:00", "0x7fffffffffffffffff", "1" + "0" * 22, "1" + "0" * 400, "9" * 5000, "[" * 3000, "{a=" * 3000,
)  # fmt: skip
NOISE = ("\0", "[", "]", '"', "\n", "=", "é", "#", "{", ",", ".", "\ud800", "a." * 3000)
VALUE = re.compile(r'-?\b[\d.]+\b|"[^"\n]*"|\[[^\[\]\n]*\]|true|false')
# Words of Python and its packages, which mean nothing to the author of the file.
FOREIGN = re.compile(r"Errno|codec|sys\.|Traceback|object|Object|NoneType|`|Error|argument|recursion|datetime")
LONGEST = 10.0


def mutated(text: str, chance: random.Random) -> str:
    """The file after one to three random mutations."""
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        lines, at = text.split("\n"), chance.randrange(len(text) + 1)
        match chance.randrange(7):
            case 0 | 1 | 2 if spots := [found.span() for found in VALUE.finditer(text)]:
                start, end = chance.choice(spots)
                text = text[:start] + chance.choice(WORDS) + text[end:]
            case 3:
                del lines[chance.randrange(len(lines))]
                text = "\n".join(lines)
            case 4:
                lines.insert(chance.randrange(len(lines) + 1), chance.choice(lines))
                text = "\n".join(lines)
            case 5:
                text = text[:at] + chance.choice(NOISE) + text[at + chance.randrange(3) :]
            case _:
                text = text[:at] + text[at + chance.choice((1, 30, 300, len(text))) :]
    return text


def bytes_of(text: str) -> bytes:
    """The text in UTF-8; a lone surrogate becomes bytes that are not valid text."""
    return text.encode("utf-8", "surrogatepass")


def refused(read: Callable[[bytes], object], content: bytes) -> Text | None:
    """Why a file is refused; None if it can be read. Any other exception fails the test."""
    try:
        read(content)
    except HelicoideError as error:
        return error.text
    return None


def hold(read: Callable[[bytes], object], good: Sequence[str], count: int, seed: int) -> tuple[int, int]:
    """Read mutated files. Each is read, or refused in both languages, within `LONGEST` s. Returns how many of each."""
    chance, refusals = random.Random(seed), 0
    for _ in range(count):
        text = mutated(chance.choice(good), chance)
        began = time.process_time()
        refusal = refused(read, bytes_of(text))
        refusals += refusal is not None
        if refusal is not None:
            _, _, reason = refusal.en.rpartition("robot.toml")
            assert not FOREIGN.search(reason), refusal.en
            assert refusal.en != refusal.pt_BR
        assert time.process_time() - began < LONGEST, text
    return count - refusals, refusals
