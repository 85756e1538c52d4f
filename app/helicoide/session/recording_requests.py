"""Requests of windows about recordings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from helicoide.session.bay import Bays
from helicoide.session.recorders import Recorders
from helicoide.session.recordings import Recordings
from helicoide.session.seats import Place, Seats
from helicoide.session.visitor import Visitor
from helicoide.state import State
from helicoide.view import requests
from helicoide.view.requests import RecordingRequest


class RecordingRequests:
    """The recorders and the open recordings of a lab. write: has the rows of all windows written."""

    def __init__(self, bays: Bays, seats: Seats, visitors: Mapping[int, Visitor], write: Callable[[], object]) -> None:
        self.bays, self.visitors = bays, visitors
        self.recordings = Recordings(seats.places.values, self._state_of, self._redraw, self._is_recorded)
        self.recorders = Recorders(lambda: bays.workcells, self.recordings.list, write)

    def do(self, visitor: Visitor, request: RecordingRequest) -> None:
        """Carry out a request of a window."""
        place, window = visitor.place, visitor.window
        match request:
            case requests.RecordArm(on):
                self.recorders.record(visitor.bay.workcell, on, window.tell)
            case requests.ForRecordingPanel(update):
                self.recordings.change(place, update)
            case requests.OpenRecording(name, content):
                self.recordings.open(place, name, content)
            case requests.DeleteRecording(name):
                self.recordings.delete(name, window.tell)
            case requests.SaveRecording(kind):
                send = partial(window.client.send_file_download, save_immediately=True)
                self.recordings.save(place, kind, send, window.tell)

    def enter(self, place: Place) -> None:
        """A window of a place opens."""
        self.recordings.list()
        self.recordings.meet(place)

    def _state_of(self, place: Place) -> State:
        return self.bays.of(place).workcell.state

    def _redraw(self, place: Place) -> None:
        for visitor in self.visitors.values():
            if visitor.place is place and visitor.bay.display is not None:
                visitor.bay.display.redraw()

    def _is_recorded(self, name: str) -> bool:
        return self.recorders.is_recorded(name)
