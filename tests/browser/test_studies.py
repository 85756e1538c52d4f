"""A study on a page: chosen, run, compared with the source and with a previous run, replayed on the arm."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, speak, status, tab, until
from tests.browser.test_methods import choose

from helicoide import studies
from helicoide.command import Replay
from helicoide.studies.panel_state import CompletedRun, StudyPanelState
from helicoide.text import LANGUAGES
from helicoide.view.panels import study
from helicoide.view.panels.study import studies_by_source

NAME = "cerbaro_orca_circle"


@pytest.fixture
def page(shared_page: Page) -> Iterator[Page]:
    tab(shared_page, "Study")
    yield shared_page
    tab(shared_page, "Robot")


def desk(lab: Lab) -> StudyPanelState:
    (found,) = {visitor.place.study_panel for visitor in lab.session.visitors.values()}
    return found


def test_a_study_is_run_read_compared_and_played(lab: Lab, page: Page) -> None:
    choose(page, "Study", dict(studies_by_source())[NAME].en)
    until(page, lambda: desk(lab).study == NAME)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).last is not None, 300)
    rows = page.locator(".helicoide-study tr")
    until(page, lambda: rows.count() > 1)
    assert "✗" not in page.locator(".helicoide-study").inner_text()
    until(page, lambda: page.locator(".uplot").count() >= 1)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).previous is not None, 300)
    page.get_by_label("Compare with previous run").click()
    until(page, lambda: "previous" in page.locator(".helicoide-study").inner_text())
    last = desk(lab).last
    assert last is not None
    page.get_by_role("button", name=last.result.motions[0].title.en).click()
    until(page, lambda: lab.state.robot.name == studies.study_named(NAME).ROBOT)
    until(page, lambda: isinstance(lab.state.request.command, Replay) and lab.state.request.command.s > 0.3)
    until(page, lambda: "Playing the study" in status(page))
    assert page.locator(".uplot").count() >= 1
    page.keyboard.press("Escape")
    until(page, lambda: not isinstance(lab.state.request.command, Replay))


def test_a_run_can_be_ended(lab: Lab, page: Page) -> None:
    choose(page, "Study", dict(studies_by_source())["cerbaro_confined_circle"].en)
    page.get_by_label("Quick run").click()
    until(page, lambda: not desk(lab).short)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).progress is not None)
    page.get_by_role("button", name="End run").click()
    until(page, lambda: desk(lab).progress is None)
    page.get_by_label("Quick run").click()
    until(page, lambda: desk(lab).short)
    assert desk(lab).last is None or desk(lab).last.study == NAME  # type: ignore[union-attr]


@pytest.fixture(scope="module")
def runs() -> tuple[CompletedRun, ...]:
    """Runs of a study with long texts and numbers as small as 1e-14, and of one whose curves are not functions of x."""
    found = {name: studies.study_named(name) for name in ("coutinho_s1", "cerbaro_confined_line")}
    return tuple(CompletedRun(n, s.Options(), True, s.run(s.Options(), True, lambda _: None)) for n, s in found.items())


def show(lab: Lab, page: Page, run: CompletedRun, compared: bool) -> None:
    """Show a run in the study panel of the newest window, and wait until it is complete."""
    place = list(lab.session.visitors.values())[-1].place
    put = StudyPanelState(study=run.study, last=run, previous=run, compares_previous=compared)
    lab.session.loop.call_soon_threadsafe(lab.session.studies._put, place, put)
    rows, charts = page.locator(".helicoide-study .quantity"), page.locator("figcaption:visible")
    until(page, lambda: rows.count() == len(run.result.rows))
    until(page, lambda: charts.count() == len(run.result.charts))
    until(page, lambda: page.evaluate(BLANK) == 0)


@pytest.mark.parametrize("size", ["desk", "phone"])
def test_nothing_of_a_result_is_cut_and_no_chart_is_blank(
    lab: Lab, browser: Browser, runs: tuple[CompletedRun, ...], size: str
) -> None:
    with window(browser, lab.port, size) as page:
        for language in LANGUAGES:
            speak(lab, page, language)
            page.get_by_role("tab", name=study.TITLE[language]).click()
            for run in runs:
                for compared in (False, True):
                    show(lab, page, run, compared)
                    assert page.evaluate(CUT) == []
            assert page.locator(".helicoide-chart polyline").count() > 0


CUT = """() => [...document.querySelectorAll('.helicoide-study, .helicoide-study td, .helicoide-chart *, .u-legend')]
  .filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth || e.getBoundingClientRect().right > innerWidth)
  .map(e => e.outerHTML.slice(0, 80))"""
BLANK = """() => [...document.querySelectorAll('.uplot canvas')].filter(c => {
  if (!c.width) return true;
  const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  for (let i = 0; i < d.length; i += 4)
    if (d[i + 3] > 200 && Math.max(d[i], d[i + 1], d[i + 2]) - Math.min(d[i], d[i + 1], d[i + 2]) > 60) return false;
  return true;
}).length"""
