"""Faults of a method: its description, and promises that it breaks on an arm to which it applies."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain

from helicoide import content
from helicoide.contributions.loading import collected_faults, unusable
from helicoide.contributions.options import option_faults
from helicoide.contributions.promises import HELD, answers
from helicoide.contributions.trials import bare_state, closed_loop_to
from helicoide.contributions.words import missing_words
from helicoide.ik import methods
from helicoide.ik.method import Promise
from helicoide.ik.methods import named
from helicoide.kernels import run_interpreted
from helicoide.kinematics.library import robot_titles
from helicoide.text import Text, untranslated
from helicoide.view.formula import formula_html

SOURCE = Text(
    en="SOURCE is empty: author, year and place, or that it is your own",
    pt_BR="SOURCE está vazio: autor, ano e lugar, ou que é seu",
)
NO_TEX = Text(en="EQUATION is no TeX that the page can show", pt_BR="EQUATION não é TeX que a página mostre")
NO_PROMISES = Text(
    en="PROMISES is empty; promise one of {known}, or say why none can be promised in NO_PROMISES, a Text",
    pt_BR="PROMISES está vazio; prometa algo de {known}, ou diga em NO_PROMISES, um Text, por que nada se promete",
)
BOTH = Text(en="it has PROMISES, and NO_PROMISES says why none", pt_BR="há PROMISES, e NO_PROMISES diz por que não há")
NOWHERE = Text(en="it applies to no arm at all", pt_BR="não se aplica a nenhum braço")
ON = Text(en="{robot}, {task}: {what}", pt_BR="{robot}, {task}: {what}")
POSE = Text(en="pose", pt_BR="pose")
POSITION = Text(en="position", pt_BR="posição")


@dataclass(frozen=True)
class Pair:
    """A robot, by its name, and whether the task has an orientation besides the position."""

    robot: str
    with_orientation: bool

    @property
    def title(self) -> str:
        """The name of its test."""
        return f"{self.robot}-{'pose' if self.with_orientation else 'position'}"


@lru_cache
@run_interpreted()
def pairs(name: str) -> tuple[tuple[Pair, ...], dict[Pair, Text]]:
    """The pairs to which a method applies, and why it does not apply to the others; for all robots with a folder."""
    applying, refused = list[Pair](), dict[Pair, Text]()
    for pair in (Pair(robot, turned) for robot in sorted(robot_titles()) for turned in (True, False)):
        state = bare_state(pair.robot)
        why = named(name).applies(closed_loop_to(state, state.T_world_tool, pair.with_orientation))
        if why is None:
            applying.append(pair)
        else:
            refused[pair] = why
    return tuple(applying), refused


def faults(name: str) -> tuple[Text, ...]:
    """The faults of a method, by its name. It drives every arm, which takes a while."""
    if (why := unusable(methods, name)) is not None:
        return (why,)
    return collected_faults(
        content.module_file(methods.__path__, name), chain(description_faults(name), _promise_faults(name))
    )


def description_faults(name: str) -> Iterator[Text]:
    """The faults of the description of a method."""
    method = named(name)
    yield from missing_words(untranslated("TITLE"), method.TITLE)
    if not method.SOURCE.strip():
        yield SOURCE
    if "<math" not in formula_html(method.EQUATION):
        yield NO_TEX
    if method.REMEMBERS is not None:
        yield from missing_words(untranslated("REMEMBERS"), method.REMEMBERS)
    yield from (
        fault for symbol, title in method.FIGURES.items() for fault in missing_words(untranslated(symbol), title)
    )
    yield from _promised(name)
    yield from option_faults(method.Options)
    applying, refused = pairs(name)
    if not applying:
        yield NOWHERE
    yield from (
        fault
        for why in dict.fromkeys(refused.values())
        for fault in missing_words(untranslated("applies"), why, differ=True)
    )


def _promised(name: str) -> Iterator[Text]:
    method, why_none = named(name), getattr(named(name), "NO_PROMISES", None)
    if method.PROMISES and why_none is not None:
        yield BOTH
    elif not method.PROMISES and why_none is None:
        yield NO_PROMISES.format(known=", ".join(promise.name for promise in Promise))
    elif why_none is not None:
        yield from missing_words(untranslated("NO_PROMISES"), why_none, differ=True)


def _promise_faults(name: str) -> Iterator[Text]:
    for pair in pairs(name)[0]:
        task = POSE if pair.with_orientation else POSITION
        promised = [HELD[promise] for promise in Promise if promise in named(name).PROMISES]
        for check in (answers, *promised):
            if (fault := check(name, pair.robot, pair.with_orientation)) is not None:
                yield ON.format(robot=pair.robot, task=task, what=fault)
