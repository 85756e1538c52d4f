"""Faults of the texts of a lesson: differences between the languages, formulas, and bold words not on the screen."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache

from helicoide import gate
from helicoide.contributions.words import missing_words
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, Prose, Step, entered, turned_to
from helicoide.lesson.links import link_targets
from helicoide.lesson.prose import FORMULA, PICTURE, paragraphs, placeholders
from helicoide.markup import formula_to_mathml
from helicoide.state import initial_state
from helicoide.text import LANGUAGES, Language, Text, join_texts
from helicoide.view import page, panels
from helicoide.view.docked import lesson_rows
from helicoide.view.rows import (
    Button,
    ButtonGroup,
    Checkbox,
    DependentRows,
    Dropdown,
    Folder,
    Row,
    Slider,
    TextEntry,
    VectorRow,
)
from helicoide.view.window import new_seat
from helicoide.view.window_view import View

SHORTEST_HINT = 20
BOLD = re.compile(r"\*\*(.+?)\*\*")
NUMBER = re.compile(r"[−]?\d+(?:[.,]\d+)?")
# What a formula may write in another way in Portuguese.
IN_PORTUGUESE = ((r"\operatorname{sen}", r"\sin"), (r"\operatorname{tg}", r"\tan"), ("{,}", "."), (r"\,", ""))
WORDS_IN_FORMULA = re.compile(r"\\(?:text|mathrm)\{[^}]*\}")
OF_STEP = Text(en="step {step}: {what}", pt_BR="passo {step}: {what}")
TITLE = Text(en="the title of the lesson", pt_BR="o título da lição")
ABOUT = Text(en="ABOUT", pt_BR="ABOUT")
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
NO_FORMULA = Text(en="the page cannot show the formula {tex}", pt_BR="a página não consegue mostrar a fórmula {tex}")
NOT_SHOWN = Text(
    en="bold is for words of the screen, and these are none of it in {language}: {words}",
    pt_BR="negrito é para palavras da tela, e estas não estão nela em {language}: {words}",
)


def word_faults(lesson: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the texts of a lesson."""
    yield from missing_words(TITLE, lesson.title)
    if lesson.about.en or lesson.about.pt_BR:
        yield from missing_words(ABOUT, lesson.about, differ=True)
    for number, step in enumerate(lesson.steps):
        for fault in _of_step(lesson, number, step, robot):
            yield OF_STEP.format(step=step.id, what=fault)


def _of_step(lesson: Lesson, number: int, step: Step, robot: Robot) -> Iterator[Text]:
    prose = lesson.prose[step.id]
    for part, text in _parts(prose):
        if text.en or text.pt_BR:
            yield from missing_words(part, text, differ=True)
        if unlike := [*_unlike(text)]:
            yield UNLIKE.format(part=part, what=join_texts(unlike, ", "))
        yield from _formula_faults(text)
    for option in prose.options:
        yield from missing_words(OPTION, option)
    for language in LANGUAGES:
        if len(prose.hint[language]) <= SHORTEST_HINT:
            yield HINT.format(n=SHORTEST_HINT, language=language)
        if re.search(r"(?m)^(#|>)", prose.body[language] + "\n" + prose.task[language]):
            yield MARKS.format(language=language)
        bold = {word for _, text in _parts(prose) for word in BOLD.findall(text[language])}
        unknown = bold - screen_words(robot, language)
        if unknown and (missing := sorted(unknown - step_words(lesson, number, robot, language))):
            yield NOT_SHOWN.format(language=language, words=", ".join(missing))


OPTION = Text(en="an option", pt_BR="uma opção")
HINT_OF = Text(en="the hint of {name}", pt_BR="a dica de {name}")


