"""Record the arm on the page, move through the recording, replay it, take it home; two windows see the same."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from playwright.sync_api import Download, Page, expect
from tests.browser.conftest import OpenPage
from tests.browser.lab import Lab, press, tab, until

from helicoide import content, gate
from helicoide.command import Replay
from helicoide.recorder.panel_state import RecordingPanelState
from helicoide.recorder.replay import REPLAYED
from helicoide.view.layers.recorded import RecordedLayer


@pytest.fixture(scope="module", autouse=True)
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder of the user that is empty at first."""
    mine = tmp_path_factory.mktemp("user")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(content, "user_folder", lambda: mine)
        yield mine / "recordings"


def panel_of(lab: Lab) -> RecordingPanelState:
    """What the first window looks at."""
    return next(iter(lab.session.visitors.values())).place.recordings


def layer_of(lab: Lab) -> RecordedLayer:
    layers = lab.windows[0].layers
    assert layers is not None
    layer: Any = layers.layers["recorded"]
    return layer  # type: ignore[no-any-return]


def record_a_turn(lab: Lab, page: Page, angle: float) -> str:
    """Record the arm while its first joint turns; the name of the file."""
    tab(page, "Charts")
    press(page, "Record the arm")
    until(page, lambda: lab.cell.recorder is not None and lab.cell.recorder.running)
    lab.post(gate.set_joint(0, angle))
    until(page, lambda: abs(lab.state.arm.q[0] - angle) < 1e-3)
    until(page, lambda: lab.cell.resting)
    press(page, "End recording")
    return until_listed(lab, page)


def until_listed(lab: Lab, page: Page) -> str:
    """Wait until the last recording is in the list; the name of its file."""
    recorder = lab.cell.recorder
    assert recorder is not None
    until(page, lambda: recorder.path.name in {file.name for file in panel_of(lab).files})
    return recorder.path.name


def open_recording(lab: Lab, page: Page, name: str) -> None:
    option = page.get_by_role("option", name=name)
    page.locator("input[role=combobox]:visible").and_(page.get_by_label("Recordings", exact=True)).click()
    option.click()
    until(page, lambda: panel_of(lab).shown is not None)
    expect(page.get_by_role("button", name="Replay on the arm")).to_be_visible()


def saved(page: Page, button: str) -> bytes:
    with page.expect_download() as waiting:
        press(page, button)
    download: Download = waiting.value
    return Path(download.path()).read_bytes()


def test_record_scrub_replay_and_save(lab: Lab, shared_page: Page, folder: Path) -> None:
    page, before = shared_page, lab.state.arm.q
    name = record_a_turn(lab, page, 0.2)
    open_recording(lab, page, name)
    resting, layer = lab.state.arm.q, layer_of(lab)

    shown = panel_of(lab).shown
    assert shown is not None
    slider = page.get_by_role("slider").locator("visible=true").first
    slider.focus()
    slider.press("End")
    until(page, lambda: panel_of(lab).instant > shown.recording.duration - 0.05)
    slider.press("Home")
    until(page, lambda: panel_of(lab).instant == 0.0)
    assert layer.outline is not None
    assert layer.outline.shown
    np.testing.assert_allclose(shown.samples.q_at(0.0), before, atol=1e-12)
    assert (lab.state.arm.q == resting).all()

    press(page, "Play as an outline")
    until(page, lambda: panel_of(lab).instant == shown.recording.duration)
    assert (lab.state.arm.q == resting).all()

    press(page, "Replay on the arm")
    until(page, lambda: isinstance(lab.state.request.command, Replay))
    assert lab.state.request.command.title == REPLAYED.format(title=name)  # type: ignore[union-attr]
    until(page, lambda: not isinstance(lab.state.request.command, Replay))
    np.testing.assert_allclose(lab.state.arm.q, shown.samples.q[-1], atol=1e-3)

    csv_rows = list(csv.DictReader(io.StringIO(saved(page, "Save recording as CSV").decode())))
    mcap = saved(page, "Save recording as MCAP")
    assert mcap == (folder / name).read_bytes()
    messages = [m for _, _, m in make_reader(io.BytesIO(mcap)).iter_messages("/joint_states")]
    assert len(messages) == len(csv_rows) == len(shown.samples.times)
    assert float(csv_rows[-1]["q J1"]) == shown.samples.q[-1, 0]


def test_a_stop_ends_a_replay_and_leaves_the_recording(lab: Lab, shared_page: Page) -> None:
    page = shared_page
    open_recording(lab, page, record_a_turn(lab, page, -0.2))
    press(page, "Replay on the arm")
    until(page, lambda: isinstance(lab.state.request.command, Replay))
    page.keyboard.press("Escape")
    until(page, lambda: not isinstance(lab.state.request.command, Replay))
    assert panel_of(lab).shown is not None


def test_two_windows_see_that_the_arm_is_recorded(lab: Lab, shared_page: Page, open_page: OpenPage) -> None:
    """The other window ends the recording; it looks at none itself."""
    other = open_page(lab.port)
    tab(other, "Charts")
    tab(shared_page, "Charts")
    press(shared_page, "Record the arm")
    expect(other.get_by_role("button", name="End recording")).to_be_visible()
    expect(other.locator(".helicoide-recording")).to_be_visible()
    lab.post(gate.set_joint(0, 0.15))
    until(shared_page, lambda: abs(lab.state.arm.q[0] - 0.15) < 1e-3)
    press(other, "End recording")
    expect(shared_page.get_by_role("button", name="Record the arm")).to_be_visible()
    name = until_listed(lab, shared_page)
    open_recording(lab, shared_page, name)
    assert list(lab.session.visitors.values())[-1].place.recordings.chosen == ""


def test_another_arm_ends_the_recording_and_hides_the_open_one(lab: Lab, shared_page: Page) -> None:
    page = shared_page
    open_recording(lab, page, record_a_turn(lab, page, 0.1))
    press(page, "Record the arm")
    until(page, lambda: lab.cell.recorder is not None and lab.cell.recorder.running)
    lab.change("planar3r")
    expect(page.get_by_text("The recording has ended: another arm was loaded.")).to_be_visible()
    expect(page.get_by_role("button", name="Replay on the arm")).to_have_count(0)
    expect(page.get_by_text("is of the arm movemaster")).to_be_visible()
    lab.change("movemaster")
    expect(page.get_by_role("button", name="Replay on the arm")).to_be_visible()


def test_a_file_that_cannot_be_read_is_refused_in_words(lab: Lab, shared_page: Page, tmp_path: Path) -> None:
    page, foreign = shared_page, tmp_path / "notes.mcap"
    foreign.write_text("no recording")
    tab(page, "Charts")
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Open a recording").click()
    chooser.value.set_files(foreign)
    expect(page.get_by_text("notes.mcap cannot be read: it is damaged, or no .mcap")).to_be_visible()


def test_a_recording_is_opened_from_a_file_and_deleted_from_the_folder(
    lab: Lab, shared_page: Page, folder: Path, tmp_path: Path
) -> None:
    page = shared_page
    name = record_a_turn(lab, page, 0.2)
    mine = tmp_path / "mine.mcap"
    mine.write_bytes((folder / name).read_bytes())
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Open a recording").click()
    chooser.value.set_files(mine)
    until(page, lambda: panel_of(lab).chosen == "mine.mcap" and panel_of(lab).shown is not None)
    expect(page.get_by_role("button", name="Delete this recording")).to_be_hidden()
    open_recording(lab, page, name)
    press(page, "Delete this recording")
    until(page, lambda: not (folder / name).exists() and panel_of(lab).chosen == "")
