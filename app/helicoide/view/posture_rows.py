"""Rows for the postures of the goal: their list, a choice of one, and the weights of the joints."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide import gate
from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.postures.branch import wrap
from helicoide.ik.postures.choice import OUT_OF_LIMITS, Ranked
from helicoide.ik.postures.solve import EXACT, answer_status
from helicoide.kinematics.robot import Robot
from helicoide.readout import too_near
from helicoide.state import PostureList, State
from helicoide.text import Language, Text, join_texts, untranslated
from helicoide.view import html
from helicoide.view.requests import ForArm, ListPostures
from helicoide.view.rows import Button, Dropdown, Folder, HtmlRow, Row, Slider
from helicoide.view.window_view import View

HERE_WITHIN = np.radians(0.5)  # rad; for a prismatic joint a share of the reach

TITLE = Text(en="Postures for the target", pt_BR="Posturas para o alvo")
ABOUT = Text(
    en="All postures that bring the end effector to the target. The current one is marked.",
    pt_BR="Todas as posturas que levam o efetuador ao alvo. A atual está marcada.",
)
LIST = Text(en="List postures", pt_BR="Listar posturas")
GO = Text(en="Go to posture", pt_BR="Ir para a postura")
CHOOSE = Text(en="choose …", pt_BR="escolha …")
HEAD = Text(
    en="For x y z = {x:.0f}, {y:.0f}, {z:.0f} mm: {status}.",
    pt_BR="Para x y z = {x:.0f}; {y:.0f}; {z:.0f} mm: {status}.",
)
HERE = Text(en="current posture", pt_BR="postura atual")
TOO_NEAR = Text(en="too close: {what}", pt_BR="perto demais: {what}")
MISSES = Text(en="{mm:.1f} mm and {degrees:.1f}° from the target", pt_BR="a {mm:.1f} mm e {degrees:.1f}° do alvo")
JOINT = untranslated("{value:.1f}{unit}")
COST = Text(en="cost {cost:.2f}", pt_BR="custo {cost:.2f}")
WEIGHTS = Text(en="Joint weights", pt_BR="Pesos das juntas")
WEIGHT = Text(en="Weight {n} {title}", pt_BR="Peso {n} {title}")
WHY_WEIGHTS = Text(
    en="The list is sorted by cost: the sum of the joint motions from the posture at the time of listing, in radians, "
    "each times its weight (for a prismatic joint, the motion divided by the reach). Large weights near the base "
    "favour motion of the outer links. Postures too close to an obstacle or a plane, or outside the joint limits, "
    "come last (Campos 1998, s.17).",
    pt_BR="A lista está em ordem de custo: a soma dos movimentos das juntas desde a postura no momento da listagem, "
    "em radianos, cada um vezes o seu peso (numa junta prismática, o movimento dividido pelo alcance). Pesos grandes "
    "perto da base favorecem o movimento dos elos mais distantes. Posturas perto demais de um obstáculo ou plano, ou "
    "fora dos limites das juntas, vêm no fim (Campos 1998, s.17).",
)


LIST_OF = Markup("<ol class='helicoide-postures'>{}</ol>")
ITEM = Markup("<li class='{}'><b>{}</b> {} <small>{}</small></li>")


def posture_rows(robot: Robot) -> Folder:
    """The list of the postures, and the choice between them."""
    rows: list[Row] = [
        HtmlRow(lambda view: html.note(ABOUT[view.seat.language])),
        Button(lambda _: LIST, lambda _: ListPostures(), Icon.LIST, lambda view: view.ready),
        HtmlRow(_listed, computed=True),
        Dropdown(
            GO,
            lambda view: [("", CHOOSE), *((str(k), name) for k, name in enumerate(_names(view.state)))],
            lambda _: "",
            lambda key: ForArm(gate.go_to_posture(int(key)) if key else lambda state: state),
        ),
        Folder(
            WEIGHTS,
            [
                HtmlRow(lambda view: html.note(WHY_WEIGHTS[view.seat.language])),
                *(_weight(robot, index) for index in range(len(robot.variables))),
            ],
            open=False,
        ),
    ]
    return Folder(TITLE, rows, open=False)


def _weight(robot: Robot, index: int) -> Slider:
    return Slider(
        WEIGHT.format(n=index + 1, title=robot.variables[index].title),
        0.0,
        gate.HEAVIEST_JOINT,
        0.1,
        lambda view: float(view.state.postures.weights[index]),
        lambda value: ForArm(gate.weigh_joint(index, value)),
    )


def _names(state: State) -> tuple[Text, ...]:
    listed = state.postures.listing
    return () if listed is None else tuple(row.branch.name for row in listed.rows)


def _listed(view: View) -> Markup:
    """The list. It is formatted again only when it changes, or when the arm reaches or leaves one of its postures."""
    state, listed = view.state, view.state.postures.listing
    if listed is None:
        return Markup("")
    return _written(listed, state.problem, _place(listed, state), view.seat.language)


def _place(listed: PostureList, state: State) -> int | None:
    """The place in the list of the posture that the arm has now; None if it has none of them."""
    robot = state.robot
    scale = np.where([joint.is_prismatic for joint in robot.variables], robot.reach, 1.0)
    for place, row in enumerate(listed.rows):
        way = state.arm.q - row.q
        if np.abs(np.where(robot.periodic, wrap(way), way) / scale).max() < HERE_WITHIN:
            return place
    return None


@lru_cache(maxsize=64)
def _written(listed: PostureList, problem: Problem, here: int | None, language: Language) -> Markup:
    x, y, z = (1000 * float(value) for value in listed.T_world_goal[:3, 3])
    head = HEAD.format(x=x, y=y, z=z, status=answer_status(listed.answer))[language]
    items = (
        ITEM.format(
            "here" if place == here else "",
            row.branch.name[language],
            join_texts([*_notes(row, problem, place == here)], " · ")[language],
            _joints(problem.robot, row.q)[language],
        )
        for place, row in enumerate(listed.rows)
    )
    words = html.note(listed.answer.words[language]) if listed.answer.words[language] else Markup("")
    return html.note(head) + words + LIST_OF.format(Markup("").join(items))


def _notes(row: Ranked, problem: Problem, here: bool) -> Iterator[Text]:
    """Remarks on a posture besides its joint values."""
    if here:
        yield HERE
    near = too_near(problem, row.q)
    if row.dropped is OUT_OF_LIMITS:
        yield OUT_OF_LIMITS
    elif near is not None:
        yield TOO_NEAR.format(what=near)
    if row.branch.missed > EXACT.position or row.branch.turned > EXACT.orientation:
        yield MISSES.format(mm=1000 * row.branch.missed, degrees=float(np.degrees(row.branch.turned)))
    yield COST.format(cost=row.cost)


def _joints(robot: Robot, q: Array) -> Text:
    """The joint values, in degrees or mm."""
    units = ((1000.0, " mm") if joint.is_prismatic else (180 / np.pi, "°") for joint in robot.variables)
    said = [JOINT.format(value=float(scale * x) + 0.0, unit=unit) for (scale, unit), x in zip(units, q, strict=True)]
    text = join_texts(said, "  ")
    return Text(en=text.en.replace("-", "−"), pt_BR=text.pt_BR.replace("-", "−"))
