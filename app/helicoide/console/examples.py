"""The example sheets in static/sheets: one for each worked example of Cerbaro 2022, ch. 5 and App. F, some of lessons.

The first two lines of a file are its titles, as the comments `# en: …` and `# pt_BR: …`; the sheet follows.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from helicoide import content
from helicoide.sheet import Sheet, sheet_of_text
from helicoide.text import Text

FOLDER = content.STATIC / "sheets"


@dataclass(frozen=True)
class ExampleSheet:
    """An example sheet with its title."""

    title: Text
    sheet: Sheet


@cache
def example_sheets() -> dict[str, ExampleSheet]:
    """All example sheets by the names of their files."""
    return {file.stem: _read(file.read_text("utf-8")) for file in sorted(FOLDER.glob("*.txt"))}


def _read(text: str) -> ExampleSheet:
    en, pt_BR, rest = text.split("\n", 2)
    return ExampleSheet(Text(en=en.removeprefix("# en: "), pt_BR=pt_BR.removeprefix("# pt_BR: ")), sheet_of_text(rest))