def _parts(prose: Prose) -> Iterator[tuple[Text, Text]]:
    """Each text of a step, with what it is called."""
    yield Text(en="its title", pt_BR="o título"), prose.title
    yield Text(en="its text", pt_BR="o texto"), prose.body
    yield Text(en="its question", pt_BR="a pergunta"), prose.question
    yield Text(en="what it reveals", pt_BR="o que ele revela"), prose.reveal
    yield Text(en="its text after the question", pt_BR="o texto depois da pergunta"), prose.task
    yield Text(en="its hint", pt_BR="a dica"), prose.hint
    for name, hint in prose.hints.items():
        yield HINT_OF.format(name=name), hint


def _numbers(words: str) -> list[str]:
    """The numbers in a text of either language, sorted, with a decimal point; without those of formulas and links."""
    plain = re.sub(r"\]\([^)]*\)", "]", FORMULA.sub("", words))
    return sorted(number.replace(",", ".") for number in NUMBER.findall(plain))


def _formulas(words: str) -> list[str]:
    """The formulas in a text, sorted, without what differs between the languages."""
    found = [match[0] for match in FORMULA.finditer(words)]
    for ours, theirs in IN_PORTUGUESE:
        found = [formula.replace(ours, theirs) for formula in found]
    return sorted(WORDS_IN_FORMULA.sub("", formula) for formula in found)


# What has to be the same in both languages.
SAME: tuple[tuple[Text, Callable[[str], object]], ...] = (
    (Text(en="paragraphs", pt_BR="parágrafos"), lambda words: len(paragraphs(words))),
    (Text(en="words in bold", pt_BR="palavras em negrito"), lambda words: len(BOLD.findall(words))),
    (Text(en="numbers", pt_BR="números"), _numbers),
    (Text(en="values", pt_BR="valores"), lambda words: sorted(placeholders(words))),
    (Text(en="formulas", pt_BR="fórmulas"), _formulas),
    (Text(en="links", pt_BR="links"), lambda words: sorted(link_targets(words))),
    (Text(en="pictures", pt_BR="figuras"), lambda words: sorted(PICTURE.findall(words))),
)


def _unlike(text: Text) -> Iterator[Text]:
    """What differs between the languages."""
    return (what for what, found in SAME if found(text.en) != found(text.pt_BR))


def _formula_faults(text: Text) -> Iterator[Text]:
    for formula in {match[0] for language in LANGUAGES for match in FORMULA.finditer(text[language])}:
        try:
            is_shown = "\\" not in formula_to_mathml(formula.strip("$"))  # an unknown command stays as it is
        except Exception:  # latex2mathml has no common class of its errors
            is_shown = False
        if not is_shown:
            yield NO_FORMULA.format(tex=formula)


@lru_cache(maxsize=32)
def screen_words(robot: Robot, language: Language) -> frozenset[str]:
    """The texts on the panels for a robot, at rest and on a path: titles of tabs, labels, buttons, options."""
    seat, at_rest = new_seat("", language, None), initial_state(robot)
    views = View(at_rest, seat), View(gate.play()(at_rest), seat)
    titles = [panel.TITLE[language] for panel in panels.all_panels()]
    words = (word for view in views for word in _labels(_panel_rows(robot), view))
    return frozenset((page.STOP[language], *titles, *words))


def step_words(lesson: Lesson, number: int, robot: Robot, language: Language) -> frozenset[str]:
    """The texts of labels and buttons in a step, and on the panels once it is set up."""
    seat = turned_to(lesson, entered(new_seat("", language, None), lesson.id), number)
    set_up = View(lesson.steps[number].setup(initial_state(robot)), seat)
    return frozenset(_labels([*lesson_rows(robot, seat), *_panel_rows(robot)], set_up))


def _panel_rows(robot: Robot) -> list[Row]:
    return [row for panel in panels.all_panels() for row in panel.rows(robot)]


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
            case ButtonGroup(label, options):
                yield from (label[language], *(shown[language] for _, shown in options))
            case Slider(label):
                yield (label if isinstance(label, Text) else label(view))[language]
            case TextEntry(label, button=button):
                yield from (label[language], button[language])
            case Checkbox(label) | VectorRow(label):
                yield label[language]
