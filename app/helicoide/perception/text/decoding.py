"""Decoding of text in the usual encodings, with the line ends of any system."""

from __future__ import annotations

import codecs

from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF32_LE: "utf-32",  # before UTF-16, whose mark it begins with
    codecs.BOM_UTF32_BE: "utf-32",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
_LOOK = 1000


def decode_text(data: bytes) -> str:
    """The text, with "\\n" at the end of each line; raises BrokenFile if the bytes are not text."""
    encoding = _encoding(data)
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        text = data.decode("utf-16", "ignore") if encoding.startswith("utf-16") else data.decode("latin-1")
    if "\0" in text:
        raise BrokenFile(Text(en="it is no text", pt_BR="não é texto"))
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def _encoding(data: bytes) -> str:
    """The encoding by the byte order mark; without one, UTF-16 if every other byte is mostly zero, else UTF-8."""
    for mark, encoding in _MARKS.items():
        if data.startswith(mark):
            return encoding
    even, odd = data[:_LOOK:2].count(0), data[1:_LOOK:2].count(0)
    most = 0.4 * len(data[:_LOOK])
    if odd > most and not even:
        return "utf-16-le"
    return "utf-16-be" if even > most and not odd else "utf-8"
