"""Rows for a planned motion: where to, and whether to execute it."""

from __future__ import annotations

from markupsafe import Markup
from viser import Icon

from helicoide import gate
from helicoide.kinematics.robot import Robot
from helicoide.state import Update
from helicoide.text import Text
from helicoide.view import html
from helicoide.view.requests import ForArm, PageRequest, PlanMotion
from helicoide.view.rows import Button, Dropdown, Folder, HtmlRow, Row
from helicoide.view.window_view import View

TITLE = Text(en="Planned motion", pt_BR="Movimento planejado")
CHOOSE = Text(en="choose …", pt_BR="escolha …")
PLAN = Text(en="Plan to", pt_BR="Planejar até")
EXECUTE = Text(en="Execute the planned motion", pt_BR="Executar o movimento planejado")
DISCARD = Text(en="Discard the planned motion", pt_BR="Descartar o movimento planejado")
THE_PATH = Text(en="along the path", pt_BR="pela trajetória")
ABOUT = Text(
    en="The motion is first shown by a ghost of the arm. The arm moves when you execute it.",
    pt_BR="Primeiro um fantasma do braço mostra o movimento; o braço só se move quando você manda executar.",
)
PLANNED = Text(en="Planned: {title}, {seconds:.1f} s.", pt_BR="Planejado: {title}, {seconds:.1f} s.")
LISTED = Text(en="posture {n} of the list", pt_BR="postura {n} da lista")

Place = tuple[Text, Update]


def plan_rows(robot: Robot) -> Folder:
    """Choose a named pose, the path or a listed posture; then execute or discard the motion."""
    fixed: list[Place] = [(title, gate.go_to(name)) for name, title in robot.pose_titles.items()]
    fixed.append((THE_PATH, gate.play()))

    def place(number: int) -> Place:
        listed = number - len(fixed)
        return fixed[number] if listed < 0 else (LISTED.format(n=listed + 1), gate.go_to_posture(listed))

    def options(view: View) -> list[tuple[str, Text]]:
        listing = view.state.postures.listing
        count = len(fixed) + (0 if listing is None else len(listing.rows))
        return [("", CHOOSE), *((str(number), place(number)[0]) for number in range(count))]

    def plan(key: str) -> PageRequest:
        if not key:
            return ForArm(lambda state: state)
        title, update = place(int(key))
        return PlanMotion(update, title)

    rows: list[Row] = [
        HtmlRow(lambda view: html.note(ABOUT[view.seat.language])),
        Dropdown(PLAN, options, lambda _: "", plan),
        HtmlRow(_planned),
        Button(lambda _: EXECUTE, lambda _: ForArm(gate.execute_plan()), Icon.PLAYER_PLAY, _exists, weight="primary"),
        Button(lambda _: DISCARD, lambda _: ForArm(gate.clear_plan()), Icon.X, _exists),
    ]
    return Folder(TITLE, rows, open=False)


def _exists(view: View) -> bool:
    return view.state.plan is not None


def _planned(view: View) -> Markup:
    plan = view.state.plan
    if plan is None:
        return Markup("")
    return html.note(PLANNED.format(title=plan.title, seconds=float(plan.times[-1]))[view.seat.language])
