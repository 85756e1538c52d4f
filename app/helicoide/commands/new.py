"""Write a small working example to begin with."""

from __future__ import annotations

import tyro

from helicoide.commands import language
from helicoide.contributions import Kind
from helicoide.contributions.examples import made
from helicoide.text import Text

NEXT = Text(en="Now change it, then check it: {command}", pt_BR="Agora mude e confira: {command}")


def run(kind: tyro.conf.Positional[Kind], name: tyro.conf.Positional[str], user: bool = False) -> None:
    """Write a small robot, lesson, method or study that works, to be changed into your own.

    Ends with 0 when it is written, and with 2 for wrong input.

    Args:
        kind: what it is.
        name: its name: small letters, digits and _.
        user: write it into your own folder, also where there is a checkout (doctor says where that is).
    """
    for path in made(kind, name, user):
        print(path)
    print(NEXT.format(command=f"helicoide check {name}")[language()])
