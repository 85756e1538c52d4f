"""Every posture of the goal as rows: the list, the way to one of them, and what the choice weighs."""

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
from helicoide.ik.postures.solve import EXACT, status
from helicoide.kinematics.robot import Robot
from helicoide.readout import too_near
from helicoide.state import PostureList, State
from helicoide.text import Language, Text, join_texts, untranslated
from helicoide.view import html
from helicoide.view.rows import Button, Dropdown, Folder, ForArm, HtmlRow, ListPostures, Row, Slider, View

HERE_WITHIN = np.radians(0.5)  # rad, or as a share of the reach where a joint slides

ABOUT = Text(
    en="In how many ways the arm can bring its end effector to the target, and which of them it has now.",
    pt_BR="De quantas maneiras o braço leva o efetuador ao alvo, e em qual delas ele está agora.",
)
LIST = Text(en="List the postures", pt_BR="Listar as posturas")
GO = Text(en="Go to posture", pt_BR="Ir para a postura")
CHOOSE = Text(en="choose …", pt_BR="escolha …")
HEAD = Text(
    en="For x y z = {x:.0f}, {y:.0f}, {z:.0f} mm: {status}.",
    pt_BR="Para x y z = {x:.0f}; {y:.0f}; {z:.0f} mm: {status}.",
)
HERE = Text(en="the arm is here", pt_BR="o braço está nesta")
TOO_NEAR = Text(en="too near: {what}", pt_BR="perto demais: {what}")
MISSES = Text(en="misses by {mm:.1f} mm and {degrees:.1f}°", pt_BR="erra por {mm:.1f} mm e {degrees:.1f}°")
JOINT = untranslated("{value:.1f}{unit}")
COST = Text(en="motion {cost:.2f}", pt_BR="movimento {cost:.2f}")
WEIGHTS = Text(en="Weights of the choice", pt_BR="Pesos da escolha")
WEIGHT = Text(en="weight {n} {title}", pt_BR="peso {n} {title}")
WHY_WEIGHTS = Text(
    en="The list begins with the least motion: the sum of what each joint turns from where the arm stood, in radians, "
    "times its weight (a slide counts in reaches of the arm). Large weights near the base let the small links move. "
    "What comes too near to an obstacle or a plane, or is outside the limits, stands last (Campos 1998, s.17).",
    pt_BR="A lista começa pelo menor movimento: a soma de quanto cada junta gira desde onde o braço estava, em "
    "radianos, vezes o peso dela (uma junta prismática conta em alcances do braço). Pesos grandes perto da base deixam "
    "que os elos pequenos se movam. O que fica perto demais de um obstáculo ou plano, ou fora dos limites, vem no fim "
    "(Campos 1998, s.17).",
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
    return Folder(Text(en="Postures for the target", pt_BR="Posturas para o alvo"), rows, open=False)


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
    """The list: it is written anew only when it changes, or when the arm comes to a posture of it or leaves it."""
    state, listed = view.state, view.state.postures.listing
    if listed is None:
        return Markup("")
    return _written(listed, state.problem, _place(listed, state), view.seat.language)


def _place(listed: PostureList, state: State) -> int | None:
    """Which posture the arm has now."""
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
    head = HEAD.format(x=x, y=y, z=z, status=status(listed.answer))[language]
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
    """What is to be said of a posture besides its joints."""
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
