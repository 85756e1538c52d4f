"""A file of progress gives it back; one that was edited or damaged is read as a whole or refused in both languages."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from tests.mutated import FOREIGN, bytes_of, hold, refused
from tests.store.samples import PROGRESS, STEPS, TOKEN, progresses

from helicoide.store.merging import Progress
from helicoide.store.progress_file import MOST_BYTES, decode_progress, encode_progress
from helicoide.store.schema import person_of

FILE = encode_progress(PROGRESS).decode()


def read(content: bytes) -> Progress:
    return decode_progress(content, STEPS)


def edited(old: str, new: str) -> str:
    assert old in FILE
    return FILE.replace(old, new, 1)


@given(progresses())
def test_a_file_gives_the_progress_back(progress: Progress) -> None:
    assert read(encode_progress(progress)) == progress


def test_equal_progress_makes_equal_files() -> None:
    assert encode_progress(dict(reversed(PROGRESS.items()))) == FILE.encode()


def test_a_file_does_not_say_whose_it_is() -> None:
    assert TOKEN not in FILE
    assert person_of(TOKEN) not in FILE


@pytest.mark.parametrize(
    "text",
    [
        "",
        "null",
        "[]",
        "{}",
        '"helicoide progress 1"',
        FILE[:-10],
        FILE + "{}",
        FILE.replace("\n", ""). replace("{", "["),
        edited("progress 1", "progress 2"),
        edited("progress 1", "waypoints 1"),
        edited('"lessons"', '"lesson"'),
        edited('"screws"', '"screw"'),
        edited('"motors"', '"screws"'),
        edited('"step": 2', '"step": -1'),
        edited('"step": 2', '"step": 5'),
        edited('"step": 2', '"step": 2.5'),
        edited('"step": 2', '"step": "2"'),
        edited('"step": 2', '"step": true'),
        edited('"step": 2', '"step": null'),
        edited('"step": 2', '"steps": 2'),
        edited('"step": 2,', ""),
        edited('"step": 2', '"step": 2, "step": 1'),
        edited('"step": 2', '"step": 2, "grade": 10'),
        edited('"step": 2', f'"step": {10**30}'),
        edited('"finished": true', '"finished": 1'),
        edited('"finished": true', '"finished": "true"'),
        edited('"axis"', '"axes"'),
        edited('"pitch"', '"axis"'),
        edited('"pitch"\n', '"pitch", "pitch"\n'),
        edited('"pitch"\n', '"pitch", 1\n'),
        edited('"right": null', '"right": "yes"'),
        edited('"right": null', '"right": null, "why": ""'),
        edited("0.25", "NaN"),
        edited("0.25", "-Infinity"),
        edited("0.25", "1e999"),
        edited("0.25", "0.2.5"),
        edited("0.25", '"0.25"'),
        edited("0.25", "[[0.25]]"),
        edited("0.25", "9" * 5000),
        edited("0.25", "[" * 100_000),
        edited('"half"', '"half", "sign"'),
        edited('"half"', '""'),
        edited('"half"', '1'),
        edited("θ ≠ 0", ""),
        edited("θ ≠ 0", "\\ud800"),
        edited("θ ≠ 0", "\\u0000"),
        edited("θ ≠ 0", "a\\nb"),
        edited("θ ≠ 0", "a" * 1001),
        "\ud800" + FILE,
        "\ufeff" + FILE,
        FILE + " " * MOST_BYTES,
    ],
)  # fmt: skip
def test_an_edited_file_is_refused_with_a_reason(text: str) -> None:
    refusal = refused(read, bytes_of(text))
    assert refusal is not None
    assert refusal.en != refusal.pt_BR
    assert not FOREIGN.search(refusal.en), refusal.en


def test_a_refusal_says_what_would_have_been_valid() -> None:
    said = refused(read, edited('"axis"', '"axes"').encode())
    assert said is not None
    assert "no step 'axes'; it has: axis, pitch, moves, open" in said.en


def test_an_edit_that_is_valid_is_read() -> None:
    found = read(edited('"step": 2', '"step": 0').encode())
    assert found["screws"].step == 0
    assert found["motors"] == PROGRESS["motors"]


@pytest.mark.parametrize(("count", "seed"), [(1000, 1), pytest.param(30_000, 2, marks=pytest.mark.soak)])
def test_a_damaged_file_is_read_or_refused_never_half(count: int, seed: int) -> None:
    """What is read says the same as the file, to the last value: nothing was left out."""

    def whole(content: bytes) -> None:
        assert json.loads(encode_progress(read(content))) == _sorted(json.loads(content))

    values, refusals = hold(whole, [FILE, encode_progress({}).decode()], count, seed)
    assert min(values, refusals) > count // 50


def _sorted(file: dict) -> dict:  # type: ignore[type-arg]
    for lesson in file["lessons"].values():
        lesson |= {key: sorted(lesson[key]) for key in ("done", "skipped", "mistakes")}
    return file
