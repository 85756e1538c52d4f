"""The prose of a lesson as HTML: an array of values is a part of its sentence."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.lesson import fixed
from helicoide.seat import Seat
from helicoide.state import initial_state
from helicoide.text import LANGUAGES
from helicoide.view.prose_html import prose_html
from helicoide.view.window_view import View


def test_an_array_stays_in_its_paragraph() -> None:
    found = lesson.load_lesson("closed_forms")
    view = View(initial_state(load_robot(found.robot)), Seat("", "en"), ready=True)
    written = prose_html(found, "It is at {polar} now, at {ready_joints}.", view)
    assert written.count("<p>") == written.count("</p>") == 1
    assert set(re.findall(r"<(\w+)", written)) == {"p", "span"}  # none of which ends a paragraph
    assert _words(written) == "It is at (300, 400)\u202fmm now, at (−25, 70, 40)°."


def test_the_numbers_of_a_tuple_are_kept_apart_in_both_languages() -> None:
    """A comma between them would be a decimal sign in Portuguese."""
    found = replace(lesson.load_lesson("workspace"), values={"place": fixed(np.array([0.0045, -0.204]), "mm", 1)})
    state = initial_state(load_robot(found.robot))
    en, pt_BR = (_words(prose_html(found, "{place}", View(state, Seat("", kind), ready=True))) for kind in LANGUAGES)
    assert en == "(4.5, −204.0)\u202fmm"
    assert pt_BR == "(4,5; −204,0)\u202fmm"


def test_an_array_of_two_rows_stays_a_matrix() -> None:
    found = replace(lesson.load_lesson("workspace"), values={"turn": fixed(np.eye(2), "", 0)})
    written = prose_html(found, "{turn}", View(initial_state(load_robot(found.robot)), Seat("", "en"), ready=True))
    assert "helicoide-brackets" in written
    assert _words(written) == "1 00 1"


def _words(written: str) -> str:
    return re.sub(r"<[^>]*>", "", written).strip()
