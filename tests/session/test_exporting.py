"""Files that a page asks for: made outside the event loop, one at a time, and never at the cost of the lab."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import numpy as np
import pytest
from tests.pages import Hand, Message
from tests.session.labs import eventually, running, state, window

from helicoide.session import exporting
from helicoide.session.display import CLIP_SECONDS
from helicoide.session.exporting import BUSY, MOST_FRAMES, UNDRAWN, motion_states
from helicoide.session.lab import Lab
from helicoide.studies.study import Motion
from helicoide.view import picture

NOTEBOOK, CLIP, PICTURE = "Jupyter notebook of this scene", "Clip of the last seconds", "Picture (PNG)"


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    with running() as lab:
        yield lab


@pytest.fixture
def hand(lab: Lab) -> Iterator[Hand]:
    hand = window(lab)
    yield hand
    hand.close()
    assert eventually(lambda: not lab.visitors)


def downloads(hand: Hand) -> list[Message]:
    """The files that the page is told to download from now on."""
    begun: list[Message] = []

    def heard(message: Message) -> None:
        if message["type"] == "FileTransferStartDownload":
            begun.append(message)

    hand.page.heard = heard
    return begun


def test_a_notebook_and_a_clip_are_downloaded(hand: Hand) -> None:
    files = downloads(hand)
    for count, button in enumerate((NOTEBOOK, CLIP), 1):
        hand.do(hand.page.press(button))
        assert eventually(lambda count=count: len(files) == count)
    assert [file["filename"] for file in files] == ["helicoide.ipynb", "helicoide.html"]
    assert 1_000 < files[0]["size_bytes"] < 100_000
    assert 900_000 < files[1]["size_bytes"] < 4_000_000


def test_what_was_drawn_is_kept_for_some_seconds_only(lab: Lab, hand: Hand) -> None:
    assert eventually(lambda: lab.shared.display is not None)
    for target in (10.0, -10.0, 0.0):
        hand.do(hand.page.give("1 waist", target))
        assert eventually(lambda target=target: abs(np.degrees(state(lab).arm.q[0]) - target) < 0.1)
    display = lab.shared.display
    assert display is not None
    times = [one.t for one in display.recent]
    assert len(times) > 3
    assert times == sorted(times)
    assert times[-1] - times[0] <= CLIP_SECONDS
    assert len({id(one.arm.q) for one in display.recent}) > 3


def test_a_page_that_draws_nothing_is_told_so(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    """As does a tab in the background, or a browser without WebGL. Everything else goes on."""
    monkeypatch.setattr(picture, "PATIENCE", 0.5)
    hand.do(hand.page.press(PICTURE))
    assert eventually(lambda: UNDRAWN.en in hand.page.told)
    files = downloads(hand)
    hand.do(hand.page.press(NOTEBOOK))
    assert eventually(lambda: len(files) == 1)


def test_a_second_request_waits_for_no_one(lab: Lab, hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    """While a file is made, another one is refused, the loop is free, and Stop works."""
    made = threading.Event()
    monkeypatch.setattr(exporting, "scene_notebook", lambda state, language: made.wait(60) and b"{}")
    files = downloads(hand)
    hand.do(hand.page.press(NOTEBOOK))
    hand.do(hand.page.press(CLIP))
    assert eventually(lambda: BUSY.en in hand.page.told)
    assert hand.do(hand.page.stop()) < 5.0
    assert not files
    made.set()
    assert eventually(lambda: [file["filename"] for file in files] == ["helicoide.ipynb"])


def test_a_window_that_closes_meanwhile_leaves_nothing_behind(lab: Lab, caplog: pytest.LogCaptureFixture) -> None:
    hand = window(lab)
    hand.do(hand.page.press(PICTURE))
    assert eventually(lambda: bool(lab.requests.exporting._tasks))
    hand.close()
    assert eventually(lambda: not lab.requests.exporting._tasks)
    assert not [record for record in caplog.records if record.name == "helicoide"]


def test_a_file_that_cannot_be_made_is_refused_in_words(hand: Hand, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> bytes:
        raise ValueError("a mistake of ours")

    monkeypatch.setattr(exporting, "clip_html", broken)
    hand.do(hand.page.press(CLIP))
    assert eventually(lambda: exporting.FAILED.en in hand.page.told)


def test_a_motion_as_states_of_its_own_robot() -> None:
    times, q = np.array([3.0, 4.0, 5.0]), np.array([[0.0, 0.0], [0.5, 0.2], [0.0, 0.4]])
    states = motion_states(Motion("planar2r", times, q))
    assert states[0].robot.name == "planar2r"
    assert (states[0].t, states[-1].t) == (0.0, 2.0)
    np.testing.assert_allclose(states[-1].arm.q, q[-1])
    middle = min(states, key=lambda one: abs(one.t - 1.0))
    np.testing.assert_allclose(middle.arm.q, q[1], atol=0.03)
    long = motion_states(Motion("planar2r", 1000.0 * times, q))
    assert len(long) == MOST_FRAMES
    assert long[-1].t == 2000.0
