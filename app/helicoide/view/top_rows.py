"""The rows above the tabs: language, own or shared arm, undo and redo, the look of the window, and a link to it."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from viser import Icon

from helicoide.history import Change
from helicoide.seat import Seat
from helicoide.sheet import SheetChange
from helicoide.text import LANGUAGES, Language, Text, untranslated
from helicoide.view.camera import PRESETS
from helicoide.view.link_rows import link_rows
from helicoide.view.requests import CopyLink, ForSeat, Look, OwnArm, Redo, Undo
from helicoide.view.rows import Button, ButtonGroup, Checkbox, Dropdown, Folder, Row

LANGUAGE_NAMES: dict[Language, str] = {"en": "English", "pt_BR": "Português (Brasil)"}
OWN = Text(en="Use my own arm", pt_BR="Usar meu próprio braço")
SHARED = Text(en="Return to the shared arm", pt_BR="Voltar ao braço comum")
UNDO = Text(en="Undo", pt_BR="Desfazer")
REDO = Text(en="Redo", pt_BR="Refazer")
OF_CHANGE = Text(en="{action}: {what}", pt_BR="{action}: {what}")
LOOK = Text(en="View", pt_BR="Vista")
PROJECTOR = Text(en="Projector", pt_BR="Projetor")
DARK = Text(en="Dark", pt_BR="Escuro")
TRANSPARENT = Text(en="Transparent arm", pt_BR="Braço transparente")
CAMERA = Text(en="Camera", pt_BR="Câmera")
COPY_LINK = Text(en="Copy link to this view", pt_BR="Copiar o link desta vista")


def top_rows() -> list[Row]:
    """The rows, the same for every robot."""
    return [
        Dropdown(
            Text(en="Language · Idioma", pt_BR="Idioma · Language"),
            [(language, untranslated(LANGUAGE_NAMES[language])) for language in LANGUAGES],
            lambda view: view.seat.language,
            lambda key: ForSeat(lambda seat: replace(seat, language="pt_BR" if key == "pt_BR" else "en")),
        ),
        Button(lambda view: SHARED if view.own else OWN, lambda view: OwnArm(not view.own), Icon.USER),
        *link_rows(),
        Button(
            lambda view: _label(UNDO, view.sheet_undo, view.state.history.undo),
            lambda view: Undo(),
            Icon.ARROW_BACK_UP,
            enabled=lambda view: bool(view.state.history.undo or view.sheet_undo),
        ),
        Button(
            lambda view: _label(REDO, view.sheet_redo, view.state.history.redo),
            lambda view: Redo(),
            Icon.ARROW_FORWARD_UP,
            enabled=lambda view: bool(view.state.history.redo or view.sheet_redo),
        ),
        Folder(LOOK, _look_rows(), open=False),
    ]


def _look_rows() -> list[Row]:
    return [
        ButtonGroup(CAMERA, list(PRESETS.items()), Look),
        Checkbox(DARK, lambda view: view.seat.dark, lambda on: ForSeat(partial(with_dark, on))),
        Checkbox(PROJECTOR, lambda view: view.seat.projector, lambda on: ForSeat(partial(with_projector, on))),
        Checkbox(TRANSPARENT, lambda view: view.seat.transparent, lambda on: ForSeat(partial(with_transparent, on))),
        Button(lambda view: COPY_LINK, lambda view: CopyLink(), Icon.LINK),
    ]


def _label(action: Text, of_sheet: SheetChange | None, changes: tuple[Change, ...]) -> Text:
    """Undo or Redo with the change that comes next: of the sheet, or else the newest one of the scene."""
    change = of_sheet or (changes[-1] if changes else None)
    return action if change is None else OF_CHANGE.format(action=action, what=change.title)


def with_projector(on: bool, seat: Seat) -> Seat:
    """A seat with the size for a projector, or with the normal size."""
    return replace(seat, projector=on)


def with_dark(on: bool, seat: Seat) -> Seat:
    """A seat with the dark look, or with the light one."""
    return replace(seat, dark=on)


def with_transparent(on: bool, seat: Seat) -> Seat:
    """A seat that sees through the arm, or not."""
    return replace(seat, transparent=on)
