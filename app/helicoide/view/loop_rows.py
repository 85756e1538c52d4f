"""The control loop of the arm: its diagram, and a button for each signal on its arrows, which adds it to the charts."""

from __future__ import annotations

from functools import partial

from markupsafe import Markup

from helicoide.readout.loop import loop_signals
from helicoide.text import Text
from helicoide.view.loop_diagram import LOOP, loop_diagram
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Button, Checkbox, DependentRows, Folder, HtmlRow, Row
from helicoide.view.signal_rows import chart_titles, with_charts, with_signal
from helicoide.view.window_view import View

SHOW = Text(en="Show the diagram", pt_BR="Mostrar o diagrama")
ADD = Text(en="Add a signal of the loop to the charts", pt_BR="Acrescentar um sinal da malha aos gráficos")
Named = tuple[tuple[str, Text], ...]


def loop_rows() -> Folder:
    """The diagram follows the method, the command and the surroundings. It is drawn only while it is asked for."""
    return Folder(
        LOOP,
        [
            Checkbox(
                SHOW,
                lambda view: view.seat.charts.loop,
                lambda on: ForSeat(lambda seat: with_charts(seat, loop=bool(on))),
            ),
            HtmlRow(lambda view: loop_diagram(view) if view.seat.charts.loop else Markup(""), computed=True),
            Folder(ADD, DependentRows(_on_arrows, _buttons), open=False),
        ],
    )


def _on_arrows(view: View) -> Named:
    """The name and the title of each signal on the arrows."""
    titles = chart_titles(view)
    return tuple((name, titles[name]) for name in loop_signals(view.state)) if titles else ()


def _buttons(named: Named) -> list[Row]:
    return [_button(name, title) for name, title in named]


def _button(name: str, title: Text) -> Button:
    return Button(lambda _: title, lambda _: ForSeat(partial(with_signal, name=name)))
