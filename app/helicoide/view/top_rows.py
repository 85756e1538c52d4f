"""The rows above the tabs: language, own or shared arm, and the size for a projector."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from viser import Icon

from helicoide.seat import Seat
from helicoide.text import LANGUAGES, Language, Text, untranslated
from helicoide.view.rows import Button, Checkbox, Dropdown, ForSeat, OwnArm, Row

LANGUAGE_NAMES: dict[Language, str] = {"en": "English", "pt_BR": "Português (Brasil)"}
OWN = Text(en="Use my own arm", pt_BR="Usar meu próprio braço")
SHARED = Text(en="Return to the shared arm", pt_BR="Voltar ao braço comum")
PROJECTOR = Text(en="Projector", pt_BR="Projetor")


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
        Checkbox(
            PROJECTOR,
            lambda view: view.seat.projector,
            lambda on: ForSeat(partial(with_projector, on)),
        ),
    ]


def with_projector(on: bool, seat: Seat) -> Seat:
    """A seat with the size for a projector, or with the normal size."""
    return replace(seat, projector=on)
