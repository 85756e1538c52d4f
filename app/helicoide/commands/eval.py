"""Evaluation of lines of the console, with the names of an arm if one is given."""

from __future__ import annotations

import json as json_format
from dataclasses import replace
from typing import Annotated

import numpy as np
import tyro

from helicoide.arrays import frozen
from helicoide.commands import language, print_remarks
from helicoide.console import LineResult, Value, kind_of, pointer, sheet_results, value_latex, value_terms, value_text
from helicoide.geometry.multivector import Multivector
from helicoide.kernels import run_interpreted
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.sheet import Sheet, SheetLine
from helicoide.state import State, initial_state
from helicoide.text import HelicoideError, Text, untranslated, with_decimal_comma

NO_ROBOT = Text(en="--q is for a robot: give one with --robot.", pt_BR="--q vale para um robô: dê um com --robot.")

NO_LINES = Text(
    en='Give at least one line, such as "distance(point(0,0,0), point(3,4,0))".',
    pt_BR='Dê ao menos uma linha, como "distance(point(0,0,0), point(3,4,0))".',
)


@run_interpreted()
def run(
    lines: tyro.conf.Positional[tuple[str, ...]],
    robot: str | None = None,
    q: Annotated[tuple[float, ...] | None, tyro.conf.arg(help="joint values: rad, or m where a joint slides")] = None,
    deg: bool = False,
    json: bool = False,
) -> None:
    """Print the value of expressions over points, lines, planes, motors and quaternions.

    Each argument is a line of the console, such as "p = point(1,2,3)", whose name the later ones may use.
    Ends with 2 for wrong input, and then marks the character that is wrong.

    Args:
        lines: expressions or definitions, each in quotes.
        robot: name of a robot, or the path of a URDF file: M_tool, L1, theta1, … are then known.
        q: joint values of the robot; its ready pose if none are given.
        deg: values of turning joints are in degrees.
        json: print JSON.
    """
    if not lines:
        raise HelicoideError(NO_LINES)
    sheet = Sheet(tuple(SheetLine(line) for line in lines))
    results = sheet_results(sheet, _state(robot, q, deg), sliders=False)
    for line, result in zip(lines, results, strict=True):
        if result.error is not None:
            shown = untranslated("{what}\n{pointer}")
            raise HelicoideError(shown.format(what=result.error.text, pointer=pointer(line, result.error)))
    if json:
        print(json_format.dumps([_as_json(result) for result in results], indent=1, ensure_ascii=False))
        return
    for result in results:
        if result.value is not None:
            print(_as_line(result, result.value)[language()])


def _state(robot: str | None, q: tuple[float, ...] | None, deg: bool) -> State | None:
    """The state that gives the names of an arm; None without one."""
    if robot is None:
        if q is not None:
            raise HelicoideError(NO_ROBOT)
        return None
    arm = load_robot(robot)
    print_remarks(arm)
    state = initial_state(arm)
    if q is None:
        return state
    values = arm.check_joints(q)
    if deg:
        values = np.where([joint.is_prismatic for joint in arm.variables], values, np.radians(values))
    posture = frozen(values)
    return replace(state, arm=replace(state.arm, q=posture, poses=frozen(link_poses(arm.chain, posture))))


def _as_line(result: LineResult, value: Value) -> Text:
    name = "" if result.name is None else f"{result.name} = "
    shown = with_decimal_comma(value_text(value))
    return untranslated("{name}{shown}   ({kind})").format(name=name, shown=shown, kind=kind_of(value).title)


def _as_json(result: LineResult) -> dict[str, object] | None:
    """A line as JSON: name, kind, algebra, and each number by its unit or blade; None for a comment."""
    if result.value is None:
        return None
    value = result.value
    return {
        "name": result.name,
        "kind": kind_of(value).name,
        "algebra": str(value.algebra) if isinstance(value, Multivector) else None,
        "values": {unit: number for number, unit in value_terms(value)},
        "text": value_text(value),
        "latex": value_latex(value),
    }
