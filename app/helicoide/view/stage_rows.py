"""Forward kinematics joint by joint, in the notation and units of the sources."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

from markupsafe import Markup

from helicoide.export.stage_table import text_table
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.stages import STAGES, StageKind
from helicoide.state import ArmState
from helicoide.text import Language, Text
from helicoide.view import html
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Dropdown, Folder, HtmlRow
from helicoide.view.settings import NONE
from helicoide.view.window_view import View

TITLE = Text(en="Joint by joint", pt_BR="Junta por junta")
SHOWN = Text(en="Show", pt_BR="Mostrar")
TITLES: dict[StageKind, Text] = {
    "dh": Text(en="DH rows and frames", pt_BR="linhas DH e referenciais"),
    "screws": Text(en="screws and displacements H", pt_BR="helicoides e deslocamentos H"),
    "products": Text(en="products of dual quaternions h", pt_BR="produtos de quatérnios duais h"),
}
Cells = tuple[Text, ...]


def stage_rows() -> Folder:
    """A table that is computed only while it is chosen."""
    return Folder(
        TITLE,
        [
            Dropdown(
                SHOWN,
                [("", NONE), *TITLES.items()],
                lambda view: view.seat.stages or "",
                lambda key: ForSeat(lambda seat: replace(seat, stages=next((k for k in STAGES if k == key), None))),
            ),
            HtmlRow(_table, computed=True),
        ],
        open=False,
    )


def _table(view: View) -> Markup:
    if view.seat.stages is None:
        return Markup("")
    return _written(view.state.robot, view.state.arm, view.seat.stages, view.seat.language)


@lru_cache(maxsize=8)  # all windows show the same table until the arm moves
def _written(robot: Robot, arm: ArmState, kind: StageKind, language: Language) -> Markup:
    found = text_table(robot, arm.q, kind, as_source=True)
    joints = Markup("").join(
        JOINT.format(named[language], Markup("").join(_row(row, language) for row in _in_fours(matrix)))
        for named, matrix in found.joints
    )
    return html.note(found.head[language]) + joints + html.note(found.end[language])


def _in_fours(matrix: Sequence[Cells]) -> Iterator[Cells]:
    """The rows of a matrix, four cells each, so that a dual quaternion has its dual part below."""
    return (row[k : k + 4] for row in matrix for k in range(0, len(row), 4))


def _row(cells: Cells, language: Language) -> Markup:
    said = (Markup("<td>{}</td>").format(cell[language].replace("-", "−")) for cell in cells)
    return Markup("<tr>{}</tr>").format(Markup("").join(said))


JOINT = Markup("<div class='helicoide-stage'>{}<table>{}</table></div>")
