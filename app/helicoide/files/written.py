"""What is written in a file that a person names, or why it cannot be had."""

from __future__ import annotations

from pathlib import Path

from helicoide.files.system import why
from helicoide.text import HelicoideError, Text

MISSING = Text(en="there is no such file", pt_BR="esse arquivo não existe")
A_FOLDER = Text(en="it is a folder: name a file in it", pt_BR="é uma pasta: indique um arquivo dela")


def text(path: Path, most: int) -> str:
    """What is written in a file of at most so many bytes, in UTF-8."""
    return decoded(raw(path, most), most)


def raw(path: Path, most: int) -> bytes:
    """The bytes of a file, or the first of one that has more than so many; a device or a pipe may never end."""
    try:
        if not path.is_file():
            raise HelicoideError(A_FOLDER if path.is_dir() else MISSING)
        with path.open("rb") as file:
            return file.read(most + 1)
    except OSError as error:
        raise HelicoideError(why(error)) from error


def decoded(content: bytes, most: int) -> str:
    """The words in at most so many bytes."""
    if len(content) > most:
        long = Text(en="it is too long: at most {kb:g} kB", pt_BR="é longo demais: no máximo {kb:g} kB")
        raise HelicoideError(long.format(kb=most / 1000))
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        at = Text(
            en="byte {at} is no text in utf-8: save it with that encoding",
            pt_BR="o byte {at} não é texto em utf-8: salve o arquivo com essa codificação",
        )
        raise HelicoideError(at.format(at=error.start)) from error
