"""The places of all users: seat, study panel and own workcell, kept for a day after the last window closes."""

from __future__ import annotations

import secrets
from dataclasses import dataclass, field
from time import monotonic

from helicoide.recorder.panel_state import NO_RECORDINGS, RecordingPanelState
from helicoide.seat import Seat
from helicoide.session.workcell import Workcell
from helicoide.studies.panel_state import NO_STUDY, StudyPanelState
from helicoide.text import Language
from helicoide.view.window import new_seat
from helicoide.view.window_view import LineCheck

# s without a window, after which a place is removed, and after which its own arm is paused
KEPT, LIVES_ON = 86_400.0, 600.0


@dataclass(eq=False)
class Place:
    """The seat of a user, its study and recording panels, and its own workcell, None if it never asked for one.

    at_own: whether its windows show the own workcell; windows: number of open windows; left: time at which the last
    one closed, s of `monotonic`; line_check: of the line that was typed last for an exercise.
    """

    seat: Seat
    study_panel: StudyPanelState = NO_STUDY
    recordings: RecordingPanelState = NO_RECORDINGS
    own: Workcell | None = None
    at_own: bool = False
    windows: int = 0
    left: float = field(default_factory=monotonic)
    line_check: LineCheck | None = None


class Seats:
    """The places, by the token that each browser stores."""

    def __init__(self, lesson: str | None, projector: bool = False) -> None:
        self.lesson, self.projector = lesson, projector
        self.places: dict[str, Place] = {}

    def take(self, token: str | None, language: Language, dark: bool = False) -> Place:
        """The place with that token, or a new one if there is none. language, dark: of a new one."""
        place = self.places.get(token or "")
        if place is None:
            token = secrets.token_urlsafe(12)
            place = self.places[token] = Place(new_seat(token, language, self.lesson, self.projector, dark))
        place.windows += 1
        return place

    def leave(self, place: Place) -> None:
        """Count a window of a place as closed."""
        place.windows -= 1
        place.left = monotonic()

    def tidy(self, now: float) -> None:
        """Pause own arms, and remove places, that had no window for long. now: s of `monotonic`."""
        for token, place in tuple(self.places.items()):
            if place.windows == 0 and now - place.left > LIVES_ON and place.own is not None:
                place.own.pause(True)
            if place.windows == 0 and now - place.left > KEPT:
                del self.places[token]
