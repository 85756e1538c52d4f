"""The rows of an exercise whose line is typed: the names it may use, the accepted lines, and what is wrong with one."""

from __future__ import annotations

from markupsafe import Markup

from helicoide.console import ExpressionError, pointer
from helicoide.lines import LINE_KINDS, GivenName, LineExercise, Refused, WrongTerm
from helicoide.text import Language, Text, untranslated
from helicoide.view.open_step import OpenStep, open_step
from helicoide.view.requests import CheckLine
from helicoide.view.rows import HtmlRow, Row, TextEntry
from helicoide.view.window_view import LineCheck, View

ASKED = Text(en="Type {kind}. Names:", pt_BR="Digite {kind}. Nomes:")
CHECK = Text(en="Check line", pt_BR="Conferir linha")
LINE = Text(en="Your line", pt_BR="Sua linha")
ACCEPTED = Text(en="Accepted: equal for all values.", pt_BR="Aceita: igual para todos os valores.")
GHOSTS = Text(
    en="In the scene, the motion of your line is orange, the right one green.",
    pt_BR="Na cena, o movimento da sua linha é laranja, e o certo é verde.",
)
BOX = Markup('<div class="helicoide-lesson helicoide-line-exercise"><p>{}</p><ul>{}</ul>{}</div>')
NAME, DONE = Markup("<li><b>{}</b> {}</li>"), Markup('<pre class="helicoide-accepted">✓ {}{}</pre>')
WRONG = Markup('<div class="helicoide-lesson" role="status"><pre class="helicoide-wrong">{}</pre>{}</div>')
PARAGRAPH = Markup("<p>{}</p>")


def line_rows(opened: OpenStep, exercise: LineExercise, language: Language) -> list[Row]:
    """The rows of an exercise; without the text field once all its lines are accepted."""
    lines, number = exercise.lines(), len(opened.accepted_lines)
    rows: list[Row] = [HtmlRow(_asked_for)]
    if number < len(lines):
        label = untranslated(_defined(exercise, number).strip()) if number < len(exercise.steps) else LINE
        rows.append(TextEntry(label, lambda _: "", CHECK, CheckLine))
    return [*rows, HtmlRow(_verdict)]


def _defined(exercise: LineExercise, number: int) -> str:
    """The beginning of a line that defines a name, such as "M_1 ="; empty for the last line."""
    return f"{exercise.steps[number][0]} = " if number < len(exercise.steps) else ""


def wrong_term(view: View) -> tuple[LineCheck, WrongTerm] | None:
    """The line that was typed last for the open step, and its wrong term; None if it has none."""
    check = _check(view)
    return (check, check.verdict) if check is not None and isinstance(check.verdict, WrongTerm) else None


def _check(view: View) -> LineCheck | None:
    opened, check = open_step(view.seat), view.line_check
    return check if opened and check and check.step == (opened.lesson.id, opened.step.id) else None


def _asked_for(view: View) -> Markup:
    opened = open_step(view.seat)
    if opened is None or (exercise := opened.step.line) is None:
        return Markup("")
    language, accepted = view.seat.language, opened.accepted_lines
    lines = exercise.lines()
    names = lines[min(len(accepted), len(lines) - 1)].names
    listed = Markup("").join(NAME.format(one.name, _titled(one, language)) for one in names)
    done = [DONE.format(_defined(exercise, k), text) for k, text in enumerate(accepted)]
    if len(accepted) == len(lines):
        done.append(PARAGRAPH.format(ACCEPTED[language]))
    asked = ASKED.format(kind=exercise.title or LINE_KINDS[exercise.kind])
    return BOX.format(asked[language], listed, Markup("").join(done))


def _titled(name: GivenName, language: Language) -> str:
    return f"{name.title[language]} = {name.formula}" if name.formula else name.title[language]


def _verdict(view: View) -> Markup:
    """What is wrong with the line that was typed last, with carets under the characters in question."""
    check, language = _check(view), view.seat.language
    match None if check is None else check.verdict:
        case Refused(error):
            assert check is not None
            return WRONG.format(pointer(check.text, error), PARAGRAPH.format(error.what[language]))
        case WrongTerm(span=span, title=title, wrong_pose=wrong):
            assert check is not None
            marked = pointer(check.text, ExpressionError(title, span.start, span.end))
            said = [title[language], *([GHOSTS[language]] if wrong is not None else [])]
            return WRONG.format(marked, Markup("").join(map(PARAGRAPH.format, said)))
        case _:
            return Markup("")
