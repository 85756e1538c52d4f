"""Sheets as text, as files and as links: they come back as they were, and hostile ones are refused in words."""

from __future__ import annotations

import zlib
from base64 import urlsafe_b64encode

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.sheet import (
    LONGEST_LINE,
    LONGEST_PACKED,
    MOST_CHARACTERS,
    MOST_LINES,
    NameSlider,
    Sheet,
    SheetLine,
    packed_sheet,
    sheet_of_file,
    sheet_of_text,
    sheet_text,
    unpacked_sheet,
)
from helicoide.text import HelicoideError

WORDS = st.text("abe12+*()#^ áπ", min_size=1, max_size=30).map(lambda text: " ".join(text.split())).filter(bool)
LINES = st.builds(SheetLine, WORDS, st.booleans())
SLIDERS = st.tuples(
    st.from_regex(r"[a-z][a-z0-9_]{0,8}", fullmatch=True),
    st.builds(
        lambda lower, width, share: NameSlider(lower + share * width, lower, lower + width),
        st.floats(-100, 100),
        st.floats(0.01, 100),
        st.just(0.5),
    ),
)
SHEETS = st.builds(
    lambda lines, sliders: Sheet(tuple(lines), tuple(dict(sliders).items())),
    st.lists(LINES, max_size=20),
    st.lists(SLIDERS, max_size=5),
)


@given(SHEETS)
def test_a_sheet_comes_back_from_its_text_its_file_and_its_link(sheet: Sheet) -> None:
    assert sheet_of_text(sheet_text(sheet)) == sheet
    assert sheet_of_file(sheet_text(sheet).encode()) == sheet
    assert unpacked_sheet(packed_sheet(sheet)) == sheet


def test_a_link_needs_no_escapes_and_is_short() -> None:
    sheet = Sheet(tuple(SheetLine(f"p{k} = point({k}, 0, 0)") for k in range(30)))
    packed = packed_sheet(sheet)
    assert set(packed) <= set("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_")
    assert len(packed) < len(sheet_text(sheet)) / 2


def test_the_longest_sheet_fits() -> None:
    """As many characters as a sheet may have, of four bytes each and in no order, all lines hidden, long numbers."""
    rng = np.random.default_rng(0)
    names = [f"a{k}" for k in range(MOST_LINES)]
    left = MOST_CHARACTERS - sum(map(len, names))
    words = "".join(map(chr, rng.integers(0x20000, 0x2A6D0, left)))
    size = left // MOST_LINES + 1
    lines = tuple(SheetLine(words[k : k + size], False) for k in range(0, left, size))
    ends = rng.uniform(1e-300, 2e-300, (MOST_LINES, 2))
    sliders = tuple((name, NameSlider(float(a), -float(b), 1e6)) for name, (a, b) in zip(names, ends, strict=True))
    sheet = Sheet(lines, sliders)
    assert sum(len(line.text) for line in lines) == left
    packed = packed_sheet(sheet)
    assert len(packed) <= LONGEST_PACKED
    assert unpacked_sheet(packed) == sheet
    assert sheet_of_text(sheet_text(sheet)) == sheet
    most = len(zlib.compress(bytes(4 * MOST_CHARACTERS + 110 * MOST_LINES), 0))  # nothing compressed at all
    assert most * 4 / 3 <= LONGEST_PACKED


def test_names_of_sliders_count() -> None:
    for names in (["a" * (LONGEST_LINE + 1)], [f"a{k}" * 100 for k in range(20)]):
        with pytest.raises(HelicoideError):
            Sheet(sliders=tuple((name, NameSlider()) for name in names))


def bomb() -> str:
    return urlsafe_b64encode(zlib.compress(b"1\n" * 10_000_000, 9)).decode().rstrip("=")


@pytest.mark.parametrize(
    "packed",
    ["", "!!!", "AAAA", "nothing", "A" * 100_000, "é", bomb(), packed_sheet(Sheet((SheetLine("e1"),)))[:-4],
     urlsafe_b64encode(zlib.compress(b"\xff\xfe")).decode(), urlsafe_b64encode(zlib.compress(b"e1") + b"!").decode()],
    ids=range(10),
)  # fmt: skip
def test_what_is_no_packed_sheet_is_refused_in_words(packed: str) -> None:
    with pytest.raises(HelicoideError) as refused:
        unpacked_sheet(packed)
    assert refused.value.text.en
    assert refused.value.text.pt_BR


@pytest.mark.parametrize(
    "text",
    [
        "slider a = nan from 0 to 1",
        "slider a = 2 from 0 to 1",
        "slider a = 0 from 0 to 0",
        "slider a = 0 from 0 to 5e-324",
        "slider a = 0 from -inf to 1",
        "slider a = 0 from 0 to 1e99",
        "slider a b",
        "slider __a = 0 from 0 to 1",
        "e1\n" * (MOST_LINES + 1),
        "e" * (LONGEST_LINE + 1),
        ("e1+" * 100 + "\n") * 20,
    ],
)
def test_a_wrong_text_is_refused_in_words(text: str) -> None:
    with pytest.raises(HelicoideError):
        sheet_of_text(text)


def test_a_file_that_is_no_text_is_refused_in_words() -> None:
    with pytest.raises(HelicoideError, match="UTF-8"):
        sheet_of_file(b"\xff\xfe\x00")
