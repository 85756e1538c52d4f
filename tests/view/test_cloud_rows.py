"""The rows that take a cloud of points: with the unit that the person chose, each in their own window."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import pytest

from helicoide.kinematics.library import load_robot
from helicoide.perception.units import UNITS
from helicoide.seat import Seat
from helicoide.state import initial_state
from helicoide.view.plane_rows import plane_rows
from helicoide.view.requests import ForSeat, ReadCloud
from helicoide.view.rows import Dropdown, Folder, Row, Upload
from helicoide.view.window_view import View

STATE = initial_state(load_robot("movemaster"))
SEAT = Seat("token", "en")


def all_rows(rows: Sequence[Row]) -> Iterator[Row]:
    for row in rows:
        yield row
        if isinstance(row, Folder) and isinstance(row.rows, Sequence):
            yield from all_rows(row.rows)


ROWS = list(all_rows([plane_rows(STATE.robot)]))
(UNIT,) = [row for row in ROWS if isinstance(row, Dropdown)]
UPLOADS = [row for row in ROWS if isinstance(row, Upload) and row.label.en.startswith("Fit to a cloud")]


@pytest.mark.parametrize("unit", UNITS)
def test_the_unit_that_is_chosen_goes_with_the_file(unit: str) -> None:
    chosen = UNIT.request(unit)
    assert isinstance(chosen, ForSeat)
    view = View(STATE, chosen.update(SEAT))
    assert UNIT.value(view) == unit
    requests = [row.request(view, "room.xyz", b"1 2 3") for row in UPLOADS]
    assert [request.unit for request in requests if isinstance(request, ReadCloud)] == [unit] * 3


def test_at_first_and_after_nonsense_a_file_tells_its_unit() -> None:
    for seat in (SEAT, replace(SEAT, cloud_unit="furlong")):
        request = UPLOADS[0].request(View(STATE, seat), "room.xyz", b"1 2 3")
        assert isinstance(request, ReadCloud)
        assert request.unit is None
    assert UNIT.value(View(STATE, SEAT)) == ""
    assert not callable(UNIT.options)
    assert {key for key, _ in UNIT.options} == {"", *UNITS}
