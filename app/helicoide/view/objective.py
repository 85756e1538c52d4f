"""Rows for what the joints do besides their task: the objective, its weight, its way, its settings."""

from __future__ import annotations

from functools import partial

from helicoide import gate
from helicoide.ik import objectives
from helicoide.ik.controller import SecondaryObjective
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view import html
from helicoide.view.formula import formula_html
from helicoide.view.rows import Checkbox, DependentRows, Dropdown, Folder, ForArm, HtmlRow, Row, Slider, View
from helicoide.view.settings import NONE, NOTHING_TO_SET, rows_of


def objective_rows(robot: Robot) -> list[Row]:
    """What the joints do besides: an objective that this robot can have, its weight, its settings."""
    known = [(name, objectives.named(name)) for name in objectives.names()]
    options = [(name, one.TITLE) for name, one in known if one.applies(robot) is None]
    return [
        Dropdown(
            Text(en="Objective", pt_BR="Objetivo"),
            [("", NONE), *options],
            _chosen,
            lambda name: ForArm(gate.choose_objective(name or None)),
        ),
        Folder(Text(en="How", pt_BR="Como"), DependentRows(_chosen, partial(_how, robot))),
    ]


def _chosen(view: View) -> str:
    second = view.state.request.controller.secondary
    return "" if second is None else second.objective


def _how(robot: Robot, name: str) -> list[Row]:
    """Weight, way and settings of an objective; what it is told after it has been taken away is not heard."""
    if not name:
        return [HtmlRow(lambda view: html.note(NOTHING_TO_SET[view.seat.language]))]
    objective, default = objectives.named(name), SecondaryObjective(name, objectives.named(name).Options())

    def second(view: View) -> SecondaryObjective:
        there = view.state.request.controller.secondary
        return there if there is not None and there.objective == name else default

    as_row = Checkbox(
        Text(en="as a row of the task", pt_BR="como linha da tarefa"),
        lambda view: second(view).as_row,
        lambda on: ForArm(gate.objective_as_row(on)),
    )
    return [
        HtmlRow(lambda view: formula_html(objective.EQUATION) + html.note(objective.SOURCE)),
        Slider(
            Text(en="weight k₀ [1/s]", pt_BR="peso k₀ [1/s]"),
            0.0,
            gate.HEAVIEST,
            1.0,
            lambda view: second(view).weight,
            lambda value: ForArm(gate.weigh_objective(value)),
        ),
        *([as_row] if objective.AUGMENTS else []),
        Checkbox(
            Text(en="weights grow at limits (Algorithm 1)", pt_BR="pesos crescem nos limites (Algoritmo 1)"),
            lambda view: second(view).adapts,
            lambda on: ForArm(gate.grow_weights(on)),
        ),
        *rows_of(
            objective.Options,
            robot.reach,
            lambda view: second(view).options,
            lambda setting, value: ForArm(gate.set_objective(setting, value)),
        ),
    ]
