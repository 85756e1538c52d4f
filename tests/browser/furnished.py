"""A lab in which every panel has something to show, and its folders are open: for tests of what a page looks like."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from playwright.sync_api import Page
from tests.browser.lab import Lab, until

from helicoide import gate
from helicoide.seat import Seat, Selection
from helicoide.session.postures import to_singular_posture
from helicoide.session.visitor import Visitor
from helicoide.sheet import Sheet, SheetLine
from helicoide.studies import panel_state
from helicoide.view.layers import playground
from helicoide.view.requests import ForStudyPanel, OpenRecording, PageRequest, RecordArm
from helicoide.view.signal_rows import with_charts

SHEET = Sheet(
    tuple(map(SheetLine, ("p = M_tool >> point(0, 0, 0.1)", "exp(0.5*phi*L1) >> p", "distance(tool, ceiling)")))
)
STUDY = "cerbaro_orca_circle"
# Press the headings of folded folders, also in folders that are folded, each once; gives how many are still folded.
UNFOLD = """() => { const folded = [...document.querySelectorAll('.mantine-Paper-root .tabler-icon-chevron-down')]
  .map(icon => icon.closest('.mantine-Paper-root[style*="cursor: pointer"]')).filter(one => one);
  for (const one of folded) if (!one.unfolds) { one.unfolds = true; one.click() } return folded.length }"""


def visitor(lab: Lab) -> Visitor:
    """The newest window with its place."""
    return list(lab.session.visitors.values())[-1]


def reseat(lab: Lab, update: Callable[[Seat], Seat]) -> None:
    """Change the seat of the newest window without the page."""
    lab.session.loop.call_soon_threadsafe(visitor(lab).reseat, update)


def ask(lab: Lab, request: PageRequest) -> None:
    """Make a request as the newest window, without its page."""
    lab.session.loop.call_soon_threadsafe(lab.session.requests.do, visitor(lab), request)


def furnish(lab: Lab, page: Page) -> None:
    """Compare two methods on a way through a singular posture, record it, and choose what panels show on request."""
    reseat(lab, _with_all_shown)
    until(page, lambda: visitor(lab).place.seat.sheet == SHEET)
    lab.post(gate.choose_method("filtered"))
    lab.post(gate.compare_with("damped"))
    ask(lab, RecordArm(True))
    until(page, lambda: lab.cell.recorder is not None and lab.cell.recorder.running)
    lab.post(to_singular_posture(lab.state))
    until(page, lambda: lab.state.compared is not None and len(lab.state.compared.trace.times) > 1)
    until(page, lambda: len(visitor(lab).history.times) > 5)
    ask(lab, RecordArm(False))
    recorder = lab.cell.recorder
    assert recorder is not None
    until(page, lambda: recorder.path.name in {file.name for file in visitor(lab).place.recordings.files})
    ask(lab, OpenRecording(recorder.path.name))
    until(page, lambda: visitor(lab).place.recordings.shown is not None)
    ask(lab, ForStudyPanel(panel_state.with_study(STUDY)))


def _with_all_shown(seat: Seat) -> Seat:
    inspecting = replace(seat.inspecting(Selection("link", 2)), coefficient="e1e")
    charted = with_charts(inspecting, shown=("planes", "singular values"), loop=True, matrix="J")
    return replace(charted.with_layer(playground.NAME, True), sheet=SHEET, stages="dh")


def unfold(page: Page) -> None:
    """Open all folders, also those inside others."""
    until(page, lambda: page.evaluate(UNFOLD) == 0)
    page.wait_for_timeout(300)
    until(page, lambda: page.evaluate(UNFOLD) == 0)
