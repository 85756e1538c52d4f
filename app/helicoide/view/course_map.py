"""The course map: all lessons by what builds on what, with marks for those that were begun or finished."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from markupsafe import Markup

from helicoide.lesson import Lesson, course_levels, next_lessons
from helicoide.text import Text, join_texts
from helicoide.view.window_view import View

COURSE = Text(en="Course map", pt_BR="Mapa do curso")
FREE = Text(
    en="Choose a lesson for step-by-step tasks, or drag the target in the scene and move the joints as you like.",
    pt_BR="Escolha uma lição para tarefas passo a passo, ou arraste o alvo na cena e mova as juntas à vontade.",
)
MARKS = {
    "finished": ("✓", Text(en="finished", pt_BR="concluída")),
    "begun": ("◐", Text(en="begun", pt_BR="começada")),
    "new": ("○", Text(en="not begun", pt_BR="não começada")),
}
BUILDS = Text(en="builds on: {titles}", pt_BR="parte de: {titles}")
NEXT = Text(en="next for you", pt_BR="a próxima para você")
MAP = Markup('<div class="helicoide-lesson helicoide-course"><b>{}</b><p>{}</p>{}</div>')
LEVEL = Markup("<ol>{}</ol>")
ENTRY = Markup(
    '<li class="{kind}"><span role="img" aria-label="{said}">{mark}</span><div>'
    '<button type="button" class="helicoide-go" data-go="lesson:{id}">{title}</button>{more}</div></li>'
)
SMALL, BADGE = Markup("<small>{}</small>"), Markup("<em>{}</em>")


def course_map(lessons: tuple[Lesson, ...], view: View) -> Markup:
    """The map of lessons in the order of the course, while none is open."""
    if view.seat.lesson is not None:
        return Markup("")
    language, levels = view.seat.language, course_levels(lessons)
    rows = (
        LEVEL.format(Markup("").join(_entries(tuple(level), lessons, view)))
        for _, level in groupby(lessons, key=lambda lesson: levels[lesson.id])
    )
    return MAP.format(COURSE[language], FREE[language], Markup("").join(rows))


def _entries(level: tuple[Lesson, ...], lessons: tuple[Lesson, ...], view: View) -> Iterator[Markup]:
    language, progress = view.seat.language, view.seat.progress
    titles = {lesson.id: lesson.title for lesson in lessons}
    onward = next_lessons(lessons, progress)
    for lesson in level:
        now = progress.get(lesson.id)
        kind = "new" if now is None else "finished" if now.finished else "begun"
        mark, said = MARKS[kind]
        needs = [titles[need] for need in lesson.needs if need in titles]
        more = [
            BADGE.format(NEXT[language]) if lesson in onward[:1] else Markup(""),
            SMALL.format(lesson.about[language]) if lesson.about.en else Markup(""),
            SMALL.format(BUILDS.format(titles=join_texts(needs))[language]) if needs else Markup(""),
        ]
        yield ENTRY.format(
            kind=kind,
            said=said[language],
            mark=mark,
            id=lesson.id,
            title=lesson.title[language],
            more=Markup("").join(more),
        )
