"""The tab of charts: signals and their bands while the arm moves, pause, file, diagram of the loop, matrices."""

from __future__ import annotations

import csv
import io
from unittest.mock import patch

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from tests.browser.lab import Lab, press, tab, until

from helicoide import gate
from helicoide.readout.signal_history import SignalHistory
from helicoide.readout.signals import signals_of
from helicoide.seat import ChartChoice
from helicoide.view.signal_rows import FILE, with_charts

# Pixels of a chart's canvas that have about a colour.
COUNT = """([chart, red, green, blue]) => { const canvas = document.querySelectorAll('.uplot canvas')[chart];
  if (!canvas?.width) return 0;
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height); let found = 0;
  for (let i = 0; i < data.length; i += 4) found += data[i + 3] > 20 &&
    Math.abs(data[i] - red) + Math.abs(data[i + 1] - green) + Math.abs(data[i + 2] - blue) < 40; return found }"""
# Press and release the pointer on a number of the diagram.
PRESS = """words => { const number = document.querySelector(`[data-helicoide-press="${words}"]`);
  number.scrollIntoView({ block: 'center' }); const { x, y, width, height } = number.getBoundingClientRect();
  const at = { clientX: x + width / 2, clientY: y + height / 2, bubbles: true };
  for (const what of ['pointerdown', 'pointerup'])
    document.elementFromPoint(at.clientX, at.clientY).dispatchEvent(new PointerEvent(what, at)) }"""
ORANGE, BLUE = (213, 94, 0), (31, 119, 180)


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    tab(shared_page, "Charts")
    visitor = list(lab.session.visitors.values())[-1]
    fresh = vars(ChartChoice())
    lab.session.loop.call_soon_threadsafe(visitor.reseat, lambda seat: with_charts(seat, **fresh))
    until(shared_page, lambda: visitor.place.seat.charts == ChartChoice())
    expect(shared_page.get_by_text("Choose a group of signals.")).to_be_visible()
    return shared_page


def history(lab: Lab) -> SignalHistory:
    return list(lab.session.visitors.values())[-1].history


def choose(page: Page, label: str, option: str) -> None:
    page.get_by_role("combobox", name=label, exact=True).click()
    page.get_by_role("option", name=option, exact=True).click()


def send_away(lab: Lab) -> None:
    """Set a target 50 mm away, on the side of the farther wall."""
    T = lab.state.T_world_tool
    away = np.array([0.0, -0.05 if T[1, 3] > 0.0 else 0.05, 0.0])
    lab.post(gate.set_target(T[:3, 3] + away, [1.0, 0.0, 0.0, 0.0]))


def move(lab: Lab, page: Page) -> None:
    """Move the arm until several of its states are sampled."""
    before = len(history(lab).times)
    send_away(lab)
    until(page, lambda: len(history(lab).times) > before + 5)


def test_a_group_is_drawn_with_its_bands_and_can_be_paused(lab: Lab, page: Page) -> None:
    choose(page, "Signals", "Distances")
    move(lab, page)
    expect(page.locator(".uplot")).to_have_count(2)
    expect(page.get_by_text("Least distance to each plane").first).to_be_visible()
    until(page, lambda: page.evaluate(COUNT, [0, *BLUE]) > 20)
    assert page.evaluate(COUNT, [0, *ORANGE]) > 200
    expect(page.locator(".uplot").first.get_by_text("safety distance").first).to_be_visible()
    press(page, "Pause charts")
    expect(page.get_by_role("button", name="Resume charts")).to_be_visible()
    kept, t = history(lab), lab.state.t
    lab.post(gate.set_target(lab.state.T_world_tool[:3, 3] - np.array([0.0, 0.05, 0.0]), [1.0, 0.0, 0.0, 0.0]))
    until(page, lambda: lab.state.t > t + 0.5)
    assert history(lab) is kept
    press(page, "Resume charts")
    move(lab, page)


def test_the_saved_file_has_the_values_of_the_state(lab: Lab, page: Page) -> None:
    choose(page, "Signals", "Distances")
    move(lab, page)
    until(page, lambda: not lab.state.arm.moving and lab.state.t - history(lab).times[-1] < 0.06)
    press(page, "Pause charts")
    expect(page.get_by_role("button", name="Resume charts")).to_be_visible()
    with patch.object(lab.windows[-1].client, "send_file_download") as sent:
        press(page, "Save charts as CSV")
        until(page, lambda: sent.call_count == 1)
    name, content = sent.call_args.args
    assert name == FILE
    rows = list(csv.DictReader(io.StringIO(content.decode("utf-8-sig"), newline="")))
    kept = history(lab)
    np.testing.assert_array_equal([float(row["t [s]"]) for row in rows], kept.times[kept.since(20.0)])
    values = signals_of(lab.state)["planes"].read(lab.state)
    for pane, value in zip(lab.state.problem.planes.panes, values, strict=True):
        assert float(rows[-1][f"Least distance to each plane: {pane.title.en} [mm]"]) == pytest.approx(value, abs=0.5)


def test_a_phase_plane_is_a_figure_and_two_methods_share_a_chart(lab: Lab, page: Page) -> None:
    lab.post(gate.choose_method("filtered"))
    lab.post(gate.compare_with("damped"))
    choose(page, "Signals", "Filter")
    move(lab, page)
    expect(
        page.locator(".helicoide-chart").filter(has_text="Phase plane dᵢ × σᵢ").locator("svg[role=img]")
    ).to_be_visible()
    choose(page, "Signals", "Errors")
    move(lab, page)
    legend = page.locator(".uplot .u-legend").first
    expect(legend.get_by_text("eₚ, damped least squares")).to_be_visible()
    expect(legend.get_by_text("eₚ, filtered inverse")).to_be_visible()


def test_a_number_of_the_loop_adds_its_signal_to_the_charts(lab: Lab, page: Page) -> None:
    shown = list(lab.session.visitors.values())[-1].place
    page.get_by_label("Show the diagram").check()
    loop = page.locator(".helicoide-loop")
    expect(loop.get_by_text("constrained QP step")).to_be_visible()
    lab.post(gate.choose_method("filtered"))
    expect(loop.get_by_text("q̇ = Θ ν")).to_be_visible()
    page.evaluate(PRESS, "Position error")
    until(page, lambda: "position error" in shown.seat.charts.shown)
    page.get_by_role("button", name="Add a signal of the loop to the charts").click()
    press(page, "Joint velocity")
    until(page, lambda: "speed" in shown.seat.charts.shown)
    before = loop.inner_text()
    move(lab, page)
    until(page, lambda: loop.inner_text() != before)


def test_a_matrix_is_shown_as_it_is_now(lab: Lab, page: Page) -> None:
    choose(page, "Matrix", "H, pose of the end effector")
    table = page.locator(".helicoide-matrix")
    expect(table.locator("tr")).to_have_count(5)
    cell = table.locator("tr").nth(2).locator("td").last
    until(page, lambda: abs(float(cell.inner_text().replace("−", "-")) - 1000 * lab.state.T_world_tool[1, 3]) < 0.1)
    before = lab.state.T_world_tool[1, 3]
    send_away(lab)
    until(page, lambda: abs(lab.state.T_world_tool[1, 3] - before) > 0.02)
    until(page, lambda: abs(float(cell.inner_text().replace("−", "-")) - 1000 * lab.state.T_world_tool[1, 3]) < 0.1)
