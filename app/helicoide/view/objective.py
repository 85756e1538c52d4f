"""Rows for the secondary objective: its choice, its weight, how it is applied, and its settings."""

from __future__ import annotations

from functools import partial

from helicoide import gate
from helicoide.ik import objectives
from helicoide.ik.controller import SecondaryObjective
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view import html
from helicoide.view.formula import formula_html
from helicoide.view.requests import ForArm
from helicoide.view.rows import Checkbox, DependentRows, Dropdown, Folder, HtmlRow, Row, Slider
from helicoide.view.settings import NONE, NOTHING_TO_SET, setting_rows
from helicoide.view.window_view import View


def objective_rows(robot: Robot) -> list[Row]:
    """Rows to choose a secondary objective among those that apply to the robot, and to set it."""
    known = [(name, objectives.named(name)) for name in objectives.names()]
    options = [(name, one.TITLE) for name, one in known if one.applies(robot) is None]
    return [
        Dropdown(
            Text(en="Objective", pt_BR="Objetivo"),
            [("", NONE), *options],
            _chosen,
            lambda name: ForArm(gate.choose_objective(name or None)),
        ),
        Folder(
            Text(en="Objective settings", pt_BR="Ajustes do objetivo"), DependentRows(_chosen, partial(_how, robot))
        ),
    ]


def _chosen(view: View) -> str:
    second = view.state.request.controller.secondary
    return "" if second is None else second.objective


def _how(robot: Robot, name: str) -> list[Row]:
    """Rows for the weight, the use and the settings of an objective; defaults if it is not the current one."""
    if not name:
        return [HtmlRow(lambda view: html.note(NOTHING_TO_SET[view.seat.language]))]
    objective, default = objectives.named(name), SecondaryObjective(name, objectives.named(name).Options())

    def second(view: View) -> SecondaryObjective:
        there = view.state.request.controller.secondary
        return there if there is not None and there.objective == name else default

    as_row = Checkbox(
        Text(en="Use as a task row", pt_BR="Usar como linha da tarefa"),
        lambda view: second(view).as_row,
        lambda on: ForArm(gate.objective_as_row(on)),
    )
    return [
        HtmlRow(lambda view: formula_html(objective.EQUATION) + html.note(objective.SOURCE)),
        Slider(
            Text(en="Weight k₀ [1/s]", pt_BR="Peso k₀ [1/s]"),
            0.0,
            gate.HEAVIEST,
            1.0,
            lambda view: second(view).weight,
            lambda value: ForArm(gate.weigh_objective(value)),
        ),
        *([as_row] if objective.AUGMENTS else []),
        Checkbox(
            Text(
                en="Adapt weights near joint limits (Algorithm 1)",
                pt_BR="Adaptar pesos perto dos limites de junta (Algoritmo 1)",
            ),
            lambda view: second(view).adapts,
            lambda on: ForArm(gate.grow_weights(on)),
        ),
        *setting_rows(
            objective.Options,
            robot.reach,
            lambda view: second(view).options,
            lambda setting, value: ForArm(gate.set_objective(setting, value)),
        ),
    ]
