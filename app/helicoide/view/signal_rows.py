"""The rows of the live charts: which signals, how long, which axis, pause, the charts, and their file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup
from viser import Icon

from helicoide.export.history_csv import history_csv
from helicoide.readout.signals import needed_signals, phase_planes, signal_groups, signals_of
from helicoide.seat import Seat
from helicoide.text import Text, join_texts, untranslated
from helicoide.view import html
from helicoide.view.requests import ForSeat, Save
from helicoide.view.rows import Button, Checkbox, Dropdown, Folder, HtmlRow, Plot, Row
from helicoide.view.settings import NONE
from helicoide.view.signal_charts import live_charts, method_titles
from helicoide.view.window_view import View

MOST_CHARTS, SPANS, FILE = 4, (10, 20, 30, 60), "helicoide_signals.csv"
GROUP, CUSTOM = Text(en="Signals", pt_BR="Sinais"), Text(en="own choice", pt_BR="escolha própria")
CHOICE, CHART = (
    Text(en="Signal of each chart", pt_BR="Sinal de cada gráfico"),
    Text(en="Chart {n}", pt_BR="Gráfico {n}"),
)
SPAN, SECONDS = Text(en="Time span", pt_BR="Intervalo"), untranslated("{n} s")
LOG = Text(en="Logarithmic axis", pt_BR="Eixo logarítmico")
PAUSE, RESUME = Text(en="Pause charts", pt_BR="Pausar gráficos"), Text(en="Resume charts", pt_BR="Retomar gráficos")
SAVE = Text(en="Save charts as CSV", pt_BR="Salvar gráficos como CSV")
CHOOSE = Text(
    en="Choose a group of signals. The charts are drawn while the arm moves.",
    pt_BR="Escolha um grupo de sinais. Os gráficos são traçados enquanto o braço se move.",
)
WAITING = Text(en="The charts begin when the arm moves.", pt_BR="Os gráficos começam quando o braço se mover.")
UNDEFINED = Text(
    en="Not defined for the current arm, command and method: {names}.",
    pt_BR="Não definido para o braço, o comando e o método atuais: {names}.",
)
POINTER = Text(
    en="The legend shows the values under the pointer. Drag across a paused chart to zoom; double-click to undo.",
    pt_BR="A legenda mostra os valores sob o ponteiro. Arraste sobre um gráfico pausado para ampliar; clique duas "
    "vezes para desfazer.",
)


def signal_rows() -> list[Row]:
    """Nothing is sampled while no signal is chosen. Charts are rows of their own, since a window writes row by row."""
    return [
        Dropdown(GROUP, _groups, _group, lambda name: ForSeat(lambda seat: with_group(seat, name))),
        Folder(CHOICE, [_picker(index) for index in range(MOST_CHARTS)], open=False),
        Dropdown(
            SPAN,
            [(str(n), SECONDS.format(n=n)) for n in SPANS],
            lambda view: str(round(view.seat.charts.span)),
            lambda n: ForSeat(lambda seat: with_charts(seat, span=float(n))),
        ),
        Checkbox(
            LOG, lambda view: view.seat.charts.log, lambda on: ForSeat(lambda seat: with_charts(seat, log=bool(on)))
        ),
        *(Plot(live_charts, index) for index in range(MOST_CHARTS)),
        HtmlRow(_note),
        *_buttons(),
    ]


def _buttons() -> Sequence[Row]:
    """Pause or resume, and save."""
    return (
        Button(
            lambda view: RESUME if view.seat.charts.paused else PAUSE,
            lambda view: ForSeat(lambda seat: with_charts(seat, paused=not view.seat.charts.paused)),
            Icon.PLAYER_PAUSE,
            lambda view: any(view.seat.charts.shown),
        ),
        Button(lambda _: SAVE, _saved, Icon.DOWNLOAD, lambda view: len(view.history.times) > 0),
    )


def with_charts(seat: Seat, **changes: object) -> Seat:
    """The seat with other fields of its choice of charts."""
    return replace(seat, charts=replace(seat.charts, **changes))  # type: ignore[arg-type]


def with_group(seat: Seat, name: str) -> Seat:
    """The seat with the charts of a group, or without charts if there is no such group."""
    shown = next((group.PRESET for group in signal_groups() if _name(group) == name), ())
    return with_charts(seat, shown=shown, paused=False)


def with_chart(seat: Seat, index: int, name: str) -> Seat:
    """The seat with one chart showing another signal, or no chart for the name ""."""
    shown = [*seat.charts.shown, *[""] * MOST_CHARTS][:MOST_CHARTS]
    shown[index] = name
    return with_charts(seat, shown=tuple(shown))


def with_signal(seat: Seat, name: str) -> Seat:
    """The seat with one more chart, in the first free place, or else in the last one."""
    shown = [*seat.charts.shown, *[""] * MOST_CHARTS][:MOST_CHARTS]
    if name in shown:
        return seat
    return with_chart(seat, shown.index("") if "" in shown else MOST_CHARTS - 1, name)


def _name(group: object) -> str:
    return str(getattr(group, "__name__", "")).rpartition(".")[2]


def _groups(view: View) -> list[tuple[str, Text]]:
    """The groups that have signals for this arm, none, and, if it is so, an own choice."""
    known = chart_titles(view)
    groups = [(_name(group), group.TITLE) for group in signal_groups() if any(name in known for name in group.PRESET)]
    own = [("own", CUSTOM)] if _group(view) == "own" else []
    return [("", NONE), *groups, *own]


def _group(view: View) -> str:
    """The group that is shown, "" for none, "own" for another choice."""
    shown = tuple(name for name in view.seat.charts.shown if name)
    known = chart_titles(view)
    if not shown or not known:
        return ""
    groups = (group for group in signal_groups() if any(name in known for name in group.PRESET))
    return next((_name(group) for group in groups if shown == group.PRESET), "own")


def _picker(index: int) -> Dropdown:
    """The choice of the signal of one chart."""

    def chosen(view: View) -> str:
        shown = view.seat.charts.shown
        name = shown[index] if index < len(shown) else ""
        return name if name in chart_titles(view) else ""

    return Dropdown(
        CHART.format(n=index + 1),
        lambda view: [("", NONE), *chart_titles(view).items()],
        chosen,
        lambda name: ForSeat(lambda seat: with_chart(seat, index, name)),
    )


def chart_titles(view: View) -> dict[str, Text]:
    """The title of every signal and phase plane, by name; none until the kernels are compiled, which find them."""
    if not view.ready:
        return {}
    signals = {name: signal.title for name, signal in signals_of(view.state).items()}
    return {**signals, **{name: phase.title for name, phase in phase_planes().items()}}


def _note(view: View) -> Markup:
    """What is missing, in words; otherwise how to read the charts."""
    language, shown = view.seat.language, [name for name in view.seat.charts.shown if name]
    if not shown:
        return html.note(CHOOSE[language])
    if len(view.history.times) < 2:
        return html.note(WAITING[language])
    blank = _undefined(view, shown)
    words = html.note(UNDEFINED.format(names=join_texts(blank))[language]) if blank else Markup("")
    return words + html.note(POINTER[language])


def _undefined(view: View, shown: Sequence[str]) -> list[Text]:
    """The titles of the chosen charts without a value at the last sample."""
    titles, history = chart_titles(view), view.history

    def is_blank(name: str) -> bool:
        sampled = (history.of(signal) for signal in needed_signals(view.state, (name,)))
        return any(values is not None and not np.isfinite(values[-1]).any() for values in sampled)

    return [titles[name] for name in shown if name in titles and is_blank(name)]


def _saved(view: View) -> Save:
    """What the charts show as a file."""
    charts, arms = view.seat.charts, method_titles(view.state)
    signals = needed_signals(view.state, charts.shown)
    return Save(FILE, history_csv(view.history, signals, charts.span, view.seat.language, arms).encode("utf-8-sig"))
