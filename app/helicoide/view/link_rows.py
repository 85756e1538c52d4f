"""Rows for a link that was opened: what it shows, and whether the arm shall go there. Empty without a link."""

from __future__ import annotations

from dataclasses import replace

from markupsafe import Markup
from viser import Icon

from helicoide.kinematics.library import robot_titles
from helicoide.seat import LinkedPosture, Seat
from helicoide.text import Text, untranslated
from helicoide.view import html
from helicoide.view.requests import CloseLink, TakeLink
from helicoide.view.rows import Button, HtmlRow, Row
from helicoide.view.window_view import View

HERE = Text(
    en="The link shows the arm in the blue outline. Nothing has moved.",
    pt_BR="O link mostra o braço no contorno azul. Nada se moveu.",
)
ELSEWHERE = Text(
    en="The link shows another arm: {robot}. Nothing has changed.",
    pt_BR="O link mostra outro braço: {robot}. Nada mudou.",
)
EXECUTE = Text(en="Go to the posture of the link", pt_BR="Ir à postura do link")
LOAD = Text(en="Load this arm", pt_BR="Carregar esse braço")
ON_OWN = Text(en="Show it on my own arm", pt_BR="Mostrar no meu próprio braço")
DISMISS = Text(en="Close the link", pt_BR="Fechar o link")


def link_rows() -> list[Row]:
    """The words and the buttons. On the shared arm, another arm is not loaded for everybody: an own arm is offered."""
    return [
        HtmlRow(_words),
        Button(
            lambda view: LOAD if view.linked_here() is None else EXECUTE,
            lambda view: TakeLink(own=False),
            Icon.PLAYER_PLAY,
            shown=lambda view: view.seat.linked is not None and (view.own or view.linked_here() is not None),
        ),
        Button(
            lambda view: ON_OWN,
            lambda view: TakeLink(own=True),
            Icon.USER,
            shown=lambda view: view.seat.linked is not None and not view.own,
        ),
        Button(
            lambda view: DISMISS,
            lambda view: CloseLink(),
            Icon.X,
            shown=lambda view: view.seat.linked is not None,
        ),
    ]


def with_linked(linked: LinkedPosture | None, seat: Seat) -> Seat:
    """A seat with the posture of a link, or without one."""
    return replace(seat, linked=linked)


def _words(view: View) -> Markup:
    linked = view.seat.linked
    if linked is None:
        return Markup("")
    if view.linked_here() is not None:
        return html.note(HERE[view.seat.language])
    title = robot_titles().get(linked.robot, untranslated(linked.robot))
    return html.note(ELSEWHERE.format(robot=title)[view.seat.language])
