"""Clouds with bytes changed, lost, doubled and added: read, or refused in words."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
import pytest
from tests.perception import test_cloud_kinds as kinds
from tests.perception.cloud_bytes import WRITERS

from helicoide.perception import cloud_file
from helicoide.perception.cloud import PointCloud
from helicoide.text import HelicoideError, Text

Generator = np.random.Generator
LONGEST = 10.0
SMALL = np.random.default_rng(0).normal(size=(12, 3)).round(4)
# What formats understand, put where it does not belong.
WORDS = (
    *(b"0", b"-1", b"99999999999", b"1e400", b"nan", b"-1.#IND", b",", b";", b'"', b"\t", b"\r", b"\n\n", b"\0"),
    *(b"x", b"X,Y,Z\n", b"#", b"//", b"list uchar int", b"property list uchar float y\n", b"element vertex 5\n"),
    *(
        b"ascii",
        b"binary",
        b"FIELDS",
        b"SIZE 8",
        b"COUNT 0",
        b"(3, 4)",
        b"'f8'",
        b"|O",
        b"\xff\xfe",
        b"[mm]",
        b"4000\n",
    ),
)


def seeds() -> list[tuple[str, bytes]]:
    """A small file of every kind."""
    texts = ((ending, text if isinstance(text, bytes) else text.encode()) for ending, text in kinds.TEXTS.values())
    files = ((ending, data()) for ending, data in kinds.FILES.values())
    written = [(ending, writer(SMALL)) for ending, writer in WRITERS.values()]
    return [
        *written,
        *((ending, data[:900]) for ending, data in texts),
        *((ending, data[:1500]) for ending, data in files),
    ]


def damaged(rng: Generator, data: bytes) -> bytes:
    """One to five changes anywhere, mostly near the beginning, which is what is understood."""
    changed = bytearray(data)
    for _ in range(rng.integers(1, 6)):
        size = len(changed) if rng.random() < 0.4 else min(len(changed), 250)
        at, long = int(rng.integers(0, size + 1)), int(rng.integers(1, 5))
        match rng.integers(6):
            case 0:
                changed[at : at + long] = rng.bytes(long)
            case 1:
                del changed[at : at + long * int(rng.integers(1, 40))]
            case 2:
                changed[at:at] = WORDS[rng.integers(len(WORDS))]
            case 3:
                changed[at : at + long] = WORDS[rng.integers(len(WORDS))]
            case 4:
                changed[at:at] = changed[at : at + 8 * long]
            case _:
                changed = changed[:at] if rng.random() < 0.2 else changed
    return bytes(changed)


def mutations(count: int, seed: int) -> Iterator[tuple[str, bytes]]:
    rng, files = np.random.default_rng(seed), seeds()
    for k in range(count):
        ending, data = files[k % len(files)]
        yield f"c{ending}", damaged(rng, data)


def answer(name: str, data: bytes) -> PointCloud | Text:
    try:
        return cloud_file.read_cloud(name, data)
    except HelicoideError as refusal:
        return refusal.text


def read_all(count: int, seed: int) -> int:
    """How many of the damaged files were read; the others were refused in time, and nothing else is raised."""
    read = 0
    for name, data in mutations(count, seed):
        began = time.process_time()
        said = answer(name, data)
        assert time.process_time() - began < LONGEST, data
        if isinstance(said, Text):
            assert said.en.startswith(f"{name} cannot be read: "), data
            assert said.pt_BR.startswith(f"Não dá para ler {name}: "), data
            assert len(said.en) < 1500, data
        else:
            assert len(said.points), data
            assert np.isfinite(said.points).all(), data
            assert said.notes, data
            read += 1
    return read


def test_damaged_clouds_are_read_or_refused() -> None:
    assert 1000 < read_all(10_000, 0) < 9000


@pytest.mark.soak
@pytest.mark.parametrize("seed", range(1, 7))
def test_many_damaged_clouds_are_read_or_refused(seed: int) -> None:
    read_all(10_000, seed)
