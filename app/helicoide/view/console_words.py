"""What the console says: the results of the lines, the names that complete what is typed, and all functions."""

from __future__ import annotations

import re
from functools import lru_cache

from markupsafe import Markup

from helicoide.console import (
    LineResult,
    SceneName,
    Value,
    all_functions,
    kind_of,
    pointer,
    scene_names,
    sheet_results,
    unit_grade,
    unit_latex,
    value_terms,
)
from helicoide.markup import formula_to_mathml
from helicoide.sheet import SheetLine
from helicoide.text import Language, Text, number_text
from helicoide.view.window_view import View

LINE = Markup(
    '<li class="helicoide-line{faint}"><span>{number}</span><div><pre>{source}</pre>{result}<em>{said}</em></div></li>'
)
LIST = Markup('<ol class="helicoide-lines">{}</ol>')
WRONG = Markup('<pre class="helicoide-wrong">{}</pre>')
ENTRY = Markup("<li><b>{}</b> {}</li>")
NAMES = Markup('<ul class="helicoide-note helicoide-names">{}</ul>')
TERM = Markup('{}<span class="g{}">{}</span> ')
FORMULA = Markup('<div class="helicoide-formula">= {}</div>')
EXAMPLE = Markup("{about}<br><i>{example} = {equals}</i>")

HIDDEN_LINE = Text(en="{kind}, hidden", pt_BR="{kind}, oculto")
EMPTY = Text(en="No lines yet.", pt_BR="Nenhuma linha ainda.")
MOST_MATCHES, DIGITS = 6, 5
_LAST_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")


def result_list(view: View) -> Markup:
    """The lines of the sheet with their results."""
    sheet, language = view.seat.sheet, view.seat.language
    if not sheet.lines:
        return Markup('<p class="helicoide-note">{}</p>').format(EMPTY[language])
    return _listed(sheet.lines, sheet_results(sheet, view.state), language)


@lru_cache(maxsize=64)  # rows are updated for other reasons, too, and these cost milliseconds
def _listed(lines: tuple[SheetLine, ...], results: tuple[LineResult, ...], language: Language) -> Markup:
    written = (_line(n, *pair, language) for n, pair in enumerate(zip(lines, results, strict=True), 1))
    return LIST.format(Markup("").join(written))


def _line(number: int, line: SheetLine, result: LineResult, language: Language) -> Markup:
    if result.error is not None:
        source, _, caret = pointer(line.text, result.error).partition("\n")
        said = result.error.text[language]
        return LINE.format(faint="", number=number, source=source, result=WRONG.format(caret), said=said)
    if result.value is None:
        return LINE.format(faint=" comment", number=number, source=line.text, result="", said="")
    kind = kind_of(result.value).title
    said = (kind if line.shown else HIDDEN_LINE.format(kind=kind))[language]
    shown = _typeset(result.value, language)
    return LINE.format(faint="" if line.shown else " faint", number=number, source=line.text, result=shown, said=said)


def _typeset(value: Value, language: Language) -> Markup:
    """A value as a formula: numbers as text, which change all the time, and blades as MathML, which is made once."""
    parts = Markup("")
    for number, unit in value_terms(value):
        sign = ("− " if parts else "−") if number < 0 else "+ " if parts else ""
        parts += TERM.format(sign, unit_grade(unit), _product(abs(number), unit, language))
    return FORMULA.format(parts or "0")


def _product(number: float, unit: str, language: Language) -> Markup:
    """A number that is not negative, and its blade; 1 alone is left out."""
    shown = number_text(number, f".{DIGITS}g")[language]
    if unit == "1":
        return Markup("{}").format(shown)
    blade = formula_to_mathml(unit_latex(unit))
    return blade if shown == "1" else Markup("{}&nbsp;{}").format(shown, blade)


def entry_help(view: View) -> Markup:
    """The names and functions that begin like the last word in the text field."""
    word, language = _LAST_WORD.search(view.seat.sheet.entry.text), view.seat.language
    if word is None:
        return Markup("")
    rows = [
        *(
            ENTRY.format(one.name, one.title[language])
            for one in scene_names(view.state).values()
            if one.name.startswith(word[0])
        ),
        *(
            ENTRY.format(function.signature, function.about[language])
            for name, function in all_functions().items()
            if name.startswith(word[0])
        ),
    ]
    return NAMES.format(Markup("").join(rows[:MOST_MATCHES])) if rows else Markup("")


def known_names(view: View) -> Markup:
    """The names of the scene, with what they stand for."""
    return _names(tuple(scene_names(view.state).values()), view.seat.language)


@lru_cache(maxsize=64)
def _names(names: tuple[SceneName, ...], language: Language) -> Markup:
    return NAMES.format(Markup("").join(ENTRY.format(one.name, one.title[language]) for one in names))


@lru_cache(maxsize=2)
def _functions(language: Language) -> Markup:
    rows = (
        ENTRY.format(
            function.signature,
            EXAMPLE.format(
                about=function.about[language], example=function.example.expression, equals=function.example.equals
            ),
        )
        for function in all_functions().values()
    )
    return NAMES.format(Markup("").join(rows))


def known_functions(view: View) -> Markup:
    """All functions, each with an example."""
    return _functions(view.seat.language)
