"""Who sat where: each person's seat, desk and own workcell, kept until nobody has used it for a day."""

from __future__ import annotations

import secrets
from dataclasses import dataclass, field
from time import monotonic

from helicoide.seat import Seat
from helicoide.session.workcell import Workcell
from helicoide.studies.panel_state import NO_STUDY, StudyPanelState
from helicoide.text import Language
from helicoide.view.window import new_seat

# s: how long a seat is kept, and how long an arm of one's own goes on living, without a window
KEPT, LIVES_ON = 86_400.0, 600.0


@dataclass(eq=False)
class Place:
    """A person's seat, what they have of the studies, and their own workcell, if they ever wished for one.

    at_own: whether they are in front of it; windows: how many they have open; left: when the last one closed, s.
    """

    seat: Seat
    desk: StudyPanelState = NO_STUDY
    own: Workcell | None = None
    at_own: bool = False
    windows: int = 0
    left: float = field(default_factory=monotonic)


class Seats:
    """The places by the token that the browser of each person keeps."""

    def __init__(self, lesson: str | None, projector: bool = False) -> None:
        self.lesson, self.projector = lesson, projector
        self.places: dict[str, Place] = {}

    def take(self, token: str | None, language: Language) -> Place:
        """The place of that token, or a new one where there is none."""
        place = self.places.get(token or "")
        if place is None:
            token = secrets.token_urlsafe(12)
            place = self.places[token] = Place(new_seat(token, language, self.lesson, self.projector))
        place.windows += 1
        return place

    def leave(self, place: Place) -> None:
        """A window of a place has closed."""
        place.windows -= 1
        place.left = monotonic()

    def tidy(self, now: float) -> None:
        """Pause the arms and forget the places that nobody has used for long; now: s."""
        for token, place in tuple(self.places.items()):
            if place.windows == 0 and now - place.left > LIVES_ON and place.own is not None:
                place.own.pause(True)
            if place.windows == 0 and now - place.left > KEPT:
                del self.places[token]
