"""Sheets as text, as files and as links: they come back as they were, and hostile ones are refused in words."""

from __future__ import annotations

import zlib
from base64 import urlsafe_b64encode

import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.sheet import (
    LINK,
    LONGEST_LINE,
    MOST_CHARACTERS,
    MOST_LINES,
    NameSlider,
    Sheet,
    SheetLine,
    sheet_link,
    sheet_of_file,
    sheet_of_link,
    sheet_of_text,
    sheet_text,
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
    assert sheet_of_link(sheet_link(sheet)) == sheet
    assert sheet_of_link(f"http://127.0.0.1:8080/#{sheet_link(sheet)}") == sheet


def test_a_link_needs_no_escapes_and_is_short() -> None:
    sheet = Sheet(tuple(SheetLine(f"p{k} = point({k}, 0, 0)") for k in range(30)))
    link = sheet_link(sheet)
    assert set(link.removeprefix(LINK)) <= set("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_")
    assert len(link) < len(sheet_text(sheet)) / 2


def bomb() -> str:
    return LINK + urlsafe_b64encode(zlib.compress(b"1\n" * 50_000_000, 9)).decode()[: 4 * MOST_CHARACTERS]


@pytest.mark.parametrize(
    "link",
    ["", "sheet=", "sheet=!!!", "sheet=AAAA", "nothing", "sheet=" + "A" * 100_000, "sheet=é", bomb(),
     sheet_link(Sheet((SheetLine("e1"),)))[:-4], LINK + urlsafe_b64encode(zlib.compress(b"\xff\xfe")).decode()],
    ids=range(10),
)  # fmt: skip
def test_a_hostile_link_is_refused_in_words(link: str) -> None:
    with pytest.raises(HelicoideError) as refused:
        sheet_of_link(link)
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
