"""Faults of the texts of a lesson: differences between the languages, and bold words that are not on the screen."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from helicoide.contributions.words import missing_words
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, Prose
from helicoide.state import initial_state
from helicoide.text import LANGUAGES, Language, Text, join_texts
from helicoide.view import page, panels
from helicoide.view.panels.lesson import step_rows
from helicoide.view.rows import Button, Checkbox, DependentRows, Dropdown, Folder, Row, Slider, VectorRow
from helicoide.view.window import new_seat
from helicoide.view.window_view import View

SHORTEST_HINT = 20
BOLD = re.compile(r"\*\*(.+?)\*\*")
NUMBER = re.compile(r"[−]?\d+(?:[.,]\d+)?")
OF_STEP = Text(en="step {step}: {what}", pt_BR="passo {step}: {what}")
TITLE = Text(en="the title of the lesson", pt_BR="o título da lição")
PARTS = {
    "title": Text(en="its title", pt_BR="o título"),
    "body": Text(en="its text", pt_BR="o texto"),
    "hint": Text(en="its hint", pt_BR="a dica"),
}
HINT = Text(
    en="its hint has fewer than {n} characters in {language}",
    pt_BR="a dica tem menos de {n} caracteres em {language}",
)
MARKS = Text(
    en="a line of its text begins with # or > in {language}", pt_BR="uma linha do texto começa com # ou > em {language}"
)
UNLIKE = Text(
    en="{part} has other {what} in English than in Portuguese",
    pt_BR="{part} tem {what} diferentes em inglês e português",
)
PARAGRAPHS = Text(en="paragraphs", pt_BR="parágrafos")
BOLDS = Text(en="words in bold", pt_BR="palavras em negrito")
NUMBERS = Text(en="numbers", pt_BR="números")
NOT_SHOWN = Text(
    en="bold is for words of the screen, and these are none of it in {language}: {words}",
    pt_BR="negrito é para palavras da tela, e estas não estão nela em {language}: {words}",
)


def word_faults(lesson: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the texts of a lesson."""
    yield from missing_words(TITLE, lesson.title)
    for step, prose in lesson.prose.items():
        for fault in _of_prose(prose, robot):
            yield OF_STEP.format(step=step, what=fault)


def _of_prose(prose: Prose, robot: Robot) -> Iterator[Text]:
    for name, part in PARTS.items():
        text: Text = getattr(prose, name)
        yield from missing_words(part, text, differ=True)
        if name != "title" and (unlike := [*_unlike(text)]):
            yield UNLIKE.format(part=part, what=join_texts(unlike, ", "))
    for language in LANGUAGES:
        if len(prose.hint[language]) <= SHORTEST_HINT:
            yield HINT.format(n=SHORTEST_HINT, language=language)
        if re.search(r"(?m)^(#|>)", prose.body[language]):
            yield MARKS.format(language=language)
        bold = set(BOLD.findall(prose.body[language] + "\n" + prose.hint[language]))
        if missing := sorted(bold - screen_words(robot, language)):
            yield NOT_SHOWN.format(language=language, words=", ".join(missing))


def _unlike(text: Text) -> Iterator[Text]:
    if len(re.split(r"\n\s*\n", text.en)) != len(re.split(r"\n\s*\n", text.pt_BR)):
        yield PARAGRAPHS
    if len(BOLD.findall(text.en)) != len(BOLD.findall(text.pt_BR)):
        yield BOLDS
    if _numbers(text.en) != _numbers(text.pt_BR):
        yield NUMBERS


def _numbers(words: str) -> list[str]:
    """The numbers in a text of either language, sorted, with a decimal point."""
    return sorted(number.replace(",", ".") for number in NUMBER.findall(words))


@lru_cache(maxsize=32)
def screen_words(robot: Robot, language: Language) -> frozenset[str]:
    """The texts on the panels for a robot: titles of tabs, labels, buttons, options."""
    view = View(initial_state(robot), new_seat("", language, None))
    rows = [*(row for panel in panels.all_panels() for row in panel.rows(robot)), *step_rows(robot, ())]
    titles = [panel.TITLE[language] for panel in panels.all_panels()]
    return frozenset((page.STOP[language], *titles, *_labels(rows, view)))


def _labels(rows: Sequence[Row], view: View) -> Iterator[str]:
    language = view.seat.language
    for row in rows:
        match row:
            case Folder(label, inside):
                yield label[language]
                yield from _labels(inside.rows(inside.key(view)) if isinstance(inside, DependentRows) else inside, view)
            case Dropdown(label, options):
                known = options(view) if callable(options) else options
                yield from (label[language], *(shown[language] for _, shown in known))
            case Button(label):
                yield label(view)[language]
            case Slider(label):
                yield (label if isinstance(label, Text) else label(view))[language]
            case Checkbox(label) | VectorRow(label):
                yield label[language]
