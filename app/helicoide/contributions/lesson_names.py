"""Faults of the names in a lesson: of layers, tabs, sheets, studies, signals and lessons, in lesson.py and in links."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from helicoide import content, studies
from helicoide.console import example_sheets
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, Step, all_lessons, circle_of_needs
from helicoide.lesson.links import LinkKind, link_targets, parsed_link
from helicoide.readout.signals import phase_planes, signals_of
from helicoide.state import initial_state
from helicoide.text import Text
from helicoide.view import layers, panels

OF_STEP = Text(en="step {step}: {what}", pt_BR="passo {step}: {what}")
UNKNOWN = Text(en="there is no {what} {name!r}; there is: {known}", pt_BR="não há {what} {name!r}; há: {known}")
CIRCLE = Text(en="NEEDS leads in a circle: {way}", pt_BR="NEEDS anda em círculo: {way}")
SIGNAL = Text(en="signal", pt_BR="sinal")
BLADE = Text(en="blade", pt_BR="lâmina")
KINDS: dict[LinkKind, Text] = {
    "layer": Text(en="layer", pt_BR="camada"),
    "sheet": Text(en="sheet", pt_BR="folha"),
    "study": Text(en="study", pt_BR="estudo"),
    "tab": Text(en="tab", pt_BR="aba"),
    "lesson": Text(en="lesson", pt_BR="lição"),
}
ADDRESS = Text(
    en="a link is https://…, or one of {kinds} with a name, as in layer:twist; not {target!r}",
    pt_BR="um link é https://…, ou {kinds} com um nome, como em layer:twist; não {target!r}",
).format(kinds=", ".join(f"{kind}:" for kind in KINDS), target="{target!r}")


def name_faults(lesson: Lesson, robot: Robot) -> Iterator[Text]:
    """The faults of the names in a lesson about a robot."""
    for need in lesson.needs:
        yield from _unknown("lesson", need)
    if lesson.id in (way := circle_of_needs(all_lessons())):
        yield CIRCLE.format(way=", ".join(way))
    begin = initial_state(robot)
    for step in lesson.steps:
        for fault in (*_shown_faults(step), *_link_faults(lesson, step)):
            yield OF_STEP.format(step=step.id, what=fault)
        signals = {*signals_of(step.setup(begin) if step.charts else begin), *phase_planes()}
        for chart in step.charts:
            if chart not in signals:
                what = UNKNOWN.format(what=SIGNAL, name=chart, known=", ".join(sorted(signals)))
                yield OF_STEP.format(step=step.id, what=what)


def linkable_names(kind: LinkKind) -> Collection[str]:
    """The names of all of a kind that a link can show or open."""
    match kind:
        case "layer":
            return [layer.NAME for layer in layers.optional()]
        case "sheet":
            return list(example_sheets())
        case "study":
            return studies.study_names()
        case "tab":
            return panels.panel_names()
        case "lesson":
            return list(content.content_folders("lessons"))


def _unknown(kind: LinkKind, name: str) -> Iterator[Text]:
    if name not in (known := linkable_names(kind)):
        yield UNKNOWN.format(what=KINDS[kind], name=name, known=", ".join(known))


def _shown_faults(step: Step) -> Iterator[Text]:
    shown = step.shown
    for layer in (*shown.layers, *shown.hidden):
        yield from _unknown("layer", layer)
    if shown.tab is not None:
        yield from _unknown("tab", shown.tab)
    if shown.sheet is not None:
        yield from _unknown("sheet", shown.sheet)
    if shown.coefficient is not None and shown.coefficient not in CL031.names:
        yield UNKNOWN.format(what=BLADE, name=shown.coefficient, known=", ".join(CL031.names))


def _link_faults(lesson: Lesson, step: Step) -> Iterator[Text]:
    prose = lesson.prose[step.id]
    for text in (prose.body, prose.question, prose.reveal, prose.task, prose.hint, *prose.hints.values()):
        for target in link_targets(text.en) + link_targets(text.pt_BR):
            link = parsed_link(target)
            if link is not None:
                yield from _unknown(link.kind, link.name)
            elif not target.startswith("https://"):
                yield ADDRESS.format(target=target)
