"""Changes of a sheet in a window: its lines, and the text field in which they are written."""

from __future__ import annotations

from dataclasses import replace

from helicoide.sheet.parts import LONGEST_LINE, MOST_LINES, LineEntry, Sheet
from helicoide.sheet.writing import sheet_of_text


def with_entered_line(sheet: Sheet, text: str) -> Sheet:
    """The sheet with a line added, or with the chosen line replaced; an empty one removes it. Raises HelicoideError.

    A line such as “slider a = 1 from 0 to 5” sets a slider. The text field is then empty, for a new line.
    """
    change, chosen = sheet_of_text(text), sheet.entry.chosen
    above = sheet.lines if chosen is None else sheet.lines[:chosen]
    below = () if chosen is None else sheet.lines[chosen + 1 :]
    hidden = chosen is not None and not sheet.lines[chosen].shown
    fresh = tuple(replace(line, shown=line.shown and not hidden) for line in change.lines)
    past = tuple(line.text for line in fresh if line.text not in sheet.entry.past)
    entry = LineEntry(past=(*sheet.entry.past, *past)[-MOST_LINES:])
    sliders = tuple({**dict(sheet.sliders), **dict(change.sliders)}.items())
    return Sheet((*above, *fresh, *below), sliders, entry)


def with_chosen_line(sheet: Sheet, index: int | None) -> Sheet:
    """The sheet with a line in the text field, to be changed; None, or no such line, for a new one."""
    if index is None or not 0 <= index < len(sheet.lines):
        return replace(sheet, entry=LineEntry(past=sheet.entry.past))
    return replace(sheet, entry=LineEntry(index, sheet.lines[index].text, sheet.entry.past))


def with_entry_text(sheet: Sheet, text: str) -> Sheet:
    """The sheet with another text in the text field; what is far too long for a line is cut off."""
    return replace(sheet, entry=replace(sheet.entry, text=text[: 2 * LONGEST_LINE]))


def with_shown(sheet: Sheet, shown: bool, index: int | None = None) -> Sheet:
    """The sheet with the result of one line, or of all, drawn or hidden."""
    lines = (replace(line, shown=shown) if index in (None, n) else line for n, line in enumerate(sheet.lines))
    return replace(sheet, lines=tuple(lines))
