"""Sheets of the console: `parts` says what a sheet is, `writing` writes it, `editing` and `undoing` change it."""

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
from helicoide.sheet.undoing import SheetChange, SheetHistory, with_sheet_redone, with_sheet_undone
from helicoide.sheet.writing import (
    LONGEST_PACKED,
    packed_sheet,
    sheet_of_file,
    sheet_of_text,
    sheet_text,
    unpacked_sheet,
)

__all__ = [
    "LONGEST_LINE",
    "LONGEST_PACKED",
    "MOST_CHARACTERS",
    "MOST_LINES",
    "LineEntry",
    "NameSlider",
    "Sheet",
    "SheetChange",
    "SheetHistory",
    "SheetLine",
    "packed_sheet",
    "sheet_of_file",
    "sheet_of_text",
    "sheet_text",
    "too_long_text",
    "unpacked_sheet",
    "with_chosen_line",
    "with_entered_line",
    "with_entry_text",
    "with_sheet_redone",
    "with_sheet_undone",
    "with_shown",
]
