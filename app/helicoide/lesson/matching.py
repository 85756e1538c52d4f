"""Whether the pages of a lesson have what its lesson.py asks for, step by step."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from helicoide.lesson.lesson import Lesson
from helicoide.lesson.predictions import Choice, Order
from helicoide.lesson.prose import Prose, Section, placeholders
from helicoide.lesson.step import Step
from helicoide.text import LANGUAGES, Language, Text

ORDER = Text(
    en="lesson.py has the steps {steps}, this page has {page}",
    pt_BR="lesson.py tem os passos {steps}, esta página tem {page}",
)
OF_STEP = Text(en="step {step}: {what}", pt_BR="passo {step}: {what}")
UNKNOWN = Text(
    en="{name} in braces is no value; VALUES has: {known}",
    pt_BR="{name} entre chaves não é um valor; VALUES tem: {known}",
)
NO_QUESTION = Text(
    en="a prediction needs a question, a paragraph that begins with '? ', and what is right, one that begins with '! '",
    pt_BR="uma previsão pede uma pergunta, um parágrafo iniciado por '? ', e a resposta certa, um iniciado por '! '",
)
NO_PREDICTION = Text(
    en="it has a question or a '! ' paragraph, but no prediction in lesson.py",
    pt_BR="há uma pergunta ou um parágrafo com '! ', mas nenhuma previsão em lesson.py",
)
EARLY = Text(
    en="a step that is done by its prediction has no task: what comes after the question begins with '! ', or else it "
    "is read before the answer",
    pt_BR="um passo que se conclui pela previsão não tem tarefa: o que vem depois da pergunta começa com '! ', senão "
    "é lido antes da resposta",
)
OPTIONS = Text(
    en="its question has {n} options, lines that begin with '- ', and needs {needed}",
    pt_BR="a pergunta tem {n} opções, linhas iniciadas por '- ', e precisa de {needed}",
)
IN_ORDER = Text(
    en="its options are in the right order already; write them in another one",
    pt_BR="as opções já estão na ordem certa; escreva-as em outra",
)
AT_LEAST = Text(en="at least {n}", pt_BR="pelo menos {n}")
NO_HINT = Text(en="the hint of the diagnosis {name} is missing", pt_BR="falta a dica do diagnóstico {name}")


@dataclass(frozen=True)
class PageFault:
    """What is wrong on the page of a language."""

    language: Language
    text: Text


def mismatch(lesson: Lesson, pages: Mapping[Language, Mapping[str, Section]]) -> PageFault | None:
    """The first fault of the pages; None if they match the steps."""
    for language in LANGUAGES:
        for fault in _page_faults(lesson, pages[language]):
            return PageFault(language, fault)
    for step in lesson.steps:
        n, needed = (len(pages[language][step.id].options) for language in ("pt_BR", "en"))
        if n != needed:
            return PageFault("pt_BR", OF_STEP.format(step=step.id, what=OPTIONS.format(n=n, needed=needed)))
    return None


def merged_prose(en: Section, pt_BR: Section) -> Prose:
    """The texts of a step in both languages, from a section of each page."""
    return Prose(
        title=Text(en=en.title, pt_BR=pt_BR.title),
        body=Text(en=en.body, pt_BR=pt_BR.body),
        hint=Text(en=en.hint, pt_BR=pt_BR.hint),
        question=Text(en=en.question, pt_BR=pt_BR.question),
        options=tuple(Text(en=one, pt_BR=other) for one, other in zip(en.options, pt_BR.options, strict=True)),
        reveal=Text(en=en.reveal, pt_BR=pt_BR.reveal),
        task=Text(en=en.task, pt_BR=pt_BR.task),
        hints={name: Text(en=hint, pt_BR=pt_BR.hints[name]) for name, hint in en.hints.items()},
    )


def _page_faults(lesson: Lesson, page: Mapping[str, Section]) -> Iterator[Text]:
    ids = [step.id for step in lesson.steps]
    if [*page] != ids:
        yield ORDER.format(steps=", ".join(ids), page=", ".join(page))
        return
    for step in lesson.steps:
        for fault in _section_faults(lesson, step, page[step.id]):
            yield OF_STEP.format(step=step.id, what=fault)


def _section_faults(lesson: Lesson, step: Step, section: Section) -> Iterator[Text]:
    for name in placeholders(section.whole):
        if name not in lesson.values:
            yield UNKNOWN.format(name=name, known=", ".join(lesson.values) or "–")
    if step.prediction is None:
        if section.question or section.reveal:
            yield NO_PREDICTION
    elif not section.question or not section.reveal:
        yield NO_QUESTION
    if step.by_answer and section.task:
        yield EARLY
    yield from _option_faults(step, len(section.options))
    for diagnosis in step.diagnoses:
        if not section.hints.get(diagnosis.id):
            yield NO_HINT.format(name=diagnosis.id)


def _option_faults(step: Step, n: int) -> Iterator[Text]:
    match step.prediction:
        case Choice(right):
            needed = max(2, right + 1)
            if n < needed:
                yield OPTIONS.format(n=n, needed=AT_LEAST.format(n=needed))
        case Order(order):
            if sorted(order) != list(range(n)):
                yield OPTIONS.format(n=n, needed=str(len(order)))
            elif list(order) == list(range(n)):
                yield IN_ORDER
        case _:
            if n:
                yield OPTIONS.format(n=n, needed="0")
