"""A sheet as text, as the content of a file, and packed for a link; and back."""

from __future__ import annotations

import math
import re
import zlib
from base64 import urlsafe_b64decode, urlsafe_b64encode

from helicoide.sheet.parts import MOST_CHARACTERS, MOST_LINES, NameSlider, Sheet, SheetLine, too_long_text
from helicoide.text import HelicoideError, Text

LARGEST, LEAST_WIDTH = 1e6, 1e-3  # of the ends of a slider, and of the distance between them
# A text has at most `MOST_LINES` sliders with three numbers of up to 24 characters each, and as many hidden lines.
# Packed, what cannot be compressed has up to four bytes for each character, and a third more in base64.
LONGEST_TEXT, LONGEST_PACKED = MOST_CHARACTERS + 110 * MOST_LINES, 32_000
HIDDEN = "hidden "
_SLIDER = re.compile(r"slider ([A-Za-z][A-Za-z0-9_]*) = (\S+) from (\S+) to (\S+)")

DAMAGED = Text(
    en="The sheet in the link is damaged, or a part of it was lost: copy the whole link again.",
    pt_BR="A folha que vem no link está danificada, ou uma parte se perdeu: copie de novo o link inteiro.",
)
NO_TEXT = Text(
    en="The file is not text in UTF-8: a sheet is a text file with one expression in each line.",
    pt_BR="O arquivo não é texto em UTF-8: uma folha é um arquivo de texto com uma expressão por linha.",
)
NO_SLIDER = Text(
    en="line {n}: a slider is written as in “slider theta = 0.5 from 0 to 3”, with numbers up to {most:.0f}, the value "
    "between the ends, and these at least {least} apart",
    pt_BR="linha {n}: um controle deslizante se escreve como em “slider theta = 0.5 from 0 to 3”, com números até "
    "{most:.0f}, o valor entre os extremos e estes a pelo menos {least} um do outro",
).format(n="{n}", most=LARGEST, least=LEAST_WIDTH)


def sheet_text(sheet: Sheet) -> str:
    """The sheet as a text file: a line for each slider, then its lines; hidden ones are marked."""
    sliders = [f"slider {name} = {s.value!r} from {s.lower!r} to {s.upper!r}" for name, s in sheet.sliders]
    lines = [line.text if line.shown else HIDDEN + line.text for line in sheet.lines]
    return "\n".join([*sliders, *lines]) + "\n"


def sheet_of_text(text: str) -> Sheet:
    """The sheet of a text, inverse of `sheet_text`; empty lines are left out. Raises HelicoideError."""
    if len(text) > LONGEST_TEXT:
        raise HelicoideError(too_long_text())
    sliders: dict[str, NameSlider] = {}
    lines: list[SheetLine] = []
    for n, raw in enumerate(text.splitlines(), 1):
        line = " ".join(raw.split())
        if line.startswith("slider "):
            name, slider = _slider(n, line)
            sliders[name] = slider
        elif line:
            shown = not line.startswith(HIDDEN)
            lines.append(SheetLine(line if shown else line.removeprefix(HIDDEN), shown))
    return Sheet(tuple(lines), tuple(sliders.items()))


def sheet_of_file(content: bytes) -> Sheet:
    """The sheet of an uploaded file. Raises HelicoideError."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise HelicoideError(NO_TEXT) from None
    return sheet_of_text(text)


def packed_sheet(sheet: Sheet) -> str:
    """The sheet for a link: its text, compressed, in letters and digits that an address needs not escape (base64)."""
    packed = zlib.compress(sheet_text(sheet).encode(), 9)
    return urlsafe_b64encode(packed).decode().rstrip("=")


def unpacked_sheet(packed: str) -> Sheet:
    """The sheet that was packed; what unpacks to too much is refused. Raises HelicoideError."""
    try:
        if len(packed) > LONGEST_PACKED:
            raise HelicoideError(too_long_text())
        raw = urlsafe_b64decode(packed.encode("ascii") + b"=" * (-len(packed) % 4))
        unpacker = zlib.decompressobj()
        text = unpacker.decompress(raw, 4 * LONGEST_TEXT)
        if not unpacker.eof or unpacker.unused_data:
            raise HelicoideError(DAMAGED)
        return sheet_of_text(text.decode("utf-8"))
    except (zlib.error, ValueError):  # of base64 and UTF-8, too
        raise HelicoideError(DAMAGED) from None


def _slider(n: int, line: str) -> tuple[str, NameSlider]:
    found = _SLIDER.fullmatch(line)
    try:
        if found is None:
            raise ValueError
        value, lower, upper = map(float, found.groups()[1:])
    except ValueError:
        raise HelicoideError(NO_SLIDER.format(n=n)) from None
    finite = all(map(math.isfinite, (value, lower, upper))) and max(map(abs, (lower, upper))) <= LARGEST
    if not finite or not lower <= value <= upper or upper - lower < LEAST_WIDTH:
        raise HelicoideError(NO_SLIDER.format(n=n))
    return found[1], NameSlider(value, lower, upper)
