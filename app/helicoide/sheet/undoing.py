"""The changes of a sheet, to undo and redo them in one order with the changes of the scene."""

from __future__ import annotations

from dataclasses import dataclass, replace

from helicoide.sheet.parts import LineEntry, NameSlider, Sheet
from helicoide.text import Text

MOST_SHEET_CHANGES = 100
SHEET_CHANGED = Text(en="sheet changed", pt_BR="folha alterada")
SLIDER_MOVED = Text(en="slider {name} moved", pt_BR="controle {name} movido")


@dataclass(frozen=True)
class SheetChange:
    """A change, and what to return to. slider: the one that moved, empty for any other change.

    after: how many changes of the scene could be undone at that time, which gives both kinds one order.
    """

    other: Sheet
    slider: str
    after: int

    @property
    def title(self) -> Text:
        """The change in words."""
        return SLIDER_MOVED.format(name=self.slider) if self.slider else SHEET_CHANGED


@dataclass(frozen=True)
class SheetHistory:
    """The changes that can be undone and redone, the newest last.

    unfinished: whether a next motion of the same slider belongs to the newest change, as while the slider is held.
    """

    undo: tuple[SheetChange, ...] = ()
    redo: tuple[SheetChange, ...] = ()
    unfinished: bool = False

    def with_change(self, before: Sheet, now: Sheet, scene: int) -> SheetHistory:
        """The history after a change. scene: how many changes of the scene can be undone."""
        slider, newest = _moved_slider(before, now), self.undo[-1] if self.undo else None
        if slider and self.unfinished and newest is not None and newest.slider == slider:
            return self
        change = SheetChange(before, slider, scene)
        return SheetHistory((*self.undo[1 - MOST_SHEET_CHANGES :], change), (), unfinished=True)

    def finished(self) -> SheetHistory:
        """The history in which any further change is a new one."""
        return replace(self, unfinished=False) if self.unfinished else self

    def next_undo(self, scene: int) -> SheetChange | None:
        """The newest change, if no change of the scene is newer. scene: how many of these can be undone."""
        return self.undo[-1] if self.undo and self.undo[-1].after >= scene else None

    def next_redo(self, scene: int, undone: int) -> SheetChange | None:
        """The change that was undone last, if none of the `undone` changes of the scene comes before it."""
        return self.redo[-1] if self.redo and (self.redo[-1].after <= scene or not undone) else None


def with_sheet_undone(sheet: Sheet, history: SheetHistory) -> tuple[Sheet, SheetHistory]:
    """Sheet and history after the newest change was undone, which there must be."""
    newest = history.undo[-1]
    redo = (*history.redo, replace(newest, other=sheet))
    return _returned(sheet, newest.other), SheetHistory(history.undo[:-1], redo)


def with_sheet_redone(sheet: Sheet, history: SheetHistory) -> tuple[Sheet, SheetHistory]:
    """Sheet and history after the change that was undone last was made again."""
    newest = history.redo[-1]
    undo = (*history.undo, replace(newest, other=sheet))
    return _returned(sheet, newest.other), SheetHistory(undo, history.redo[:-1])


def _returned(sheet: Sheet, other: Sheet) -> Sheet:
    """The other sheet, with no line chosen in the text field."""
    return replace(other, entry=LineEntry(past=sheet.entry.past))


def _moved_slider(before: Sheet, now: Sheet) -> str:
    """The name of the only thing that differs, if it is a slider; otherwise empty."""
    if before.lines != now.lines:
        return ""
    one, other = dict(before.sliders), dict(now.sliders)
    moved = [name for name in {**one, **other} if one.get(name, NameSlider()) != other.get(name, NameSlider())]
    return moved[0] if len(moved) == 1 else ""
