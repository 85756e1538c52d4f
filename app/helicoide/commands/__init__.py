"""The subcommands of `helicoide`, a file each, each with a `run` function; and what they share.

A command ends with 0 when it came to what was asked for, with WRONG_INPUT when it cannot use what was typed, with
NOT_REACHED when it worked and the answer is no, and with CLOSED when nobody reads any more what it prints.
"""

from __future__ import annotations

import codecs
import io
import os
import signal
import sys
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from helicoide import __version__
from helicoide.text import HelicoideError, Language, Text

if TYPE_CHECKING:  # it brings the kernels with it, which --version does not wait for
    from helicoide.kinematics.robot import Robot

WRONG_INPUT = 2
NOT_REACHED = 3
ENDS = Text(en="   from link {base} to link {tip}", pt_BR="   do elo {base} ao elo {tip}")
CLOSED = 141  # what a shell says of a program that a closed pipe has ended, 128 + SIGPIPE

# signs that Unicode does not take apart, as they are written where there are only letters and digits
LIKE = str.maketrans(
    {"−": "-", "–": "-", "·": "-", "•": "*", "×": "x", "°": " deg", "±": "+-", "→": "->", "≤": "<=", "≥": ">="}
    | {"≠": "!=", "√": "sqrt", "§": "sec. ", "“": '"', "”": '"', "‘": "'", "’": "'"}
)


@contextmanager
def ending() -> Iterator[None]:
    """End a command: with one line on the error output for a HelicoideError, and quietly when its reader has gone.

    The reader goes in `helicoide study --list | head`, for instance. Within, what a terminal cannot show is written
    as it can.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=_alike.__name__)
    try:
        try:
            yield
        except HelicoideError as error:
            print(f"helicoide: {error.text[language()]}", file=sys.stderr)
            sys.exit(WRONG_INPUT)
        except KeyboardInterrupt:
            sys.exit(128 + signal.SIGINT)
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        _drop_what_is_left()
        sys.exit(CLOSED)


def tell_version() -> None:
    """Print the name and the version."""
    print(f"helicoide {__version__}")


def _drop_what_is_left() -> None:
    """Let what is not written yet go nowhere: the interpreter writes it when it ends, and would fail once more."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())


def _alike(error: UnicodeError) -> tuple[str, int]:
    """In place of characters that an encoding lacks: letters without their accents, signs like them, or "?"."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_plain, error.object[error.start : error.end])), error.end


def _plain(character: str) -> str:
    parts = unicodedata.normalize("NFKD", character.translate(LIKE)).translate(LIKE)
    plain = "".join(part for part in parts if not unicodedata.combining(part))
    return plain if plain.isascii() else "?"


codecs.register_error(_alike.__name__, _alike)


def ends(robot: Robot) -> Text:
    """From where to where the arm goes."""
    return ENDS.format(base=robot.base_link, tip=robot.tool_link)


def remark(robot: Robot, drawn: bool = False, lang: Language | None = None) -> None:
    """Say on the error output how a robot's file was read; drawn: and what is not drawn, and what is wrong."""
    for text in _said_of(robot, drawn):
        print(f"{robot.name}: {text[lang or language()]}", file=sys.stderr)


def described_ends(robot: Robot, drawn: bool = False) -> dict[str, object]:
    """The same for --json: the links where the arm begins and ends, and what is to be said of its file."""
    remarks = [{"en": text.en, "pt_BR": text.pt_BR} for text in _said_of(robot, drawn)]
    return {"base": robot.base_link, "tip": robot.tool_link, "remarks": remarks}


def _said_of(robot: Robot, drawn: bool) -> tuple[Text, ...]:
    if not drawn:
        return robot.remarks
    from helicoide.kinematics.robot_faults import remarks_and_faults  # it brings the reader of URDF files with it

    return remarks_and_faults(robot)


def language() -> Language:
    """The language of the terminal: the first of LANGUAGE that we speak, else that of LC_ALL, LC_MESSAGES or LANG.

    As in other programs, LANGUAGE counts for nothing where these say C. Whether the system has the locale does not
    matter. English where nothing is said.
    """
    chosen = next(filter(None, map(os.environ.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), "")
    wishes = [] if chosen in ("C", "POSIX") else os.environ.get("LANGUAGE", "").split(":")
    known = (wish[:2].lower() for wish in (*wishes, chosen) if wish[:2].lower() in ("pt", "en"))
    return "pt_BR" if next(known, "en") == "pt" else "en"
