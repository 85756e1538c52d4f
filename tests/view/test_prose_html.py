"""The prose of a lesson as HTML: an array of values is a part of its sentence."""

from __future__ import annotations

import re

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.seat import Seat
from helicoide.state import initial_state
from helicoide.view.prose_html import prose_html
from helicoide.view.window_view import View


def test_an_array_stays_in_its_paragraph() -> None:
    found = lesson.load_lesson("closed_forms")
    view = View(initial_state(load_robot(found.robot)), Seat("", "en"), ready=True)
    written = prose_html(found, "It is at {polar} now, at {ready_joints}.", view)
    assert written.count("<p>") == written.count("</p>") == 1
    assert set(re.findall(r"<(\w+)", written)) == {"p", "span", "i"}  # none of which ends a paragraph
    assert re.sub(r"<[^>]*>", "", written).strip() == "It is at 300 400\u202fmm now, at −25 70 40°."
