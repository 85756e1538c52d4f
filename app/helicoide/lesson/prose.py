"""The page of a lesson in one language: a section for each step, in Markdown with marks at the start of paragraphs.

`## id: Title` begins a step. A paragraph that begins with `?` is the question of its prediction, and the list after it
has the options; one that begins with `!` is what is revealed. Quotations at the end are the hints: `> text` is the
general one, `> diagnosis: text` that of a mistake. `{name}` stands for a value, `$…$` is a formula.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from helicoide.markup import PLACEHOLDER
from helicoide.text import HelicoideError, Text

HEADING = re.compile(r"## (?P<id>[a-z][a-z0-9_]*): (?P<title>\S.*)")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
FORMULA = re.compile(r"(\$\$?)(?=\S)(?:\\.|[^$\\])+?(?<=\S)\1")
FORM = Text(
    en="each step is '## id: title', its text and, at the end, its hint on lines that begin with '> '; not so: {got!r}",
    pt_BR="cada passo é '## id: título', o texto e, ao fim, a dica em linhas iniciadas por '> '; não é assim: {got!r}",
)


@dataclass(frozen=True)
class Section:
    """The texts of a step in one language, in Markdown; empty where the page has none.

    body: before the question; task: after it; hints: of mistakes, by diagnosis.
    """

    title: str
    body: str
    question: str = ""
    options: tuple[str, ...] = ()
    reveal: str = ""
    task: str = ""
    hint: str = ""
    hints: Mapping[str, str] = field(default_factory=dict)

    @property
    def whole(self) -> str:
        """All texts, one after another."""
        parts = (self.title, self.body, self.question, *self.options, self.reveal, self.task, self.hint)
        return "\n\n".join((*parts, *self.hints.values()))


@dataclass(frozen=True)
class Prose:
    """The texts of a step in both languages; fields as those of `Section`."""

    title: Text
    body: Text
    hint: Text
    question: Text = field(default=Text(en="", pt_BR=""))
    options: tuple[Text, ...] = ()
    reveal: Text = field(default=Text(en="", pt_BR=""))
    task: Text = field(default=Text(en="", pt_BR=""))
    hints: Mapping[str, Text] = field(default_factory=dict)


def read_sections(page: str, diagnoses: Mapping[str, Collection[str]]) -> dict[str, Section]:
    """The sections of a page by step id, in its order. Raises HelicoideError if one does not have the form.

    diagnoses: the ids of the diagnoses of each step.
    """
    before, *sections = re.split(r"(?m)^(?=## )", page)
    if before.strip():
        raise HelicoideError(FORM.format(got=before.strip().splitlines()[0]))
    found = dict[str, Section]()
    for section in sections:
        first = section.splitlines()[0]
        heading = HEADING.fullmatch(first.rstrip())
        if heading is None or heading["id"] in found:
            raise HelicoideError(FORM.format(got=first))
        written = _section(heading["title"].strip(), section[len(first) :], diagnoses.get(heading["id"], ()))
        if not (written.body or written.question) or not written.hint:
            raise HelicoideError(FORM.format(got=first))
        found[heading["id"]] = written
    return found


def placeholders(text: str) -> list[str]:
    """The names in braces in a text, outside its formulas."""
    return PLACEHOLDER.findall(FORMULA.sub("", text))


def paragraphs(text: str) -> list[str]:
    """The paragraphs of a text, which are separated by empty lines."""
    return [part for part in re.split(r"\n\s*\n", text.strip()) if part]


def _section(title: str, text: str, diagnoses: Collection[str]) -> Section:
    body, task, questions, options, reveals, quoted = (list[str]() for _ in range(6))
    may_have_options = False
    for part in paragraphs(text):
        lines = part.splitlines()
        if quoted and not part.startswith(">"):
            raise HelicoideError(FORM.format(got=lines[0]))
        is_list = all(line.startswith("- ") for line in lines)
        if part.startswith("? "):
            questions.append("\n".join(_without(line, "?") for line in lines if not line.startswith("- ")))
            options += [line[2:].strip() for line in lines if line.startswith("- ")]
        elif may_have_options and is_list:
            options += [line[2:].strip() for line in lines]
        elif part.startswith("! "):
            reveals.append("\n".join(_without(line, "!") for line in lines))
        elif part.startswith(">"):
            quoted += ["", *lines]
        else:
            (task if questions else body).append(part)
        may_have_options = part.startswith("? ") and not options
    texts = ["\n\n".join(parts) for parts in (body, questions, reveals, task)]
    hint, hints = _hints(quoted, diagnoses)
    return Section(title, texts[0], texts[1], tuple(options), texts[2], texts[3], hint, hints)


def _without(line: str, mark: str) -> str:
    return line.removeprefix(mark).strip()


def _hints(lines: list[str], diagnoses: Collection[str]) -> tuple[str, dict[str, str]]:
    """The general hint, and those of the diagnoses. A line that begins with the id of a diagnosis begins its hint."""
    general, hints = list[str](), dict[str, list[str]]()
    into = general
    for line in lines:
        said = _without(line, ">")
        name, colon, rest = said.partition(":")
        if not line:
            into = general
        if colon and name in diagnoses:
            into, said = hints.setdefault(name, []), rest.strip()
        into.append(said)
    return "\n\n".join(paragraphs("\n".join(general))), {name: "\n".join(said).strip() for name, said in hints.items()}
