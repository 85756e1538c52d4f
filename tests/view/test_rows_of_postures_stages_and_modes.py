"""Postures of a goal, the arm joint by joint, and the modes of a filtered inverse, as the page writes them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from tests.driving import after, with_joints

from helicoide import gate, readout
from helicoide.export import stage_table
from helicoide.ik import methods
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.stages import STAGES, StageKind
from helicoide.seat import Seat
from helicoide.session.postures import list_postures
from helicoide.state import State, initial_state
from helicoide.text import LANGUAGES, Language
from helicoide.view.modes import _table, mode_table
from helicoide.view.panels import algebra, method, robot
from helicoide.view.posture_rows import posture_rows
from helicoide.view.requests import ForArm, ForSeat, ListPostures
from helicoide.view.rows import Dropdown, Folder, HtmlRow, Row
from helicoide.view.window_view import View


def inside(folder: Folder) -> Iterator[Row]:
    assert not isinstance(folder.rows, tuple)
    for row in folder.rows:  # type: ignore[union-attr]
        yield row
        if isinstance(row, Folder):
            yield from inside(row)


def written(folder: Folder, view: View) -> str:
    return " ".join(row.html(view) for row in inside(folder) if isinstance(row, HtmlRow))


def folder(rows: list[Row], english: str) -> Folder:
    return next(row for row in rows if isinstance(row, Folder) and row.label.en == english)


@pytest.fixture
def puma() -> State:
    return initial_state(load_robot("puma560"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_list_names_every_posture_and_marks_the_one_that_the_arm_has(puma: State, language: Language) -> None:
    rows = folder(robot.rows(puma.robot), "Postures for the target")
    assert not rows.open
    view = View(puma, Seat("", language))
    assert "<li" not in written(rows, view)
    (button,) = [row for row in inside(rows) if type(row).__name__ == "Button"]
    assert button.request(view) == ListPostures()  # type: ignore[union-attr]
    view = replace(view, state=list_postures(puma)(puma))
    said = written(rows, view)
    listed = view.state.postures.listing
    assert listed is not None
    assert all(row.branch.name[language] in said for row in listed.rows)
    assert said.count("<li") == 8
    assert said.index("class='here'") < said.index(listed.rows[1].branch.name[language])
    assert said.count({"en": "current posture", "pt_BR": "postura atual"}[language]) == 1
    assert {"en": "−70.0°", "pt_BR": "−70,0°"}[language] in said
    moved = replace(view, state=after(gate.set_joint(0, 0.5)(view.state), 1.0))
    assert "class='here'" not in written(rows, moved)


def test_a_posture_is_chosen_from_the_list(puma: State) -> None:
    rows = posture_rows(puma.robot)
    (choice,) = [row for row in inside(rows) if isinstance(row, Dropdown)]
    view = View(list_postures(puma)(puma), Seat("", "en"))
    assert callable(choice.options)
    assert len(choice.options(View(puma, view.seat))) == 1
    assert len(choice.options(view)) == 9
    request = choice.request("1")
    assert isinstance(request, ForArm)
    gone = after(request.update(view.state), 12.0)
    assert "shoulder right, elbow up</b> current posture" in written(rows, replace(view, state=gone))


@pytest.mark.parametrize("kind", STAGES)
@pytest.mark.parametrize("name", ["movemaster", "dia10"])
def test_the_arm_joint_by_joint_as_the_command_line_prints_it(name: str, kind: StageKind) -> None:
    state = initial_state(load_robot(name))
    rows = folder(algebra.rows(state.robot), "Joint by joint")
    assert not rows.open
    (choice,) = [row for row in inside(rows) if isinstance(row, Dropdown)]
    seat = Seat("", "pt_BR")
    assert "<td" not in written(rows, View(state, seat))
    request = choice.request(kind)
    assert isinstance(request, ForSeat)
    said = written(rows, View(state, request.update(seat)))
    table = stage_table.text_table(state.robot, state.arm.q, kind, as_source=True)
    assert all(text.pt_BR in said for text in (table.head, table.end, *(named for named, _ in table.joints)))
    cells = [cell.pt_BR.replace("-", "−") for _, matrix in table.joints for row in matrix for cell in row]
    assert [part.split("<")[0] for part in said.split("<td>")[1:]] == cells
    hidden = choice.request("")
    assert isinstance(hidden, ForSeat)
    assert hidden.update(request.update(seat)).stages is None
    forged = choice.request("nothing of this kind")
    assert isinstance(forged, ForSeat)
    assert forged.update(seat).stages is None


def test_a_table_of_an_arm_that_has_not_moved_is_not_written_again(
    puma: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = folder(algebra.rows(puma.robot), "Joint by joint")
    view = View(puma, replace(Seat("", "en"), stages="screws"))
    once = written(rows, view)
    monkeypatch.setattr("helicoide.view.stage_rows.text_table", None)
    assert written(rows, replace(view, state=replace(puma, t=1.0))) == once


@pytest.mark.parametrize("name", ["filtered", "filtered_modified", "filtered_normal"])
def test_the_modes_come_to_the_inverse_of_each_singular_value(puma: State, name: str) -> None:
    """σᵢ dᵢ is 1 in the end, also with unequal gains; a small σ takes longer."""
    assert "<table" not in mode_table(View(puma, Seat("", "en")))
    state = gate.choose_method(name)(puma)
    if name != "filtered_normal":
        state = gate.set_option(name, "ratio", 4.0)(state)
    state = gate.set_target(state.T_world_tool[:3, 3] + [0.02, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0])(state)
    view = View(after(state, 10.0), Seat("", "pt_BR"))
    found, said = readout.method_modes(view.state), mode_table(view)
    assert found is not None
    learnt = found.rates.diagonal() > 2
    assert learnt.sum() >= 3
    np.testing.assert_allclose((found.sigma * found.d)[learnt], 1, atol=1e-3)
    assert (np.diff(found.rates.diagonal()) < 0).all()
    assert said.count("<tr>") == 1 + 6
    assert "Resíduos" in said
    numbers = said[said.index("<table") : said.index("</table>")]
    assert "." not in numbers.rpartition("</th>")[2]


def test_a_singular_value_that_is_lost_in_rounding_is_0_and_its_time_infinite() -> None:
    start = initial_state(load_robot("planar2r"))
    state = gate.choose_method("filtered")(with_joints(start, np.zeros(2)))
    state = gate.set_target(state.T_world_tool[:3, 3] - [0.02, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0])(state)
    found = readout.method_modes(after(state, 0.01))
    assert found is not None
    lost = replace(found, sigma=np.array([*found.sigma[:-1], 1.106e-17]), rates=np.full_like(found.rates, 1e-32))
    said = _table(lost, "pt_BR")
    assert "<td>0</td>" in said
    assert "<td>∞</td>" in said
    assert "⁻¹⁷" not in said


def test_other_methods_have_no_modes(puma: State) -> None:
    rows = folder(method.rows(puma.robot), "Modes of Θ")
    for name in set(methods.names()) - {"filtered", "filtered_modified", "filtered_normal"}:
        asked = gate.set_target(puma.T_world_tool[:3, 3] + 0.01, [1.0, 0, 0, 0])(gate.choose_method(name)(puma))
        state = after(asked, 0.1)
        said = [written(rows, View(state, Seat("", language))) for language in LANGUAGES]
        assert all("<table" not in words and "<p" in words for words in said)
