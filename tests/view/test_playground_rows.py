"""What the playground says about its two rotations."""

from __future__ import annotations

from dataclasses import replace

import pytest

from helicoide.seat import AxisAngle, Playground, Seat
from helicoide.state import State
from helicoide.text import LANGUAGES, Language
from helicoide.view.layers import playground as layer
from helicoide.view.playground_rows import playground_rows
from helicoide.view.rows import HtmlRow
from helicoide.view.window_view import View


@pytest.mark.parametrize("language", LANGUAGES)
def test_halfway_to_the_opposite_quaternion_lerp_has_no_finite_speed(state: State, language: Language) -> None:
    """The chord passes through zero there. The page writes this as a symbol, not as Python does."""
    one = AxisAngle((0.0, 0.0, 1.0), 1.5)
    seat = replace(Seat("", language), playground=Playground(one, one, 0.5, opposite=True)).with_layer(layer.NAME, True)
    rows = playground_rows().rows
    assert isinstance(rows, list)
    (*_, words) = (str(row.html(View(state, seat))) for row in rows if isinstance(row, HtmlRow))
    assert "∞°" in words
    assert "inf" not in words
