"""The method that drives the tool: choose it, set it, see what it reads, and compare it with another."""

from __future__ import annotations

import inspect
from functools import partial
from html import escape
from types import FunctionType
from typing import cast

from viser import Icon

from helicoide import gate
from helicoide.ik import objectives
from helicoide.ik.drive import GUARDED, Secondary
from helicoide.ik.method import Method, Promise, settings
from helicoide.ik.methods import named, names
from helicoide.kinematics.robot import Robot
from helicoide.readout import Instrument, holding, instruments
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.formula import mathml
from helicoide.view.rows import Changing, Choice, Folder, ForArm, Row, Slider, Tick, View, Words
from helicoide.view.settings import rows_of

TITLE = Text(en="Method", pt_BR="Método")
ORDER = 3
ICON = Icon.ROUTE

NONE = Text(en="none", pt_BR="nenhum")
NOTHING_TO_SET = Text(en="Nothing can be set.", pt_BR="Não há o que ajustar.")


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [
        Choice(
            Text(en="Method", pt_BR="Método"),
            [(name, named(name).TITLE) for name in names()],
            lambda view: view.state.drive.method,
            lambda name: ForArm(gate.choose_method(name)),
        ),
        Choice(
            Text(en="Side by side with", pt_BR="Lado a lado com"),
            [("", NONE), *((name, named(name).TITLE) for name in names())],
            _beside,
            lambda name: ForArm(gate.compare_with(name or None)),
        ),
        Words(_instruments),
        Folder(
            Text(en="Settings", pt_BR="Ajustes"),
            Changing(lambda view: view.state.drive.method, partial(_settings, robot)),
        ),
        Folder(
            Text(en="Settings of the other one", pt_BR="Ajustes do outro"),
            Changing(_beside, partial(_settings, robot)),
            open=False,
        ),
        Folder(Text(en="Gains", pt_BR="Ganhos"), [*map(_gain, range(4))], open=False),
        Folder(OBJECTIVE, _objective(robot), open=False),
        Folder(Text(en="About the method", pt_BR="Sobre o método"), [Words(_about), Words(_listing)], open=False),
    ]


def _beside(view: View) -> str:
    return "" if view.state.beside is None else view.state.beside.drive.method


def _about(view: View) -> str:
    """The source, the promises and the memory of the method."""
    method, language = named(view.state.drive.method), view.seat.language
    promises = "".join(f"<li>{escape(promise.value[language])}</li>" for promise in _in_order(method.PROMISES))
    remembers = f"<li>{escape(REMEMBERS.format(what=method.REMEMBERS)[language])}</li>" if method.REMEMBERS else ""
    return (
        f"<div class='helicoide-note'><p>{escape(method.SOURCE)}</p>"
        f"<p>{PROMISES[language]}</p><ul>{promises}{remembers}</ul></div>"
    )


PROMISES = Text(en="It promises:", pt_BR="Ele promete:")
REMEMBERS = Text(en="remembers {what}", pt_BR="lembra {what}")


def _in_order(promises: frozenset[Promise]) -> list[Promise]:
    return [promise for promise in Promise if promise in promises]


def _settings(robot: Robot, method: str) -> list[Row]:
    """A row for each setting of a method."""
    if not method or not settings(named(method).Options):
        return [Words(lambda view: f"<p class='helicoide-note'>{NOTHING_TO_SET[view.seat.language]}</p>")]
    return rows_of(
        named(method).Options,
        robot.reach,
        lambda view: view.state.drive.options(method),
        lambda name, value: ForArm(gate.set_option(method, name, value)),
    )


GAINS = (
    Text(en="x [1/s]", pt_BR="x [1/s]"),
    Text(en="y [1/s]", pt_BR="y [1/s]"),
    Text(en="z [1/s]", pt_BR="z [1/s]"),
    Text(en="orientation [1/s]", pt_BR="orientação [1/s]"),
)


def _gain(index: int) -> Slider:
    return Slider(
        GAINS[index],
        gate.LEAST_GAIN,
        gate.LARGEST_GAIN,
        0.5,
        lambda view: view.state.drive.gains[index],
        lambda value: ForArm(gate.set_gain(index, value)),
        lambda view: view.state.drive.method != GUARDED,
    )


OBJECTIVE = Text(en="Secondary objective", pt_BR="Objetivo secundário")


