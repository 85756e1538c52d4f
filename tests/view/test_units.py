"""Every number that people set has a unit in its label, or is named here as a pure number; no label has an e+04."""

from __future__ import annotations

import re
from collections.abc import Iterator
from types import MappingProxyType

import pytest
from tests.pressing import leaves

from helicoide import gate
from helicoide.ik import methods, objectives
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.state import State, initial_state
from helicoide.text import LANGUAGES, Text
from helicoide.view import layers, panels
from helicoide.view.rows import Slider, VectorRow
from helicoide.view.window_view import View

# Pure numbers, by the words with which their labels begin.
PURE = (
    "weight",
    "orientation weight",
    "gain ratio",
    "row coupling",
    "threshold w₀",
    "α, or its maximum",
    "points per link",
    "steepness k",
    "share of the range",
    "axis of q₁",
    "axis of q₂",
    "way from q₁ to q₂, t",
)
# In brackets, or after the value. The folder of the joints says “Joints [°]”.
UNIT = re.compile(r"\[.+\]|: \S+ \S+|^\d ")


def states(robot: Robot) -> Iterator[State]:
    """The arm under each method and each objective that applies, with a waypoint and an obstacle."""
    start = gate.add_obstacle()(gate.record()(initial_state(robot)))
    for name in methods.names():
        yield gate.choose_method(name)(start)
    for name in objectives.names():
        yield gate.choose_objective(name)(start)


@pytest.mark.parametrize("name", ["movemaster", "dia10_rod", "polar_rp"])
def test_every_number_has_a_unit(name: str) -> None:
    robot = load_robot(name)
    seat = Seat("", "en", visible_layers=MappingProxyType({layer.NAME: True for layer in layers.optional()}))
    bare, exponents = set(), set()
    for state in states(robot):
        view = View(state, seat)
        for row in leaves([panel.rows(robot) for panel in panels.all_panels()], view):
            if isinstance(row, Slider | VectorRow):
                label = row.label if isinstance(row.label, Text) else row.label(view)
                if not UNIT.search(label.en.rstrip("\u2063")) and not label.en.casefold().startswith(PURE):
                    bare.add(label.en)
                exponents |= {label[language] for language in LANGUAGES if re.search(r"\de[+-]\d", label[language])}
    assert bare == set()
    assert exponents == set()
