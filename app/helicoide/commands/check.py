"""Hold what was added to everything that the tests ask of it."""

from __future__ import annotations

import sys
from pathlib import Path

import tyro

from helicoide import content, contributions
from helicoide.commands import NOT_REACHED, language
from helicoide.text import Text

GOOD = Text(en="{what} {name}: no faults", pt_BR="{what} {name}: sem falhas")
WRONG = Text(en="{what} {name}:", pt_BR="{what} {name}:")


def run(name: tyro.conf.Positional[str | None] = None, lessons: Path | None = None) -> None:
    """Check a robot, a lesson, a method or a study, shipped or your own, and say in words what is wrong with it.

    Robots: whether screws, DH rows and URDF agree, poses lie inside the limits, meshes are there. Lessons are played by
    their solutions, methods drive every arm, studies do their quick run. Ends with 0 when all is well, with 3
    where something is wrong, and with 2 for wrong input.

    Args:
        name: its name; all that there is if none, which takes minutes.
        lessons: a folder with further lessons.
    """
    if lessons is not None:
        content.add_lessons(lessons)
    spoken, wrong = language(), False
    for kind, each in contributions.named(name):
        faults = contributions.faults(kind, each)
        wrong = wrong or bool(faults)
        head = (WRONG if faults else GOOD).format(what=contributions.TITLES[kind], name=each)
        print("\n".join([head[spoken], *(f"   {fault[spoken]}" for fault in faults)]), flush=True)
    if wrong:
        sys.exit(NOT_REACHED)
