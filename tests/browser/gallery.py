"""The gallery of the README: each picture with its size, look, language and the scene that is set up for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tests.browser import set_ups
from tests.browser.studio import Studio

from helicoide.text import Language


@dataclass(frozen=True)
class Picture:
    """A picture of the gallery. size: one of `conftest.SIZES`; a projector has its switch on."""

    name: str
    size: str
    dark: bool
    language: Language
    set_up: Callable[[Studio], None]


LIGHT, DARK = False, True
GALLERY = (
    Picture("blocked", "desktop", LIGHT, "en", set_ups.blocked),
    Picture("screw", "desktop", LIGHT, "pt_BR", set_ups.screw),
    Picture("why_this_number", "desktop", DARK, "en", set_ups.why_this_number),
    Picture("quaternions", "desktop", LIGHT, "en", set_ups.quaternions),
    Picture("console", "desktop", DARK, "pt_BR", set_ups.console),
    Picture("ellipsoid", "phone", DARK, "en", set_ups.ellipsoid),
    Picture("planned", "projector", LIGHT, "pt_BR", set_ups.planned),
    Picture("distances", "desktop", LIGHT, "en", set_ups.distances),
    Picture("dh_frames", "desktop", DARK, "en", set_ups.dh_frames),
    Picture("entry_point", "desktop", LIGHT, "pt_BR", set_ups.entry_point),
    Picture("branches", "desktop", LIGHT, "en", set_ups.branches),
    Picture("signals", "desktop", LIGHT, "pt_BR", set_ups.signals),
    Picture("loop", "projector", LIGHT, "en", set_ups.loop),
    Picture("recording", "desktop", DARK, "pt_BR", set_ups.recording),
    Picture("study", "desktop", LIGHT, "en", set_ups.study_of_a_source),
    Picture("lesson", "phone", LIGHT, "pt_BR", set_ups.first_lesson),
)
