"""Rows for the console: the text field, the lines with their results, sliders, example sheets, files and links."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from viser import Icon

from helicoide.console import example_sheets, free_names, scene_names
from helicoide.sheet import (
    NameSlider,
    Sheet,
    sheet_of_file,
    sheet_text,
    with_chosen_line,
    with_entered_line,
    with_entry_text,
    with_shown,
)
from helicoide.text import Text, untranslated
from helicoide.view import html
from helicoide.view.console_words import entry_help, known_functions, known_names, result_list
from helicoide.view.requests import ForSeat, OpenLink, Save
from helicoide.view.rows import Button, DependentRows, Dropdown, Folder, HtmlRow, Row, Slider, TextEntry, Upload
from helicoide.view.share import encode_link
from helicoide.view.window_view import View

TITLE_OF_CONSOLE = Text(en="Console", pt_BR="Console")
ABOUT_CONSOLE = Text(
    en="Compute with what is in the scene: type join(elbow, wrist), p = M_tool >> point(0,0,0.1) or "
    "exp(0.5*theta*L2). A name that nothing defines becomes a slider. Numbers have a decimal point, arguments a comma "
    "between them.",
    pt_BR="Calcule com o que está na cena: digite join(elbow, wrist), p = M_tool >> point(0,0,0.1) ou "
    "exp(0.5*theta*L2). Um nome sem definição vira controle deslizante. Aqui os números têm ponto decimal, e uma "
    "vírgula separa os argumentos.",
)
NEW_LINE = Text(en="new line", pt_BR="nova linha")
FILE = "sheet.txt"
STEPS = 200
LONGEST_LABEL = 40


def console_rows() -> Folder:
    """All rows of the console."""
    rows: list[Row] = [
        HtmlRow(lambda view: html.note(ABOUT_CONSOLE[view.seat.language])),
        *console_line_rows(),
        Folder(Text(en="Change a line", pt_BR="Mudar uma linha"), _line_rows(), open=False),
        Folder(Text(en="Names and functions", pt_BR="Nomes e funções"), _help_rows(), open=False),
        Folder(Text(en="Sheets", pt_BR="Folhas"), _sheet_rows(), open=False),
    ]
    return Folder(TITLE_OF_CONSOLE, rows, open=False)


def console_line_rows() -> list[Row]:
    """The text field of the console with the results, and the sliders of the names."""
    return [
        _entry(),
        HtmlRow(entry_help),
        HtmlRow(result_list, computed=True),
        Folder(Text(en="Sliders", pt_BR="Controles deslizantes"), DependentRows(_slider_names, _sliders)),
    ]


def _changed(change: Callable[[Sheet], Sheet]) -> ForSeat:
    return ForSeat(lambda seat: replace(seat, sheet=change(seat.sheet)))


def _entry() -> TextEntry:
    return TextEntry(
        Text(en="Expression", pt_BR="Expressão"),
        lambda view: view.seat.sheet.entry.text,
        Text(en="Enter line", pt_BR="Inserir linha"),
        lambda text: _changed(lambda sheet: with_entered_line(sheet, text)),
        lambda text: _changed(lambda sheet: with_entry_text(sheet, text)),
    )


def _help_rows() -> list[Row]:
    return [HtmlRow(known_names), HtmlRow(known_functions)]


def _slider_names(view: View) -> tuple[tuple[str, float, float], ...]:
    """The free names of the sheet, with the ends of their sliders."""
    sheet = view.seat.sheet
    free = free_names(sheet, scene_names(view.state))
    return tuple((name, sheet.slider(name).lower, sheet.slider(name).upper) for name in free)


def _sliders(names: tuple[tuple[str, float, float], ...]) -> list[Row]:
    return [_slider(name, lower, upper) for name, lower, upper in names]


def _slider(name: str, lower: float, upper: float) -> Slider:
    return Slider(
        untranslated(name),
        lower,
        upper,
        (upper - lower) / STEPS,
        lambda view: view.seat.sheet.slider(name).value,
        lambda value: _changed(lambda sheet: sheet.with_slider(name, NameSlider(value, lower, upper))),
    )


def _chosen(view: View) -> int | None:
    """The line that is being changed."""
    return view.seat.sheet.entry.chosen


def _has_choice(view: View) -> bool:
    return _chosen(view) is not None


def _line_rows() -> list[Row]:
    """Rows that choose a line, and change, hide or remove it."""

    def options(view: View) -> list[tuple[str, Text]]:
        lines = view.seat.sheet.lines
        texts = [untranslated(f"{n + 1}: {line.text[:LONGEST_LABEL]}") for n, line in enumerate(lines)]
        return [("", NEW_LINE), *((str(n), text) for n, text in enumerate(texts))]

    def key(view: View) -> str:
        chosen = _chosen(view)
        return "" if chosen is None else str(chosen)

    return [
        Dropdown(
            Text(en="Line", pt_BR="Linha"),
            options,
            key,
            lambda key: _changed(lambda sheet: with_chosen_line(sheet, int(key) if key.isdigit() else None)),
        ),
        _past_lines(),
        Button(_eye_label, _toggle, Icon.EYE, enabled=_has_choice),
        Button(
            lambda _: Text(en="Show all results", pt_BR="Mostrar todos os resultados"),
            lambda _: _changed(lambda sheet: with_shown(sheet, True)),
            Icon.EYE,
        ),
        Button(
            lambda _: Text(en="Remove line", pt_BR="Remover linha"),
            lambda _: _changed(lambda sheet: with_entered_line(sheet, "")),
            Icon.TRASH,
            enabled=_has_choice,
            weight="destructive",
        ),
    ]


def _past_lines() -> Dropdown:
    """Lines that were entered before, the newest first; the chosen one is put into the text field."""

    def options(view: View) -> list[tuple[str, Text]]:
        past = view.seat.sheet.entry.past
        return [("", NOTHING), *((text, untranslated(text[:LONGEST_LABEL])) for text in reversed(past))]

    return Dropdown(
        Text(en="Entered before", pt_BR="Já inseridas"),
        options,
        lambda _: "",
        lambda text: _changed(lambda sheet: with_entry_text(sheet, text)),
    )


NOTHING = Text(en="–", pt_BR="–")
HIDE = Text(en="Hide result in the scene", pt_BR="Ocultar o resultado na cena")
SHOW = Text(en="Show result in the scene", pt_BR="Mostrar o resultado na cena")


def _eye_label(view: View) -> Text:
    chosen = _chosen(view)
    return HIDE if chosen is None or view.seat.sheet.lines[chosen].shown else SHOW


def _toggle(view: View) -> ForSeat:
    chosen = _chosen(view) or 0
    shown = not view.seat.sheet.lines[chosen].shown
    return _changed(lambda sheet: with_shown(sheet, shown, chosen))


def _sheet_rows() -> list[Row]:
    """Rows that load an example, save and load a file, and open a link."""
    return [
        Dropdown(
            Text(en="Example", pt_BR="Exemplo"),
            [("", NOTHING), *((name, example.title) for name, example in example_sheets().items())],
            _example,
            lambda name: _changed(lambda sheet: example_sheets()[name].sheet if name in example_sheets() else sheet),
        ),
        Button(
            lambda _: Text(en="Save sheet", pt_BR="Salvar folha"),
            lambda view: Save(FILE, sheet_text(view.seat.sheet).encode()),
            Icon.DOWNLOAD,
        ),
        Upload(
            Text(en="Load sheet", pt_BR="Carregar folha"),
            lambda _, __, content: _changed(lambda _: sheet_of_file(content)),
        ),
        TextEntry(
            Text(en="Link to this sheet", pt_BR="Link desta folha"),
            _address,
            Text(en="Open link", pt_BR="Abrir link"),
            OpenLink,
        ),
        Button(
            lambda _: Text(en="Empty sheet", pt_BR="Esvaziar folha"),
            lambda _: _changed(lambda _: Sheet()),
            Icon.TRASH,
            enabled=lambda view: bool(view.seat.sheet.lines),
            weight="destructive",
        ),
    ]


def _address(view: View) -> str:
    """The address that opens the sheet in a browser; empty for an empty sheet."""
    return f"{view.address}#{encode_link(view.seat.sheet)}" if view.seat.sheet != Sheet() else ""


def _example(view: View) -> str:
    """The example that the sheet is, as long as it is unchanged."""
    same = (name for name, example in example_sheets().items() if example.sheet == view.seat.sheet)
    return next(same, "")
