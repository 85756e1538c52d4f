"""The method that drives the tool: choose it, set it, read its instruments, compare it with another."""

from __future__ import annotations

import inspect
from functools import cache, partial
from types import FunctionType
from typing import cast

from markupsafe import Markup
from viser import Icon

from helicoide import gate
from helicoide.ik.controller import GUARDED
from helicoide.ik.method import Promise, settings
from helicoide.ik.methods import named, names
from helicoide.kinematics.robot import Robot
from helicoide.text import Text
from helicoide.view import html
from helicoide.view.comparison import CHARTS, comparison_charts, largest_values
from helicoide.view.instruments import instrument_table
from helicoide.view.modes import MODES, mode_table
from helicoide.view.objective import objective_rows
from helicoide.view.requests import ForArm, TrySingular
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, HtmlRow, Plot, Row, Slider
from helicoide.view.settings import NONE, NOTHING_TO_SET, setting_rows
from helicoide.view.window_view import View

TITLE = Text(en="Method", pt_BR="Método")
ORDER = 3
ICON = Icon.ROUTE


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [
        Dropdown(
            Text(en="Method", pt_BR="Método"),
            [(name, named(name).TITLE) for name in names()],
            lambda view: view.state.request.controller.method,
            lambda name: ForArm(gate.choose_method(name)),
        ),
        Dropdown(
            Text(en="Compare with", pt_BR="Comparar com"),
            [("", NONE), *((name, named(name).TITLE) for name in names())],
            _compared,
            lambda name: ForArm(gate.compare_with(name or None)),
        ),
        Button(lambda _: SINGULAR, lambda _: TrySingular(), Icon.TRENDING_UP, lambda view: view.ready),
        *(Plot(comparison_charts, index) for index in range(CHARTS)),
        HtmlRow(largest_values, computed=True),
        HtmlRow(instrument_table, computed=True),
        Folder(
            Text(en="Settings", pt_BR="Ajustes"),
            DependentRows(lambda view: view.state.request.controller.method, partial(_settings, robot)),
        ),
        Folder(MODES, [HtmlRow(mode_table, computed=True)], open=False),
        Folder(
            Text(en="Settings of the compared method", pt_BR="Ajustes do método comparado"),
            DependentRows(_compared, partial(_settings, robot)),
            open=False,
        ),
        Folder(Text(en="Gains", pt_BR="Ganhos"), [*map(_gain, range(4))], open=False),
        Folder(Text(en="Secondary objective", pt_BR="Objetivo secundário"), objective_rows(robot), open=False),
        Folder(Text(en="About the method", pt_BR="Sobre o método"), [HtmlRow(_about), HtmlRow(_listing)], open=False),
    ]


SINGULAR = Text(en="Try a singular posture", pt_BR="Testar uma postura singular")


def _compared(view: View) -> str:
    return "" if view.state.compared is None else view.state.compared.controller.method


def _about(view: View) -> Markup:
    """The source, the promises and the memory of the method."""
    method, language = named(view.state.request.controller.method), view.seat.language
    said = [promise.value for promise in _in_order(method.PROMISES)]
    if method.REMEMBERS:
        said.append(REMEMBERS.format(what=method.REMEMBERS))
    points = Markup("").join(Markup("<li>{}</li>").format(words[language]) for words in said)
    return Markup("<div class='helicoide-note'><p>{}</p><p>{}</p><ul>{}</ul></div>").format(
        method.SOURCE, PROMISES[language], points
    )


PROMISES = Text(en="Guarantees:", pt_BR="Garantias:")
REMEMBERS = Text(en="internal state: {what}", pt_BR="estado interno: {what}")


def _in_order(promises: frozenset[Promise]) -> list[Promise]:
    return [promise for promise in Promise if promise in promises]


def _settings(robot: Robot, method: str) -> list[Row]:
    """A row for each setting of a method."""
    if not method or not settings(named(method).Options):
        return [HtmlRow(lambda view: html.note(NOTHING_TO_SET[view.seat.language]))]
    return setting_rows(
        named(method).Options,
        robot.reach,
        lambda view: view.state.request.controller.options(method),
        lambda name, value: ForArm(gate.set_option(method, name, value)),
    )


GAINS = (
    Text(en="x [1/s]", pt_BR="x [1/s]"),
    Text(en="y [1/s]", pt_BR="y [1/s]"),
    Text(en="z [1/s]", pt_BR="z [1/s]"),
    Text(en="Orientation [1/s]", pt_BR="Orientação [1/s]"),
)


def _gain(index: int) -> Slider:
    return Slider(
        GAINS[index],
        gate.LEAST_GAIN,
        gate.LARGEST_GAIN,
        0.5,
        lambda view: view.state.request.controller.gains[index],
        lambda value: ForArm(gate.set_gain(index, value)),
        lambda view: view.state.request.controller.method != GUARDED,
    )


def _listing(view: View) -> Markup:
    """The source of the method's step, as it runs."""
    return Markup("<pre class='helicoide-listing'>{}</pre>").format(listing(view.state.request.controller.method))


@cache
def listing(name: str) -> str:
    """The source of the method's step, after those functions of `helicoide.ik` that it calls by name."""
    step = cast(FunctionType, named(name).step)
    called = (step.__globals__.get(name) for name in step.__code__.co_names)
    ours = [one for one in called if isinstance(one, FunctionType) and one.__module__.startswith(OURS)]
    return "\n\n".join(inspect.getsource(function) for function in (*ours, step))


OURS = "helicoide.ik"
