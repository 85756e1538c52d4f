"""Sheets of the console: `parts` says what a sheet is, `writing` its files and links, `editing` its changes."""

from helicoide.sheet.editing import with_chosen_line, with_entered_line, with_entry_text, with_shown
from helicoide.sheet.parts import (
    LONGEST_LINE,
    MOST_CHARACTERS,
    MOST_LINES,
    LineEntry,
    NameSlider,
    Sheet,
    SheetLine,
    too_long_text,
)
from helicoide.sheet.writing import LINK, sheet_link, sheet_of_file, sheet_of_link, sheet_of_text, sheet_text

__all__ = [
    "LINK",
    "LONGEST_LINE",
    "MOST_CHARACTERS",
    "MOST_LINES",
    "LineEntry",
    "NameSlider",
    "Sheet",
    "SheetLine",
    "sheet_link",
    "sheet_of_file",
    "sheet_of_link",
    "sheet_of_text",
    "sheet_text",
    "too_long_text",
    "with_chosen_line",
    "with_entered_line",
    "with_entry_text",
    "with_shown",
]
