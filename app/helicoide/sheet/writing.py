"""A sheet as text, as the content of a file, and as a link; and back."""

from __future__ import annotations

import math
import re
import zlib
from base64 import urlsafe_b64decode, urlsafe_b64encode

from helicoide.sheet.parts import MOST_CHARACTERS, NameSlider, Sheet, SheetLine, too_long_text
from helicoide.text import HelicoideError, Text

LARGEST, LEAST_WIDTH = 1e6, 1e-3  # of the ends of a slider, and of the distance between them
HIDDEN, LINK = "hidden ", "sheet="
_SLIDER = re.compile(r"slider ([A-Za-z][A-Za-z0-9_]*) = (\S+) from (\S+) to (\S+)")

BROKEN_LINK = Text(
    en="This is no link of a sheet, or it has lost a part: copy the whole text, which begins with {begins}.",
    pt_BR="Isto não é um link de folha, ou uma parte se perdeu: copie o texto inteiro, que começa com {begins}.",
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
    if len(text) > 2 * MOST_CHARACTERS:
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


def sheet_link(sheet: Sheet) -> str:
    """The sheet as the fragment of a link, such as sheet=eJx…: its text, compressed, in base64 for addresses."""
    packed = zlib.compress(sheet_text(sheet).encode(), 9)
    return LINK + urlsafe_b64encode(packed).decode().rstrip("=")


def sheet_of_link(link: str) -> Sheet:
    """The sheet of a link, or of its fragment alone; what unpacks to too much is refused. Raises HelicoideError."""
    _, found, packed = link.strip().rpartition(LINK)
    try:
        if not found or len(packed) > 4 * MOST_CHARACTERS:
            raise HelicoideError(BROKEN_LINK.format(begins=LINK))
        raw = urlsafe_b64decode(packed.encode("ascii") + b"=" * (-len(packed) % 4))
        unpacker = zlib.decompressobj()
        text = unpacker.decompress(raw, 8 * MOST_CHARACTERS)
        if not unpacker.eof:
            raise HelicoideError(BROKEN_LINK.format(begins=LINK))
        return sheet_of_text(text.decode("utf-8"))
    except (zlib.error, ValueError):  # of base64 and UTF-8, too
        raise HelicoideError(BROKEN_LINK.format(begins=LINK)) from None


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
