"""A small working example of a robot, a lesson, a method or a study, written under a new name."""

from __future__ import annotations

import keyword
import re
from pathlib import Path

from helicoide import content, studies
from helicoide.contributions import TITLES, Kind, contribution_names
from helicoide.files.os_errors import os_error_reason
from helicoide.ik import methods
from helicoide.kinematics import library
from helicoide.text import HelicoideError, Text

EXAMPLES = content.STATIC / "examples"
NAME = "new_name"  # the name of the examples, in their text and in their file names
BAD_NAME = Text(
    en="{name!r} is no name: use small letters, digits and _, a letter first, such as my_{kind}.",
    pt_BR="{name!r} não serve de nome: use letras minúsculas sem acento, algarismos e _, letra no início: my_{kind}.",
)
TAKEN = Text(
    en="There is already a {what} named {name}; give it another name.",
    pt_BR="Já há {what} de nome {name}; escolha outro nome.",
)
THERE = Text(
    en="{path} already exists; move it away, or choose another name.",
    pt_BR="{path} já existe; tire-o de lá ou escolha outro nome.",
)
UNWRITTEN = Text(en="{path} cannot be written: {why}.", pt_BR="Não dá para gravar {path}: {why}.")


def made(kind: Kind, name: str, own: bool) -> list[Path]:
    """Write an example into the checkout; with `own`, or without a checkout, into the user's folder.

    Returns its files. Raises HelicoideError if the name is not valid, if the name or a file exists already, or if the
    folder is not writable.
    """
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name):
        raise HelicoideError(BAD_NAME.format(name=name, kind=kind))
    known = (*contribution_names(kind), *(library.robot_names() if kind == "robot" else ()))
    if name in known:
        raise HelicoideError(TAKEN.format(what=TITLES[kind], name=name))
    target = _target(kind, own or not content.IN_CHECKOUT) / name
    example = EXAMPLES / kind
    if (example / f"{NAME}.py").is_file():
        pairs = [(example / f"{NAME}.py", target.with_suffix(".py"))]
    else:
        pairs = [(file, target / file.name.replace(NAME, name)) for file in sorted(example.iterdir()) if file.is_file()]
    shipped = _target(kind, own=False) / name  # another file of that name would be found first
    for place in (target, shipped, shipped.with_suffix(".py"), *(to for _, to in pairs)):
        if place.exists():
            raise HelicoideError(THERE.format(path=place))
    for file, to in pairs:
        _write(to, file.read_text("utf-8").replace(NAME, name))
    return [to for _, to in pairs]


def _target(kind: Kind, own: bool) -> Path:
    match kind:
        case "robot" | "lesson":
            return (content.user_folder() if own else content.SHIPPED) / f"{kind}s"
        case "method":
            return Path(methods.__path__[-1 if own else 0])
        case "study":
            return Path(studies.__path__[-1 if own else 0])


def _write(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise HelicoideError(UNWRITTEN.format(path=path, why=os_error_reason(error))) from error
