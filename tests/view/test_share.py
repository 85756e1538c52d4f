"""A link to a view: what was shared is read again, and whatever else is refused in words."""

from __future__ import annotations

import zlib
from base64 import urlsafe_b64encode
from dataclasses import replace
from urllib.parse import quote

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from helicoide import content
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.seat import LinkedPosture
from helicoide.sheet import LONGEST_PACKED, NameSlider, Sheet, SheetLine
from helicoide.text import HelicoideError
from helicoide.view import panels
from helicoide.view.channel import LONGEST_ADDRESS
from helicoide.view.serve import CHANNEL_BYTES
from helicoide.view.share import LONGEST_LINK, MOST_JOINTS, SharedView, decode_link, encode_link

places = arrays(np.float64, 3, elements=st.floats(-100, 100))
GOOD = "v=1&robot=movemaster&q=0,0.5,-1,0,0&camera=1,2,3,0,0,0&tab=algebra&end=1"
SHEET = Sheet((SheetLine("p = point(a, 0, 0)"), SheetLine("L2", shown=False)), (("a", NameSlider(0.3, 0.0, 1.0)),))
ALONE = encode_link(SHEET)
BOTH = GOOD.replace("&end=1", f"&{ALONE}&end=1")


def bomb() -> str:
    """A sheet of 20 MB in 20 kB."""
    return urlsafe_b64encode(zlib.compress(b"1\n" * 10_000_000, 9)).decode().rstrip("=")


@given(
    q=st.lists(st.floats(-6.3, 6.3), min_size=1, max_size=12),
    eye=places,
    away=st.floats(0.01, 10),
    robot=st.sampled_from(sorted(robot_titles())),
    tab=st.integers(0, len(panels.all_panels()) - 1),
)
def test_what_is_shared_is_read_again(q: list[float], eye: np.ndarray, away: float, robot: str, tab: int) -> None:
    text = encode_link(SharedView(LinkedPosture(robot, tuple(q)), (eye, eye + away), tab))
    assert len(text) < LONGEST_LINK
    read = decode_link(text)
    assert (read.posture.robot, read.tab) == (robot, tab)
    np.testing.assert_allclose(read.posture.q, q, rtol=1e-5, atol=1e-300)
    np.testing.assert_allclose(read.camera, (eye, eye + away), rtol=1e-5, atol=1e-300)


def test_every_arm_fits_in_a_link() -> None:
    for name in robot_titles():
        posture = LinkedPosture(name, tuple(load_robot(name).poses["ready"].tolist()))
        text = encode_link(SharedView(posture, (np.ones(3), np.zeros(3)), 0))
        assert decode_link(text).posture.q == pytest.approx(posture.q, abs=1e-5)


def test_a_sheet_travels_with_the_view_or_alone() -> None:
    shown = SharedView(LinkedPosture("movemaster", (0.0, 0.5, -1.0, 0.0, 0.0)), (np.ones(3), np.zeros(3)), 0, SHEET)
    for shared in (shown, replace(shown, sheet=Sheet())):
        read = decode_link(encode_link(shared))
        assert isinstance(read, SharedView)
        assert read.sheet == shared.sheet
    assert "sheet" not in encode_link(replace(shown, sheet=Sheet()))
    assert decode_link(ALONE) == SHEET


def test_the_longest_sheet_fits_beside_the_longest_view() -> None:
    """And into what the page cuts it to, and into one message of its channel."""
    page = (content.STATIC / "helicoide.js").read_text("utf-8")
    assert f"const LONGEST_LINK = {LONGEST_LINK};" in page
    numbers = ",".join(["-12345.6e-308"] * (MOST_JOINTS + 6))
    longest = max(len(quote(name)) for name in robot_titles()) + len(numbers) + len(GOOD) + LONGEST_PACKED
    assert longest < LONGEST_LINK
    assert LONGEST_LINK + 6 * LONGEST_ADDRESS < CHANNEL_BYTES


@pytest.mark.parametrize("whole", [GOOD, ALONE, BOTH], ids=["view", "sheet", "both"])
def test_a_link_that_was_cut_is_refused(whole: str) -> None:
    for length in range(len(whole)):
        with pytest.raises(HelicoideError):
            decode_link(whole[:length])


@pytest.mark.parametrize(
    ("part", "value"),
    [
        ("robot", "../../etc/passwd"),
        ("robot", "<img src=x onerror=alert(1)>"),
        ("robot", ""),
        ("q", "nan,0,0,0,0"),
        ("q", "1e999,0,0,0,0"),
        ("q", "1e5,0,0,0,0"),
        ("q", ""),
        ("q", ",".join(["0"] * 41)),
        ("q", "٣,0"),
        ("q", "__import__('os')"),
        ("camera", "1,2,3"),
        ("camera", "1,1,1,1,1,1"),
        ("camera", "inf,2,3,0,0,0"),
        ("tab", "__init__"),
        ("tab", "-1"),
        ("v", "2"),
        ("end", "0"),
    ],
)
def test_a_hostile_part_is_refused_in_words(part: str, value: str) -> None:
    parts = dict(pair.split("=") for pair in GOOD.split("&"))
    with pytest.raises(HelicoideError) as refusal:
        decode_link("&".join(f"{key}={quote(value if key == part else old)}" for key, old in parts.items()))
    assert refusal.value.text.en != refusal.value.text.pt_BR
    assert "<img" not in refusal.value.text.en


@pytest.mark.parametrize(
    "text",
    [
        "",
        "#",
        "end=1",
        GOOD + GOOD,
        GOOD + "&q=1",
        "q=1&" * 5000,
        "x" * 10_000,
        GOOD + "&sheet=1",
        GOOD.replace("&end=1", "&sheet=1&end=1"),
        GOOD.replace("&end=1", "&sheet=&end=1"),
        GOOD.replace("&end=1", f"&sheet={bomb()}&end=1"),
        BOTH.replace("&end=1", f"&{ALONE}&end=1"),
        BOTH + "&" + ALONE,
        f"{ALONE}&{ALONE}",
        f"{ALONE}&" + "&".join(f"x{k}=1" for k in range(10)),
        ALONE + "&end=1",
        ALONE + "A" * LONGEST_LINK,
        f"sheet={bomb()}",
        "sheet=",
        "sheet",
        "%ff%00=1",
        "&" * 300,
    ],
)
def test_a_hostile_link_is_refused_in_words(text: str) -> None:
    with pytest.raises(HelicoideError):
        decode_link(text)


@given(text=st.text(max_size=300))
def test_any_text_is_read_or_refused(text: str) -> None:
    with pytest.raises(HelicoideError):
        decode_link(text)