def _objective(robot: Robot) -> list[Row]:
    """What the joints do besides: an objective that this robot can have, its weight, its settings."""
    known = [(name, objectives.named(name)) for name in objectives.names()]
    options = [(name, one.TITLE) for name, one in known if one.applies(robot) is None]
    return [
        Choice(
            Text(en="Objective", pt_BR="Objetivo"),
            [("", NONE), *options],
            _chosen,
            lambda name: ForArm(gate.choose_objective(name or None)),
        ),
        Folder(Text(en="How", pt_BR="Como"), Changing(_chosen, partial(_how, robot))),
    ]


def _chosen(view: View) -> str:
    second = view.state.drive.secondary
    return "" if second is None else second.objective


def _how(robot: Robot, name: str) -> list[Row]:
    """Weight, way and settings of an objective; what it is told after it has been taken away is not heard."""
    if not name:
        return [Words(lambda view: f"<p class='helicoide-note'>{NOTHING_TO_SET[view.seat.language]}</p>")]
    objective, default = objectives.named(name), Secondary(name, objectives.named(name).Options())

    def second(view: View) -> Secondary:
        there = view.state.drive.secondary
        return there if there is not None and there.objective == name else default

    as_row = Tick(
        Text(en="as a row of the task", pt_BR="como linha da tarefa"),
        lambda view: second(view).as_row,
        lambda on: ForArm(gate.objective_as_row(on)),
    )
    return [
        Words(lambda view: f"{mathml(objective.EQUATION)}<p class='helicoide-note'>{escape(objective.SOURCE)}</p>"),
        Slider(
            Text(en="weight k₀ [1/s]", pt_BR="peso k₀ [1/s]"),
            0.0,
            gate.HEAVIEST,
            1.0,
            lambda view: second(view).weight,
            lambda value: ForArm(gate.weigh_objective(value)),
        ),
        *([as_row] if objective.AUGMENTS else []),
        Tick(
            Text(en="weights grow at limits (Algorithm 1)", pt_BR="pesos crescem nos limites (Algoritmo 1)"),
            lambda view: second(view).grows,
            lambda on: ForArm(gate.grow_weights(on)),
        ),
        *rows_of(
            objective.Options,
            robot.reach,
            lambda view: second(view).options,
            lambda setting, value: ForArm(gate.set_objective(setting, value)),
        ),
    ]


def _instruments(view: View) -> str:
    """The equation, and a table of what can be read off the method and off the one beside it."""
    arms = [state for state in (view.state, view.state.of_beside) if state is not None]
    columns = [{instrument.symbol: instrument for instrument in instruments(state)} for state in arms]
    lines = {symbol: instrument for column in columns for symbol, instrument in column.items()}
    head = "".join(f"<th>{escape(named(state.drive.method).TITLE[view.seat.language])}</th>" for state in arms)
    body = "".join(
        f"<tr><td>{mathml(symbol)}<span>{escape(instrument.title[view.seat.language])}</span></td>"
        + "".join(f"<td>{_read(column.get(symbol))}</td>" for column in columns)
        + "</tr>"
        for symbol, instrument in lines.items()
    )
    held = "".join(f"<td>{_held(state, view)}</td>" for state in arms)
    return mathml(named(view.state.drive.method).EQUATION) + (
        f"<table class='helicoide-instruments'><tr><th></th>{head}</tr>{body}"
        f"<tr><td>{HELD[view.seat.language]}</td>{held}</tr></table>"
    )


HELD = Text(en="held by", pt_BR="retido por")


def _read(instrument: Instrument | None) -> str:
    if instrument is None:
        return "–"
    return f"{instrument.value:.4g} {instrument.unit}".replace("-", "−").replace("inf", "∞")


def _held(state: State, view: View) -> str:
    return "<br>".join(escape(text[view.seat.language]) for text in holding(state)) or "–"


def _listing(view: View) -> str:
    """The source of the method's step, as it runs."""
    return f"<pre class='helicoide-listing'>{escape(listing(named(view.state.drive.method)))}</pre>"


def listing(method: Method) -> str:
    """The method's step as it runs, and before it the functions of ours that it calls by name."""
    step = cast(FunctionType, method.step)
    called = (step.__globals__.get(name) for name in step.__code__.co_names)
    ours = [one for one in called if isinstance(one, FunctionType) and one.__module__.startswith(OURS)]
    return "\n\n".join(inspect.getsource(function) for function in (*ours, step))


OURS = "helicoide.ik"
