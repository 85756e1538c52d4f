"""What is written in a file that a person names, or why it cannot be had."""

from __future__ import annotations

from pathlib import Path

from helicoide.text import HelicoideError, Text


def text(path: Path, most: int) -> str:
    """What is written in a file of at most so many bytes."""
    try:
        with path.open("rb") as file:
            content = file.read(most + 1)
    except FileNotFoundError as error:
        raise HelicoideError(Text(en="there is no such file", pt_BR="esse arquivo não existe")) from error
    except (OSError, ValueError) as error:  # the second for a name with a zero byte
        folder = Text(en="it is a folder, not a file", pt_BR="é uma pasta, não um arquivo")
        closed = Text(en="it cannot be read", pt_BR="não dá para lê-lo")
        raise HelicoideError(folder if isinstance(error, OSError) and path.is_dir() else closed) from error
    return decoded(content, most)


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
