"""Reading a file that a person names, or the reason why it cannot be read."""

from __future__ import annotations

from pathlib import Path

from helicoide.files.os_errors import os_error_reason
from helicoide.text import HelicoideError, Text

NO_FILE = Text(en="there is no such file", pt_BR="esse arquivo não existe")
A_FOLDER = Text(en="it is a folder: name a file in it", pt_BR="é uma pasta: indique um arquivo dela")


def read_text(path: Path, max_bytes: int) -> str:
    """The text of a UTF-8 file of at most `max_bytes` bytes."""
    return decode_utf8(read_bytes(path, max_bytes), max_bytes)


def read_bytes(path: Path, max_bytes: int) -> bytes:
    """The bytes of a file, at most `max_bytes` + 1 of them, as a device or a pipe may never end."""
    try:
        if not path.is_file():
            raise HelicoideError(A_FOLDER if path.is_dir() else NO_FILE)
        with path.open("rb") as file:
            return file.read(max_bytes + 1)
    except OSError as error:
        raise HelicoideError(os_error_reason(error)) from error


def decode_utf8(content: bytes, max_bytes: int) -> str:
    """The UTF-8 text in at most `max_bytes` bytes."""
    if len(content) > max_bytes:
        long = Text(en="it is too long: at most {kb:g} kB", pt_BR="é longo demais: no máximo {kb:g} kB")
        raise HelicoideError(long.format(kb=max_bytes / 1000))
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        at = Text(
            en="byte {at} is no text in utf-8: save it with that encoding",
            pt_BR="o byte {at} não é texto em utf-8: salve o arquivo com essa codificação",
        )
        raise HelicoideError(at.format(at=error.start)) from error
