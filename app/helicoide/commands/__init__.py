"""The subcommands of `helicoide`, one file each with a `run` function, and what they share.

Exit codes: 0 for success, WRONG_INPUT for invalid arguments, NOT_REACHED when the command worked but did not reach what
was requested, and CLOSED when the reader of the output has closed the pipe.
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

if TYPE_CHECKING:  # it imports the kernels, and --version shall be fast
    from helicoide.kinematics.robot import Robot

WRONG_INPUT = 2
NOT_REACHED = 3
CHAIN_ENDS = Text(en="   from link {base} to link {tip}", pt_BR="   do elo {base} ao elo {tip}")
PIPE_CLOSED = 141  # as in a shell, 128 + SIGPIPE

# ASCII equivalents of characters that Unicode does not decompose
ASCII_EQUIVALENTS = str.maketrans(
    {"−": "-", "–": "-", "·": "-", "•": "*", "×": "x", "°": " deg", "±": "+-", "→": "->", "≤": "<=", "≥": ">="}
    | {"≠": "!=", "√": "sqrt", "§": "sec. ", "“": '"', "”": '"', "‘": "'", "’": "'"}
)


@contextmanager
def exit_codes() -> Iterator[None]:
    """Exit a command with its code: a HelicoideError prints one line on stderr, and a closed pipe prints nothing.

    A pipe closes in `helicoide study --list | head`, for instance. Inside, characters that the terminal cannot show are
    replaced by similar ones.
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
        sys.exit(PIPE_CLOSED)


def print_version() -> None:
    """Print the name and the version."""
    print(f"helicoide {__version__}")


def _drop_what_is_left() -> None:
    """Discard unwritten output, which the interpreter would otherwise try to write again when it exits."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())


def _alike(error: UnicodeError) -> tuple[str, int]:
    """Replace characters that an encoding lacks by letters without accents, similar characters, or "?"."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_plain, error.object[error.start : error.end])), error.end


def _plain(character: str) -> str:
    parts = unicodedata.normalize("NFKD", character.translate(ASCII_EQUIVALENTS)).translate(ASCII_EQUIVALENTS)
    plain = "".join(part for part in parts if not unicodedata.combining(part))
    return plain if plain.isascii() else "?"


codecs.register_error(_alike.__name__, _alike)


def chain_ends(robot: Robot) -> Text:
    """The base link and the tip link of the arm, as a line."""
    return CHAIN_ENDS.format(base=robot.base_link, tip=robot.tool_link)


def print_remarks(robot: Robot, with_visuals: bool = False, lang: Language | None = None) -> None:
    """Print the remarks about a robot's file on stderr; with_visuals: also what cannot be drawn, and the faults."""
    for text in _said_of(robot, with_visuals):
        print(f"{robot.name}: {text[lang or language()]}", file=sys.stderr)


def chain_ends_json(robot: Robot, with_visuals: bool = False) -> dict[str, object]:
    """For --json: the base link and the tip link of the arm, and the remarks about its file."""
    remarks = [{"en": text.en, "pt_BR": text.pt_BR} for text in _said_of(robot, with_visuals)]
    return {"base": robot.base_link, "tip": robot.tool_link, "remarks": remarks}


def _said_of(robot: Robot, drawn: bool) -> tuple[Text, ...]:
    if not drawn:
        return robot.remarks
    from helicoide.kinematics.robot_faults import remarks_and_faults  # it brings the reader of URDF files with it

    return remarks_and_faults(robot)


def language() -> Language:
    """The language of the terminal: the first supported one in LANGUAGE, else in LC_ALL, LC_MESSAGES or LANG.

    As in other programs, LANGUAGE is ignored if these say C. The locale need not be installed. English is the default.
    """
    chosen = next(filter(None, map(os.environ.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), "")
    preferred = [] if chosen in ("C", "POSIX") else os.environ.get("LANGUAGE", "").split(":")
    known = (code[:2].lower() for code in (*preferred, chosen) if code[:2].lower() in ("pt", "en"))
    return "pt_BR" if next(known, "en") == "pt" else "en"
