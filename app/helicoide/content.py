"""Finds robots/, lessons/ and static/: in a checkout, else inside the wheel; the user's folder adds to two."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from platformdirs import user_data_path

from helicoide.text import HelicoideError, Text

Kind = Literal["robots", "lessons"]

_PACKAGE = Path(__file__).parent
_CHECKOUT = _PACKAGE.parent.parent
SHIPPED = _CHECKOUT if (_CHECKOUT / "pyproject.toml").is_file() else _PACKAGE
STATIC = SHIPPED / "static"
_MARKER: dict[Kind, str] = {"robots": "robot.toml", "lessons": "lesson.py"}


def user_folder() -> Path:
    """Where a user's own robots and lessons are looked for."""
    return user_data_path("helicoide")


def found(kind: Kind) -> dict[str, Path]:
    """Folders of one kind by name; the user's own come before the shipped ones of the same name."""
    roots = (SHIPPED / kind, user_folder() / kind)
    return {file.parent.name: file.parent for root in roots for file in sorted(root.glob(f"*/{_MARKER[kind]}"))}


def folder(kind: Kind, name: str) -> Path:
    """The folder of one robot or lesson; raises HelicoideError that lists the names there are."""
    known = found(kind)
    if name not in known:
        what = {"robots": Text(en="robot", pt_BR="robô"), "lessons": Text(en="lesson", pt_BR="lição")}[kind]
        raise HelicoideError(
            Text(
                en="There is no {what} named {name!r}; there is: {known}.",
                pt_BR="Não existe {what} de nome {name!r}; existe: {known}.",
            ).format(what=what, name=name, known=", ".join(sorted(known)))
        )
    return known[name]
