"""What each tab of the panel costs in an update while the arm moves, at most five times a second for each window."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from time import thread_time_ns
from types import ModuleType

import viser
from tests.benchmarks.report import p50, verdict

from helicoide import content, gate
from helicoide.advance import advance
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY
from helicoide.readout.signals import needed_signals
from helicoide.seat import Seat, Selection
from helicoide.session.preparing import TICK, exercise, rehearse
from helicoide.sheet import with_entered_line
from helicoide.state import State, initial_state
from helicoide.view import panels
from helicoide.view.placed_rows import place_rows
from helicoide.view.signal_rows import with_chart, with_charts
from helicoide.view.window import new_seat
from helicoide.view.window_view import View

TITLE = "Tabs of the panel, ms per update while the arm moves"
UPDATES, EVERY, GOAL = 20, 20, 50.0
LINES = ("p = M_tool >> point(0, 0, 0.1)", "log(M_tool)", "exp(0.5*theta*L1) >> p")
CHARTS = ("positions", "speeds", "singular values", "manipulability")


def busy_seat() -> Seat:
    """A seat with three lines in the console, the tool's motor and a coefficient selected, four charts and J shown."""
    seat = new_seat("", "en", None)
    for line in LINES:
        seat = replace(seat, sheet=with_entered_line(seat.sheet, line))
    for k, name in enumerate(CHARTS):
        seat = with_chart(seat, k, name)
    return replace(with_charts(seat, matrix="J"), selected=Selection("tool"), coefficient="e1e2")


def _motion(robot: Robot) -> Iterator[State]:
    """A state for each update, while the first joint moves."""
    state = initial_state(robot)
    state = gate.set_joint(0, float(robot.poses["ready"][0]) + 0.6)(state)
    for tick in range(UPDATES * EVERY):
        state = advance(state, TICK)
        if tick % EVERY == 0:
            yield state


def _cost(server: viser.ViserServer, panel: ModuleType, states: list[State], seat: Seat) -> float:
    """The median time of an update of all rows, ms."""
    history, took = NO_SIGNAL_HISTORY, []
    view = View(states[0], seat, history=history)
    rows = place_rows(server.gui, panel.rows(states[0].robot), view, print)
    for state in states:
        history = history.with_sample(state, needed_signals(state, seat.charts.shown))
        view = View(replace(state), seat, history=history)  # a new state, so that nothing is cached for the rows
        began = thread_time_ns()
        for row in rows:
            row.refresh(view)
        took.append((thread_time_ns() - began) / 1e6)
    server.gui.reset()
    return p50(took[1:])


def run() -> None:
    exercise()
    server, seat = viser.ViserServer(host="127.0.0.1", port=0, verbose=False), busy_seat()
    names = sorted(content.content_folders("robots"))
    costs: dict[str, list[float]] = {panel.TITLE.en: [] for panel in panels.all_panels()}
    for name in names:
        robot = load_robot(name)
        rehearse(robot)
        states = list(_motion(robot))
        for panel in panels.all_panels():
            costs[panel.TITLE.en].append(_cost(server, panel, states, seat))
    server.stop()
    print(f"  {'':20}" + "".join(f"{name[:10]:>11}" for name in names))
    for title, row in sorted(costs.items(), key=lambda item: -max(item[1])):
        print(f"  {title:20}" + "".join(f"{cost:11.1f}" for cost in row))
    verdict("dearest tab", max(max(row) for row in costs.values()), GOAL, " ms")
