"""A sheet of the console: its lines, and the sliders of its names. Its length is bounded."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from helicoide.text import HelicoideError, Text

MOST_CHARACTERS, MOST_LINES, LONGEST_LINE = 4_000, 60, 400

TOO_LONG = Text(
    en="The sheet is too long: it may have {lines} lines, {lines} sliders, {line} characters in a line or a name, and "
    "{most} characters in all.",
    pt_BR="A folha é longa demais: ela pode ter {lines} linhas, {lines} controles deslizantes, {line} caracteres por "
    "linha ou nome e {most} caracteres no total.",
)


@dataclass(frozen=True)
class SheetLine:
    """One line as it was typed. shown: whether its result is drawn in the scene."""

    text: str
    shown: bool = True


@dataclass(frozen=True)
class NameSlider:
    """The value of a name that no line defines, and the ends of its slider."""

    value: float = 1.0
    lower: float = -10.0
    upper: float = 10.0


@dataclass(frozen=True)
class LineEntry:
    """The text field of a window. It belongs to no file and no link.

    chosen: the line that is being changed, None for a new one; past: the lines that were entered, the newest last.
    """

    chosen: int | None = None
    text: str = ""
    past: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sheet:
    """Lines that are evaluated from top to bottom, and sliders by name. Raises HelicoideError if it is too long.

    Sheets with the same lines and sliders are equal, whatever their `entry` is.
    """

    lines: tuple[SheetLine, ...] = ()
    sliders: tuple[tuple[str, NameSlider], ...] = ()
    entry: LineEntry = field(default=LineEntry(), compare=False)

    def __post_init__(self) -> None:
        """Check the length; every sheet from outside is made here."""
        too_many = len(self.lines) > MOST_LINES or len(self.sliders) > MOST_LINES
        lengths = [len(line.text) for line in self.lines] + [len(name) for name, _ in self.sliders]
        if too_many or sum(lengths) > MOST_CHARACTERS or any(length > LONGEST_LINE for length in lengths):
            raise HelicoideError(too_long_text())

    def slider(self, name: str) -> NameSlider:
        """The slider of a name; the usual one if it was never moved."""
        return dict(self.sliders).get(name, NameSlider())

    def with_slider(self, name: str, slider: NameSlider) -> Sheet:
        """The sheet with one slider changed, or added."""
        return replace(self, sliders=tuple({**dict(self.sliders), name: slider}.items()))


def too_long_text() -> Text:
    """Why a sheet or a line is refused for its length."""
    return TOO_LONG.format(lines=MOST_LINES, line=LONGEST_LINE, most=MOST_CHARACTERS)
