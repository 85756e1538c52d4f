"""Every label of a control begins with a capital, unless it begins with a symbol such as x or λ."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from types import MappingProxyType
from typing import Any

import pytest
from tests.view.test_units import states

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.seat import Seat
from helicoide.text import LANGUAGES, Text, sentence_case
from helicoide.view import layers, panels
from helicoide.view.docked import lesson_rows
from helicoide.view.rows import DependentRows, Folder
from helicoide.view.top_rows import top_rows
from helicoide.view.window_view import View

SMALL = re.compile(r"[a-zà-ÿ]{2}")


def labels(rows: Sequence[Any], view: View) -> Iterator[Text]:
    """The labels of all rows, of their folders too."""
    for row in rows:
        label = getattr(row, "label", None)
        if label is not None:
            yield label if isinstance(label, Text) else label(view)
        if isinstance(row, Folder):
            inside = row.rows
            yield from labels(inside.rows(inside.key(view)) if isinstance(inside, DependentRows) else inside, view)


@pytest.mark.parametrize("name", ["movemaster", "dia10_rod", "polar_rp"])
def test_every_label_begins_with_a_capital(name: str) -> None:
    robot = load_robot(name)
    seat = Seat("", "en", visible_layers=MappingProxyType({layer.NAME: True for layer in layers.optional()}))
    rows = [row for panel in panels.all_panels() for row in panel.rows(robot)]
    seats = [(seat, [*rows, *top_rows()])]
    for found in (one for one in lesson.all_lessons() if one.robot == name):
        for number in range(len(found.steps) + 1):
            opened = lesson.turned_to(found, lesson.entered(seat, found.id), number)
            seats.append((opened, lesson_rows(robot, opened)))
    small = {
        label[language]
        for state in states(robot)
        for one, every in seats
        for label in labels(every, View(state, one))
        for language in LANGUAGES
        if SMALL.match(label[language])
    }
    assert small == set()


@pytest.mark.parametrize(
    ("given", "en", "pt_BR"),
    [
        (Text(en="damping λ", pt_BR="amortecimento λ"), "Damping λ", "Amortecimento λ"),
        (Text(en="x y z [mm]", pt_BR="x y z [mm]"), "x y z [mm]", "x y z [mm]"),
        (Text(en="δ below w₀", pt_BR="δ abaixo de w₀"), "δ below w₀", "δ abaixo de w₀"),
        (Text(en="initial Θ", pt_BR="Θ inicial"), "Initial Θ", "Θ inicial"),
        (Text(en="", pt_BR=""), "", ""),
    ],
)
def test_sentence_case_leaves_symbols(given: Text, en: str, pt_BR: str) -> None:
    assert sentence_case(given) == Text(en=en, pt_BR=pt_BR)
